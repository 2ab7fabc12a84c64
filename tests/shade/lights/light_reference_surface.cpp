// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral over a light by its definition: density times cosine at the light over distance
// squared, summed over the light's surface by rows.

#include "tests/shade/lights/light_reference.h"
#include "tests/shade/quadrature_1d.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace openltc::testing {

namespace {

struct Row {
  Vec3d center, u, v; // center + u cos t + v sin t; relative to the point, world space
  double from, to;
};

struct Rows {
  const CaseView& view;
  const f64::Lobe& lobe;
  double tolerance;
  const Vec3d* front;

  double density(Vec3d x_world) const {
    if (front && dot(*front, x_world) <= 0) return 0;
    const Vec3d w = f64::to_shading(view.frame, x_world);
    return w.z > 0 ? f64::eval_lobe(lobe, w / length(w)) : 0.0;
  }

  /// Integral along a row of density * weight(t) / |x|^2, cut where x or a facing changes sides.
  template <class Weight>
  double row(const Row& r, const Weight& weight, bool faces_cut, Vec3d center_of_curvature) const {
    std::vector<double> breaks = {r.from, r.to};
    const auto cut = [&](Vec3d normal, double offset) {
      const double a = dot(normal, r.center) - offset, b = dot(normal, r.u), c = dot(normal, r.v);
      const double size = std::hypot(b, c);
      if (!(std::abs(a) < size)) return;
      const double middle = std::atan2(c, b), half = std::acos(-a / size);
      for (const double t : {middle - half, middle + half})
        for (int turn = -1; turn <= 1; ++turn)
          if (t + turn * 2 * f64::k_pi > r.from && t + turn * 2 * f64::k_pi < r.to)
            breaks.push_back(t + turn * 2 * f64::k_pi);
    };
    cut(view.frame.n, 0);
    cut(view.frame.t1 * lobe.m20 + view.frame.n * lobe.m22, 0);
    if (front) cut(*front, 0);
    if (faces_cut) // (x - center) . x = 0 on a sphere: a plane
      cut(center_of_curvature, dot(center_of_curvature, center_of_curvature) - sphere_radius2);
    std::sort(breaks.begin(), breaks.end());
    double sum = 0;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      sum += integrate_adaptive(
          [&](double t) {
            const Vec3d x = r.center + r.u * std::cos(t) + r.v * std::sin(t);
            return density(x) * weight(x) / dot(x, x);
          },
          breaks[i - 1], breaks[i], tolerance);
    return sum;
  }
  double sphere_radius2 = 0;
};

// Concentric ellipses: x = c + r (u cos t + v sin t), area |u x v| r dr dt.
double over_ellipse(const Rows& rows, Vec3d c, Vec3d u, Vec3d v, bool two_sided) {
  const Vec3d area = cross(u, v);
  if (dot(area, c) >= 0 && !two_sided) return 0;
  const auto weight = [&](Vec3d x) { return std::abs(dot(area, x)) / length(x); };
  return integrate_adaptive(
      [&](double r) {
        return r * rows.row({c, u * r, v * r, 0, 2 * f64::k_pi}, weight, false, Vec3d(0.0));
      },
      0, 1, rows.tolerance, 12);
}

// Circles of latitude about `axis`: from its pole to the latitude -> cos_end.
double over_sphere(Rows rows, Vec3d c, double radius, Vec3d axis, double cos_end) {
  if (length(c) <= radius) return 0;
  const f64::Frame f = f64::shading_frame(axis, axis);
  rows.sphere_radius2 = radius * radius;
  const auto weight = [&](Vec3d x) { return std::max(-dot(x - c, x), 0.0) / (radius * length(x)); };
  const auto at = [&](double angle) {
    const double r = radius * std::sin(angle);
    return radius * r *
           rows.row({c + f.n * (radius * std::cos(angle)), f.t1 * r, f.t2 * r, 0, 2 * f64::k_pi},
                    weight, true, c);
  };
  const double end = std::acos(cos_end);
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    sum += integrate_adaptive(at, end * k / 4, end * (k + 1) / 4, rows.tolerance, 14);
  return sum;
}

// Circles around the axis.
double over_lateral(const Rows& rows, Vec3d from, Vec3d to, double radius) {
  const double height = length(to - from);
  const Vec3d axis = (to - from) / height;
  const Vec3d foot = from - axis * dot(from, axis); // the axis, nearest to the point
  const double rho = length(foot);
  if (rho <= radius) return 0;
  // Facing: between the two lines of tangency.
  const Vec3d radial = foot / -rho, side = cross(axis, radial);
  const double beta = std::acos(radius / rho);
  const auto weight = [&](Vec3d x) {
    const Vec3d n = x - axis * dot(x, axis) - foot;
    return std::max(-dot(n, x), 0.0) / (radius * length(x));
  };
  double sum = 0;
  for (int k = 0; k < 16; ++k) // so that no kink where a plane takes leave of the tube is missed
    sum += integrate_adaptive(
        [&](double t) {
          return radius * rows.row({from + axis * t, radial * radius, side * radius, -beta, beta},
                                   weight, false, Vec3d(0.0));
        },
        height * k / 16, height * (k + 1) / 16, rows.tolerance, 12);
  return sum;
}

} // namespace

double surface_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe,
                        double tolerance, const Vec3d* front) {
  const Rows rows{view, lobe, tolerance, front};
  const Vec3d a = to_double(light.a) - view.position, b = to_double(light.b);
  const double radius = double(light.radius);
  switch (light.shape) {
  case LightShape::rectangle:
  case LightShape::polygon:
    return brute_force_integral(light.polygon->view(), view.position, view.frame, lobe, tolerance,
                                front);
  case LightShape::disk:
  case LightShape::ellipse:
    return over_ellipse(rows, a, b, to_double(light.c), light.two_sided);
  case LightShape::sphere:
    return over_sphere(rows, a, radius, normalize(-a), -1);
  default:
    break;
  }
  const Vec3d to = b - view.position, axis = normalize(to - a);
  if (light.shape == LightShape::line) {
    double sum = 0; // sine over distance squared, along the line
    const auto f = [&](double t) {
      const Vec3d x = a + (to - a) * t;
      return rows.density(x) * length(cross(to - a, x)) / (length(x) * dot(x, x));
    };
    for (int k = 0; k < 64; ++k)
      sum += integrate_adaptive(f, k / 64.0, (k + 1) / 64.0, tolerance / 64);
    return sum;
  }
  double sum = over_lateral(rows, a, to, radius);
  if (light.shape == LightShape::tube_flat) {
    const f64::Frame f = f64::shading_frame(axis, axis);
    sum += over_ellipse(rows, a, f.t2 * radius, f.t1 * radius, false);
    sum += over_ellipse(rows, to, f.t1 * radius, f.t2 * radius, false);
  }
  if (light.shape == LightShape::capsule) {
    sum += over_sphere(rows, a, radius, -axis, 0);
    sum += over_sphere(rows, to, radius, axis, 0);
  }
  return sum;
}

} // namespace openltc::testing
