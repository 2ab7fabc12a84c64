// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Sources of the conventions, each read in the project's own shader: ltc_code, webgl/shaders/ltc/
// ltc_quad.fs; Unity Graphics, com.unity.render-pipelines.high-definition/Runtime/Material/
// LTCAreaLight; Godot, servers/rendering/renderer_rd/shaders/area_lights_inc.glsl; O3DE, Gems/Atom/
// Feature/Common/Assets/ShaderLib/Atom/Features/PBR/Lights/Ltc.azsli.

#include "openltc/table/layout.h"

#include "openltc/table/clipped_sphere.h"
#include "openltc/table/half.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc::table {

namespace {

constexpr std::array k_layouts = {Layout::native, Layout::ltc_code, Layout::unity, Layout::godot,
                                  Layout::o3de};
constexpr std::array k_names = {"native", "ltc_code", "unity", "godot", "o3de"};

double width_of(brdf::LobeWidth width, double roughness) {
  return width == brdf::LobeWidth::alpha ? f64::alpha_from_roughness(roughness) : 1.0;
}

double angle_coordinate(AngleAxis axis, double cos_theta) {
  const double c = std::clamp(cos_theta, 0.0, 1.0);
  return axis == AngleAxis::theta ? std::acos(c) / (0.5 * f64::k_pi) : std::sqrt(1 - c);
}

// Godot's arc cosine, whose error reaches .5 degrees.
double godot_acos(double x) {
  return (-0.156583 * x + 0.5 * f64::k_pi) * std::sqrt(std::max(1 - x, 0.0));
}

// The channels of a node; lobe_of_texel is the inverse. `native` holds A B C D.
void store_texel(Layout layout, const f64::Lobe& m, Vec4d native, double n1, double n5,
                 double* first, double* second) {
  switch (layout) {
  case Layout::native:
    std::copy_n(std::array{native.x, native.y, native.z, native.w}.data(), 4, first);
    std::copy_n(std::array{n1, n5, 0.0, 0.0}.data(), 4, second);
    return;
  case Layout::ltc_code: // the fourth channel of the second texture is not a node's
    std::copy_n(std::array{m.m00, m.m20, m.m02, m.m22}.data(), 4, first);
    std::copy_n(std::array{n1, n5, 0.0}.data(), 3, second);
    return;
  case Layout::unity:
    std::copy_n(std::array{m.m00 / m.m22, m.m20 / m.m22, 1 / m.m22, m.m02 / m.m22}.data(), 4,
                first);
    return;
  case Layout::godot: {
    // M is the adjugate of M^-1 up to scale, its third column (-m02, 0, m00).
    const double scale = 1 / std::hypot(m.m00, m.m02);
    std::copy_n(std::array{m.m22 * scale, -m.m20 * scale, m.det * scale, -m.m02 * scale}.data(), 4,
                first);
    std::copy_n(std::array{m.m00 * scale, n1, n5, 0.0}.data(), 4, second);
    return;
  }
  case Layout::o3de:
    std::copy_n(std::array{m.m22 / m.m00, m.m20 / m.m00, 1 / m.m00, m.m02 / m.m00}.data(), 4,
                first);
    std::copy_n(std::array{n1, n5}.data(), 2, second);
    return;
  }
}

// The element of the first texture that raises the determinant when it goes up.
int determinant_channel(Layout layout) {
  return layout == Layout::native || layout == Layout::ltc_code ? 3 : 0;
}

// Rounds the textures to half precision and keeps the determinants positive.
Status round_to_half(PackedTable& packed) {
  for (std::size_t t = 0; t < packed.textures.size(); ++t) {
    Texture& texture = packed.textures[t];
    for (std::size_t i = 0; i < texture.values.size(); ++i) {
      const float rounded = rounded_to_half(texture.values[i]);
      if (!std::isfinite(rounded)) {
        const std::size_t texel = i / std::size_t(texture.channels);
        return Error{fmt::format(
            "layout {}: texel ({}, {}) of texture {}, channel {}, is {:g}, beyond the {} of half "
            "precision; choose --precision float32",
            name_of(packed.layout), texel % std::size_t(texture.width),
            texel / std::size_t(texture.width), t + 1, i % std::size_t(texture.channels),
            texture.values[i], k_half_max)};
      }
      texture.values[i] = rounded;
    }
  }
  return Success{};
}

double determinant(const PackedTable& packed, int column, int row);

// Moves one element of the texel up, half by half, until the determinant is positive.
Status repair_determinant(PackedTable& packed, int column, int row) {
  Texture& first = packed.textures[0];
  float& value = first.values[std::size_t((row * first.width + column) * first.channels +
                                          determinant_channel(packed.layout))];
  for (int step = 0; step < 1024 && value >= 0 && value < k_half_max; ++step) {
    if (determinant(packed, column, row) > 0) return Success{};
    value = float_from_half(std::uint16_t(half_from_float(value) + 1));
  }
  return Error{fmt::format("layout {}: the lobe of node ({}, {}) has no positive determinant in {}",
                           name_of(packed.layout), column, row, name_of(packed.precision))};
}

f64::FittedLobe lobe_of_node(const PackedTable& packed, int column, int row) {
  std::array<double, 4> channels[2] = {};
  for (std::size_t t = 0; t < packed.textures.size(); ++t) {
    const Texture& texture = packed.textures[t];
    for (int k = 0; k < texture.channels; ++k)
      channels[t][std::size_t(k)] = double(
          texture.values[std::size_t((row * texture.width + column) * texture.channels + k)]);
  }
  const double roughness = node_roughness(packed.columns(), column);
  return lobe_of_texel(packed.layout, channels[0], channels[1], width_of(packed.width, roughness),
                       row_cosine(packed.layout, packed.angle_axis, packed.rows(), row));
}

double determinant(const PackedTable& packed, int column, int row) {
  const double det = lobe_of_node(packed, column, row).lobe.det;
  return std::isfinite(det) ? det : 0;
}

} // namespace

