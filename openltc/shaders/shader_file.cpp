// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/shader_file.h"

#include "openltc/shaders/arguments.h"
#include "openltc/shaders/lobe_constants.h"
#include "openltc/shaders/parser.h"
#include "openltc/shaders/quads.h"
#include "openltc/shaders/reach.h"
#include "openltc/shaders/shader_head.h"
#include "openltc/shaders/simplify.h"
#include "openltc/shaders/sources.h"
#include "openltc/shaders/writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace openltc::shaders {

namespace {

bool has(const ShaderRequest& request, Shape shape) {
  return std::find(request.shapes.begin(), request.shapes.end(), shape) != request.shapes.end();
}

std::string text_of(const std::string& path) {
  for (const EmbeddedFile& file : embedded_files())
    if (path == file.path) return file.text;
  return {};
}

// The files of openltc/shade in the order in which they build on each other.
std::vector<std::string> shading_paths() {
  std::vector<std::string> paths;
  const std::string list = text_of("openltc/target/shade_all.inc");
  const std::string include = "#include \"";
  for (std::size_t at = list.find(include); at != std::string::npos; at = list.find(include, at)) {
    at += include.size();
    paths.push_back(list.substr(at, list.find('"', at) - at));
  }
  return paths;
}

std::string stem_of(const std::string& path) {
  const std::size_t begin = path.rfind('/') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

Status parse_into(std::vector<SourceFile>& files, const std::string& path) {
  Result<SourceFile> file = parse_file(text_of(path), path);
  if (!file) return file.error();
  file->name = stem_of(path);
  files.push_back(std::move(*file));
  return Success{};
}

// The files of dialect/ that stand before the maths, and after it.
std::vector<std::string> data_files(const ShaderRequest& request) {
  std::vector<std::string> names;
  if (!is_constant(request.lobe)) names.push_back("table_data");
  if (has(request, Shape::quad) || has(request, Shape::textured)) names.push_back("quad_data");
  if (has(request, Shape::polygon)) names.push_back("polygon_data");
  if (has(request, Shape::textured)) names.push_back("picture_data");
  return names;
}

std::vector<std::string> entry_files(const ShaderRequest& request) {
  constexpr const char* k_surfaces[] = {"polynomial_surface", "two_lobe_polynomial_surface",
                                        "table_surface", "two_lobe_table_surface"};
  std::vector<std::string> names = {k_surfaces[int(request.lobe)], "gltf_surface", "lights"};
  if (has(request, Shape::textured)) names.push_back("textured");
  if (request.sampling) names.push_back("sampling");
  return names;
}

// What functions of a light have in their names.
constexpr const char* light_of(Shape shape) {
  constexpr const char* k_lights[] = {"quad", "polygon", "ellipse", "sphere",
                                      "tube", "line",    "quad"};
  return k_lights[int(shape)];
}

Roots roots_of(const ShaderRequest& request) {
  Roots roots = {{"surface_at", "gltf_surface"}, {"Quad", "Ellipse", "Sphere", "Tube", "Line"}};
  const auto add = [&](std::initializer_list<const char*> names) {
    roots.functions.insert(names.begin(), names.end());
  };
  if (!request.lean) add({"set_geometric_normal", "correct_at_mean"});
  bool parts = false;
  for (const Shape shape : request.shapes) {
    if (shape != Shape::textured) parts = true;
    switch (shape) {
    case Shape::quad:
      add({"make_quad", "shade_quad", "shade_quad_parts"});
      break;
    case Shape::polygon:
      add({"shade_polygon", "shade_polygon_parts"});
      break;
    case Shape::disk:
      add({"make_disk", "make_ellipse", "shade_ellipse", "shade_ellipse_parts"});
      break;
    case Shape::sphere:
      add({"make_sphere", "shade_sphere", "shade_sphere_parts"});
      break;
    case Shape::tube:
      add({"make_tube", "shade_tube", "shade_tube_parts"});
      break;
    case Shape::line:
      add({"make_line", "shade_line", "shade_line_parts"});
      break;
    case Shape::textured:
      add({"make_quad", "shade_textured_quad"});
      break;
    }
  }
  if (parts) roots.structs.insert("ShadedLight");
  if (request.sampling) {
    roots.structs.insert("LightPoint");
    add({"point_density", "eval_point"});
    for (const Shape shape : request.shapes) {
      const std::string light = light_of(shape);
      roots.functions.insert("draw_" + light);
      if (shape == Shape::line) continue;
      roots.functions.insert("meet_" + light);
      add({"lobe_direction"});
    }
  }
  return roots;
}

Handles handles_of(const ShaderRequest& request) {
  const Words& words = words_of(request.language);
  const bool samplers = *words.sampler != '\0';
  const auto with_sampler = [&](std::vector<HandlePart> parts, const std::string& suffix) {
    if (samplers) parts.push_back({words.sampler, suffix + "_sampler"});
    return parts;
  };
  std::vector<HandlePart> table = {{words.texture, "_coefficients"},
                                   {words.texture, "_amplitudes"}};
  if (request.lobe == Lobe::two_lobe) table.push_back({words.texture, "_second"});
  Handles handles;
  handles["LobePolynomial"] = {};
  handles["LobeTable"] = with_sampler(std::move(table), "");
  handles["Lobes"] = handles[is_constant(request.lobe) ? "LobePolynomial" : "LobeTable"];
  handles["Polygon"] = {{words.polygon, ""}};
  handles["Picture"] = with_sampler({{words.texture, ""}}, "");
  handles["EmissionTexture"] =
      with_sampler({{"Quad", ""}, {words.texture, "_picture"}}, "_picture");
  return handles;
}

// All that may be in the file, in its order.
Result<std::vector<SourceFile>> read_source(const ShaderRequest& request) {
  std::vector<SourceFile> maths;
  for (const std::string& path : shading_paths())
    if (Status status = parse_into(maths, path); !status) return status.error();
  if (has(request, Shape::quad) || has(request, Shape::textured)) add_quad_functions(maths);
  drop_quad_case(maths);
  if (is_constant(request.lobe))
    if (Status status = set_lobe_constants(maths, has_two(request.lobe)); !status)
      return status.error();
  std::vector<SourceFile> files = {std::move(maths[0])}; // constants
  const auto add = [&](const std::vector<std::string>& names) -> Status {
    for (const std::string& name : names)
      if (Status status = parse_into(files, "openltc/shaders/dialect/" + name + ".glsl"); !status)
        return status;
    return Success{};
  };
  if (Status status = add(data_files(request)); !status) return status.error();
  for (std::size_t i = 1; i < maths.size(); ++i)
    files.push_back(std::move(maths[i]));
  if (Status status = add(entry_files(request)); !status) return status.error();
  return files;
}

// What a language wants before the first function.
constexpr const char* k_glsl_es_preamble = R"(precision highp float;
precision highp int;
precision highp sampler2D;

// c ? a : b, a && b and a || b, of which all is computed. Browsers make branches of the signs, and many of them
// in a loop take SwiftShader minutes to compile.
float {ltc}select(bool c, float a, float b) {{ return mix(b, a, c); }}
vec2 {ltc}select(bool c, vec2 a, vec2 b) {{ return mix(b, a, bvec2(c)); }}
vec3 {ltc}select(bool c, vec3 a, vec3 b) {{ return mix(b, a, bvec3(c)); }}
vec4 {ltc}select(bool c, vec4 a, vec4 b) {{ return mix(b, a, bvec4(c)); }}
int {ltc}select(bool c, int a, int b) {{ return int(c) * a + int(!c) * b; }}
bool {ltc}select(bool c, bool a, bool b) {{ return bool(int(c) * int(a) + int(!c) * int(b)); }}
bool {ltc}both_hold(bool a, bool b) {{ return all(bvec2(a, b)); }}
bool {ltc}either_holds(bool a, bool b) {{ return any(bvec2(a, b)); }}

)";

std::string preamble(const ShaderRequest& request, bool sizes) {
  if (request.language == Language::glsl_es)
    return fmt::format(k_glsl_es_preamble, fmt::arg("ltc", request.prefix));
  if (request.language == Language::metal)
    return "#include <metal_stdlib>\nusing namespace metal;\n\n";
  if (request.language == Language::hlsl && sizes)
    return fmt::format("// Columns and rows of a texture.\n"
                       "float2 {}texture_size(Texture2D<float4> picture) {{\n"
                       "  uint columns, rows;\n"
                       "  picture.GetDimensions(columns, rows);\n"
                       "  return float2(columns, rows);\n}}\n\n",
                       request.prefix);
  return {};
}

std::string section(const SourceFile& file) {
  std::string title = "// ---- " + file.name + " ";
  std::replace(title.begin(), title.end(), '_', ' ');
  if (title.size() < 100) title += std::string(100 - title.size(), '-');
  std::string out = title + "\n";
  if (!file.opening.empty()) out += "//\n" + comment_lines(file.opening, 0);
  return out;
}

} // namespace

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes = {Shape::quad,    Shape::polygon, Shape::disk,
                                            Shape::sphere,  Shape::tube,    Shape::line,
                                            Shape::textured};
  return shapes;
}

