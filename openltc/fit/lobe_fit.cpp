// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Levenberg-Marquardt on iteratively reweighted squares.
//
// Sources:
//   Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed
//     Cosines", section 3 (the fit; three degrees of freedom there, four here);
//   Marquardt 1963, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters";
//   Holland, Welsch 1977, "Robust Regression Using Iteratively Reweighted Least-Squares".
//
// With r = D - rho/E over the hemisphere, s the density of the quadrature's points, e the rounding
// and L the lobe's leak below the horizon, the objective is
//   F = 1/2 ( integral of [sqrt(r^2 + (e s)^2) - e s] + L )  +  l2_weight * integral of r^2 / N2,
//   N2 = integral of (rho/E)^2.
// The first part is the total variation, rounded so that it is smooth: it bounds the shading error
// of every light. The second holds on to the peak, which total variation alone gives away at
// grazing angles. F's gradient is that of the weighted squares 1/2 sum w_i omega_i r_i^2 with
//   omega = 1/(2 sqrt(r^2 + (e s)^2)) + 2 l2_weight / N2
// at the current r, so each step solves those; a step that does not lower F is taken back and
// damped more.
//
// The leak is exact: below the horizon rho = 0, and the integral of D there is, in cosine space,
// the cosine's integral over a half-space with normal m = M^T z ~ (-m20, 0, m00), (1 - cos g)/2
// with cos g = m_z/|m|; that is sin^2(g/2), a square by itself.

#include "openltc/fit/lobe_fit.h"

#include "openltc/target/shade_f64.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace openltc::fit {

namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4>;
using Vector4 = Eigen::Matrix<double, 4, 1>;

// Angle g between the cosine's axis and the surface's normal in cosine space, with derivatives.
struct LeakAngle {
  double half_sine = 0; // sin(g/2); its square is the leak
  double derivative[4] = {0, 0, 0, 0};
};

LeakAngle leak_angle(Vec4d abcd, double alpha, double cos_theta) {
  const double c = cos_theta, s = std::sqrt(std::max(0.0, 1 - c * c));
  const double m00 = abcd.x * c - alpha * abcd.y * s;
  const double m20 = alpha * (abcd.z * c - abcd.w * s);
  const double length2 = m00 * m00 + m20 * m20;
  const double g = std::atan2(-m20, m00);
  // dg = (m20 dm00 - m00 dm20) / length2
  const double by_m00 = m20 / length2, by_m20 = -m00 / length2;
  const double outer = 0.5 * std::cos(0.5 * g);
  LeakAngle result;
  result.half_sine = std::sin(0.5 * g);
  result.derivative[0] = outer * by_m00 * c;
  result.derivative[1] = outer * by_m00 * -alpha * s;
  result.derivative[2] = outer * by_m20 * alpha * c;
  result.derivative[3] = outer * by_m20 * -alpha * s;
  return result;
}

double determinant(Vec4d abcd, double alpha) {
  return alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
}

// Objective, and when asked for the normal equations of the reweighted squares.
struct Evaluation {
  double objective = std::numeric_limits<double>::infinity();
  Matrix4 hessian = Matrix4::Zero();
  Vector4 gradient = Vector4::Zero();
};

