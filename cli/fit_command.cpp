// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/fit_command.h"

#include <fmt/format.h>

namespace openltc::cli {

const char* const k_fit_footer =
    "For every roughness and view angle the linearly transformed cosine is found that comes\n"
    "closest to the BRDF. Objectives: balanced, better than the published table in every norm\n"
    "at once, in the mean; tv, least total variation; l2 and l3, least relative squares or\n"
    "cubes, which hold on to the peak. The error is measured between the nodes, through the\n"
    "look-up of the layout and in the precision that is written. Total variation (TV) is a\n"
    "bound: for F = 1 no light of radiance up to L_max errs by more than (E TV + |n1 - E|) L_max, "
    "E the\n"
    "albedo and n1 what is stored for it.\n"
    "\n"
    "Layouts: native, for this project's shading (low roughness and small tables stay good);\n"
    "ltc_code (three.js, Babylon.js, Bevy, EEVEE); unity (HDRP); godot; o3de.\n"
    "A form without a table: polynomials, whose lobes are proven never to turn inside out.\n"
    "Two lobes, fitted together, halve the error; only this project reads tables of them.\n"
    "\n"
    "--engine NAME makes the files that an engine itself ships, of the same names, sizes and\n"
    "axes, fitted for what its look-up does, and says where they go; -o is a folder then.\n"
    "\n"
    "Examples:\n"
    "  openltc fit                                        GGX, errors only, all of them\n"
    "  openltc fit --list                                 the BRDFs\n"
    "  openltc fit --brdf charlie --size 32 -o sheen.json\n"
    "  openltc fit --layout ltc_code -o ggx.dds           writes ggx_1.dds and ggx_2.dds\n"
    "  openltc fit --engine godot -o .                    ltc_lut1.dds and ltc_lut2.dds\n"
    "  openltc fit --form polynomial -o lobes.glsl        a function to paste\n"
    "  openltc fit --form two-lobe -o two.ktx2            writes two_1, two_2 and two_3\n"
    "  openltc fit --form two-lobe-polynomial -o two.glsl a function that gives both lobes\n"
    "  openltc fit --report ggx.html --against ltc_1.dds  a page of figures and heat maps\n"
    "  openltc fit --brdf gold-paint.binary -o gold.json  a measured material";

std::string shell_word(const std::string& path) {
  constexpr const char* k_plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "_-./,:=@%+";
  if (!path.empty() && path.find_first_not_of(k_plain) == std::string::npos) return path;
  std::string quoted = "'";
  for (const char c : path)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string fit_command_of(const std::string& brdf, const fit::FitRequest& c,
                           const table::Engine* engine) {
  fit::FitRequest standard;
  std::string command = fmt::format("openltc fit --brdf {}", shell_word(brdf));
  if (is_polynomial(c.form))
    command += fmt::format(
        " --form {} --degree {}",
        c.form == table::LobeForm::polynomial ? "polynomial" : "two-lobe-polynomial", c.degree);
  else if (engine)
    command += fmt::format(" --engine {}", engine->name);
  else
    command += fmt::format("{} --size {}",
                           c.form == table::LobeForm::two_lobe ? " --form two-lobe" : "", c.size);
  if (engine) {
    standard.layout = engine->layout;
    standard.precision = engine->precision;
    standard.refine = fit::Refine::on;
  }
  if (c.objective != standard.objective) command += fmt::format(" --objective {}", c.objective);
  if (c.layout != standard.layout) command += fmt::format(" --layout {}", name_of(c.layout));
  if (c.precision != standard.precision)
    command += fmt::format(" --precision {}", name_of(c.precision));
  if (c.refine != standard.refine)
    command += fmt::format(" --refine {}", c.refine == fit::Refine::on ? "on" : "off");
  return c.clip_aware ? command + " --clip-aware" : command;
}

} // namespace openltc::cli
