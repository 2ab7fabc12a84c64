// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Tables and polynomials of the caller's: copied, and refused when they are none.

#include "openltc/api/lobes.h"
#include "tests/c_api/c_lights.h"
#include "tests/c_api/c_points.h"

#include <limits>

using namespace openltc;
using namespace openltc::testing;

namespace {

constexpr std::size_t k_side = std::size_t(k_ggx_table_columns);

std::vector<float> built_in_texels() { return {k_ggx_table, k_ggx_table + k_side * k_side * 8}; }

LobesHandle own_table(const std::vector<float>& texels) {
  openltc_lobes* lobes = nullptr;
  REQUIRE(openltc_lobes_create_table(texels.data(), k_side, k_side, &lobes) == OPENLTC_OK);
  return LobesHandle(lobes);
}

std::vector<float> shade_with(const openltc_lobes* lobes) {
  static const std::vector<Vertex> vertices = random_vertices(50);
  static const AllLights all;
  const openltc_points points = points_of(vertices);
  std::vector<float> radiance(3 * points.count);
  REQUIRE(openltc_shade(lobes, all.c.get(), &points, 1, radiance.data()) == OPENLTC_OK);
  return radiance;
}

} // namespace

TEST_CASE("own_lobes_are_copied_and_shade_as_the_built_in_ones") {
  std::vector<float> texels = built_in_texels();
  const LobesHandle table = own_table(texels);
  texels.assign(texels.size(), std::numeric_limits<float>::quiet_NaN());
  CHECK(shade_with(table.get()) == shade_with(built_in_lobes(OPENLTC_TABLE).get()));

  openltc_lobes* lobes = nullptr;
  REQUIRE(openltc_lobes_create_polynomial(k_ggx_polynomial, std::size_t(k_ggx_polynomial_degree),
                                          &lobes) == OPENLTC_OK);
  const LobesHandle polynomial(lobes);
  CHECK(shade_with(polynomial.get()) == shade_with(built_in_lobes(OPENLTC_POLYNOMIAL).get()));
  CHECK(shade_with(polynomial.get()) != shade_with(table.get()));
}

TEST_CASE("a_table_of_two_lobes_is_copied_and_shades_as_the_built_in_one") {
  constexpr std::size_t side = std::size_t(k_ggx_two_lobes_columns);
  std::vector<float> texels(k_ggx_two_lobes, k_ggx_two_lobes + side * side * 8);
  std::vector<float> second(k_ggx_two_lobes_second, k_ggx_two_lobes_second + side * side * 4);
  openltc_lobes* lobes = nullptr;
  const auto create = [&] {
    return openltc_lobes_create_two_lobe_table(texels.data(), second.data(), side, side, &lobes);
  };
  REQUIRE(create() == OPENLTC_OK);
  const LobesHandle own(lobes);
  second[4 * 7] *= -1; // a determinant below 0
  CHECK(create() == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("second lobe of node (7, 0)"));
  second[4 * 7] = std::numeric_limits<float>::infinity();
  CHECK(create() == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("channel 0 of number 7"));
  second[4 * 7] = 1;
  texels[6] = 1.01f;
  CHECK(create() == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("weight of texel 0"));
  CHECK(openltc_lobes_create_two_lobe_table(texels.data(), nullptr, side, side, &lobes) ==
        OPENLTC_INVALID_ARGUMENT);
  const std::vector<float> two = shade_with(own.get());
  CHECK(two == shade_with(built_in_lobes(OPENLTC_TWO_LOBE_TABLE).get()));
  CHECK(two != shade_with(built_in_lobes(OPENLTC_TABLE).get()));
}

TEST_CASE("numbers_that_are_no_lobes_are_refused") {
  openltc_lobes* lobes = nullptr;
  std::vector<float> texels = built_in_texels();
  const auto create = [&](std::size_t columns, std::size_t rows) {
    return openltc_lobes_create_table(texels.data(), columns, rows, &lobes);
  };
  for (const std::size_t size : {std::size_t(0), std::size_t(1), std::size_t(513), SIZE_MAX}) {
    CHECK(create(size, k_side) == OPENLTC_INVALID_ARGUMENT);
    CHECK(create(k_side, size) == OPENLTC_INVALID_ARGUMENT);
    CHECK(openltc_lobes_create_polynomial(texels.data(), size, &lobes) == OPENLTC_INVALID_ARGUMENT);
  }
  texels[8 * 5 + 2] = std::numeric_limits<float>::infinity();
  CHECK(create(k_side, k_side) == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("channel 2 of number 5 is not finite"));
  texels = built_in_texels();
  texels[8 * 70] = -1; // A of node (6, 1)
  CHECK(create(k_side, k_side) == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("(6, 1) has no positive determinant"));
  const std::vector<float> zeros(120, 0.0f);
  CHECK(openltc_lobes_create_polynomial(zeros.data(), 4, &lobes) == OPENLTC_INVALID_ARGUMENT);
  CHECK(last_error_says("determinant"));
  CHECK(lobes == nullptr);
}
