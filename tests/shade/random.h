// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Random numbers of the tests: the same sequence with every standard library.

#pragma once

#include "openltc/target/vec.h"

#include <cmath>
#include <cstdint>
#include <random>

namespace openltc::testing {

/// Uniform numbers from a fixed seed; std::mt19937_64 is specified to the bit, distributions are
/// not.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1).
  double uniform() { return double(engine_() >> 11) * 0x1p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /// In [from, to), uniform in the logarithm.
  double log_uniform(double from, double to) { return from * std::pow(to / from, uniform()); }
  int integer(int count) { return int(uniform() * count); }
  Vec2d square() {
    const double x = uniform();
    return Vec2d(x, uniform());
  }
  Vec3d sphere() {
    const double z = uniform(-1, 1), phi = uniform(0, 2 * 3.14159265358979323846);
    const double r = std::sqrt(1 - z * z);
    return Vec3d(r * std::cos(phi), r * std::sin(phi), z);
  }
  Vec3d hemisphere() {
    Vec3d w = sphere();
    w.z = std::abs(w.z);
    return w;
  }

private:
  std::mt19937_64 engine_;
};

} // namespace openltc::testing
