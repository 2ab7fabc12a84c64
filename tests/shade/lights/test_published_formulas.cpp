// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The published formulas as written down here, where they must be exact: what they approximate away
// is not at work there. Otherwise a comparison with them would say nothing.

#include "tests/shade/lights/light_reference.h"
#include "tests/shade/lights/published_formulas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using testing::LightCase;
using testing::LightShape;
using testing::Random;

TEST_CASE("published formulas agree with the reference where they are exact") {
  for (const LightShape shape : {LightShape::rectangle, LightShape::polygon, LightShape::disk,
                                 LightShape::ellipse, LightShape::sphere, LightShape::line}) {
    Random random(77);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
      LightCase light = testing::random_light(shape, random);
      light.roughness = std::max(light.roughness, 0.2f);
      const testing::CaseView view = testing::view_of(light);
      for (const f64::Lobe& lobe : {view.lobe, f64::cosine_lobe()}) {
        const Vec3d exact = testing::contour_integral(light, view, lobe, false);
        // Wholly above the cosine's horizon: a sphere of the same vector is then above it, too,
        // but the other way round it need not be.
        f64::Lobe flipped = lobe;
        flipped.m20 = -lobe.m20;
        flipped.m22 = -lobe.m22;
        const bool above = testing::contour_integral(light, view, flipped, false).z == 0;
        if (shape != LightShape::line &&
            (!above || exact.z * exact.z < length(exact) * dot(exact, exact)))
          continue;
        CAPTURE(int(shape));
        CAPTURE(i);
        const double scale = std::max(exact.z, 1.0);
        CHECK(std::abs(testing::published_integral(light, view, lobe) - exact.z) < 1e-6 * scale);
        ++compared;
      }
    }
    CHECK(compared > 300);
  }
}

TEST_CASE("a published tube tends to the tube as it gets thin") {
  Random random(78);
  for (int i = 0; i < 500; ++i) {
    LightCase light = testing::random_light(LightShape::tube_open, random);
    light.roughness = std::max(light.roughness, 0.3f);
    light.radius *= 1e-4f;
    const testing::CaseView view = testing::view_of(light);
    const double exact = testing::contour_integral(light, view, view.lobe, false).z;
    const double published = testing::published_integral(light, view, view.lobe);
    CHECK(std::abs(published - exact) < 2e-3 * exact + 1e-9);
  }
}
