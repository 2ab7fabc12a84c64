// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Integrals over the sphere in coordinates that resolve a narrow lobe.
//
// With gamma the angle to the axis, r = tan(gamma/2)/width and s = r^2/(1 + r^2), the unit square
// (s, phi/2pi) covers the sphere; d omega = 2 width^2 / ((1 + width^2 r^2)^2 (1 - s)^2) ds dphi.

#pragma once

#include "openltc/target/shade_f64.h"

#include <cmath>

namespace openltc::testing {

struct SphereMap {
  f64::Frame frame; // n is the axis
  double width;

  SphereMap(Vec3d axis, double width_) : frame(f64::shading_frame(axis, axis)), width(width_) {}

  Vec3d direction(double s, double phi) const {
    const double t = width * std::sqrt(s / (1 - s));
    const double inv = 1 / (1 + t * t);
    return f64::to_world(
        frame, Vec3d(2 * t * std::cos(phi) * inv, 2 * t * std::sin(phi) * inv, (1 - t * t) * inv));
  }
  double solid_angle(double s) const { // per ds dphi
    const double t2 = width * width * s / (1 - s);
    const double a = (1 + t2) * (1 - s);
    return 2 * width * width / (a * a);
  }
  double s_of(Vec3d w) const {
    const Vec3d local = f64::to_shading(frame, w);
    // tan^2(gamma/2), without cancellation near the axis.
    const double c = 1 + local.z;
    const double t2 = (local.x * local.x + local.y * local.y) / (c * c > 1e-300 ? c * c : 1e-300);
    const double r2 = t2 / (width * width);
    return r2 / (1 + r2);
  }
  double phi_of(Vec3d w) const {
    const Vec3d local = f64::to_shading(frame, w);
    const double phi = std::atan2(local.y, local.x);
    return phi < 0 ? phi + 2 * f64::k_pi : phi;
  }

  /// Midpoint rule of n x n points, crowded towards both ends in s.
  template <class F> double integrate(F f, int n) const {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n;
      const double s = t * t * (3 - 2 * t);
      double row = 0;
      for (int j = 0; j < n; ++j)
        row += f(direction(s, 2 * f64::k_pi * (j + 0.5) / n));
      sum += row * solid_angle(s) * 6 * t * (1 - t);
    }
    return sum * 2 * f64::k_pi / (double(n) * n);
  }
};

} // namespace openltc::testing
