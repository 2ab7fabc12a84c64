// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Expected values: glTF 2.0 specification, appendix C, by hand.

#include "openltc/scene/keyframes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace openltc;
using namespace openltc::scene;

namespace {

const std::vector<double> k_times = {1, 2, 4};

TEST_CASE("times_before_and_behind_the_keys_take_the_nearest_one") {
  for (const auto mode :
       {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    CHECK(find_span(k_times, -5, mode).first == 0);
    CHECK(find_span(k_times, -5, mode).at_key);
    CHECK(find_span(k_times, 1, mode).first == 0);
    CHECK(find_span(k_times, 99, mode).first == 2);
    CHECK(find_span(k_times, 99, mode).at_key);
  }
}

TEST_CASE("a_step_keeps_the_value_of_the_key_before") {
  CHECK(find_span(k_times, 3.999, Interpolation::step).first == 1);
  CHECK(find_span(k_times, 3.999, Interpolation::step).at_key);
  CHECK(find_span(k_times, 4, Interpolation::step).first == 2);
}

TEST_CASE("linear_values_lie_on_the_line_between_two_keys") {
  const KeySpan span = find_span(k_times, 3.5, Interpolation::linear);
  CHECK(span.first == 1);
  CHECK(span.fraction == doctest::Approx(0.75));
  const std::vector<double> from = {10, -4}, to = {20, 4};
  const auto value = value_at(span, from, to, 2, Interpolation::linear, false);
  CHECK(value[0] == doctest::Approx(17.5));
  CHECK(value[1] == doctest::Approx(2));
}

TEST_CASE("rotations_take_the_shorter_arc_at_constant_speed") {
  // About z, from 0 to 120 degrees, of which a third is 40 degrees.
  const auto about_z = [](double degrees) {
    const double half = degrees * std::numbers::pi / 360;
    return std::vector<double>{0, 0, std::sin(half), std::cos(half)};
  };
  KeySpan span;
  span.at_key = false;
  span.fraction = 1.0 / 3;
  std::vector<double> to = about_z(120);
  const auto expected = about_z(40);
  for (const double sign : {1.0, -1.0}) { // a quaternion and its opposite are one rotation
    std::vector<double> signed_to = to;
    for (double& c : signed_to)
      c *= sign;
    const auto value = value_at(span, about_z(0), signed_to, 4, Interpolation::linear, true);
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(value[i] == doctest::Approx(expected[i]));
  }
}

TEST_CASE("cubic_splines_follow_the_formula_of_the_specification") {
  // Keys of one number: in-tangent, value, out-tangent. The cubic p(t) = t^3 - 2 t over [2, 4] is
  // its own Hermite spline: p' = 3 t^2 - 2.
  const auto p = [](double t) { return t * t * t - 2 * t; };
  const auto slope = [](double t) { return 3 * t * t - 2; };
  const std::vector<double> from = {99, p(2), slope(2)}, to = {slope(4), p(4), 99};
  for (const double t : {2.2, 3.0, 3.7}) {
    const KeySpan span = find_span(k_times, t, Interpolation::cubic_spline);
    CHECK(value_at(span, from, to, 1, Interpolation::cubic_spline, false)[0] ==
          doctest::Approx(p(t)));
  }
}

TEST_CASE("a_cubic_rotation_has_unit_length") {
  const std::vector<double> from = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0};
  const std::vector<double> to = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
  KeySpan span;
  span.at_key = false;
  span.fraction = 0.5;
  span.seconds = 1;
  const auto value = value_at(span, from, to, 4, Interpolation::cubic_spline, true);
  CHECK(value[2] == doctest::Approx(std::sqrt(0.5)));
  CHECK(value[3] == doctest::Approx(std::sqrt(0.5)));
}

} // namespace
