// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/shader_head.h"

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_table.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"
#include "openltc/api/ggx_two_lobes.inc"

#include <fmt/format.h>

namespace openltc::shaders {

namespace {

std::string joined_names(const std::vector<Shape>& shapes, const char* between) {
  std::string names;
  for (const Shape shape : shapes)
    names += (names.empty() ? "" : between) + name_of(shape);
  return names;
}

// Writes lines of a call in the words of a language.
class Calls {
public:
  explicit Calls(const ShaderRequest& request) : request_(request) {
    samplers_ = *words_of(request.language).sampler != '\0';
  }

  // Declares a value that a function of the file returns.
  std::string value(const std::string& type, const std::string& name,
                    const std::string& call) const {
    const auto& types = words_of(request_.language).types;
    const auto found = types.find(type);
    const std::string word = request_.language == Language::wgsl ? "let"
                             : found != types.end()              ? found->second
                                                                 : request_.prefix + type;
    return fmt::format("//   {} {} = {}{};\n", word, name, request_.prefix, call);
  }
  std::string sampler(const char* name) const {
    return samplers_ ? fmt::format(", {}_sampler", name) : "";
  }
  // What a surface takes of a table, before the rest.
  std::string table() const {
    if (is_constant(request_.lobe)) return {};
    return std::string("coefficients, amplitudes") +
           (request_.lobe == Lobe::two_lobe ? ", second" : "") + sampler("table") + ", ";
  }
  std::string light(const char* radiance, const std::string& call) const {
    return fmt::format("//   light += {} * {}shade_{};\n", radiance, request_.prefix, call);
  }

  std::string shape(Shape shape) const {
    switch (shape) {
    case Shape::quad:
      return value("Quad", "lamp", "make_quad(center, half_u, half_v, 0.0)") +
             light("radiance", "quad(surface, lamp)");
    case Shape::polygon:
      return light("radiance", "polygon(surface, outline)");
    case Shape::disk:
      return value("Ellipse", "disk", "make_disk(center, normal_of_disk, radius, 0.0)") +
             light("radiance", "ellipse(surface, disk)");
    case Shape::sphere:
      return value("Sphere", "ball", "make_sphere(center, radius)") +
             light("radiance", "sphere(surface, ball)");
    case Shape::tube:
      return value("Tube", "rod", "make_tube(one_end, other_end, radius, 2.0)") +
             light("radiance", "tube(surface, rod)");
    case Shape::line:
      return value("Line", "wire", "make_line(one_end, other_end)") +
             light("intensity_per_metre", "line(surface, wire)");
    default:
      return value("Quad", "screen", "make_quad(center, half_u, half_v, 0.0)") +
             light("radiance", "textured_quad(surface, screen, picture" + sampler("picture") + ")");
    }
  }

