// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::table {

namespace {

// area_lights_inc.glsl, acos_approx, for x >= 0.
double godot_acos(double x) {
  return (-0.156583 * x + 0.5 * f64::k_pi) * std::sqrt(std::max(1 - x, 0.0));
}

} // namespace

double factored_width(brdf::LobeWidth width, double roughness) {
  return width == brdf::LobeWidth::alpha ? f64::alpha_from_roughness(roughness) : 1.0;
}

double angle_coordinate(AngleAxis axis, double cos_theta) {
  const double c = std::clamp(cos_theta, 0.0, 1.0);
  return axis == AngleAxis::theta ? std::acos(c) / (0.5 * f64::k_pi) : std::sqrt(1 - c);
}

double look_up_coordinate(Layout layout, AngleAxis axis, double cos_theta) {
  if (layout != Layout::godot || axis != AngleAxis::theta) return angle_coordinate(axis, cos_theta);
  return godot_acos(std::clamp(cos_theta, 0.0, 1.0)) / (0.5 * f64::k_pi);
}

double column_roughness(Layout layout, int columns, int column) {
  const double x = node_roughness(columns, column);
  return layout == Layout::ltc_code_alpha ? std::sqrt(x) : x;
}

double roughness_coordinate(Layout layout, double roughness) {
  constexpr double k_least_alpha = 0.001; // of both engines
  const double r = std::clamp(roughness, layout == Layout::godot ? 0.02 : 0.0, 1.0);
  return layout == Layout::ltc_code_alpha ? std::max(r * r, k_least_alpha) : r;
}

double cosine_of_coordinate(Layout layout, AngleAxis axis, double y) {
  if (axis != AngleAxis::theta) return 1 - y * y;
  if (layout != Layout::godot) return std::cos(0.5 * f64::k_pi * y);
  // Falls strictly from cos = 0 to cos = 1; 60 halvings reach the last bit.
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (look_up_coordinate(layout, axis, middle) > y ? low : high) = middle;
  }
  return y <= 0 ? 1 : 0.5 * (low + high);
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

Vec2d look_up_position(const PackedTable& packed, double roughness, double cos_theta) {
  return {roughness_coordinate(packed.layout, roughness),
          look_up_coordinate(packed.layout, packed.angle_axis, std::clamp(cos_theta, 0.0, 1.0))};
}

f64::FittedLobe fetch_packed(const PackedTable& packed, double roughness, double cos_theta) {
  const double c = std::clamp(cos_theta, 0.0, 1.0);
  const Vec2d at = look_up_position(packed, roughness, c);
  const double u = f64::table_coordinate(at.x, packed.columns());
  const double v = f64::table_coordinate(at.y, packed.rows());
  const std::array<double, 4> first = sample_texture(packed.textures[0], u, v);
  std::array<double, 4> second = {};
  if (packed.textures.size() > 1) second = sample_texture(packed.textures[1], u, v);
  const double width = factored_width(packed.width, std::clamp(roughness, 0.0, 1.0));
  return lobe_of_texel(packed.layout, first, second, width, c);
}

f64::SecondLobe fetch_packed_second(const PackedTable& packed, double roughness, double cos_theta) {
  f64::SecondLobe second{f64::cosine_lobe(), 0};
  if (packed.layout != Layout::native_two) return second;
  const double r = std::clamp(roughness, 0.0, 1.0), c = std::clamp(cos_theta, 0.0, 1.0);
  const double u = f64::table_coordinate(r, packed.columns());
  const double v = f64::table_coordinate(angle_coordinate(packed.angle_axis, c), packed.rows());
  const std::array<double, 4> m = sample_texture(packed.textures[2], u, v);
  second.lobe = f64::lobe_from_mirror({m[0], m[1], m[2], m[3]}, factored_width(packed.width, r), c);
  second.weight = sample_texture(packed.textures[1], u, v)[2];
  return second;
}

f64::FittedLobe fetch_native(const LobeTable& table, double roughness, double cos_theta) {
  const double r = std::clamp(roughness, 0.0, 1.0), c = std::clamp(cos_theta, 0.0, 1.0);
  const f64::LobeTexel texel =
      f64::lobe_table_texel(table.view(), {r, angle_coordinate(table.angle_axis, c)});
  f64::FittedLobe fitted;
  fitted.lobe = f64::lobe_from_mirror(texel.coefficients, factored_width(table.width, r), c);
  fitted.n1 = texel.amplitudes.x;
  fitted.n5 = texel.amplitudes.y;
  return fitted;
}

f64::SecondLobe fetch_native_second(const LobeTable& table, double roughness, double cos_theta) {
  const double r = std::clamp(roughness, 0.0, 1.0), c = std::clamp(cos_theta, 0.0, 1.0);
  f64::SecondLobe second{f64::cosine_lobe(), 0};
  if (!table.two_lobes()) return second;
  const Vec2d at{r, angle_coordinate(table.angle_axis, c)};
  second.lobe = f64::lobe_from_mirror(f64::lobe_table_second(table.view(), at),
                                      factored_width(table.width, r), c);
  second.weight = f64::lobe_table_texel(table.view(), at).second_weight;
  return second;
}

LobeTable interpolate(const LobeTable& table, std::span<const double> across,
                      std::span<const double> from) {
  const int columns = int(across.size());
  LobeTable result = table;
  result.columns = columns;
  result.rows = int(from.size());
  result.texels.assign(std::size_t(columns) * from.size() * LobeTable::k_channels, 0.0f);
  result.second.clear();
  for (int row = 0; row < result.rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2d at{across[std::size_t(column)], from[std::size_t(row)]};
      const auto [m, n, weight] = f64::lobe_table_texel(table.view(), at);
      const double channels[7] = {m.x, m.y, m.z, m.w, n.x, n.y, weight};
      for (int k = 0; k < 7; ++k)
        result.texel(column, row)[k] = float(channels[k]);
      if (!table.two_lobes()) continue;
      const Vec4d second = f64::lobe_table_second(table.view(), at);
      for (const double value : {second.x, second.y, second.z, second.w})
        result.second.push_back(float(value));
    }
  return result;
}

Result<LobeTable> resample(const LobeTable& table, int columns, int rows, AngleAxis axis) {
  if (columns < 1 || rows < 2 || columns > Texture::k_max_side || rows > Texture::k_max_side)
    return Error{fmt::format("table size {} x {}: choose 2 to {} nodes per axis", columns, rows,
                             Texture::k_max_side)};
  std::vector<double> from(std::size_t(rows), 1.0); // the last row is the same on every axis
  for (int row = 0; row + 1 < rows; ++row) {
    const double y = double(row) / (rows - 1);
    from[std::size_t(row)] =
        table.angle_axis == axis
            ? y
            : angle_coordinate(table.angle_axis, cosine_of_coordinate(Layout::native, axis, y));
  }
  std::vector<double> across(std::size_t(columns), 1.0);
  for (int column = 0; column < columns; ++column)
    across[std::size_t(column)] = node_roughness(columns, column);
  LobeTable result = interpolate(table, across, from);
  result.angle_axis = axis;
  return result;
}

} // namespace openltc::table
