// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc convert: between table layouts, precisions and containers; lights of scenes.

#include "cli/commands.h"
#include "cli/convert/photometry.h"
#include "cli/convert/picture.h"
#include "cli/convert/scene.h"
#include "cli/options/choice.h"
#include "cli/options/number.h"
#include "cli/options/reading_options.h"
#include "cli/options/shape_options.h"
#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/fit/fit_job.h"
#include "openltc/fit/measure/error.h"
#include "openltc/light/photometry/photometry.h"
#include "openltc/table/divided.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/shading_lobes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace openltc::cli {

namespace {

using table::Layout;
using table::Precision;

struct ConvertArguments {
  std::string input, output;
  std::optional<Layout> layout, from_layout;
  std::optional<Precision> precision;
  int size = 0;
  std::string brdf;
  scene::EmissiveOptions emissive;
  scene::ReadOptions reading;
  PictureConversion picture;
  bool quiet = false;

  bool asks_for_layout() const { return layout || from_layout || size > 0 || !brdf.empty(); }
  bool asks_for_picture() const {
    return !picture.layer.empty() || picture.exposure || picture.tonemap;
  }
};

// What the arguments ask of the table, through the native packing where that is needed.
Result<table::PackedTable> convert(const table::PackedTable& from,
                                   const ConvertArguments& arguments) {
  const Layout layout = arguments.layout.value_or(from.layout);
  const Precision precision = arguments.precision.value_or(from.precision);
  const bool same_size =
      arguments.size == 0 || (arguments.size == from.columns() && arguments.size == from.rows());
  // The same texels: nothing is lost, and nothing asked of them.
  if (layout == from.layout && same_size && precision == from.precision) return from;
  if (layout == from.layout && same_size) return with_precision(from, precision);
  Result<table::LobeTable> lobes = unpack(from);
  if (!lobes) return lobes.error();
  if (!same_size) {
    const int columns = lobes->columns == 1 ? 1 : arguments.size;
    lobes = resample(*lobes, columns, arguments.size, lobes->angle_axis);
    if (!lobes) return lobes.error();
  }
  // The horizon says how the lobes are to be read, and so how they are measured.
  const bool divided = is_divided(from) && layout != Layout::native;
  if (layout == Layout::native)
    lobes->metadata.horizon = table::k_clipped;
  else if (layout != from.layout)
    lobes->metadata.horizon = name_of(fit::Horizon::leaking); // what the engines do
  Result<table::PackedTable> to = pack(*lobes, layout, divided ? Precision::float32 : precision);
  if (!to || !divided) return to;
  divide_amplitudes(*to); // still for a renderer that clips
  return with_precision(*to, precision);
}

// The errors that the metadata state are those of the lobes as this layout reads them.
void restate_errors(table::PackedTable& packed) {
  table::TableMetadata& m = packed.metadata;
  m.mean_tv = m.max_tv = 0;
  const brdf::Brdf* brdf = brdf::find_brdf(m.brdf);
  if (!brdf) return;
  fit::MeasureOptions options;
  options.horizon = fit::horizon_of(packed);
  const Result<fit::TableError> error = fit::measure_lobes(
      *brdf, [&](double roughness, double c) { return fit::fetch_measured(packed, roughness, c); },
      options);
  if (!error) return;
  const auto four_digits = [](double x) {
    return std::strtod(fmt::format("{:.3e}", x).c_str(), nullptr);
  };
  m.mean_tv = four_digits(error->mean.tv);
  m.max_tv = four_digits(error->max.tv);
}

// How to make the same from what the input was made from.
std::string command_of(const table::PackedTable& packed, int size) {
  std::string command = packed.metadata.command;
  command +=
      fmt::format("{}openltc convert --layout {} --precision {}", command.empty() ? "" : "; ",
                  name_of(packed.layout), name_of(packed.precision));
  return size > 0 ? fmt::format("{} --size {}", command, size) : command;
}

// A polynomial has no layout: only its container changes.
int convert_polynomial(const ConvertArguments& arguments) {
  const bool asks_for_table = arguments.layout || arguments.from_layout || arguments.precision ||
                              arguments.size > 0 || !arguments.brdf.empty();
  if (asks_for_table)
    return fail("convert",
                Error{arguments.input + ": holds a polynomial; --layout, --from-layout, "
                                        "--precision, --size and --brdf are for tables"});
  const std::string extension = std::filesystem::path(arguments.output).extension().string();
  if (extension == ".cpp" || extension == ".inc") // the source of the built-in, no container
    return fail("convert",
                Error{arguments.output + ": a polynomial is written as .json .h .glsl .hlsl .wgsl "
                                         "or .js"},
                k_exit_usage);
  if (Status status = table::check_polynomial_extension(arguments.output); !status)
    return fail("convert", status.error(), k_exit_usage);
  const Result<table::LobePolynomial> polynomial = table::read_polynomial(arguments.input);
  if (!polynomial) return fail("convert", polynomial.error());
  if (Status status = check_places({arguments.output}); !status)
    return fail("convert", status.error());
  if (Status status = table::write_polynomial(*polynomial, arguments.output); !status)
    return fail("convert", status.error());
  if (!arguments.quiet) say("wrote {}\n", arguments.output);
  return k_exit_ok;
}

int convert_lights(const ConvertArguments& arguments) {
  const bool is_scene = is_scene_file(arguments.input);
  const bool asks_for_table = arguments.layout || arguments.from_layout || arguments.precision ||
                              arguments.size > 0 || !arguments.brdf.empty();
  if (asks_for_table)
    return fail("convert",
                Error{fmt::format("{}: holds {}; --layout, --from-layout, --precision, --size and "
                                  "--brdf are for tables",
                                  arguments.input, is_scene ? "a scene" : "photometry")});
  const Status status =
      is_scene ? convert_scene(arguments.input, arguments.output, arguments.emissive,
                               arguments.reading, arguments.quiet)
               : convert_photometry(arguments.input, arguments.output, arguments.quiet);
  return status.ok() ? k_exit_ok : fail("convert", status.error());
}

int convert_to_picture(const ConvertArguments& arguments) {
  if (arguments.asks_for_layout())
    return fail("convert",
                Error{arguments.input + ": holds a picture; --layout, --from-layout, --size and "
                                        "--brdf are for tables"},
                k_exit_usage);
  PictureConversion picture = arguments.picture;
  if (arguments.precision == Precision::float16)
    picture.precision = image::ExrPrecision::half_float;
  const Status status =
      convert_picture(arguments.input, arguments.output, picture, arguments.quiet);
  return status.ok() ? k_exit_ok : fail("convert", status.error());
}

int run_convert(const ConvertArguments& arguments) {
  const bool asks = arguments.asks_for_picture();
  if (asks || (!arguments.asks_for_layout() && is_picture_file(arguments.input, arguments.output)))
    return convert_to_picture(arguments);
  if (table::is_polynomial_file(arguments.input)) return convert_polynomial(arguments);
  if (is_scene_file(arguments.input) || light::is_photometric_name(arguments.input))
    return convert_lights(arguments);
  if (Status status = table::check_packed_extension(arguments.output); !status)
    return fail("convert", status.error(), k_exit_usage);
  const Result<table::PackedTable> read =
      table::read_packed(arguments.input, arguments.from_layout);
  if (!read) return fail("convert", read.error());
  table::PackedTable from = *read;
  if (!arguments.brdf.empty()) {
    from.metadata.brdf = arguments.brdf;
    if (from.metadata.variant.empty())
      from.metadata.variant = brdf::find_brdf(arguments.brdf)->variant;
  }
  if (Status status =
          check_places(packed_files(arguments.layout.value_or(from.layout), arguments.output));
      !status)
    return fail("convert", status.error());

  Result<table::PackedTable> to = convert(from, arguments);
  if (!to)
    return fail("convert", Error{fmt::format("{}: {}", arguments.input, to.error().message)});
  const bool changed = to->layout != from.layout || to->precision != from.precision ||
                       to->columns() != from.columns() || to->rows() != from.rows();
  if (changed || (to->metadata.mean_tv == 0 && !arguments.brdf.empty())) restate_errors(*to);
  if (changed) {
    to->metadata.command = command_of(*to, arguments.size);
    to->metadata.tool_version = OPENLTC_VERSION;
  }
  const auto written = write_packed(*to, arguments.output);
  if (!written) return fail("convert", written.error());
  if (arguments.quiet) return k_exit_ok;
  for (const std::string& file : *written)
    say("wrote {}\n", file);
  const std::string note = fit::size_note(*to);
  if (!note.empty()) say("{}\n", note);
  return k_exit_ok;
}

} // namespace

