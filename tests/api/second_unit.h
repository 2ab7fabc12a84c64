// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A second translation unit with the whole API in it. It is C++17, and compiled as that too
// (tests/tools/test_api_headers.py).

#pragma once

#include "openltc/openltc.h"

namespace openltc::testing {

/// Where that unit has the built-in numbers.
const float* table_of_second_unit();
const float* polynomial_of_second_unit();

/// One call of every function that shades or samples: the sum of what comes out.
double all_of_it_in_second_unit();

/// What it does.
inline double sum_of_all() {
  Material material;
  material.roughness = 0.4f;
  double sum = 0;
  const auto add = [&](Vec3f v) { sum += double(v.x) + double(v.y) + double(v.z); };
  for (const Lobes& lobes : {built_in_table(), built_in_polynomial()}) {
    const Surface surface =
        make_surface({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, material, lobes, {0, 1, 0.1f});
    const auto use = [&](const auto& light) {
      add(shade(surface, light, Vec3f(2.0f)));
      const LightSample sample = sample_light(surface, light, {0.3f, 0.6f});
      add(eval_surface(surface, sample.direction) * sample.pdf);
    };
    const auto meet = [&](const auto& light) {
      use(light);
      add(intersect_light(surface, light, {0, 1, 0}).position);
      sum += double(pdf_light(surface, light, {0, 1, 0}));
    };
    meet(Polygon::rectangle({0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}));
    meet(disk({0, 1, 0}, {0, -1, 0}, 0.5f));
    meet(Sphere{{0, 1, 0}, 0.5f});
    meet(Tube{{-1, 1, 0}, {1, 1, 0}, 0.1f, TubeCaps::flat});
    use(Line{{-1, 1, 0}, {1, 1, 0}});
    add(shade(surface, PointLight{{0, 1, 0}}));
    add(shade(surface, SpotLight{{0, 1, 0}, {0, -1, 0}}));
    add(shade(surface, DirectionalLight{{0, -1, 0}}));
    const DirectionSample sample = sample_surface(surface, {0.3f, 0.6f});
    add(sample.value);
    sum += double(sample.pdf);
  }
  return sum;
}

} // namespace openltc::testing
