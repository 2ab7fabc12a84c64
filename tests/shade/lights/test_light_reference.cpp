// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The reference that lights are measured against, against quadrature of the light's definition.

#include "tests/shade/lights/light_reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace openltc;
using testing::LightCase;
using testing::LightShape;
using testing::Random;

TEST_CASE("the contour of every shape gives the integral over its surface") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    Random random(900 + std::uint64_t(k));
    double worst = 0, largest = 0;
    int seen = 0;
    for (int i = 0; i < 60; ++i) {
      LightCase light = testing::random_light(shape, random);
      light.roughness = std::max(light.roughness, 0.3f);
      const testing::CaseView view = testing::view_of(light);
      for (const f64::Lobe& lobe : {view.lobe, f64::cosine_lobe()}) {
        const double contour = testing::contour_integral(light, view, lobe).z;
        const double surface = testing::surface_integral(light, view, lobe, 1e-7);
        // Per metre of diameter: relative for lines.
        const double scale = shape == LightShape::line ? std::max(surface, 1.0) : 1.0;
        const double difference = std::abs(contour - surface) / scale;
        CAPTURE(k);
        CAPTURE(i);
        CAPTURE(contour);
        CAPTURE(surface);
        CHECK(difference < 3e-6);
        worst = std::max(worst, difference);
        largest = std::max(largest, surface);
        seen += surface > 1e-3;
      }
    }
    MESSAGE(std::string(testing::shape_name(shape)), ": largest difference ", worst,
            " of integrals up to ", largest, ", ", seen, " of 120 above 1e-3");
    CHECK(seen > 30);
  }
}
