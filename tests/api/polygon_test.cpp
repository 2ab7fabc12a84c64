// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons own their arrays, and outlines that cannot be shaded say why.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace openltc;

namespace {

const std::vector<Vec3f> k_square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

Surface floor_below() {
  return make_surface({1, 1, 3}, {0, 0, -1}, {0, 0, -1}, Material(), built_in_polynomial());
}

std::string error_of(const std::vector<std::vector<Vec3f>>& rings) {
  const Polygon polygon = Polygon::from_rings(rings);
  CHECK(polygon.usable() == (polygon.error() == nullptr));
  // Whatever is wrong with it, it is dark and has no area.
  if (!polygon.usable()) {
    CHECK(polygon.area() == 0);
    CHECK(shade(floor_below(), polygon).x == 0);
    CHECK(!sample_light(floor_below(), polygon, {0.5f, 0.5f}).valid);
    CHECK(pdf_light(floor_below(), polygon, {0, 0, -1}) == 0);
  }
  return polygon.error() ? polygon.error() : "";
}

} // namespace

TEST_CASE("polygons_know_area_and_normal_of_any_outline") {
  const Polygon square = Polygon::from_vertices(k_square);
  REQUIRE(square.usable());
  CHECK(square.area() == doctest::Approx(4));
  CHECK(square.normal().z == 1); // counter-clockwise seen from there
  CHECK(!square.two_sided());
  CHECK(Polygon::from_vertices(k_square, true).two_sided());

  // An L, and two triangles that are one light.
  const Polygon l =
      Polygon::from_vertices({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  CHECK(l.area() == doctest::Approx(3));
  const Polygon two =
      Polygon::from_rings({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}});
  CHECK(two.area() == doctest::Approx(1));
  // A parallelogram: |u x v| times 4.
  CHECK(Polygon::rectangle({0, 0, 0}, {1, 0, 0}, {0.5f, 1, 0}).area() == doctest::Approx(4));
}

TEST_CASE("copies_of_a_polygon_are_independent_and_light_alike") {
  Polygon first = Polygon::from_vertices(k_square);
  const float light = shade(floor_below(), first).x;
  CHECK(light > 0);
  Polygon copy = first;
  CHECK(copy.view().points != first.view().points);
  first = Polygon();
  CHECK(shade(floor_below(), copy).x == light);
  Polygon& itself = copy;
  copy = itself;
  CHECK(shade(floor_below(), copy).x == light);
  const Polygon moved = std::move(copy);
  CHECK(shade(floor_below(), moved).x == light);
  std::vector<Polygon> many(3, moved);
  many.resize(50);
  CHECK(shade(floor_below(), many[2]).x == light);
  CHECK(shade(floor_below(), many[49]).x == 0);
}

TEST_CASE("outlines_that_cannot_be_shaded_are_dark_and_say_why") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(error_of({k_square}).empty());
  CHECK(error_of({}).find("no vertices") != std::string::npos);
  CHECK(error_of({{}}).find("no vertices") != std::string::npos);
  CHECK(error_of({k_square, {{0, 0, 0}, {1, 0, 0}}}).find("fewer than three") != std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}}).find("not finite") != std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {1, 0, 0}, {0, 1e9f, 0}}}).find("4e8") != std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}).find("no area") != std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}).find("no area") != std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0.5f}, {0, 2, 0}}}).find("one plane") !=
        std::string::npos);
  // A hole that runs as its outline does, and an outline that crosses itself.
  CHECK(error_of({k_square, {{0.5f, 0.5f, 0}, {1, 0.5f, 0}, {1, 1, 0}}}).find("hole") !=
        std::string::npos);
  CHECK(error_of({{{0, 0, 0}, {4, 0, 0}, {1, 2, 0}, {3, 2, 0}}}).find("cross") !=
        std::string::npos);
  CHECK(Polygon().error() != nullptr);
}

TEST_CASE("shader_files_get_the_elements_that_they_describe") {
  // A board of 4 x 2 m with a hole of 2 x 1 m in its middle, at a height of 3 m, facing up.
  const std::vector<std::vector<Vec3f>> rings = {
      {{-2, 3, 1}, {2, 3, 1}, {2, 3, -1}, {-2, 3, -1}},
      {{-1, 3, 0.5f}, {-1, 3, -0.5f}, {1, 3, -0.5f}, {1, 3, 0.5f}}};
  const Polygon board = Polygon::from_rings(rings, true);
  REQUIRE(board.usable());
  const std::vector<float> elements = polygon_elements(board.view());
  REQUIRE(elements.size() == 4 * (8 + 10));
  const auto element = [&](std::size_t i) {
    return std::array<float, 4>{elements[4 * i], elements[4 * i + 1], elements[4 * i + 2],
                                elements[4 * i + 3]};
  };
  CHECK(element(0)[0] == 10);
  CHECK(element(0)[1] == 1);
  CHECK(double(element(0)[2]) == doctest::Approx(6));
  CHECK(element(1)[1] == 3); // in its plane
  CHECK(element(4) == std::array<float, 4>{0, 1, 0, 0});
  const std::array<float, 4> middle = element(5);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(double(middle[i]) == doctest::Approx(i == 1 ? 3 : 0).epsilon(1e-5));
  CHECK(double(middle[3]) == doctest::Approx(std::sqrt(5.0)));
  // Variances of the area: along x (8 * 16 / 12 - 2 * 4 / 12) / 6 = 5 / 3, across
  // (8 * 4 / 12 - 2 / 12) / 6 = 5 / 12; the spreads are the roots of twice those.
  CHECK(double(std::abs(element(6)[0])) == doctest::Approx(std::sqrt(10.0 / 3)));
  CHECK(double(std::abs(element(7)[2])) == doctest::Approx(std::sqrt(5.0 / 6)));
  for (std::size_t i = 0; i < 10; ++i) {
    CAPTURE(i);
    const Vec3f corner = rings[i / 5][i % 5 % 4]; // each ring ends with its first point
    CHECK(element(8 + i) ==
          std::array<float, 4>{corner.x, corner.y, corner.z, i % 5 == 0 ? 1.0f : 0.0f});
  }
  // Without points all that is read of a polygon is that it has none.
  const std::vector<float> none = polygon_elements(PolygonView{});
  CHECK(none.size() == 4 * 8);
  CHECK(none[0] == 0);
}
