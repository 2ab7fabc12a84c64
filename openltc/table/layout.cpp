// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources of the conventions, each read in the project's own shader: ltc_code, webgl/shaders/ltc/
// ltc_quad.fs; Unity Graphics, com.unity.render-pipelines.high-definition/Runtime/Material/
// LTCAreaLight; Godot, servers/rendering/renderer_rd/shaders/area_lights_inc.glsl; O3DE, Gems/Atom/
// Feature/Common/Assets/ShaderLib/Atom/Features/PBR/Lights/Ltc.azsli.

#include "openltc/table/layout.h"

#include "openltc/table/lookup.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace openltc::table {

namespace {

constexpr std::array k_layouts = {Layout::native, Layout::ltc_code, Layout::unity, Layout::godot,
                                  Layout::o3de};
constexpr std::array k_names = {"native", "ltc_code",   "unity",         "godot",
                                "o3de",   "native_two", "ltc_code_alpha"};
constexpr std::array k_unasked = {Layout::native_two, Layout::ltc_code_alpha};

} // namespace

double node_roughness(int columns, int column) {
  return columns > 1 ? double(column) / (columns - 1) : 1.0;
}

double node_width(brdf::LobeWidth width, int columns, int column) {
  return factored_width(width, node_roughness(columns, column));
}

std::span<const Layout> all_layouts() { return k_layouts; }

const char* name_of(Layout layout) { return k_names[std::size_t(layout)]; }

const char* name_of(Precision precision) {
  return precision == Precision::float32 ? "float32" : "float16";
}

const char* name_of(AngleAxis axis) {
  return axis == AngleAxis::theta ? "theta" : "sqrt(1 - cos theta)";
}

const Layout* find_layout(std::string_view name) {
  for (const Layout& layout : k_layouts)
    if (name == name_of(layout)) return &layout;
  for (const Layout& layout : k_unasked)
    if (name == name_of(layout)) return &layout;
  return nullptr;
}

const LayoutFacts& facts_of(Layout layout) {
  constexpr AngleAxis root = AngleAxis::sqrt_one_minus_cos;
  static const std::array<LayoutFacts, k_names.size()> facts = {
      LayoutFacts{root,
                  true,
                  0,
                  "OpenLTC",
                  "mirror frame: M^-1 = [A 0 wB; 0 1 0; wC 0 wD] on (x', y, z'), x' = (cos, 0, "
                  "sin), z' = (-sin, 0, cos); w = alpha, or 1 where width is one",
                  {{"A", "B", "C", "D"}, {"n1", "n5", "0", "0"}}},
      LayoutFacts{root,
                  true,
                  64,
                  "ltc_code, three.js, Babylon.js, Bevy, EEVEE",
                  "M^-1 divided by its middle element M11",
                  {{"M00", "M20", "M02", "M22"}, {"n1", "n5", "0", "clipped sphere"}}},
      LayoutFacts{
          root, false, 64, "Unity HDRP", "M^-1 divided by M22", {{"M00", "M20", "M11", "M02"}}},
      LayoutFacts{AngleAxis::theta,
                  true,
                  64,
                  "Godot",
                  "M = [a 0 d; 0 c 0; b 0 e], its third column of length 1",
                  {{"a", "b", "c", "d"}, {"e", "n1", "n5", "0"}}},
      LayoutFacts{AngleAxis::theta,
                  true,
                  32,
                  "O3DE",
                  "M^-1 divided by M00",
                  {{"M22", "M20", "M11", "M02"}, {"n1", "n5"}}},
      LayoutFacts{root,
                  true,
                  0,
                  "OpenLTC",
                  "mirror frame: M^-1 = [A 0 wB; 0 1 0; wC 0 wD] on (x', y, z'), x' = (cos, 0, "
                  "sin), z' = (-sin, 0, cos); w = alpha, or 1 where width is one; the second "
                  "lobe has the share weight of n1, the first the rest",
                  {{"A", "B", "C", "D"}, {"n1", "n5", "weight", "0"}, {"A2", "B2", "C2", "D2"}}},
      LayoutFacts{root,
                  true,
                  64,
                  "PlayCanvas, Ogre-Next",
                  "M^-1 divided by its middle element M11",
                  {{"M00", "M20", "M02", "M22"}, {"n1", "n5", "0", "clipped sphere"}}},
  };
  return facts[std::size_t(layout)];
}

AngleAxis angle_axis_of(Layout layout) { return facts_of(layout).angle_axis; }

double row_cosine(Layout layout, AngleAxis axis, int rows, int row) {
  if (row + 1 < rows) return cosine_of_coordinate(layout, axis, double(row) / (rows - 1));
  if (is_native(layout)) return 0;
  return 0.03 * cosine_of_coordinate(layout, axis, double(rows - 2) / (rows - 1));
}

f64::FittedLobe lobe_of_texel(Layout layout, std::span<const double> first,
                              std::span<const double> second, double width, double cos_theta) {
  f64::FittedLobe fitted;
  fitted.n1 = 1;
  fitted.n5 = 0;
  if (layout != Layout::unity) {
    const std::size_t at = layout == Layout::godot ? 1 : 0;
    fitted.n1 = second[at];
    fitted.n5 = second[at + 1];
  }
  const double x = first[0], y = first[1], z = first[2], w = first[3];
  switch (layout) {
  case Layout::native:
  case Layout::native_two:
    fitted.lobe = f64::lobe_from_mirror({x, y, z, w}, width, cos_theta);
    break;
  case Layout::ltc_code:
  case Layout::ltc_code_alpha:
    fitted.lobe = f64::make_lobe(x, z, y, w);
    break;
  case Layout::unity:
    fitted.lobe = f64::make_lobe(x / z, w / z, y / z, 1 / z);
    break;
  case Layout::godot: {
    const double e = second[0], scale = z / (x * e - y * w); // M11 / (M00 M22 - M20 M02)
    fitted.lobe = f64::make_lobe(e * scale, -w * scale, -y * scale, x * scale);
    break;
  }
  case Layout::o3de:
    fitted.lobe = f64::make_lobe(1 / z, w / z, y / z, x / z);
    break;
  }
  return fitted;
}

Status check_textures(const std::string& name, Layout layout, std::span<const Texture> textures) {
  const LayoutFacts& facts = facts_of(layout);
  if (textures.size() != facts.channels.size())
    return Error{fmt::format("{}: layout {} has {} texture(s), not {}", name, name_of(layout),
                             facts.channels.size(), textures.size())};
  for (std::size_t t = 0; t < textures.size(); ++t) {
    if (std::size_t(textures[t].channels) != facts.channels[t].size())
      return Error{fmt::format("{}: texture {} has {} channels, but layout {} has {} there", name,
                               t + 1, textures[t].channels, name_of(layout),
                               facts.channels[t].size())};
    if (textures[t].width != textures[0].width || textures[t].height != textures[0].height)
      return Error{fmt::format("{}: the textures have {} x {} and {} x {} texels; they must agree",
                               name, textures[0].width, textures[0].height, textures[t].width,
                               textures[t].height)};
    if (textures[t].precision != textures[0].precision)
      return Error{fmt::format("{}: one texture is in half and one in single precision", name)};
  }
  if (textures[0].height < 2)
    return Error{fmt::format("{}: a table has at least 2 rows over the view angle", name)};
  return Success{};
}

} // namespace openltc::table
