// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons own their arrays, and outlines that cannot be shaded say why.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

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
