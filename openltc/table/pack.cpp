// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/clipped_sphere.h"
#include "openltc/table/divided.h"
#include "openltc/table/half.h"
#include "openltc/table/layout.h"
#include "openltc/table/lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc::table {

namespace {

// The channels of a node; lobe_of_texel is the inverse. `native` holds A B C D.
void store_texel(Layout layout, const f64::Lobe& m, Vec4d native, double n1, double n5,
                 double* first, double* second) {
  switch (layout) {
  case Layout::native:
  case Layout::native_two: // whose third texture and weight stand in the table
    std::copy_n(std::array{native.x, native.y, native.z, native.w}.data(), 4, first);
    std::copy_n(std::array{n1, n5, 0.0, 0.0}.data(), 4, second);
    return;
  case Layout::ltc_code:
  case Layout::ltc_code_alpha: // the fourth channel of the second texture is not a node's
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

// Whether channel 3 of the second texture is that of clipped_sphere.h.
bool has_clipped_sphere(Layout layout) {
  return layout == Layout::ltc_code || layout == Layout::ltc_code_alpha;
}

// The width that is factored out of a column's lobes, in the table that is packed or unpacked.
double column_width(brdf::LobeWidth width, Layout layout, int columns, int column) {
  return factored_width(width, column_roughness(layout, columns, column));
}

// The element of the first texture that raises the determinant when it goes up.
int determinant_channel(Layout layout) {
  return is_native(layout) || has_clipped_sphere(layout) ? 3 : 0;
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
            "precision; openltc fit and openltc convert keep it with --precision float32",
            name_of(packed.layout), texel % std::size_t(texture.width),
            texel / std::size_t(texture.width), t + 1, i % std::size_t(texture.channels),
            texture.values[i], k_half_max)};
      }
      texture.values[i] = rounded;
    }
  }
  return Success{};
}

// The texture that holds a lobe, 0 or 1.
std::size_t texture_of_lobe(int lobe) { return lobe == 0 ? 0 : 2; }

int lobe_count(Layout layout) { return layout == Layout::native_two ? 2 : 1; }

// Of the first lobe of a node or the second.
double determinant(const PackedTable& packed, int column, int row, int lobe);

// Moves one element of the texel up, half by half, until the determinant is positive.
Status repair_determinant(PackedTable& packed, int column, int row, int lobe) {
  Texture& texture = packed.textures[texture_of_lobe(lobe)];
  float& value = texture.values[std::size_t((row * texture.width + column) * texture.channels +
                                            determinant_channel(packed.layout))];
  for (int step = 0; step < 1024 && value >= 0 && value < k_half_max; ++step) {
    if (determinant(packed, column, row, lobe) > 0) return Success{};
    value = float_from_half(std::uint16_t(half_from_float(value) + 1));
  }
  return Error{fmt::format("layout {}: the lobe of node ({}, {}) has no positive determinant in {}",
                           name_of(packed.layout), column, row, name_of(packed.precision))};
}

double determinant(const PackedTable& packed, int column, int row, int lobe) {
  double det = 0;
  if (lobe == 0) {
    det = lobe_of_node(packed, column, row).lobe.det;
  } else {
    const Texture& texture = packed.textures[texture_of_lobe(lobe)];
    const float* m = texture.values.data() + (row * texture.width + column) * texture.channels;
    const double width = node_width(packed.width, packed.columns(), column);
    det = width * (double(m[0]) * double(m[3]) - width * double(m[1]) * double(m[2]));
  }
  return std::isfinite(det) ? det : 0;
}

// The channels of the first texture that are M00 and M02 up to a common factor, which turn a narrow
// lobe when one of them is off; none where the lobe's direction is stored otherwise.
const int* direction_channels(Layout layout) {
  static constexpr int k_ltc_code[2] = {0, 2}, k_unity[2] = {0, 3};
  return has_clipped_sphere(layout) ? k_ltc_code : layout == Layout::unity ? k_unity : nullptr;
}

// How far the lobe of a node in half precision is from that in single precision: M_half^-1 M - 1,
// the sum of the squares of its elements.
double rounding_distance(const PackedTable& half, const PackedTable& single, int column, int row) {
  const f64::Lobe h = lobe_of_node(half, column, row).lobe,
                  s = lobe_of_node(single, column, row).lobe;
  const double across = (h.m00 * s.m22 - h.m02 * s.m20) / s.det - 1;
  const double turn = (h.m02 * s.m00 - h.m00 * s.m02) / s.det;
  const double shear = (h.m20 * s.m22 - h.m22 * s.m20) / s.det;
  const double along = (h.m22 * s.m00 - h.m20 * s.m02) / s.det - 1;
  return across * across + turn * turn + shear * shear + along * along;
}

