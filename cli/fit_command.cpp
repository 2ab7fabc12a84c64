// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/fit_command.h"

#include <fmt/format.h>

namespace openltc::cli {

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
    command += fmt::format(" --engine {}{}", engine->name,
                           c.size != engine->size ? fmt::format(" --size {}", c.size) : "");
  else
    command += fmt::format("{} --size {}",
                           c.form == table::LobeForm::two_lobe ? " --form two-lobe" : "", c.size);
  if (engine) standard.layout = c.layout, standard.precision = c.precision;
  if (c.objective != standard.objective) command += fmt::format(" --objective {}", c.objective);
  if (c.layout != standard.layout) command += fmt::format(" --layout {}", name_of(c.layout));
  if (c.precision != standard.precision)
    command += fmt::format(" --precision {}", name_of(c.precision));
  if (c.refine != standard.refine)
    command += fmt::format(" --refine {}", c.refine == fit::Refine::on ? "on" : "off");
  return c.clip_aware ? command + " --clip-aware" : command;
}

} // namespace openltc::cli
