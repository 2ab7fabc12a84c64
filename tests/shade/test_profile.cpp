// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Angles and grid of intensity profiles.

#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace openltc;

TEST_CASE("angles of profiles are accurate to 2.5e-7 radians in double, 6e-7 in float") {
  double worst = 0, worst_single = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double angle = f64::k_pi * i / 100000;
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const double x = scale * std::cos(angle), y = std::abs(scale * std::sin(angle));
      worst = std::max(worst, std::abs(f64::half_turn_angle(x, y) - angle));
      const double single = double(f32::half_turn_angle(float(x), float(y)));
      worst_single = std::max(worst_single, std::abs(single - angle));
    }
  }
  MESSAGE("double " << worst << ", float " << worst_single);
  CHECK(worst < 2.5e-7);
  CHECK(worst > 1e-7); // the stated error is the true one
  CHECK(worst_single < 6e-7);
  CHECK(f32::half_turn_angle(0.0f, 0.0f) == 0.0f);
}

TEST_CASE("a profile has its nodes' values at their angles, all around") {
  constexpr int columns = 13, rows = 10;
  std::vector<float> values;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      values.push_back(float((j * 7 + i % (columns - 1) * 5) % 17) / 17);
  const ProfileView view{values.data(), columns, rows};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double vertical = f64::k_pi * j / (rows - 1),
                   azimuth = 2 * f64::k_pi * i / (columns - 1);
      const Vec3d direction(std::sin(vertical) * std::cos(azimuth),
                            std::sin(vertical) * std::sin(azimuth), std::cos(vertical));
      // At the poles every azimuth is the same direction.
      if (j == 0 || j == rows - 1) continue;
      CHECK(f64::eval_profile(view, direction) ==
            doctest::Approx(double(values[std::size_t(j * columns + i)])).epsilon(1e-5));
    }
}

TEST_CASE("a profile shades any direction, also one that is none, within its values") {
  const std::vector<float> values = {0, 0.25f, 0, 1, 0.5f, 1};
  const ProfileView view{values.data(), 3, 2};
  for (const float x : {0.0f, -0.0f, 1e-30f, -1e-20f, 1.0f, -1e15f})
    for (const float y : {0.0f, -0.0f, 1e-30f, 2.0f, -1e15f})
      for (const float z : {0.0f, -0.0f, -1e-30f, 1.0f, -1e15f}) {
        const float share = f32::eval_profile(view, Vec3f(x, y, z));
        CHECK((share >= 0.0f && share <= 1.0f));
      }
}
