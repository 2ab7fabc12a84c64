// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/emission_cells.h"

#include <doctest/doctest.h>

#include <random>

using namespace openltc;

namespace {

std::vector<float> level(int columns, int rows, float value) {
  std::vector<float> texels;
  for (int i = 0; i < columns * rows; ++i)
    texels.insert(texels.end(), {value, value, value, 1.0f});
  return texels;
}

double probability(const light::EmissionCells& cells, int columns, int x, int y) {
  const auto share = [](const float* cdf, int i) {
    return double(cdf[i]) - (i > 0 ? double(cdf[i - 1]) : 0.0);
  };
  return share(cells.row_cdf.data(), y) * share(cells.cell_cdf.data() + y * columns, x);
}

} // namespace

TEST_CASE("an even picture is not sampled by cells") {
  const auto texels = level(16, 8, 0.7f);
  CHECK(light::make_emission_cells(texels, 16, 8).share == 0);
  CHECK(light::make_emission_cells(level(16, 8, 0), 16, 8).share == 0);
}

TEST_CASE("cells have the light of an interpolated texel") {
  auto texels = level(16, 8, 0);
  for (std::size_t c = 0; c < 3; ++c)
    texels[4 * (3 * 16 + 5) + c] = 2;
  const auto cells = light::make_emission_cells(texels, 16, 8);
  CHECK(cells.share > 0.7f);
  CHECK(cells.share <= 0.75f);
  double sum = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) {
      const auto part = [](int from, int to) {
        return from == to ? 0.75 : std::abs(from - to) == 1 ? 0.125 : 0.0;
      };
      CHECK(probability(cells, 16, x, y) == doctest::Approx(part(x, 5) * part(y, 3)).epsilon(1e-5));
      sum += probability(cells, 16, x, y);
    }
  CHECK(sum == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("cells beside the light have no share, and shares end at one") {
  std::mt19937 random(2);
  auto texels = level(32, 16, 0);
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    const bool is_light = random() % 3 != 0;
    texels[i + 3] = is_light ? 1.0f : 0.0f;
    if (is_light && random() % 4 == 0) texels[i] = float(random() % 1000);
  }
  const auto cells = light::make_emission_cells(texels, 32, 16);
  REQUIRE(cells.share > 0);
  CHECK(cells.row_cdf.size() == 16);
  CHECK(cells.cell_cdf.size() == 32 * 16);
  CHECK(cells.row_cdf.back() == 1.0f);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      if (texels[4 * std::size_t(y * 32 + x) + 3] == 0)
        CHECK(probability(cells, 32, x, y) == doctest::Approx(0).epsilon(1e-6));
}
