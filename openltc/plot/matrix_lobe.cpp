// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Inverse of M, with D = a - b d:
//   M^-1 = [ 1/D  0  -b/D ; 0  1/c  0 ; -d/D  0  a/D ],
// and scaled by c, so that its middle element is 1 as in shade/lobe.glsl.

#include "openltc/plot/matrix_lobe.h"

#include "openltc/plot/lobe_quadrature.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace openltc::plot {

namespace {

// D(w) at w = M o / |M o|, for a unit o.
double density_at(const f64::Lobe& lobe, Vec3d o) {
  return f64::eval_lobe(lobe, normalize(f64::from_cosine(lobe, o)));
}

// The maximum of D over o = (sin t cos p, sin t sin p, cos t): a grid, then a compass search. A
// lobe that is stretched across has two, at +-p.
Vec3d peak_cosine(const f64::Lobe& lobe) {
  const auto direction = [](double t, double p) {
    return Vec3d(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
  };
  constexpr int k_rings = 90, k_spokes = 60;
  double best_t = 0, best_p = 0, best = density_at(lobe, {0, 0, 1});
  const auto improve = [&](double t, double p) {
    const double density = density_at(lobe, direction(t, p));
    if (!(density > best)) return false;
    best = density, best_t = t, best_p = p;
    return true;
  };
  for (int i = 1; i < k_rings; ++i)
    for (int j = 0; j <= k_spokes; ++j)
      improve(0.5 * f64::k_pi * i / k_rings, f64::k_pi * j / k_spokes);
  for (double step = 0.05; step > 1e-9; step *= 0.5)
    for (bool better = true; better;) {
      better = false;
      for (const auto& [dt, dp] : {std::array{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
        better = improve(best_t + step * dt, best_p + step * dp) || better;
    }
  return direction(best_t, best_p);
}

} // namespace

double determinant(const LobeMatrix& m) { return m.c * (m.a - m.b * m.d); }

Vec3d column(const LobeMatrix& m, int axis) {
  if (axis == 0) return {m.a, 0, m.d};
  if (axis == 1) return {0, m.c, 0};
  return {m.b, 0, 1};
}

Status check_matrix(const LobeMatrix& m, const std::string& name) {
  for (const double v : {m.a, m.b, m.c, m.d})
    if (!std::isfinite(v) || std::abs(v) > 20)
      return Error{fmt::format("{}: a, b, c, d of M = [[a,0,b],[0,c,0],[d,0,1]] must be numbers "
                               "between -20 and 20",
                               name)};
  // Narrower lobes are a tenth of a degree wide: no picture shows them.
  const double in_plane = m.a - m.b * m.d;
  if (!(m.c >= 0.002) || !(in_plane >= 0.002))
    return Error{fmt::format("{}: det M = c (a - b d) = {:.4g}{}; M = [[a,0,b],[0,c,0],[d,0,1]] "
                             "needs c > 0 and a > b d, both by 0.002 at least",
                             name, determinant(m),
                             determinant(m) > 0 && m.c < 0 ? " with c < 0" : "")};
  return Success{};
}

f64::Lobe lobe_of_matrix(const LobeMatrix& m) {
  const double scale = m.c / (m.a - m.b * m.d);
  return f64::make_lobe(scale, -m.b * scale, -m.d * scale, m.a * scale);
}

Result<LobeMatrix> matrix_of_lobe(const f64::Lobe& lobe) {
  if (!(lobe.m00 > 1e-6) || !(lobe.det > 0))
    return Error{"the lobe's matrix cannot be scaled to a last element of 1"};
  return LobeMatrix{lobe.m22 / lobe.m00, -lobe.m02 / lobe.m00, lobe.det / lobe.m00,
                    -lobe.m20 / lobe.m00};
}

LobeFacts lobe_facts(const f64::Lobe& lobe) {
  LobeFacts facts;
  const Vec3d peak = peak_cosine(lobe);
  facts.peak = density_at(lobe, peak);
  facts.peak_direction = normalize(f64::from_cosine(lobe, peak));
  const LobeMoments moments = integrate_over_sphere(lobe);
  facts.integral = moments.mass;
  facts.mean_direction = normalize(moments.first);
  facts.above = f64::share_above_horizon(lobe);
  return facts;
}

} // namespace openltc::plot
