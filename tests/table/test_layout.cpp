// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Layouts: what an engine reads of them is the table, and packing can be undone.

#include "openltc/table/clipped_sphere.h"
#include "openltc/table/divided.h"
#include "openltc/table/half.h"
#include "openltc/table/layout.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace openltc;
using namespace openltc::table;

namespace {

double difference(const f64::Lobe& a, const f64::Lobe& b) {
  const double scale =
      std::max({std::abs(b.m00), std::abs(b.m02), std::abs(b.m20), std::abs(b.m22), 1e-30});
  return std::max({std::abs(a.m00 - b.m00), std::abs(a.m02 - b.m02), std::abs(a.m20 - b.m20),
                   std::abs(a.m22 - b.m22)}) /
         scale;
}

// Node (column, row) of the built-in on an angle axis, as a lobe.
f64::FittedLobe node(const LobeTable& table, Layout layout, int column, int row) {
  const float* t = table.texel(column, row);
  f64::FittedLobe fitted;
  fitted.lobe = f64::lobe_from_mirror({double(t[0]), double(t[1]), double(t[2]), double(t[3])},
                                      node_width(table.width, table.columns, column),
                                      row_cosine(layout, table.angle_axis, table.rows, row));
  fitted.n1 = double(t[4]);
  fitted.n5 = double(t[5]);
  return fitted;
}

} // namespace

TEST_CASE("an engine reads the lobe of a node exactly, whatever the layout") {
  for (const Layout layout : all_layouts()) {
    CAPTURE(std::string(name_of(layout)));
    const Result<LobeTable> table = resample(builtin_ggx_table(), 64, 64, angle_axis_of(layout));
    REQUIRE(table);
    const Result<PackedTable> packed = pack(*table, layout, Precision::float32);
    REQUIRE(packed);
    double worst = 0, worst_n = 0;
    // Not the last row, whose lobe belongs to a cosine above 0, nor roughness below Godot's .02.
    for (int row = 0; row < 63; ++row)
      for (int column = 2; column < 64; ++column) {
        const double y = row / 63.0, roughness = column / 63.0;
        // The matrix of the node, read at the cosine for which the layout has the row.
        const double c = row_cosine(layout, angle_axis_of(layout), 64, row);
        if (layout == Layout::godot) { // where its polynomial arc cosine takes the row's value
          const double theta = (-0.156583 * c + 0.5 * f64::k_pi) * std::sqrt(1 - c);
          REQUIRE(theta == doctest::Approx(0.5 * f64::k_pi * y).epsilon(1e-7).scale(1));
        } else {
          REQUIRE(c == doctest::Approx(angle_axis_of(layout) == AngleAxis::theta
                                           ? std::cos(0.5 * f64::k_pi * y)
                                           : 1 - y * y));
        }
        const f64::FittedLobe want = layout == Layout::godot ? fetch_native(*table, roughness, c)
                                                             : node(*table, layout, column, row);
        const f64::FittedLobe got = fetch_packed(*packed, roughness, c);
        worst = std::max(worst, difference(got.lobe, want.lobe));
        if (facts_of(layout).has_amplitudes)
          worst_n = std::max({worst_n, std::abs(got.n1 - want.n1), std::abs(got.n5 - want.n5)});
      }
    CHECK(worst < 1e-5);
    CHECK(worst_n < 1e-6);
  }
}

TEST_CASE("the layouts are those of the engines' shaders, element by element") {
  // A lobe whose four elements all differ, and its inverse M, row by row.
  const f64::Lobe m = f64::make_lobe(0.9, 0.3, -0.2, 0.8);
  const double det = 0.9 * 0.8 + 0.3 * 0.2;
  const auto same = [&](Layout layout, std::array<double, 4> first, std::array<double, 4> second) {
    CAPTURE(std::string(name_of(layout)));
    CHECK(difference(lobe_of_texel(layout, first, second, 1, 0.5).lobe, m) < 1e-12);
  };
  // GLSL: mat3(vec3(x, 0, y), vec3(0, 1, 0), vec3(z, 0, w)), columns.
  same(Layout::ltc_code, {0.9, -0.2, 0.3, 0.8}, {});
  // HLSL: _m00_m02_m11_m20 of the transposed matrix, _m22 = 1.
  same(Layout::unity, {0.9 / 0.8, -0.2 / 0.8, 1 / 0.8, 0.3 / 0.8}, {});
  // M = [a 0 d; 0 c 0; b 0 e] = inverse of M^-1, here doubled.
  same(Layout::godot, {2 * 0.8 / det, 2 * 0.2 / det, 2, 2 * -0.3 / det}, {2 * 0.9 / det, 1, 0, 0});
  // [1 0 w; 0 z 0; y 0 x]
  same(Layout::o3de, {0.8 / 0.9, -0.2 / 0.9, 1 / 0.9, 0.3 / 0.9}, {});
}

