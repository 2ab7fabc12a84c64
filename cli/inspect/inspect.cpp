// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc inspect: what a file is.

#include "cli/inspect/inspect.h"

#include "cli/commands.h"
#include "cli/options/pose_options.h"
#include "cli/options/reading_options.h"
#include "cli/options/shape_options.h"
#include "cli/process/standard_streams.h"
#include "openltc/image/file.h"
#include "openltc/table/packed_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace openltc::cli {

namespace {

struct InspectArguments {
  std::string path, layer;
  bool json = false;
  scene::EmissiveOptions emissive;
  scene::ReadOptions reading;
};

struct Kind {
  const char* extension;
  Result<Description> (*inspect)(const std::string& path); ///< none: a scene
};
Result<Description> inspect_whole_picture(const std::string& path) { return inspect_picture(path); }
constexpr Kind k_kinds[] = {
    {".gltf", nullptr},
    {".glb", nullptr},
    {".exr", inspect_exr},
    {".hdr", inspect_whole_picture},
    {".json", inspect_table},
    {".png", inspect_whole_picture},
    {".dds", inspect_table},
    {".jpg", inspect_whole_picture},
    {".ktx2", inspect_table},
    {".jpeg", inspect_whole_picture},
    {".webp", inspect_whole_picture},
    {".npy", inspect_table},
    {".ies", inspect_photometry},
    {".ldt", inspect_photometry},
};

Result<Description> describe(const std::string& path, const InspectArguments& arguments) {
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (std::filesystem::is_directory(status)) return Error{fmt::format("{}: is a directory", path)};
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const Kind& kind : k_kinds)
    if (extension == kind.extension) {
      // A table of two files goes by the name of neither: ggx.dds is ggx_1.dds and ggx_2.dds.
      const bool may_be_two = kind.inspect == inspect_table || kind.inspect == inspect_exr;
      if (!std::filesystem::exists(status) && !(may_be_two && table::table_exists(path))) break;
      return kind.inspect ? kind.inspect(path)
                          : inspect_scene(path, arguments.emissive, arguments.reading);
    }
  if (!std::filesystem::exists(status)) return Error{fmt::format("{}: no such file", path)};
  return Error{fmt::format(
      "{}: cannot tell what it is; known are scenes (.gltf .glb), pictures "
      "(.exr .hdr .png .jpg), photometric files (.ies .ldt) and lobe tables or polynomials "
      "(.json .dds .ktx2 .exr .npy)",
      path)};
}

int run_inspect(const InspectArguments& arguments) {
  image::PictureName name = image::split_picture_name(arguments.path);
  if (!arguments.layer.empty()) name.layer = arguments.layer;
  const Result<Description> description =
      name.layer.empty() ? describe(name.path, arguments) : inspect_picture(name.path, name.layer);
  if (!description) return fail("inspect", description.error());
  if (!arguments.json) {
    put("{}", description->text);
    return k_exit_ok;
  }
  // Names and paths may hold any bytes; they must not break the output.
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  put("{}\n", description->json.dump(2, ' ', false, replace));
  return k_exit_ok;
}

} // namespace

void add_inspect(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<InspectArguments>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Say what a file is: a scene, a picture, a luminaire or a lobe table");
  command->footer(
      "A scene (.gltf .glb): geometry, cameras by number and name, lights in nits, candela and\n"
      "lumens, animations, and what the importer warns about; coordinates are the file's.\n"
      "A picture (.exr .hdr .png .jpg .webp): size, parts and\n"
      "layers, range and mean of each channel, NaN and infinities, and for scene-linear ones the\n"
      "exposure that openltc compare --exposure auto would choose. A lobe table (.json .dds .ktx2 "
      ".exr .npy): its "
      "metadata,\n"
      "errors and ranges; for a bare texture, which does not say what it is, how well every known\n"
      "layout and axis fits every named BRDF, the best first. An .exr is taken for a table when "
      "its\n"
      "attributes say so or NAME_1.exr and NAME_2.exr lie side by side. A lobe polynomial "
      "(.json):\n"
      "its metadata, errors, and the proof that none of its lobes turns inside out, made anew.\n"
      "A photometric file (.ies .ldt): lumens, integrated and stated, peak, beam and field "
      "angles,\n"
      "symmetry, opening.\n"
      "\n"
      "Examples:\n"
      "  openltc inspect room.glb\n"
      "  openltc inspect truth.exr --json\n"
      "  openltc inspect blender.exr:ViewLayer.Normal\n"
      "  openltc inspect lamp.ldt\n"
      "  openltc fit -o ggx.json && openltc inspect ggx.json\n"
      "  openltc inspect ltc_1.dds");
  command->add_option("file", arguments->path, "File to look at")->required();
  command->add_option("--layer", arguments->layer,
                      "Of an .exr this layer only; FILE.exr:LAYER means the same");
  add_shape_options(*command, arguments->emissive);
  add_reading_options(*command, arguments->reading);
  add_pose_options(*command, arguments->reading.pose);
  command->add_flag("--json", arguments->json, "Print as JSON");
  command->callback([arguments, &exit_code] { exit_code = run_inspect(*arguments); });
}

} // namespace openltc::cli