  // A point of the light that shape() declares.
  std::string point(Shape shape) const {
    constexpr const char* k_draws[] = {"quad(lamp",   "polygon(outline", "ellipse(disk",
                                       "sphere(ball", "tube(rod",        "line(wire",
                                       "quad(screen"};
    constexpr const char* k_points[] = {"on_lamp", "on_outline", "on_disk",  "on_ball",
                                        "on_rod",  "on_wire",    "on_screen"};
    const std::string name = k_points[int(shape)];
    return value("LightPoint", name,
                 fmt::format("draw_{}, position, random)", k_draws[int(shape)])) +
           fmt::format("//   sampled += {0}eval_point(surface, {1}, {0}point_density(surface, {1}, "
                       "0.0));\n",
                       request_.prefix, name);
  }

private:
  const ShaderRequest& request_;
  bool samplers_ = false;
};

std::string lobe_lines(const ShaderRequest& request) {
  const auto error = [](const LobeMetadata& m) {
    return fmt::format(
        "//        total variation {:.3f} in the mean, {:.2f} at most, which bounds the "
        "error of every light\n//        (docs/fitting.md).\n",
        m.mean_tv, m.max_tv);
  };
  const std::string bound = "from textures that you bind: see \"table data\" below. Those of\n";
  switch (request.lobe) {
  case Lobe::polynomial:
    return fmt::format(
        "// Lobe   one, by polynomials of degree {} in this file: no texture. It differs "
        "from the BRDF by a\n{}",
        k_ggx_polynomial_degree, error(k_ggx_polynomial_metadata));
  case Lobe::two_lobe_polynomial:
    return fmt::format("// Lobes  two, by polynomials of degree {} in this file: no texture. They "
                       "differ from the BRDF by a\n{}",
                       k_ggx_two_lobe_polynomial_degree, error(k_ggx_two_lobe_polynomial_metadata));
  case Lobe::table:
    return fmt::format("// Lobe   one, {}//        `{} -o ggx.dds` differ from the BRDF by a\n{}",
                       bound, k_ggx_table_metadata.command, error(k_ggx_table_metadata));
  default:
    return fmt::format("// Lobes  two, {}//        `{} -o ggx.dds`\n"
                       "//        differ from the BRDF by a\n{}",
                       bound, k_ggx_two_lobes_metadata.command, error(k_ggx_two_lobes_metadata));
  }
}

std::string polygon_lines(const ShaderRequest& request) {
  if (request.language == Language::metal)
    return "// `outline` points at a polygon's first element: see \"polygon data\" below.\n";
  const std::string declared =
      request.language == Language::wgsl
          ? fmt::format("fn {}polygon_data(i: i32) -> vec4f", request.prefix)
          : fmt::format("{} {}polygon_data(int i)", words_of(request.language).types.at("Vec4"),
                        request.prefix);
  return fmt::format("// Polygons are read by a function of yours, which stands before this file:\n"
                     "//   {}   element i of what \"polygon data\" below says\n"
                     "// `outline` is the index of a polygon's first element.\n",
                     declared);
}

} // namespace

std::string command_of(const ShaderRequest& request) {
  std::string command = "openltc shaders --language " + name_of(request.language);
  if (request.lobe != Lobe::polynomial) command += " --lobe " + name_of(request.lobe);
  command += " --shapes " + (request.shapes.size() == all_shapes().size()
                                 ? std::string("all")
                                 : joined_names(request.shapes, ","));
  if (request.lean) command += " --lean";
  if (request.sampling) command += " --sampling";
  if (request.prefix != "ltc_") command += " --prefix " + request.prefix;
  return command;
}

std::string head_of(const ShaderRequest& request) {
  const Calls calls(request);
  const std::string& prefix = request.prefix;
  std::string out =
      "// Copyright (c) 2026 The OpenLTC authors\n// SPDX-License-Identifier: MIT\n//\n";
  out += fmt::format("// Area lights in closed form, by linearly transformed cosines (LTC).\n"
                     "// Language: {}. Shapes: {}.\n//\n",
                     words_of(request.language).title, joined_names(request.shapes, ", "));
  out += fmt::format(
      "// Made by OpenLTC {} from its shading source, and readable and yours to change like that:\n"
      "//   {}\n//\n",
      request.version, command_of(request));
  out +=
      "// BRDF   GGX with height-correlated Smith masking and Schlick's Fresnel, over Lambert.\n";
  out += lobe_lines(request) + "//\n// How to call it:\n";
  out += calls.value("Surface", "surface",
                     "gltf_surface(" + calls.table() +
                         "position, normal, view, base_color, metallic, roughness)");
  for (const Shape shape : request.shapes)
    out += calls.shape(shape) + (request.sampling ? calls.point(shape) : "");
  out += "// `normal`, on the viewer's side, and `view`, to the eye, are unit and in world space, "
         "like all else;\n"
         "// a lamp emits along half_u x half_v. The result has no shadow. "
         "One `surface` serves all lights.\n";
  if (request.sampling)
    out += "// `sampled` is the light by one point of each, for shadows: see \"sampling\" below.\n";
  for (const Shape shape : request.shapes)
    if (shape == Shape::polygon) out += polygon_lines(request);
  out += fmt::format(
      "//\n// More:\n"
      "//   {0}surface_at              a surface of any reflectance, instead of glTF's\n{1}{2}{3}",
      prefix,
      request.lean
          ? ""
          : fmt::format(
                "//   {0}set_geometric_normal    where a normal map turns the normal: hides "
                "what the triangle does\n"
                "//   {0}correct_at_mean         small lights become exact, for a few "
                "instructions more\n",
                prefix),
      request.shapes == std::vector<Shape>{Shape::textured}
          ? ""
          : fmt::format("//   {}shade_..._parts         diffuse and specular light apart\n",
                        prefix),
      request.sampling && request.shapes != std::vector<Shape>{Shape::line}
          ? fmt::format("//   {0}meet_..., {0}lobe_direction   points by the surface's lobe\n",
                        prefix)
          : "");
  out += fmt::format("//\n// Comments are those of the source: names have no {} there, a lane is "
                     "an invocation, and files that\n"
                     "// they name are OpenLTC's, as is docs/method.md, where all is derived.\n",
                     prefix);
  return out;
}

} // namespace openltc::shaders