TEST_CASE("unpacking undoes packing on the layout's own nodes") {
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::godot) continue; // resampled: the next test
    CAPTURE(std::string(name_of(layout)));
    const Result<LobeTable> table = resample(builtin_ggx_table(), 33, 17, angle_axis_of(layout));
    REQUIRE(table);
    const Result<PackedTable> packed = pack(*table, layout, Precision::float32);
    REQUIRE(packed);
    const Result<LobeTable> back = unpack(*packed);
    REQUIRE(back);
    CHECK(back->angle_axis == table->angle_axis);
    CHECK(back->metadata.command == table->metadata.command);
    double worst = 0;
    for (int row = 0; row < 17; ++row)
      for (int column = 0; column < 33; ++column) {
        const f64::FittedLobe want = node(*table, layout, column, row);
        const f64::FittedLobe got = node(*back, layout, column, row);
        worst = std::max(worst, difference(got.lobe, want.lobe));
        if (facts_of(layout).has_amplitudes) REQUIRE(got.n1 == want.n1);
      }
    CHECK(worst < 3e-6);
    if (layout == Layout::native) CHECK(back->texels == table->texels);
    // And packing again gives the same file up to the last bits of its floats.
    const Result<PackedTable> again = pack(*back, layout, Precision::float32);
    REQUIRE(again);
    for (std::size_t t = 0; t < packed->textures.size(); ++t)
      for (std::size_t i = 0; i < packed->textures[t].values.size(); ++i)
        REQUIRE(again->textures[t].values[i] ==
                doctest::Approx(double(packed->textures[t].values[i])).epsilon(1e-3).scale(1e-3));
  }
}

TEST_CASE("amplitudes over the share above the horizon come back as they were") {
  for (const Layout layout : all_layouts()) {
    CAPTURE(std::string(name_of(layout)));
    const Result<LobeTable> table = resample(builtin_ggx_table(), 32, 32, angle_axis_of(layout));
    REQUIRE(table);
    const Result<PackedTable> plain = pack(*table, layout, Precision::float32);
    REQUIRE(plain);
    PackedTable divided = *plain;
    divide_amplitudes(divided);
    if (!facts_of(layout).has_amplitudes) {
      CHECK(divided.textures[0].values == plain->textures[0].values);
      CHECK(divided.metadata.horizon == "clipped");
      continue;
    }
    CHECK(is_divided(divided));
    CHECK(divided.metadata.horizon == "divided");
    CHECK(divided.textures[0].values == plain->textures[0].values);
    PackedTable twice = divided;
    divide_amplitudes(twice);
    CHECK(twice.textures[1].values == divided.textures[1].values);

    // Divided: n1 by the share, as shading would, at a node near grazing.
    const f64::FittedLobe before = lobe_of_node(*plain, 10, 29);
    const double above = f64::share_above_horizon(before.lobe);
    CHECK(above < 0.99);
    CHECK(lobe_of_node(divided, 10, 29).n1 * above == doctest::Approx(before.n1));
    CHECK(lobe_of_node(divided, 10, 29).n5 * above == doctest::Approx(before.n5));

    const Result<LobeTable> want = unpack(*plain), got = unpack(divided);
    REQUIRE(want);
    REQUIRE(got);
    CHECK(got->metadata.horizon == "clipped");
    for (std::size_t i = 0; i < want->texels.size(); ++i)
      REQUIRE(got->texels[i] == doctest::Approx(double(want->texels[i])).epsilon(1e-6));
    for (int row = 0; row < 32; ++row) { // on the nodes and, less exactly, between them
      const double c = row_cosine(layout, divided.angle_axis, 32, row);
      for (const double roughness : {10 / 31.0, 10.5 / 31.0})
        REQUIRE(fetch_albedo(divided, roughness, c).n1 ==
                doctest::Approx(fetch_packed(*plain, roughness, c).n1).epsilon(0.02));
    }
    CHECK(fetch_albedo(*plain, 0.4, 0.2).n1 == fetch_packed(*plain, 0.4, 0.2).n1);
  }
}

TEST_CASE("Godot's table comes back through its polynomial arc cosine") {
  const Result<LobeTable> table = resample(builtin_ggx_table(), 64, 64, AngleAxis::theta);
  REQUIRE(table);
  const Result<PackedTable> packed = pack(*table, Layout::godot, Precision::float32);
  REQUIRE(packed);
  const Result<LobeTable> back = unpack(*packed);
  REQUIRE(back);
  double worst = 0;
  for (int row = 0; row < 63; ++row) // the last row of M depends on .03 of the cosine before it
    for (int column = 0; column < 64; ++column)
      for (int k = 0; k < 6; ++k)
        worst = std::max(worst, std::abs(double(back->texel(column, row)[k]) -
                                         double(table->texel(column, row)[k])));
  MESSAGE("largest difference of A B C D n1 n5: ", worst);
  CHECK(worst < 0.03);
}

