// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Levenberg-Marquardt on iteratively reweighted squares.
//
// Sources:
//   Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed
//     Cosines", section 3 (the fit; three degrees of freedom there, four here);
//   Marquardt 1963, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters".
//
// Each step solves the reweighted squares of objective.cpp, damped; one that does not lower the
// objective is taken back and damped more.

#include "openltc/fit/lobe_fit.h"

#include "openltc/target/shade_f64.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace openltc::fit {

// With o = M^-1 w = (A x' + aB z', y, a (C x' + D z')) and det = a (A D - a B C),
//   value = o.z det / (pi |o|^4),
//   d value = value (d det / det + d o.z / o.z - 4 o . d o / |o|^2).
LobeDensity lobe_density(Vec4d abcd, double alpha, Vec3d wi_mirror) {
  LobeDensity result;
  const double x = wi_mirror.x, z = wi_mirror.z;
  const double ox = abcd.x * x + alpha * abcd.y * z;
  const double oz = alpha * (abcd.z * x + abcd.w * z);
  if (!(oz > 0)) return result;
  const double det = alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
  const double inv_length2 = 1 / (ox * ox + wi_mirror.y * wi_mirror.y + oz * oz);
  const double common = inv_length2 * inv_length2 * f64::k_inv_pi;
  const double value = oz * det * common;
  const double by_ox = -4 * ox * inv_length2 * value;
  const double by_oz = det * common - 4 * oz * inv_length2 * value;
  const double by_det = oz * common;
  result.value = value;
  result.derivative[0] = by_det * alpha * abcd.w + by_ox * x;
  result.derivative[1] = -by_det * alpha * alpha * abcd.z + by_ox * alpha * z;
  result.derivative[2] = -by_det * alpha * alpha * abcd.y + by_oz * alpha * x;
  result.derivative[3] = by_det * alpha * abcd.x + by_oz * alpha * z;
  return result;
}

double lobe_leak(Vec4d abcd, double alpha, double cos_theta) {
  return 1 - above_horizon(f64::lobe_from_mirror(abcd, alpha, cos_theta));
}

double above_horizon(const f64::Lobe& lobe) { return f64::share_above_horizon(lobe); }

Vec4d cosine_start(double alpha, double cos_theta) {
  return f64::mirror_from_lobe(f64::cosine_lobe(), alpha, cos_theta);
}

LobeFit fit_lobe(const Quadrature& q, Vec4d start, const LobeFitOptions& options) {
  using Matrix4 = Eigen::Matrix4d;
  using Vector4 = Eigen::Vector4d;
  LobeFit fit;
  fit.mirror = start;
  const bool symmetric = q.cos_theta >= 1;
  if (symmetric) fit.mirror = Vec4d(1, 0, 0, start.w);

  ObjectiveValue at = evaluate_objective(q, fit.mirror, options.objective);
  double damping = 1e-4;
  while (fit.iterations < options.max_iterations && !fit.converged && damping < 1e12) {
    Matrix4 system;
    Vector4 gradient;
    int k = 0;
    for (int i = 0; i < 4; ++i) {
      gradient[i] = at.gradient[i];
      for (int j = i; j < 4; ++j, ++k)
        system(i, j) = system(j, i) = at.hessian[k];
      system(i, i) += damping * system(i, i) + 1e-300;
    }
    const Vector4 step = symmetric ? Vector4(0, 0, 0, -gradient[3] / system(3, 3))
                                   : Vector4(-system.ldlt().solve(gradient));
    const Vec4d trial(fit.mirror.x + step[0], fit.mirror.y + step[1], fit.mirror.z + step[2],
                      fit.mirror.w + step[3]);
    const ObjectiveValue there = evaluate_objective(q, trial, options.objective);
    ++fit.iterations;
    if (there.value <= at.value) {
      fit.converged = at.value - there.value <= options.tolerance * at.value &&
                      step.cwiseAbs().maxCoeff() < options.step_tolerance;
      fit.mirror = trial;
      at = there;
      damping = std::max(damping * 0.1, 1e-9);
    } else {
      fit.converged = step.cwiseAbs().maxCoeff() < 1e-9;
      damping = std::max(damping, 1e-6) * 8;
    }
  }
  fit.objective = at.value;
  return fit;
}

} // namespace openltc::fit
