// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polygon is cut at the surface's horizon and taken as a fan of triangles around the lobe's
// centre c, one per edge, those wound the other way negative: c need not lie inside. In polar
// coordinates (psi, phi) about c each triangle is
//   integral over phi from phi_a to phi_b of F(phi),
//   F = integral of f cos_i sin psi over psi from 0 to the edge.
// c is the mirror direction, above the horizon like the polygon, so every triangle is too, and the
// integrand is smooth within. Along psi = s sinh v the lobe's core, of scale s, and each decade
// beyond get their share of points, as in quadrature.cpp. The edge is the plane N.w = 0, so its
// angle from c is tan psi = -N_z/(N_x cos phi + N_y sin phi).
//
// At grazing angles the lobe is 1/cos theta times longer in the plane of incidence, phi = 0, than
// across it. So the azimuth is stretched, tan phi = A tan t, A near cos theta, which spreads the
// lobe evenly over t; t is halved until the parts agree.
//
// Points along psi and phi: Fejer 1933, "Mechanische Quadraturen mit positiven Cotesschen Zahlen",
// first rule: nodes cos((i + 1/2) pi / n), weights in closed form.

#include "openltc/fit/measure/polygon_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace openltc::fit {

namespace {

struct Rule {
  std::vector<double> node, weight; // on [0, 1]
};

Rule fejer(int n) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * f64::k_pi / n;
    double sum = 0;
    for (int k = 1; k <= n / 2; ++k)
      sum += std::cos(2 * k * t) / (4.0 * k * k - 1);
    rule.node.push_back(0.5 * (1 - std::cos(t)));
    rule.weight.push_back((1 - 2 * sum) / n);
  }
  return rule;
}

const Rule& radial_rule(int n) {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> all(65);
    for (int k = 4; k <= 64; ++k)
      all[std::size_t(k)] = fejer(k);
    return all;
  }();
  return rules[std::size_t(std::clamp(n, 4, 64))];
}

const Rule& azimuth_rule() {
  static const Rule rule = fejer(8);
  return rule;
}

// One integral: the BRDF, and where its lobe lies.
struct Fan {
  const brdf::Brdf& brdf;
  const Rule& radial;
  double roughness;
  double cos_theta, sin_theta; // of the view direction, and of c on the other side of the normal
  double stretch;              // A
  double scale;                // s in the plane of incidence
  double tolerance;

  Vec3d to_fan(Vec3d w) const {
    return {cos_theta * w.x + sin_theta * w.z, w.y, cos_theta * w.z - sin_theta * w.x};
  }

  double density(double sin_psi, double cos_psi, double cos_phi, double sin_phi) const {
    const double x = sin_psi * cos_phi;
    const Vec3d w(cos_theta * x - sin_theta * cos_psi, sin_psi * sin_phi,
                  cos_theta * cos_psi + sin_theta * x);
    return w.z > 0 ? brdf.eval(Vec3d(sin_theta, 0, cos_theta), w, roughness).scale : 0;
  }

  // F at one stretched azimuth, times d phi / d t.
  double ray(Vec3d edge, double t) const {
    const double x = std::cos(t), y = stretch * std::sin(t);
    const double inv = 1 / std::sqrt(x * x + y * y);
    const double c = x * inv, s = y * inv; // of phi
    const double reach =
        std::atan2(std::abs(edge.z), -std::copysign(1.0, edge.z) * (edge.x * c + edge.y * s));
    const double width = scale * stretch / std::sqrt(stretch * stretch * c * c + s * s);
    const double v_max = std::asinh(reach / width);
    double sum = 0;
    for (std::size_t i = 0; i < radial.node.size(); ++i) {
      const double growth = std::exp(v_max * radial.node[i]);
      const double psi = 0.5 * width * (growth - 1 / growth);
      const double d_psi = 0.5 * width * (growth + 1 / growth) * v_max * radial.weight[i];
      const double sin_psi = std::sin(psi);
      sum += d_psi * sin_psi * density(sin_psi, std::cos(psi), c, s);
    }
    return sum * stretch * inv * inv;
  }