std::string name_of(Shape shape) {
  constexpr const char* k_names[] = {"quad", "polygon", "disk",    "sphere",
                                     "tube", "line",    "textured"};
  return k_names[int(shape)];
}

std::string name_of(Lobe lobe) {
  constexpr const char* k_names[] = {"polynomial", "two-lobe-polynomial", "table", "two-lobe"};
  return k_names[int(lobe)];
}

Status check_prefix(const std::string& prefix) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto part_of_word = [&](char c) {
    return letter(c) || c == '_' || std::isdigit(static_cast<unsigned char>(c)) != 0;
  };
  if (prefix.empty() || !letter(prefix[0]) ||
      !std::all_of(prefix.begin(), prefix.end(), part_of_word) ||
      prefix.find("__") != std::string::npos || prefix.rfind("gl_", 0) == 0)
    return Error{
        fmt::format("'{}' cannot begin the names of a shader: it takes a letter, then letters, "
                    "digits and single underscores, and not gl_",
                    prefix)};
  return Success{};
}

std::string file_name(const ShaderRequest& request) {
  std::string name = request.prefix;
  if (name.back() != '_') name += '_';
  if (request.shapes.size() == all_shapes().size()) {
    name += "lights";
  } else {
    for (std::size_t i = 0; i < request.shapes.size(); ++i)
      name += (i > 0 ? "_" : "") + name_of(request.shapes[i]);
  }
  constexpr const char* k_lobes[] = {"", "_two_lobe_polynomial", "_table", "_two_lobe"};
  name += k_lobes[int(request.lobe)];
  if (request.lean) name += "_lean";
  if (request.sampling) name += "_sampling";
  if (request.language == Language::glsl_es) name += "_es";
  return name + words_of(request.language).extension;
}

