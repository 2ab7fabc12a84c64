// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/simple_outline.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace {

using namespace openltc;
using Ring = std::vector<Vec2d>;

bool refuses(const Status& status, const std::string& part) {
  return !status.ok() && status.error().message.find(part) != std::string::npos;
}

Ring square(double half, Vec2d at = {0, 0}) {
  return {{at.x - half, at.y - half},
          {at.x + half, at.y - half},
          {at.x + half, at.y + half},
          {at.x - half, at.y + half}};
}

TEST_CASE("outlines_that_bound_an_area_are_simple") {
  CHECK(scene::check_simple(square(1)).ok());
  CHECK(scene::signed_area(square(1)) == doctest::Approx(4));
  CHECK(scene::check_simple(Ring{{0, 0}, {2, 0}, {1, 0.2}, {0, 2}}).ok()); // concave
  CHECK(scene::check_simple(Ring{{0, 0}, {1, 0}, {2, 0}, {2, 1}}).ok());   // a point on an edge
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int i = 0; i < 50; ++i) { // star-shaped about the origin
    Ring ring;
    for (int k = 0; k < 40; ++k) {
      const double r = radius(random), angle = 2 * std::numbers::pi * k / 40;
      ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    CHECK(scene::check_simple(ring).ok());
    std::swap(ring[3], ring[20]); // now it crosses itself
    CHECK(refuses(scene::check_simple(ring), "crosses itself"));
  }
}

TEST_CASE("outlines_that_do_not_are_refused_by_edge_or_point") {
  CHECK(refuses(scene::check_simple(Ring{{0, 0}, {1, 0}}), "three points"));
  CHECK(refuses(scene::check_simple(Ring{{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "edges 0 and 2"));
  CHECK(refuses(scene::check_simple(Ring{{0, 0}, {1, 0}, {1, 0}, {0, 1}}), "points 1 and 2"));
  CHECK(refuses(scene::check_simple(Ring{{0, 0}, {2, 0}, {1, 0}, {1, 1}}), "turns back"));
  CHECK(refuses(scene::check_simple(Ring{{0, 0}, {2, 0}, {4, 0}}), "turns back"));
  // Touching itself in a point.
  CHECK(!scene::check_simple(Ring{{0, 0}, {4, 0}, {2, 2}, {3, 3}, {1, 3}, {2, 2}}).ok());
}

TEST_CASE("holes_lie_inside_and_apart") {
  CHECK(scene::check_inside(square(1), square(2)).ok());
  CHECK(refuses(scene::check_inside(square(1, {2, 0}), square(2)), "crosses"));
  CHECK(refuses(scene::check_inside(square(1, {5, 0}), square(2)), "outside"));
  CHECK(refuses(scene::check_inside(square(2), square(2)), "touches"));
  CHECK(scene::check_apart(square(1), square(1, {3, 0})).ok());
  CHECK(!scene::check_apart(square(1), square(1, {1, 0})).ok());
  CHECK(!scene::check_apart(square(1), square(3)).ok());
}

TEST_CASE("an_outline_of_forty_thousand_points_is_checked_point_by_point") {
  constexpr int n = 40000;
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  CHECK(scene::check_simple(ring).ok());
  // One point moved to the other side: the edges at it cross those there.
  ring[100] = {1.01 * std::cos(4.0), 1.01 * std::sin(4.0)};
  CHECK(refuses(scene::check_simple(ring), "crosses itself: edges 99 and"));
  // Many holes side by side.
  std::vector<Ring> holes;
  for (double x = 0; x < 30; ++x)
    holes.push_back({{x, 0}, {x + 0.9, 0}, {x + 0.9, 1}, {x, 1}});
  for (std::size_t i = 0; i < holes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      CHECK(scene::check_apart(holes[i], holes[k]).ok());
}

} // namespace