// Two halves that are each rounded by themselves turn a lobe by up to .03 degrees, more than what
// it is wide below roughness .02. A few halves to and fro there is a pair of nearly the same width
// whose ratio is right.
void turn_back(PackedTable& half, const PackedTable& single, int column, int row) {
  const int* channels = direction_channels(half.layout);
  const std::size_t at = std::size_t(row * half.columns() + column) * 4;
  float& m00 = half.textures[0].values[at + std::size_t(channels[0])];
  float& m02 = half.textures[0].values[at + std::size_t(channels[1])];
  const double ratio = double(single.textures[0].values[at + std::size_t(channels[1])]) /
                       double(single.textures[0].values[at + std::size_t(channels[0])]);
  constexpr int k_reach = 8; // halves: .4 % to .8 % of the width
  const std::uint16_t nearest = half_from_float(m00);
  if (!(m00 > 0) || (nearest & 0x7fff) < k_reach || !std::isfinite(ratio)) return;
  float best00 = m00, best02 = m02;
  double least = rounding_distance(half, single, column, row);
  for (int step = -k_reach; step <= k_reach; ++step) {
    m00 = float_from_half(std::uint16_t(nearest + step));
    m02 = rounded_to_half(float(ratio * double(m00)));
    if (!std::isfinite(m00) || !std::isfinite(m02)) continue;
    const double distance = rounding_distance(half, single, column, row);
    if (distance < least) least = distance, best00 = m00, best02 = m02;
  }
  m00 = best00;
  m02 = best02;
}

// Packs a table whose nodes lie where the layout wants them.
Result<PackedTable> pack_nodes(const LobeTable& table, Layout layout, Precision precision) {
  const LayoutFacts& facts = facts_of(layout);
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
      const double width = column_width(table.width, layout, table.columns, column);
      double channels[3][4] = {};
      store_texel(layout, f64::lobe_from_mirror(native, width, cos_theta), native, double(t[4]),
                  double(t[5]), channels[0], channels[1]);
      if (has_clipped_sphere(layout))
        channels[1][3] = clipped_sphere_form_factor(2.0 * column / (table.columns - 1) - 1,
                                                    double(row) / (table.rows - 1));
      if (layout == Layout::native_two) {
        channels[1][2] = double(t[6]);
        std::copy_n(table.second_texel(column, row), 4, channels[2]);
      }
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

} // namespace

f64::FittedLobe lobe_of_node(const PackedTable& packed, int column, int row) {
  std::array<double, 4> channels[3] = {};
  for (std::size_t t = 0; t < packed.textures.size(); ++t) {
    const Texture& texture = packed.textures[t];
    for (int k = 0; k < texture.channels; ++k)
      channels[t][std::size_t(k)] = double(
          texture.values[std::size_t((row * texture.width + column) * texture.channels + k)]);
  }
  return lobe_of_texel(packed.layout, channels[0], channels[1],
                       node_width(packed.width, packed.columns(), column),
                       row_cosine(packed.layout, packed.angle_axis, packed.rows(), row));
}

