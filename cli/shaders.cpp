// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc shaders: the shading source as one file of a shading language.

#include "cli/commands.h"
#include "cli/options/choice.h"
#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/base/atomic_file.h"
#include "openltc/shaders/shader_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace openltc::cli {

namespace {

struct ShadersArguments {
  shaders::ShaderRequest request;
  std::vector<std::string> shapes = {"quad"};
  std::string folder;
  bool quiet = false;
};

// The shapes by their names, each once, in the order of the files.
Result<std::vector<shaders::Shape>> shapes_of(const std::vector<std::string>& names) {
  std::vector<shaders::Shape> shapes;
  std::string listed;
  for (const shaders::Shape shape : shaders::all_shapes()) {
    const std::string name = name_of(shape);
    listed += (listed.empty() ? "" : ", ") + name;
    if (std::find(names.begin(), names.end(), name) != names.end() ||
        std::find(names.begin(), names.end(), "all") != names.end())
      shapes.push_back(shape);
  }
  for (const std::string& name : names) {
    const auto is_it = [&](shaders::Shape shape) { return name_of(shape) == name; };
    if (name != "all" && std::none_of(shapes.begin(), shapes.end(), is_it))
      return Error{fmt::format("--shapes: no shape '{}'; there are {}, and all", name, listed)};
  }
  return shapes;
}

Status write_shader(const std::string& path, const std::string& text) {
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) return Error{path + ": cannot write; is the disk full?"};
    return Success{};
  });
}

int run_shaders(ShadersArguments& arguments) {
  shaders::ShaderRequest& request = arguments.request;
  const Result<std::vector<shaders::Shape>> shapes = shapes_of(arguments.shapes);
  if (!shapes) return fail("shaders", shapes.error(), k_exit_usage);
  request.shapes = *shapes;
  if (Status status = shaders::check_prefix(request.prefix); !status)
    return fail("shaders", Error{"--prefix: " + status.error().message}, k_exit_usage);
  request.version = OPENLTC_VERSION;
  const std::string path = (std::filesystem::path(arguments.folder) / file_name(request)).string();
  if (Status status = check_places({path}); !status) return fail("shaders", status.error());
  const Result<std::string> text = make_shader(request);
  if (!text) return fail("shaders", text.error());
  if (Status status = write_shader(path, *text); !status) return fail("shaders", status.error());
  if (!arguments.quiet) say("wrote {}\n", path);
  return k_exit_ok;
}

constexpr const char* k_shaders_footer =
    "The file needs no other and no table, unless you choose one. It is made of the source that\n"
    "the tool itself is built from, with its names, comments and derivations, so that you can "
    "read\n"
    "and change it; its head shows how to call it, in three lines for a quad. Only what the "
    "shapes\n"
    "need is in it, and every name begins with the prefix.\n"
    "\n"
    "Languages: glsl (Vulkan and desktop), glsl-es (WebGL 2), hlsl (Unreal, Unity), metal, wgsl\n"
    "(WebGPU), gdshader (Godot 4).\n"
    "Lobes: polynomial, constants in the file, mean total variation from GGX 0.038; table, "
    "textures\n"
    "of `openltc fit`, 0.037 or any other BRDF; two-lobe, textures of `openltc fit --form "
    "two-lobe`,\n"
    "0.016.\n"
    "Shapes: quad, a rectangle or parallelogram; polygon, any outline from a buffer; disk, "
    "ellipses\n"
    "too; sphere; tube, cylinder or capsule; line; textured, a rectangle with a picture.\n"
    "Files made beforehand, and more about their use: shaders/README.md.\n"
    "\n"
    "Examples:\n"
    "  openltc shaders --language wgsl -o .                        ltc_quad.wgsl\n"
    "  openltc shaders --language wgsl --lean -o .                 ltc_quad_lean.wgsl\n"
    "  openltc shaders --language hlsl --shapes quad,sphere,tube -o Shaders\n"
    "  openltc shaders --language glsl --shapes quad --sampling -o .   for shadows by rays\n"
    "  openltc shaders --language metal --shapes all --lobe two-lobe --prefix Area_ -o .";

} // namespace

void add_shaders(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ShadersArguments>();
  CLI::App* command = app.add_subcommand(
      "shaders", "Write the closed form of lights as one file of a shading language");
  command->footer(k_shaders_footer);
  Choices<shaders::Language> languages;
  for (const shaders::Language language : shaders::all_languages())
    languages.emplace_back(name_of(language), language);
  add_choice(*command, "--language", arguments->request.language, "Shading language", languages)
      ->required();
  Choices<shaders::Lobe> lobes;
  for (const shaders::Lobe lobe : {shaders::Lobe::polynomial, shaders::Lobe::two_lobe_polynomial,
                                   shaders::Lobe::table, shaders::Lobe::two_lobe})
    lobes.emplace_back(name_of(lobe), lobe);
  add_choice(*command, "--lobe", arguments->request.lobe,
             "Fitted lobes, one or two: constants of the file, or textures that you bind "
             "[polynomial]",
             lobes);
  command
      ->add_option("--shapes", arguments->shapes,
                   "Shapes of light, by commas: quad, polygon, disk, sphere, tube, line, textured; "
                   "or all")
      ->delimiter(',')
      ->type_name("SHAPE,...")
      ->capture_default_str();
  command->add_flag("--lean", arguments->request.lean,
                    "Without set_geometric_normal (for normal maps) and correct_at_mean (for small "
                    "lights): less to compile");
  command->add_flag("--sampling", arguments->request.sampling,
                    "With functions that draw points of the lights, for shadows by rays");
  command
      ->add_option("--prefix", arguments->request.prefix, "What every name of the file begins with")
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder, "Folder to write the file to")->required();
  command->add_flag("--quiet", arguments->quiet, "No messages on stderr");
  command->callback([arguments, &exit_code] { exit_code = run_shaders(*arguments); });
}

} // namespace openltc::cli