  double interval(Vec3d edge, double from, double to) const {
    const Rule& rule = azimuth_rule();
    double sum = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i)
      sum += rule.weight[i] * ray(edge, from + (to - from) * rule.node[i]);
    return sum * (to - from);
  }

  double refine(Vec3d edge, double from, double to, double whole, int depth) const {
    const double middle = 0.5 * (from + to);
    const double first = interval(edge, from, middle), second = interval(edge, middle, to);
    if (depth == 0 || std::abs(first + second - whole) < tolerance) return first + second;
    return refine(edge, from, middle, first, depth - 1) +
           refine(edge, middle, to, second, depth - 1);
  }

  // The triangle c, a, b, negative when wound the other way.
  double triangle(Vec3d a_shading, Vec3d b_shading) const {
    const Vec3d a = to_fan(a_shading), b = to_fan(b_shading);
    const Vec3d edge = cross(a, b);
    // An edge through c itself has a triangle of no area.
    if (!(std::abs(edge.z) > 1e-14 * length(edge))) return 0;
    const double ay = a.y / stretch, by = b.y / stretch;
    const double from = std::atan2(ay, a.x);
    const double turn = std::atan2(a.x * by - ay * b.x, a.x * b.x + ay * by);
    // No interval is longer than an eighth of the circle, so that none hides a whole lobe.
    const int parts = 1 + int(std::abs(turn) / (0.25 * f64::k_pi));
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
      const double t0 = from + turn * i / parts, t1 = from + turn * (i + 1) / parts;
      sum += refine(edge, t0, t1, interval(edge, t0, t1), 16);
    }
    return sum;
  }
};

// The part of a convex polygon above the horizon.
std::vector<Vec3d> above_horizon(std::span<const Vec3d> corners) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
    if (a.z >= 0) kept.push_back(a);
    if ((a.z >= 0) != (b.z >= 0)) {
      Vec3d cut = a + (b - a) * (a.z / (a.z - b.z));
      cut.z = 0;
      kept.push_back(cut);
    }
  }
  return kept;
}

} // namespace

double integrate_brdf_over_polygon(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   double scale, std::span<const Vec3d> corners,
                                   const PolygonRule& rule) {
  const std::vector<Vec3d> above = above_horizon(corners);
  if (above.size() < 3) return 0;
  const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
  // Directions turn twice as far as the half vectors that `scale` speaks of.
  const double s = std::clamp(scale > 0 ? 2 * scale : 1.0, 1e-6, 1.0);
  // A wide lobe is never narrower across than the spread of its half vectors makes it; and beyond
  // cos theta from the mirror direction a lobe at grazing angles is a wedge rather than round.
  const double stretch = std::min(1.0, std::sqrt(cos_theta * cos_theta + s * s));
  const Fan fan{brdf,    radial_rule(rule.radial), roughness,     cos_theta, sin_theta,
                stretch, std::min(s, cos_theta),   rule.tolerance};
  double sum = 0;
  for (std::size_t i = 0; i < above.size(); ++i)
    sum += fan.triangle(above[i], above[(i + 1) % above.size()]);
  return std::abs(sum);
}

double integrate_lobe_over_polygon(const f64::Lobe& lobe, std::span<const Vec3d> corners) {
  if (corners.size() < 3) return 0;
  const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double side = f64::apex_side(normal.y, dot(normal, corners[0]));
  Vec3d sum(0, 0, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
    sum += f64::clipped_edge_term(f64::to_cosine(lobe, a), f64::to_cosine(lobe, b), a.z, b.z, side);
  }
  return std::min(std::abs(sum.z) * f64::k_half_inv_pi, 1.0);
}

} // namespace openltc::fit
