// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace {

using namespace openltc;
using scene::Ring;

using Triangle = std::array<std::uint32_t, 3>;

struct Soup {
  std::vector<Vec3d> points;
  std::vector<Triangle> triangles;
};

constexpr double k_tolerance = 1e-9;
const Vec3d k_up(0, 0, 1);

// Unit cells of a w x h grid where `is_filled`, each as two triangles with a diagonal of its own.
template <class Filled> Soup grid(int w, int h, std::mt19937& random, const Filled& is_filled) {
  Soup soup;
  for (int y = 0; y <= h; ++y)
    for (int x = 0; x <= w; ++x)
      soup.points.push_back(Vec3d(x, y, 0));
  const auto at = [&](int x, int y) { return std::uint32_t(y * (w + 1) + x); };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      if (!is_filled(x, y)) continue;
      const std::uint32_t a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
      if (random() % 2) {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({c, d, a});
      } else {
        soup.triangles.push_back({b, c, d});
        soup.triangles.push_back({d, a, b});
      }
    }
  }
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
  return soup;
}

double area_of(const Soup& soup, Vec3d normal) {
  double sum = 0;
  for (const Triangle& t : soup.triangles)
    sum += 0.5 *
           dot(cross(soup.points[t[1]] - soup.points[t[0]], soup.points[t[2]] - soup.points[t[0]]),
               normal);
  return sum;
}

double area_of(const std::vector<Ring>& rings, Vec3d normal) {
  double sum = 0;
  for (const Ring& ring : rings)
    sum += scene::signed_area(ring, normal);
  return sum;
}

// Rings with positive area.
std::size_t outer_count(const std::vector<Ring>& rings, Vec3d normal) {
  return std::size_t(std::count_if(rings.begin(), rings.end(), [&](const Ring& ring) {
    return scene::signed_area(ring, normal) > 0;
  }));
}

bool visits_no_corner_twice(const Ring& ring) {
  std::set<std::array<double, 3>> seen;
  for (const Vec3d& p : ring)
    if (!seen.insert({p.x, p.y, p.z}).second) return false;
  return true;
}

std::vector<Ring> trace(const Soup& soup, Vec3d normal = k_up) {
  return scene::trace_outline(soup.points, soup.triangles, normal, k_tolerance);
}

TEST_CASE("a_square_of_many_triangles_has_four_corners") {
  std::mt19937 random(1);
  const auto rings = trace(grid(5, 4, random, [](int, int) { return true; }));
  REQUIRE(rings.size() == 1);
  CHECK(rings[0].size() == 4);
  CHECK(scene::signed_area(rings[0], k_up) == doctest::Approx(20));
}

TEST_CASE("an_l_has_six_corners") {
  std::mt19937 random(2);
  const auto rings = trace(grid(4, 4, random, [](int x, int y) { return x == 0 || y == 0; }));
  REQUIRE(rings.size() == 1);
  CHECK(rings[0].size() == 6);
  CHECK(scene::signed_area(rings[0], k_up) == doctest::Approx(7));
}

TEST_CASE("holes_run_clockwise_and_come_after_the_outside") {
  std::mt19937 random(3);
  const auto rings = trace(grid(5, 3, random, [](int x, int y) { return y != 1 || x % 2 == 0; }));
  REQUIRE(rings.size() == 3);
  CHECK(scene::signed_area(rings[0], k_up) == doctest::Approx(15));
  CHECK(scene::signed_area(rings[1], k_up) == doctest::Approx(-1));
  CHECK(scene::signed_area(rings[2], k_up) == doctest::Approx(-1));
  for (const Ring& ring : rings)
    CHECK(ring.size() == 4);
}

TEST_CASE("islands_are_outer_rings_and_may_stand_in_holes") {
  std::mt19937 random(4);
  const auto rings = trace(grid(5, 5, random, [](int x, int y) {
    const int ring = std::min({x, y, 4 - x, 4 - y});
    return ring != 1;
  }));
  REQUIRE(rings.size() == 3);
  CHECK(outer_count(rings, k_up) == 2);
  CHECK(area_of(rings, k_up) == doctest::Approx(17));
}