Result<std::string> make_shader(const ShaderRequest& request) {
  Result<std::vector<SourceFile>> read = read_source(request);
  if (!read) return read.error();
  std::vector<SourceFile>& files = *read;

  Facts facts;
  facts.fields = {{"exact", false}, {"adaptive", false}, {"two", has_two(request.lobe)}};
  if (request.lean) facts.fields.insert({{"tilted", false}, {"corrected", false}});
  for (const SourceFile& file : files)
    note_integers(file, facts);
  for (SourceFile& file : files)
    for (Item& item : file.items)
      simplify(item, facts);
  do {
    keep_reached(files, roots_of(request));
  } while (settle_arguments(files, facts, roots_of(request).functions));

  std::set<std::string> globals = {"polygon_data", "texture_size"};
  bool sizes = false;
  for (const SourceFile& file : files)
    for (const Item& item : file.items) {
      globals.insert(item.name);
      walk(item.body, [&](const Node& node) { sizes = sizes || is_call(node, "texture_size"); });
    }
  const std::unique_ptr<Writer> writer =
      make_writer(request.language, request.prefix, handles_of(request), std::move(globals));
  std::string text = head_of(request) + "\n" + preamble(request, sizes);
  for (const SourceFile& file : files) {
    if (file.items.empty()) continue;
    text += section(file) + "\n";
    for (const Item& item : file.items)
      text += writer->item(item) + "\n";
  }
  text.pop_back();
  return text;
}

} // namespace openltc::shaders