Result<PackedTable> pack(const LobeTable& table, Layout layout, Precision precision) {
  if (table.two_lobes() && layout != Layout::native_two)
    return Error{
        fmt::format("layout {} holds one lobe, this table has two; they are kept in layout "
                    "{}, which only this project reads",
                    name_of(layout), name_of(Layout::native_two))};
  if (!table.two_lobes() && layout == Layout::native_two)
    return Error{fmt::format("layout {} holds two lobes, this table has one", name_of(layout))};
  const LayoutFacts& facts = facts_of(layout);
  // The clipped sphere needs a second axis even where roughness does not.
  const int columns = has_clipped_sphere(layout) && table.columns == 1 ? table.rows : table.columns;
  if (table.angle_axis == facts.angle_axis && table.columns == columns && layout != Layout::godot &&
      layout != Layout::ltc_code_alpha)
    return pack_nodes(table, layout, precision);
  // Rows of the layout, as coordinates of the table's own axis; both end in the grazing row.
  std::vector<double> from(std::size_t(table.rows), 1.0);
  for (int row = 0; row + 1 < table.rows; ++row)
    from[std::size_t(row)] =
        angle_coordinate(table.angle_axis, row_cosine(layout, facts.angle_axis, table.rows, row));
  std::vector<double> across(std::size_t(columns), 1.0);
  for (int column = 0; column < columns; ++column)
    across[std::size_t(column)] = column_roughness(layout, columns, column);
  LobeTable nodes = interpolate(table, across, from);
  nodes.angle_axis = facts.angle_axis;
  return pack_nodes(nodes, layout, precision);
}
Result<PackedTable> with_precision(const PackedTable& packed, Precision precision) {
  PackedTable result = packed;
  result.precision = precision;
  for (Texture& texture : result.textures)
    texture.precision = precision;
  if (precision == Precision::float16)
    if (Status status = round_to_half(result); !status) return status.error();
  if (precision == Precision::float16 && direction_channels(result.layout))
    for (int row = 0; row < result.rows(); ++row)
      for (int column = 0; column < result.columns(); ++column)
        turn_back(result, packed, column, row);
  for (int row = 0; row < result.rows(); ++row)
    for (int column = 0; column < result.columns(); ++column)
      for (int lobe = 0; lobe < lobe_count(result.layout); ++lobe) {
        if (determinant(result, column, row, lobe) > 0) continue;
        const Error error{
            fmt::format("layout {}: the {}lobe of node ({}, {}) has no positive determinant",
                        name_of(result.layout), lobe == 0 ? "" : "second ", column, row)};
        if (!(determinant(packed, column, row, lobe) > 0) || precision == Precision::float32)
          return error;
        if (Status status = repair_determinant(result, column, row, lobe); !status)
          return status.error();
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
  const bool divided = is_divided(packed);
  if (packed.metadata.horizon == k_divided) table.metadata.horizon = k_clipped;
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
      if (is_native(packed.layout)) {
        std::copy_n(packed.textures[0].values.data() + (row * table.columns + column) * 4, 4,
                    texel);
      } else {
        const double width = column_width(packed.width, packed.layout, table.columns, column);
        const Vec4d m = f64::mirror_from_lobe(fitted.lobe, width, cos_theta);
        texel[0] = float(m.x);
        texel[1] = float(m.y);
        texel[2] = float(m.z);
        texel[3] = float(m.w);
      }
      const double above = divided ? share_above(fitted.lobe) : 1;
      texel[4] = float(fitted.n1 * above);
      texel[5] = float(fitted.n5 * above);
      if (packed.layout == Layout::native_two) {
        const std::size_t at = std::size_t(row * table.columns + column) * 4;
        texel[6] = packed.textures[1].values[at + 2];
        if (!(texel[6] >= 0 && texel[6] <= 1))
          return Error{
              fmt::format("layout {}: the weight of texel ({}, {}) is {:g}, not within 0 to 1",
                          name_of(packed.layout), column, row, texel[6])};
        if (!(determinant(packed, column, row, 1) > 0))
          return Error{fmt::format(
              "layout {}: the second lobe of texel ({}, {}) has no positive determinant",
              name_of(packed.layout), column, row)};
        const float* second = packed.textures[2].values.data() + at;
        table.second.insert(table.second.end(), second, second + 4);
      }
      for (int k = 0; k < 6; ++k)
        if (!std::isfinite(texel[k]))
          return Error{fmt::format("layout {}: the lobe of texel ({}, {}) is not finite",
                                   name_of(packed.layout), column, row)};
    }
  }
  if (packed.layout != Layout::godot && packed.layout != Layout::ltc_code_alpha) return table;
  // From where the shader reads its rows and columns to where theta / (pi/2) and the roughness say.
  std::vector<double> across(std::size_t(table.columns), 1.0);
  for (int column = 0; column < table.columns; ++column) {
    const double r = node_roughness(table.columns, column);
    across[std::size_t(column)] = packed.layout == Layout::ltc_code_alpha ? r * r : r;
  }
  std::vector<double> from(std::size_t(table.rows), 1.0);
  for (int row = 0; row + 1 < table.rows; ++row)
    from[std::size_t(row)] = look_up_coordinate(
        packed.layout, packed.angle_axis,
        cosine_of_coordinate(Layout::native, packed.angle_axis, double(row) / (table.rows - 1)));
  return interpolate(table, across, from);
}

} // namespace openltc::table
