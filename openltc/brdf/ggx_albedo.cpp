// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Each node of the table is an integral over slopes of the half vector, h ~ (r cos phi, r sin phi,
// 1), which fit/quadrature.cpp derives: wi lies above the horizon for r < exp(k cos chi), where
// sinh(k cos chi) = tan theta cos phi, k = asinh(tan theta), and d wi = 4 (wo.h) r dr dphi /
// (1 + r^2)^(3/2). Along r = s sinh v a Fejer rule, along chi equal steps.
//
// Axes. At small alpha all that happens lies where mu = cos theta is comparable with alpha; at both
// ends of it the albedo is no polynomial (it goes like mu log mu near 0). So the second axis is
//   y = 1/(1 + R^(-1/3)),  R = mu (1 + alpha)/(alpha (1 - mu)),
// 0..1 for every alpha, in which both ends are flat to third order. The first axis is roughness,
// from that of the least alpha to 1. In between, cubic Lagrange interpolation along each axis.

#include "openltc/brdf/ggx_albedo.h"

#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace openltc::brdf {

namespace {

constexpr int k_rows = 32, k_columns = 96; // nodes along roughness and along y
constexpr double k_start = 0.01;           // roughness below has the alpha k_min_alpha of this
constexpr int k_radial = 32, k_azimuths = 20;

// Fejer's first rule on [0, 1].
struct FejerRule {
  std::array<double, k_radial> node, weight;
  FejerRule() {
    for (int i = 0; i < k_radial; ++i) {
      const double angle = (i + 0.5) * f64::k_pi / k_radial;
      double sum = 1;
      for (int j = 1; j <= k_radial / 2; ++j)
        sum -= 2 * std::cos(2 * j * angle) / (4.0 * j * j - 1);
      node[std::size_t(i)] = 0.5 - 0.5 * std::cos(angle);
      weight[std::size_t(i)] = sum / k_radial;
    }
  }
};

double integrate(double cos_o, double alpha) {
  static const FejerRule rule;
  const double sin_o = std::sqrt(std::max(0.0, 1 - cos_o * cos_o));
  const Vec3d wo(sin_o, 0, cos_o);
  const double t = std::max(sin_o / cos_o, 1e-6), k = std::asinh(t);
  double sum = 0;
  for (int j = 0; j < k_azimuths; ++j) {
    const double chi = (j + 0.5) * f64::k_pi / k_azimuths;
    const double kc = k * std::cos(chi), s = std::sin(chi);
    const double cos_phi = std::sinh(kc) / t;
    const double half_c = std::cos(0.5 * chi), half_s = std::sin(0.5 * chi);
    const double sin_phi =
        std::sqrt(std::sinh(2 * k * half_c * half_c) * std::sinh(2 * k * half_s * half_s)) / t;
    const double dphi = f64::k_pi / k_azimuths * k * std::cosh(kc) * s / (t * sin_phi);
    const double v_max = std::asinh(std::exp(kc) / alpha);
    for (int i = 0; i < k_radial; ++i) {
      const double v = v_max * rule.node[std::size_t(i)];
      const double r = alpha * std::sinh(v);
      const double dr = alpha * std::cosh(v) * v_max * rule.weight[std::size_t(i)];
      const double inv = 1 / (1 + r * r);
      const double o_dot = cos_o + r * sin_o * cos_phi; // wo.h sqrt(1 + r^2)
      const double twice = 2 * o_dot * inv;
      const Vec3d wi(twice * r * cos_phi - sin_o, twice * r * sin_phi, twice - cos_o);
      if (wi.z > 0)
        sum += 8 * o_dot * r * dr * dphi * inv * inv * f64::eval_ggx_terms(wo, wi, alpha).scale;
    }
  }
  return sum;
}

double axis_of(double mu, double alpha) {
  const double inverse = alpha * std::max(0.0, 1 - mu) / (mu * (1 + alpha)); // 1/R
  return 1 / (1 + std::cbrt(inverse));
}

// The inverse of axis_of; at y = 0 just above the horizon.
double cosine_of(double y, double alpha) {
  const double root = y / std::max(1 - y, 1e-9), ratio = root * root * root;
  return std::clamp(alpha * ratio / (1 + alpha + alpha * ratio), 1e-9, 1.0);
}

double alpha_of(double x) {
  const double roughness = k_start + x * (1 - k_start);
  return roughness * roughness;
}

std::vector<double> make_table() {
  std::vector<double> table(std::size_t(k_rows) * k_columns);
  for (int i = 0; i < k_rows; ++i) {
    const double alpha = alpha_of(double(i) / (k_rows - 1));
    for (int j = 0; j < k_columns; ++j) {
      table[std::size_t(i * k_columns + j)] =
          integrate(cosine_of(double(j) / (k_columns - 1), alpha), alpha);
    }
  }
  return table;
}

// Four neighbouring nodes and their weights for x in 0..1.
struct Cubic {
  int first;
  double weight[4];
  Cubic(double x, int size) {
    const double at = std::clamp(x, 0.0, 1.0) * (size - 1);
    first = std::clamp(int(at) - 1, 0, size - 4);
    const double u = at - first;
    weight[0] = -(u - 1) * (u - 2) * (u - 3) / 6;
    weight[1] = u * (u - 2) * (u - 3) / 2;
    weight[2] = -u * (u - 1) * (u - 3) / 2;
    weight[3] = u * (u - 1) * (u - 2) / 6;
  }
};

} // namespace

double ggx_albedo(double cos_o, double roughness) {
  static const std::vector<double> table = make_table();
  const double alpha = f64::alpha_from_roughness(roughness);
  const Cubic x((std::sqrt(alpha) - k_start) / (1 - k_start), k_rows),
      y(axis_of(cos_o, alpha), k_columns);
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum +=
          x.weight[i] * y.weight[j] * table[std::size_t((x.first + i) * k_columns + y.first + j)];
  return std::min(sum, 1.0);
}

} // namespace openltc::brdf
