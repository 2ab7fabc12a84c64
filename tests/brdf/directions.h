// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Directions and roughnesses at which BRDFs are tested.

#pragma once

#include "openltc/target/shade_f64.h"

#include <cmath>
#include <vector>

namespace openltc::test {

inline double radians(double degrees) { return degrees * f64::k_pi / 180; }

inline Vec3d direction(double theta, double phi) {
  return Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

inline Vec3d mirrored(Vec3d w) { return Vec3d(-w.x, -w.y, w.z); }

/// The whole range of the slider, both ends, and what lies about the least alpha.
inline const std::vector<double>& roughnesses() {
  static const std::vector<double> list = {0,   1e-3, 0.01, 0.02, 0.05, 0.1,
                                           0.2, 0.35, 0.5,  0.7,  0.85, 1};
  return list;
}

/// Degrees from the normal, up to 89.99.
inline const std::vector<double>& view_angles() {
  static const std::vector<double> list = {0, 1, 10, 35, 60, 75, 85, 88, 89.5, 89.9, 89.99};
  return list;
}

} // namespace openltc::test
