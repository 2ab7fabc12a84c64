// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Quads around a point at the origin, and what GGX reflects of them by many points of each: what
// the sums along edges, and those of few points, are held against.
#pragma once

#include "openltc/target/shade_f64.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <algorithm>
#include <cmath>

namespace openltc::testing {

/// f_s cos_i.
inline double reflected(const f64::Surface& s, Vec3d wi) {
  const f64::GgxTerms terms = f64::eval_ggx_terms(s.wo, wi, s.alpha);
  return s.f0.x * terms.scale + (s.f90.x - s.f0.x) * terms.bias;
}

/// A rectangle.
struct Quad {
  Vec3d center, u, v; // half extents at right angles, facing the origin with u x v

  TestPolygon polygon() const {
    return TestPolygon({rectangle(2 * length(u), 2 * length(v))}, center, normalize(u),
                       normalize(v));
  }
};

/// The light of a quad, by the middles of n x n parts.
inline double midpoints(const f64::Surface& s, const Quad& q, int n) {
  const Vec3d normal = normalize(cross(q.u, q.v));
  const double area = 4 * length(q.u) * length(q.v) / (n * n);
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3d p = q.center + q.u * (2 * (i + 0.5) / n - 1) + q.v * (2 * (j + 0.5) / n - 1);
      const double distance2 = dot(p, p), facing = -dot(p, normal) / std::sqrt(distance2);
      const Vec3d wi = f64::to_shading(s.frame, normalize(p));
      if (facing > 0) sum += reflected(s, wi) * facing / distance2;
    }
  return sum * area;
}

/// Anywhere above, more or less towards the origin.
inline Quad random_quad(double size, Random& random) {
  const Vec3d w = random.hemisphere();
  const f64::Frame frame =
      f64::shading_frame(normalize(random.sphere() * 0.9 - w), Vec3d(0, 0.3, 1));
  return {w * random.uniform(1, 4), frame.t1 * (size * random.uniform(0.1, 2)),
          frame.t2 * (size * random.uniform(0.1, 2))};
}

/// Errors over what is right.
struct Errors {
  double sum = 0, light = 0, worst = 0;
  int count = 0;

  void add(double found, double exact) {
    sum += std::abs(found - exact);
    light += exact;
    worst = std::max(worst, std::abs(found - exact));
    ++count;
  }
  double mean() const { return sum / count; }
  double of_light() const { return sum / light; }
};

} // namespace openltc::testing
