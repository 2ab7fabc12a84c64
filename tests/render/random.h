// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Places and directions at random, the same in every run.

#pragma once

#include "openltc/target/vec.h"

#include <random>

namespace openltc::test {

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float operator()(float low, float high) {
    return low + (high - low) * std::uniform_real_distribution<float>(0, 1)(engine_);
  }
  Vec3f in_box(float half) {
    const float x = (*this)(-half, half), y = (*this)(-half, half);
    return {x, y, (*this)(-half, half)};
  }
  Vec3f direction() {
    for (;;) {
      const Vec3f v = in_box(1);
      const float l = length(v);
      if (l > 0.05f && l < 1) return v / l;
    }
  }

private:
  std::mt19937 engine_;
};

} // namespace openltc::test