template <bool with_derivatives>
Evaluation evaluate(const Quadrature& q, Vec4d abcd, double l2_scale, double rounding) {
  Evaluation e;
  // The cosine's hemisphere must not be turned inside out. A and D by themselves may reach 0: at
  // grazing angles -B C carries the determinant.
  if (!(determinant(abcd, q.width) > 0)) return e;

  double sum = 0;
  double h[10] = {}, g[4] = {};
  for (std::size_t i = 0; i < q.size(); ++i) {
    const LobeDensity d = lobe_density(abcd, q.width, Vec3d(q.x_mirror[i], q.y[i], q.z_mirror[i]));
    const double r = d.value - q.density[i];
    const double soft = rounding * std::max(q.density[i], 1e-3 * f64::k_inv_pi);
    const double root = std::sqrt(r * r + soft * soft);
    sum += q.weight[i] * (0.5 * (root - soft) + l2_scale * r * r);
    if constexpr (with_derivatives) {
      const double omega = q.weight[i] * (0.5 / root + 2 * l2_scale);
      int k = 0;
      for (int a = 0; a < 4; ++a) {
        const double wa = omega * d.derivative[a];
        g[a] += wa * r;
        for (int b = a; b < 4; ++b)
          h[k++] += wa * d.derivative[b];
      }
    }
  }

  const LeakAngle leak = leak_angle(abcd, q.width, q.cos_theta);
  sum += 0.5 * leak.half_sine * leak.half_sine;
  e.objective = sum;
  if constexpr (with_derivatives) {
    int k = 0;
    for (int a = 0; a < 4; ++a) {
      e.gradient[a] = g[a] + leak.derivative[a] * leak.half_sine;
      for (int b = a; b < 4; ++b) {
        e.hessian(a, b) = h[k++] + leak.derivative[a] * leak.derivative[b];
        e.hessian(b, a) = e.hessian(a, b);
      }
    }
  }
  return e;
}

} // namespace

// With o = M^-1 w = (A x' + aB z', y, a (C x' + D z')) and det = a (A D - a B C),
//   value = o.z det / (pi |o|^4),
//   d value = value (d det / det + d o.z / o.z - 4 o . d o / |o|^2).
LobeDensity lobe_density(Vec4d abcd, double alpha, Vec3d wi_mirror) {
  LobeDensity result;
  const double x = wi_mirror.x, z = wi_mirror.z;
  const double ox = abcd.x * x + alpha * abcd.y * z;
  const double oz = alpha * (abcd.z * x + abcd.w * z);
  if (!(oz > 0)) return result;
  const double det = determinant(abcd, alpha);
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
  const double half_sine = leak_angle(abcd, alpha, cos_theta).half_sine;
  return half_sine * half_sine;
}

Vec4d cosine_start(double alpha, double cos_theta) {
  return f64::mirror_from_lobe(f64::cosine_lobe(), alpha, cos_theta);
}

LobeFit fit_lobe(const Quadrature& q, Vec4d start, const LobeFitOptions& options) {
  LobeFit fit;
  fit.mirror = start;
  const bool symmetric = q.cos_theta >= 1;
  if (symmetric) fit.mirror = Vec4d(1, 0, 0, start.w);

  double norm2 = 0;
  for (std::size_t i = 0; i < q.size(); ++i)
    norm2 += q.weight[i] * q.density[i] * q.density[i];
  const double l2_scale = options.l2_weight / norm2;

  double damping = 1e-3;
  while (fit.iterations < options.max_iterations && !fit.converged) {
    const Evaluation at = evaluate<true>(q, fit.mirror, l2_scale, options.rounding);
    fit.objective = at.objective;
    bool accepted = false;
    while (!accepted && damping < 1e12) {
      Matrix4 system = at.hessian;
      for (int k = 0; k < 4; ++k)
        system(k, k) += damping * at.hessian(k, k) + 1e-300;
      Vector4 step;
      if (symmetric) {
        step = Vector4(0, 0, 0, -at.gradient[3] / system(3, 3));
      } else {
        step = -system.ldlt().solve(at.gradient);
      }
      const Vec4d trial(fit.mirror.x + step[0], fit.mirror.y + step[1], fit.mirror.z + step[2],
                        fit.mirror.w + step[3]);
      const Evaluation there = evaluate<false>(q, trial, l2_scale, options.rounding);
      ++fit.iterations;
      const double moved = step.cwiseAbs().maxCoeff();
      if (there.objective <= at.objective) {
        accepted = true;
        fit.mirror = trial;
        fit.objective = there.objective;
        damping = std::max(damping * 0.2, 1e-9);
      } else {
        damping = std::max(damping, 1e-6) * 5;
      }
      if (moved < options.tolerance) {
        fit.converged = true;
        break;
      }
    }
    if (!accepted) break;
  }
  return fit;
}

} // namespace openltc::fit