TEST_CASE("rings_that_touch_in_a_corner_stay_simple") {
  std::mt19937 random(5);
  SUBCASE("two squares") {
    const auto rings = trace(grid(2, 2, random, [](int x, int y) { return x == y; }));
    REQUIRE(rings.size() == 2);
    CHECK(outer_count(rings, k_up) == 2);
  }
  SUBCASE("two holes") {
    const auto rings = trace(grid(
        4, 4, random, [](int x, int y) { return !((x == 1 && y == 1) || (x == 2 && y == 2)); }));
    CHECK(area_of(rings, k_up) == doctest::Approx(14));
    for (const Ring& ring : rings)
      CHECK(visits_no_corner_twice(ring));
  }
  SUBCASE("a hole and the outside") {
    const auto rings = trace(grid(
        3, 3, random, [](int x, int y) { return !((x == 1 && y == 1) || (x == 2 && y == 2)); }));
    CHECK(area_of(rings, k_up) == doctest::Approx(7));
    for (const Ring& ring : rings)
      CHECK(visits_no_corner_twice(ring));
  }
}

TEST_CASE("any_pattern_in_any_plane_keeps_its_area_and_gives_simple_rings") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    const int w = 1 + int(random() % 8), h = 1 + int(random() % 8);
    const unsigned density = 1 + unsigned(random() % 4);
    std::vector<bool> filled(std::size_t(w * h));
    for (std::size_t i = 0; i < filled.size(); ++i)
      filled[i] = random() % 5 <= density;
    Soup soup =
        grid(w, h, random, [&](int x, int y) { return bool(filled[std::size_t(y * w + x)]); });
    // rotate, shear within the plane, shift
    const Vec3d n = normalize(Vec3d(uniform(random), uniform(random), uniform(random) + 0.1));
    const Vec3d t = normalize(cross(n, std::abs(n.x) < 0.7 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)));
    const Vec3d b = cross(n, t);
    const double shear = uniform(random);
    for (Vec3d& p : soup.points)
      p = t * (p.x + shear * p.y) + b * p.y + Vec3d(3, -2, 7);
    const auto rings = trace(soup, n);
    CHECK(area_of(rings, n) == doctest::Approx(area_of(soup, n)).epsilon(1e-9));
    bool holes_began = false;
    for (const Ring& ring : rings) {
      CHECK(ring.size() >= 3);
      CHECK(visits_no_corner_twice(ring));
      const bool is_hole = scene::signed_area(ring, n) < 0;
      CHECK(!(holes_began && !is_hole));
      holes_began = is_hole;
    }
    CHECK(rings.empty() == soup.triangles.empty());
  }
}

TEST_CASE("t_junctions_leave_no_seam") {
  // one large triangle pair beside two small ones
  Soup soup;
  soup.points = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 2, 0), Vec3d(0, 2, 0),
                 Vec3d(2, 0, 0), Vec3d(2, 2, 0), Vec3d(1, 1, 0), Vec3d(2, 1, 0)};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 7}, {1, 7, 6}, {6, 7, 5}, {6, 5, 2}};
  const auto rings = trace(soup);
  REQUIRE(rings.size() == 1);
  CHECK(rings[0].size() == 4);
  CHECK(scene::signed_area(rings[0], k_up) == doctest::Approx(4));
}

TEST_CASE("overlapping_triangles_become_separate_rings_of_the_same_total") {
  Soup soup;
  soup.points = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0.2, 1, 0),
                 Vec3d(0.4, 1, 0)};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const auto rings = trace(soup);
  CHECK(rings.size() == 3);
  CHECK(area_of(rings, k_up) == doctest::Approx(1.5));
}

TEST_CASE("no_area_gives_no_rings") {
  Soup soup;
  soup.points = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 0, 0)};
  soup.triangles = {{0, 1, 2}};
  CHECK(trace(soup).empty());
  CHECK(trace(Soup{}).empty());
}

} // namespace