void add_convert(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand(
      "convert", "Convert a lobe table to another layout, a scene's lights to EXT_lights_area, "
                 "photometric files, or a picture to another format");
  command->footer(
      "The container is that of the extension of OUT: .dds .ktx2 .exr .npy .json, and as source\n"
      ".h (C and C++) .glsl .hlsl .wgsl .js. A table of two textures becomes OUT_1 and OUT_2 in\n"
      "the first four. A .dds or .npy says what it is in OUT.dds.json beside it; the others "
      "inside.\n"
      "A polynomial (.json) becomes .h .glsl .hlsl .wgsl .js, a function to paste.\n"
      "Layouts: native; ltc_code (three.js, Babylon.js, Bevy, EEVEE); unity (HDRP);\n"
      "godot; o3de. The error is measured again, through the look-up of the new layout.\n"
      "A scene (.gltf .glb) becomes a .glb whose rectangular and round lights, those of emissive\n"
      "surfaces and of nodes' extras, are EXT_lights_area, and those with a photometric file\n"
      "EXT_lights_ies; everything else stays in it. A photometric file (.ies .ldt) becomes an\n"
      ".ies of LM-63-2002.\n"
      "A picture (.exr .hdr .png .jpg .webp) becomes .exr, .hdr or .png. From linear to .png it is "
      "exposed\n"
      "and tone-mapped as by render, from .png or .jpg to .exr and .hdr decoded to linear light. "
      "Of\n"
      "an .exr one layer is taken, by --layer NAME or FILE.exr:NAME. An .exr that says that it is "
      "a\n"
      "table, or is to be made .dds or such, is taken for one.\n"
      "\n"
      "Examples:\n"
      "  openltc convert ggx.json ggx.dds --layout ltc_code\n"
      "  openltc convert ggx.json ggx.ktx2 --layout o3de --size 32\n"
      "  openltc convert ltc_1.dds ltc.exr --from-layout ltc_code --brdf ggx\n"
      "  openltc convert room.gltf room_lights.glb --recognise-shapes\n"
      "  openltc convert blender.exr:ViewLayer.Combined picture.png --exposure 10\n"
      "  openltc convert lamp.ldt lamp.ies");
  Choices<Layout> layouts;
  for (const Layout layout : table::all_layouts())
    layouts.emplace_back(name_of(layout), layout);
  const Choices<Precision> precisions = {{name_of(Precision::float32), Precision::float32},
                                         {name_of(Precision::float16), Precision::float16}};
  std::vector<std::string> brdfs;
  for (const brdf::Brdf& b : brdf::all_brdfs())
    brdfs.push_back(b.name);
  command
      ->add_option(
          "input", arguments->input,
          "Table: .json .dds .ktx2 .exr .npy; scene: .gltf .glb; photometry: .ies .ldt; or "
          "picture: .exr .hdr .png .jpg .webp")
      ->required();
  command->add_option("output", arguments->output, "File to write")->required();
  add_choice(*command, "--layout", arguments->layout,
             "Layout to write; that of the input if not given", layouts);
  add_choice(*command, "--precision", arguments->precision,
             "Numbers to write; as the input if not given, float32 for pictures", precisions);
  add_choice(*command, "--from-layout", arguments->from_layout,
             "Layout of a bare texture, which does not say what it is", layouts);
  command
      ->add_option("--size", arguments->size,
                   "Nodes per axis to write, 2 to 512; as the input if not given")
      ->transform(whole_number(2, 512));
  command->add_option("--brdf", arguments->brdf, "BRDF of a bare texture")
      ->check(CLI::IsMember(brdfs));
  command->add_option("--layer", arguments->picture.layer,
                      "Of an .exr, the layer to convert; openltc inspect lists them");
  command
      ->add_option("--exposure", arguments->picture.exposure,
                   "For a .png from .exr or .hdr: EV100, or auto [auto]")
      ->check(CLI::Validator(check_exposure, "EV100|auto"));
  const Choices<image::Tonemap> tonemaps = {{"neutral", image::Tonemap::neutral},
                                            {"aces", image::Tonemap::aces},
                                            {"none", image::Tonemap::none}};
  add_choice(*command, "--tonemap", arguments->picture.tonemap,
             "The same: its tone curve [neutral]", tonemaps);
  add_shape_options(*command, arguments->emissive);
  add_reading_options(*command, arguments->reading);
  command->add_flag("--quiet", arguments->quiet, "No messages on stderr");
  command->callback([arguments, &exit_code] { exit_code = run_convert(*arguments); });
}

} // namespace openltc::cli