double node_roughness(int columns, int column) {
  return columns > 1 ? double(column) / (columns - 1) : 1.0;
}

double node_width(brdf::LobeWidth width, int columns, int column) {
  return width_of(width, node_roughness(columns, column));
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
  return nullptr;
}

const LayoutFacts& facts_of(Layout layout) {
  constexpr AngleAxis root = AngleAxis::sqrt_one_minus_cos;
  static const std::array<LayoutFacts, k_layouts.size()> facts = {
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
                  "ltc_code, three.js, Babylon.js, Bevy, PlayCanvas, EEVEE",
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
  };
  return facts[std::size_t(layout)];
}

AngleAxis angle_axis_of(Layout layout) { return facts_of(layout).angle_axis; }

double row_cosine(Layout layout, AngleAxis axis, int rows, int row) {
  const auto cosine = [&](int j) {
    const double y = double(j) / (rows - 1);
    return axis == AngleAxis::theta ? std::cos(0.5 * f64::k_pi * y) : 1 - y * y;
  };
  if (row + 1 < rows) return cosine(row);
  if (layout == Layout::native) return 0;
  return 0.03 * cosine(rows - 2);
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
    fitted.lobe = f64::lobe_from_mirror({x, y, z, w}, width, cos_theta);
    break;
  case Layout::ltc_code:
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

Result<PackedTable> pack(const LobeTable& table, Layout layout, Precision precision) {
  const LayoutFacts& facts = facts_of(layout);
  // The clipped sphere needs a second axis even where roughness does not.
  const int columns = layout == Layout::ltc_code && table.columns == 1 ? table.rows : table.columns;
  if (table.angle_axis != facts.angle_axis || table.columns != columns) {
    const Result<LobeTable> other = resample(table, columns, table.rows, facts.angle_axis);
    if (!other) return other.error();
    return pack(*other, layout, precision);
  }

  PackedTable packed;
  packed.layout = layout;
  packed.angle_axis = facts.angle_axis;
  packed.width = table.width;
  packed.metadata = table.metadata;
  for (const auto& channels : facts.channels) {
    Texture texture;
    texture.width = table.columns;
    texture.height = table.rows;
    texture.channels = int(channels.size());
    texture.values.assign(texture.count(), 0.0f);
    packed.textures.push_back(std::move(texture));
  }

  for (int row = 0; row < table.rows; ++row) {
    const double cos_theta = row_cosine(layout, facts.angle_axis, table.rows, row);
    for (int column = 0; column < table.columns; ++column) {
      const float* t = table.texel(column, row);
      const Vec4d native{double(t[0]), double(t[1]), double(t[2]), double(t[3])};
      const double width = width_of(table.width, node_roughness(table.columns, column));
      double channels[2][4] = {};
      store_texel(layout, f64::lobe_from_mirror(native, width, cos_theta), native, double(t[4]),
                  double(t[5]), channels[0], channels[1]);
      if (layout == Layout::ltc_code)
        channels[1][3] = clipped_sphere_form_factor(2.0 * column / (table.columns - 1) - 1,
                                                    double(row) / (table.rows - 1));
      for (std::size_t k = 0; k < packed.textures.size(); ++k) {
        Texture& texture = packed.textures[k];
        for (int c = 0; c < texture.channels; ++c) {
          const float value = float(channels[k][c]);
          if (!std::isfinite(value))
            return Error{fmt::format("layout {}: node ({}, {}) has no finite value",
                                     name_of(layout), column, row)};
          texture.values[std::size_t((row * table.columns + column) * texture.channels + c)] =
              value;
        }
      }
    }
  }
  return with_precision(packed, precision);
}

Result<PackedTable> with_precision(const PackedTable& packed, Precision precision) {
  PackedTable result = packed;
  result.precision = precision;
  for (Texture& texture : result.textures)
    texture.precision = precision;
  if (precision == Precision::float16)
    if (Status status = round_to_half(result); !status) return status.error();
  for (int row = 0; row < result.rows(); ++row)
    for (int column = 0; column < result.columns(); ++column) {
      if (determinant(result, column, row) > 0) continue;
      const Error error{
          fmt::format("layout {}: the lobe of node ({}, {}) has no positive determinant",
                      name_of(result.layout), column, row)};
      if (!(determinant(packed, column, row) > 0) || precision == Precision::float32) return error;
      if (Status status = repair_determinant(result, column, row); !status) return status.error();
    }
  return result;
}

Result<LobeTable> unpack(const PackedTable& packed) {
  if (Status status = check_textures("packed table", packed.layout, packed.textures); !status)
    return status.error();
  LobeTable table;
  table.columns = packed.columns();
  table.rows = packed.rows();
  table.angle_axis = packed.angle_axis;
  table.width = packed.width;
  table.metadata = packed.metadata;
  table.texels.assign(std::size_t(table.columns) * std::size_t(table.rows) * LobeTable::k_channels,
                      0.0f);
  for (int row = 0; row < table.rows; ++row) {
    const double cos_theta = row_cosine(packed.layout, packed.angle_axis, table.rows, row);
    for (int column = 0; column < table.columns; ++column) {
      const f64::FittedLobe fitted = lobe_of_node(packed, column, row);
      if (!(fitted.lobe.det > 0) || !std::isfinite(fitted.lobe.det))
        return Error{fmt::format(
            "layout {}: the lobe of texel ({}, {}) has no positive determinant; is it that layout?",
            name_of(packed.layout), column, row)};
      float* texel = table.texel(column, row);
      if (packed.layout == Layout::native) {
        std::copy_n(packed.textures[0].values.data() + (row * table.columns + column) * 4, 4,
                    texel);
      } else {
        const double width = width_of(packed.width, node_roughness(table.columns, column));
        const Vec4d m = f64::mirror_from_lobe(fitted.lobe, width, cos_theta);
        texel[0] = float(m.x);
        texel[1] = float(m.y);
        texel[2] = float(m.z);
        texel[3] = float(m.w);
      }
      texel[4] = float(fitted.n1);
      texel[5] = float(fitted.n5);
      for (int k = 0; k < 6; ++k)
        if (!std::isfinite(texel[k]))
          return Error{fmt::format("layout {}: the lobe of texel ({}, {}) is not finite",
                                   name_of(packed.layout), column, row)};
    }
  }
  return table;
}

std::array<double, 4> sample_texture(const Texture& texture, double u, double v) {
  const double x = std::clamp(u * texture.width - 0.5, 0.0, double(texture.width - 1));
  const double y = std::clamp(v * texture.height - 0.5, 0.0, double(texture.height - 1));
  const int x0 = int(x), y0 = int(y);
  const int x1 = std::min(x0 + 1, texture.width - 1), y1 = std::min(y0 + 1, texture.height - 1);
  const double fx = x - x0, fy = y - y0;
  std::array<double, 4> result = {0, 0, 0, 0};
  for (int k = 0; k < texture.channels; ++k) {
    const auto at = [&](int column, int row) {
      return double(
          texture.values[std::size_t((row * texture.width + column) * texture.channels + k)]);
    };
    const double top = at(x0, y0) + (at(x1, y0) - at(x0, y0)) * fx;
    const double bottom = at(x0, y1) + (at(x1, y1) - at(x0, y1)) * fx;
    result[std::size_t(k)] = top + (bottom - top) * fy;
  }
  return result;
}

f64::FittedLobe fetch_packed(const PackedTable& packed, double roughness, double cos_theta) {
  const double c = std::clamp(cos_theta, 0.0, 1.0);
  double r = std::clamp(roughness, 0.0, 1.0), y = angle_coordinate(packed.angle_axis, c);
  if (packed.layout == Layout::godot) {
    r = std::max(r, 0.02);
    if (packed.angle_axis == AngleAxis::theta) y = godot_acos(c) / (0.5 * f64::k_pi);
  }
  const double u = f64::table_coordinate(r, packed.columns());
  const double v = f64::table_coordinate(y, packed.rows());
  const std::array<double, 4> first = sample_texture(packed.textures[0], u, v);
  std::array<double, 4> second = {};
  if (packed.textures.size() > 1) second = sample_texture(packed.textures[1], u, v);
  return lobe_of_texel(packed.layout, first, second, width_of(packed.width, r), c);
}

f64::FittedLobe fetch_native(const LobeTable& table, double roughness, double cos_theta) {
  const double r = std::clamp(roughness, 0.0, 1.0), c = std::clamp(cos_theta, 0.0, 1.0);
  const Vec2d uv{f64::table_coordinate(r, table.columns),
                 f64::table_coordinate(angle_coordinate(table.angle_axis, c), table.rows)};
  const auto amplitudes = f64::lobe_table_amplitudes(table.view(), uv);
  f64::FittedLobe fitted;
  fitted.lobe = f64::lobe_from_mirror(f64::lobe_table_coefficients(table.view(), uv),
                                      width_of(table.width, r), c);
  fitted.n1 = amplitudes.x;
  fitted.n5 = amplitudes.y;
  return fitted;
}

Result<LobeTable> resample(const LobeTable& table, int columns, int rows, AngleAxis axis) {
  if (columns < 1 || rows < 2 || columns > Texture::k_max_side || rows > Texture::k_max_side)
    return Error{fmt::format("table size {} x {}: choose 2 to {} nodes per axis", columns, rows,
                             Texture::k_max_side)};
  LobeTable result = table;
  result.columns = columns;
  result.rows = rows;
  result.angle_axis = axis;
  result.texels.assign(std::size_t(columns) * std::size_t(rows) * LobeTable::k_channels, 0.0f);
  for (int row = 0; row < rows; ++row) {
    // Row 0 and the last row are the same in every axis, and exactly so.
    const double y = double(row) / (rows - 1);
    const double c = axis == AngleAxis::theta ? std::cos(0.5 * f64::k_pi * y) : 1 - y * y;
    const double from = table.angle_axis == axis ? y
                        : row + 1 == rows        ? 1
                                                 : angle_coordinate(table.angle_axis, c);
    for (int column = 0; column < columns; ++column) {
      const Vec2d uv{f64::table_coordinate(node_roughness(columns, column), table.columns),
                     f64::table_coordinate(from, table.rows)};
      const auto m = f64::lobe_table_coefficients(table.view(), uv);
      const auto n = f64::lobe_table_amplitudes(table.view(), uv);
      const double channels[6] = {m.x, m.y, m.z, m.w, n.x, n.y};
      for (int k = 0; k < 6; ++k)
        result.texel(column, row)[k] = float(channels[k]);
    }
  }
  return result;
}

} // namespace openltc::table
