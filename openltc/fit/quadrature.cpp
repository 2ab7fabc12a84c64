// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source of the combination: Veach, Guibas 1995, "Optimally Combining Sampling Techniques for Monte
// Carlo Rendering", equation 9 (balance heuristic); here with fixed grids instead of random points:
//   integral of f = sum over techniques t and points i of f(w_ti) / sum over s of (n_s p_s(w_ti)).

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

  const double count = double(grid) * grid;
  for (const double drawn : {narrow, wide}) {
    for (int i = 0; i < grid; ++i) {
      for (int j = 0; j < grid; ++j) {
        // Midpoints: exact for low frequencies in azimuth, second order in the other direction.
        const Vec2d u((i + 0.5) / (2.0 * grid), (j + 0.5) / grid);
        const Vec3d wi = brdf.sample(wo, drawn, u);
        if (!(wi.z > 0)) continue;
        const double mixture = 0.5 * (brdf.pdf(wo, wi, narrow) + brdf.pdf(wo, wi, wide));
        const brdf::BrdfValue value = brdf.eval(wo, wi, narrow);
        if (!(mixture > 0)) continue;
        const double weight = 1 / (2 * count * mixture);
        q.x_mirror.push_back(cos_theta * wi.x + sin_theta * wi.z);
        q.y.push_back(wi.y);
        q.z_mirror.push_back(cos_theta * wi.z - sin_theta * wi.x);
        q.weight.push_back(weight);
        q.density.push_back(value.scale);
        q.scale.push_back(mixture);
        q.n1 += weight * value.scale;
        q.n5 += weight * value.bias;
      }
    }
  }
  for (double& d : q.density) d /= q.n1;
  return q;
}

} // namespace openltc::fit
