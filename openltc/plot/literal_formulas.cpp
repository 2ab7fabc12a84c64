// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/literal_formulas.h"

#include <algorithm>
#include <cmath>

namespace openltc::plot {

namespace {

// Points along each axis of the sums.
constexpr int k_points = 256;

// Integral over the sphere. With gamma the angle to `axis`, tan(gamma/2) = width sqrt(s/(1-s)): the
// unit square of (s, azimuth) covers the sphere, half of it the cone that a lobe of this width
// fills. The points are crowded towards both ends of s.
template <class F> double sphere_integral(Vec3d axis, double width, F f) {
  const f64::Frame frame = f64::shading_frame(axis, axis);
  double sum = 0;
  for (int i = 0; i < k_points; ++i) {
    const double u = (i + 0.5) / k_points;
    const double s = u * u * (3 - 2 * u);
    const double t = width * std::sqrt(s / (1 - s));
    const double cos_gamma = (1 - t * t) / (1 + t * t), sin_gamma = 2 * t / (1 + t * t);
    double ring = 0;
    for (int j = 0; j < k_points; ++j) {
      const double phi = 2 * f64::k_pi * (j + 0.5) / k_points;
      ring += f(f64::to_world(
          frame, Vec3d(sin_gamma * std::cos(phi), sin_gamma * std::sin(phi), cos_gamma)));
    }
    const double root = width / ((1 + t * t) * (1 - s));
    sum += ring * 2 * root * root * 6 * u * (1 - u);
  }
  return sum * 2 * f64::k_pi / (double(k_points) * k_points);
}

// Over a lobe: about its axis, as wide as the image of a cone is across the plane of incidence.
template <class F> double lobe_sphere_integral(const f64::Lobe& lobe, F f) {
  const Vec3d axis = f64::from_cosine(lobe, Vec3d(0, 0, 1));
  return sphere_integral(normalize(axis), std::min(1.0, lobe.det / length(axis)), f);
}

} // namespace

double literal_ggx(Vec3d wo, Vec3d wi, double alpha) {
  if (!(wo.z > 0 && wi.z > 0)) return 0;
  const double g = f64::smith_visibility(wo.z, wi.z, alpha);
  return f64::ggx_distribution(normalize(wo + wi), alpha) * g / (4 * wo.z * wi.z) * wi.z;
}

double literal_schlick(double f0, double cos_theta) {
  return f0 + (1 - f0) * (1 - std::pow(cos_theta, 5));
}

double literal_lobe(const f64::Lobe& lobe, Vec3d wi) {
  return f64::eval_lobe(lobe, wi) / lobe.det * std::sqrt(f64::lobe_stretch2(lobe));
}

double literal_point_light(const f64::Lobe& lobe, Vec3d wi) {
  const Vec3d o = f64::to_cosine(lobe, wi);
  const double l = length(o);
  return std::max(0.0, o.z) / l * l / (l * l * l);
}

double literal_point_light_by_determinant(const f64::Lobe& lobe, Vec3d wi) {
  const Vec3d o = f64::to_cosine(lobe, wi);
  const double l = length(o);
  return std::max(0.0, o.z) / l * lobe.det / (l * l * l);
}

Slip white_furnace(double alpha, double cos_theta) {
  const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
  const Vec3d wo(sin_theta, 0, cos_theta), mirror(-sin_theta, 0, cos_theta);
  return {sphere_integral(mirror, alpha,
                          [&](Vec3d wi) { return f64::eval_ggx_terms(wo, wi, alpha).scale; }),
          sphere_integral(mirror, alpha, [&](Vec3d wi) { return literal_ggx(wo, wi, alpha); })};
}

Slip fresnel_reflectance(double f0, double cos_theta) {
  return {f64::schlick_fresnel(Vec3d(f0), Vec3d(1.0), cos_theta).x, literal_schlick(f0, cos_theta)};
}

Slip fresnel_twice(double f0, double cos_theta) {
  const double f = f64::schlick_fresnel(Vec3d(f0), Vec3d(1.0), cos_theta).x;
  return {f, f * f};
}

Slip lobe_integral(const f64::Lobe& lobe) {
  return {lobe_sphere_integral(lobe, [&](Vec3d w) { return f64::eval_lobe(lobe, w); }),
          lobe_sphere_integral(lobe, [&](Vec3d w) { return literal_lobe(lobe, w); })};
}

Slip lobe_amplitude(const f64::FittedLobe& fitted, double f0) {
  return {f64::specular_amplitude(fitted, Vec3d(f0), Vec3d(1.0)).x,
          lobe_integral(fitted.lobe).correct};
}

PointLightIntegrals point_light_integrals(const f64::Lobe& lobe) {
  return {lobe_sphere_integral(lobe, [&](Vec3d w) { return literal_point_light(lobe, w); }),
          lobe_sphere_integral(
              lobe, [&](Vec3d w) { return literal_point_light_by_determinant(lobe, w); })};
}

} // namespace openltc::plot
