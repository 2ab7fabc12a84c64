// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the functions of parity_body.inc are called with.

#pragma once

#include "openltc/target/vec.h"
#include "tests/shade/parity/parity.h"
#include "tests/shade/random.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace openltc::testing {

inline constexpr int k_count = 4096;

struct Batch {
  std::vector<float> in = std::vector<float>(std::size_t(k_parity_inputs) * k_count);
};

// Everything is drawn in double and rounded once, so that all number types get the same numbers.
inline Batch make_batch(Random& random) {
  Batch batch;
  for (int i = 0; i < k_count; ++i) {
    int k = 0;
    const auto put = [&](double x) { batch.in[std::size_t(k++ * k_count + i)] = float(x); };
    const auto put3 = [&](Vec3d v) {
      put(v.x);
      put(v.y);
      put(v.z);
    };
    const double roughness = random.log_uniform(0.05, 1);
    const double theta = random.uniform(0, 1.5), c = std::cos(theta), s = std::sin(theta);
    put(roughness);
    put3(Vec3d(s, 0, c));
    put3(random.sphere());
    const Vec3d normal = random.sphere();
    Vec3d wo = random.sphere();
    if (dot(wo, normal) < 0) wo = -wo;
    put3(normal);
    put3(wo);
    const Vec3d position(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    put3(position);
    for (const double x : {0.2 + 0.7 * c, -0.8 * s, 1.3 * s, 0.2 + 1.6 * c})
      put(x);
    put(random.uniform());
    put(random.uniform());
    put3(Vec3d(random.uniform(), random.uniform(), random.uniform()));
    put3(random.sphere());
    put(random.uniform(0, 4));
    put(random.uniform(0, 3));
  }
  return batch;
}

} // namespace openltc::testing