TEST_CASE("half precision keeps every determinant positive, between the nodes too") {
  for (const Layout layout : {Layout::native, Layout::ltc_code, Layout::unity, Layout::godot}) {
    CAPTURE(std::string(name_of(layout)));
    const Result<PackedTable> packed = pack(builtin_ggx_table(), layout, Precision::float16);
    REQUIRE(packed);
    for (const Texture& texture : packed->textures)
      for (const float value : texture.values)
        REQUIRE(rounded_to_half(value) == value);
    const int n = 1009; // no multiple of the nodes' spacing
    double least = 1e9;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double roughness = double(i) / (n - 1), y = double(j) / (n - 1);
        const f64::FittedLobe f = fetch_packed(*packed, roughness, 1 - y * y);
        least = std::min(least, f.lobe.det / f64::alpha_from_roughness(roughness));
        REQUIRE(f.lobe.det > 0);
        REQUIRE(std::isfinite(f.lobe.m00 + f.lobe.m02 + f.lobe.m20 + f.lobe.m22));
      }
    MESSAGE(std::string(name_of(layout)), ": least determinant over alpha ", least);
  }
}

TEST_CASE("in half precision the native look-up stays within a rounding of the table") {
  const Result<PackedTable> packed = pack(builtin_ggx_table(), Layout::native, Precision::float16);
  REQUIRE(packed);
  const Result<LobeTable> back = unpack(*packed);
  REQUIRE(back);
  for (std::size_t i = 0; i < back->texels.size(); ++i) {
    const float want = builtin_ggx_table().texels[i];
    REQUIRE(std::abs(back->texels[i] - want) <= std::max(std::abs(want) * 0x1p-10f, 0x1p-24f));
  }
}

TEST_CASE("what half precision cannot hold is refused with its texel") {
  LobeTable table = builtin_ggx_table();
  table.texel(5, 7)[4] = 70000.0f;
  const Result<PackedTable> packed = pack(table, Layout::ltc_code, Precision::float16);
  REQUIRE_FALSE(packed);
  CHECK(packed.error().message.find("(5, 7)") != std::string::npos);
  CHECK(packed.error().message.find("float32") != std::string::npos);
  CHECK(packed.error().message.find('\n') == std::string::npos);
}

TEST_CASE("a texel without a lobe is refused, packing and unpacking") {
  LobeTable table = builtin_ggx_table();
  table.texel(5, 7)[0] = -1;
  const Result<PackedTable> packed = pack(table, Layout::native, Precision::float32);
  REQUIRE_FALSE(packed);
  CHECK(packed.error().message.find("(5, 7)") != std::string::npos);
  PackedTable good = *pack(builtin_ggx_table(), Layout::ltc_code, Precision::float32);
  good.textures[0].values[(7 * 64 + 5) * 4 + 3] = -1;
  const Result<LobeTable> back = unpack(good);
  REQUIRE_FALSE(back);
  CHECK(back.error().message.find("(5, 7)") != std::string::npos);
}

TEST_CASE("the fourth channel of ltc_code is the clipped sphere on axes of its own") {
  const Result<PackedTable> packed =
      pack(builtin_ggx_table(), Layout::ltc_code, Precision::float32);
  REQUIRE(packed);
  const auto at = [&](int column, int row) {
    return packed->textures[1].values[std::size_t((row * 64 + column) * 4 + 3)];
  };
  CHECK(at(63, 0) == 1);
  CHECK(at(0, 63) == doctest::Approx(0).scale(1));
  CHECK(at(40, 21) == doctest::Approx(clipped_sphere_form_factor(80.0 / 63 - 1, 21.0 / 63)));
}

TEST_CASE("a table of one column, for a BRDF without roughness, goes into every layout") {
  LobeTable table;
  table.columns = 1;
  table.rows = 8;
  table.width = brdf::LobeWidth::one;
  table.texels.assign(8 * LobeTable::k_channels, 0.0f);
  for (int row = 0; row < 8; ++row) { // the cosine lobe
    const float y = float(row) / 7, c = 1 - y * y, s = std::sqrt(1 - c * c);
    const float texel[6] = {c, -s, s, c, 0.9f, 0};
    std::copy_n(texel, 6, table.texel(0, row));
  }
  for (const Layout layout : all_layouts()) {
    CAPTURE(std::string(name_of(layout)));
    const Result<PackedTable> packed = pack(table, layout, Precision::float32);
    REQUIRE(packed);
    const f64::FittedLobe f =
        fetch_packed(*packed, 0.3, row_cosine(layout, packed->angle_axis, 8, 3));
    CHECK(f.lobe.m00 == doctest::Approx(1).epsilon(0.05));
    CHECK(f.lobe.m22 == doctest::Approx(1).epsilon(0.05));
  }
}

TEST_CASE("resampling to the same nodes changes nothing, impossible sizes are refused") {
  const LobeTable& t = builtin_ggx_table();
  const Result<LobeTable> same = resample(t, 64, 64, AngleAxis::sqrt_one_minus_cos);
  REQUIRE(same);
  for (std::size_t i = 0; i < t.texels.size(); ++i)
    REQUIRE(same->texels[i] == doctest::Approx(double(t.texels[i])).epsilon(1e-6));
  CHECK_FALSE(resample(t, 0, 8, AngleAxis::theta));
  CHECK_FALSE(resample(t, 8, 1, AngleAxis::theta));
  CHECK_FALSE(resample(t, 8, 513, AngleAxis::theta));
}
