// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source of the combination: Veach, Guibas 1995, "Optimally Combining Sampling Techniques for Monte
// Carlo Rendering", equation 9 (balance heuristic); here with fixed grids instead of random points:
//   integral of f = sum over techniques t and points i of c_i f(w_ti) / sum over s of p_s(w_ti),
// c_i being the area that point i stands for in the unit square. In the direction that decides how
// far out of the lobe a point lies, u.y, points crowd towards both ends: u = t^3 (10 - 15 t + 6
// t^2) at the midpoints t of equal cells. The lobe's tail and its cut at the horizon are resolved
// so; the derivative vanishes at both ends, which makes the midpoint rule converge fast.

#include "openltc/fit/quadrature.h"

#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>

namespace openltc::fit {

namespace {

// The fitted lobe is wider than the BRDF in places; points three times as wide in alpha find them.
constexpr double k_widening = 1.7320508075688772; // in roughness

} // namespace

Quadrature make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta, int grid) {
  Quadrature q;
  q.cos_theta = cos_theta;
  q.alpha = f64::alpha_from_roughness(roughness);
  const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
  const Vec3d wo(sin_theta, 0, cos_theta);
  const double narrow = f64::roughness_from_alpha(q.alpha);
  const double wide = k_widening * narrow;

  for (const double drawn : {narrow, wide}) {
    for (int j = 0; j < grid; ++j) {
      const double t = (j + 0.5) / grid;
      const double v = t * t * t * (10 + t * (-15 + 6 * t));
      const double area = 30 * t * t * (1 - t) * (1 - t) / (double(grid) * grid);
      for (int i = 0; i < grid; ++i) {
        const Vec3d wi = brdf.sample(wo, drawn, Vec2d((i + 0.5) / (2.0 * grid), v));
        if (!(wi.z > 0)) continue;
        const double sum = brdf.pdf(wo, wi, narrow) + brdf.pdf(wo, wi, wide);
        if (!(sum > 0)) continue;
        const brdf::BrdfValue value = brdf.eval(wo, wi, narrow);
        const double weight = area / sum;
        q.x_mirror.push_back(cos_theta * wi.x + sin_theta * wi.z);
        q.y.push_back(wi.y);
        q.z_mirror.push_back(cos_theta * wi.z - sin_theta * wi.x);
        q.weight.push_back(weight);
        q.density.push_back(value.scale);
        q.scale.push_back(0.5 * sum);
        q.n1 += weight * value.scale;
        q.n5 += weight * value.bias;
      }
    }
  }
  for (double& d : q.density)
    d /= q.n1;
  return q;
}

} // namespace openltc::fit
