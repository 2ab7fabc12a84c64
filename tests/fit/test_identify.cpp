// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A bare texture is told for what it is, in every layout and in the ways in which published ones
// differ.

#include "openltc/fit/measure/identify.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using namespace openltc::table;

namespace {

fit::Identification best_of(const std::vector<Texture>& textures) {
  const Result<std::vector<fit::Identification>> found = fit::identify(textures);
  REQUIRE(found);
  REQUIRE(found->size() > 1);
  return found->front();
}

// The built-in as ltc_code, each texel from (roughness, cosine) as `where` says for x, y in 0..1.
template <class Where> std::vector<Texture> textures_over(Where&& where) {
  const Result<PackedTable> packed =
      pack(builtin_ggx_table(), Layout::ltc_code, Precision::float32);
  REQUIRE(packed);
  std::vector<Texture> textures = packed->textures;
  for (Texture& texture : textures)
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column < 64; ++column) {
        const auto [roughness, cos_theta] = where(column / 63.0, row / 63.0);
        const Texture& from = packed->textures[std::size_t(&texture - textures.data())];
        const auto texel = sample_texture(from, f64::table_coordinate(roughness, 64),
                                          f64::table_coordinate(std::sqrt(1 - cos_theta), 64));
        for (int k = 0; k < 4; ++k)
          texture.values[std::size_t((row * 64 + column) * 4 + k)] = float(texel[std::size_t(k)]);
      }
  return textures;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("every layout is recognised, with its BRDF and its amplitudes") {
  for (const Layout layout : all_layouts()) {
    CAPTURE(std::string(name_of(layout)));
    const Result<PackedTable> packed = pack(builtin_ggx_table(), layout, Precision::float32);
    REQUIRE(packed);
    const fit::Identification best = best_of(packed->textures);
    REQUIRE(best.layout);
    CHECK(*best.layout == layout);
    CHECK(best.brdf == "ggx");
    CHECK(best.mean_tv < 0.06);
    if (facts_of(layout).has_amplitudes) CHECK(best.mean_n1 < 2e-3);
  }
}

TEST_CASE("other axes are found: theta, cos theta, alpha, exchanged") {
  const double half_pi = 0.5 * f64::k_pi;
  const auto theta = best_of(textures_over(
      [&](double x, double y) { return std::pair(x, std::max(std::cos(half_pi * y), 0.0)); }));
  CHECK(has(theta.reading, "by theta"));
  CHECK_FALSE(theta.layout);
  const auto cosine = best_of(textures_over([](double x, double y) { return std::pair(x, y); }));
  CHECK(has(cosine.reading, "by cos theta"));
  const auto alpha =
      best_of(textures_over([](double x, double y) { return std::pair(std::sqrt(x), 1 - y * y); }));
  CHECK(has(alpha.reading, "alpha by sqrt"));
  const auto swapped =
      best_of(textures_over([](double x, double y) { return std::pair(y, 1 - x * x); }));
  CHECK(has(swapped.reading, "axes swapped"));
  for (const fit::Identification& id : {theta, cosine, alpha, swapped}) {
    CHECK(has(id.reading, "M^-1 as ltc_code (M00 M20 M02 M22)"));
    CHECK(id.mean_tv < 0.08);
  }
}

TEST_CASE("a transposed and an inverted matrix are found") {
  const Result<PackedTable> packed =
      pack(builtin_ggx_table(), Layout::ltc_code, Precision::float32);
  REQUIRE(packed);
  std::vector<Texture> transposed = packed->textures, inverted = packed->textures;
  for (std::size_t i = 0; i < transposed[0].values.size(); i += 4) {
    std::swap(transposed[0].values[i + 1], transposed[0].values[i + 2]);
    float* t = inverted[0].values.data() + i;
    const float det = t[0] * t[3] - t[1] * t[2];
    const float m[4] = {t[3] / det, -t[1] / det, -t[2] / det, t[0] / det};
    std::copy_n(m, 4, t);
  }
  const fit::Identification a = best_of(transposed), b = best_of(inverted);
  CHECK(has(a.reading, "M^-1 as ltc_code, transposed"));
  CHECK(has(b.reading, "M (not M^-1) in the order of ltc_code;"));
  CHECK(a.mean_tv < 0.05);
  CHECK(b.mean_tv < 0.05);
}

TEST_CASE("what is no table fits nothing, and what cannot be one is refused") {
  Texture noise;
  noise.width = noise.height = 32;
  noise.channels = 4;
  for (std::size_t i = 0; i < noise.count(); ++i)
    noise.values.push_back(float(i * 2654435761u % 1000) / 1000);
  CHECK(best_of({noise}).mean_tv > 0.25);
  noise.channels = 2;
  noise.values.resize(noise.count());
  CHECK_FALSE(fit::identify(std::vector<Texture>{noise}));
  CHECK_FALSE(fit::identify({}));
}
