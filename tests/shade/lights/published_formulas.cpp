// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shade/lights/published_formulas.h"

#include "openltc/table/clipped_sphere.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace openltc::testing {

namespace {

Vec3d to_cosine_space(const CaseView& view, const f64::Lobe& lobe, Vec3d relative_world) {
  return f64::to_cosine(lobe, f64::to_shading(view.frame, relative_world));
}

// 1/(2 pi) of the edge sum: the vector irradiance over pi.
Vec3d polygon_vector(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  const PolygonView& polygon = light.polygon->view();
  const double facing =
      dot(f64::polygon_normal(polygon), view.position - f64::polygon_origin(polygon));
  if (facing <= 0 && !light.two_sided) return Vec3d(0.0);
  Vec3d sum(0.0), a(0.0);
  for (int i = 0; i < polygon.point_count; ++i) {
    const Vec3d b =
        normalize(to_cosine_space(view, lobe, f64::polygon_point(polygon, i) - view.position));
    if (!f64::polygon_starts_ring(polygon, i)) {
      const Vec3d c = cross(a, b);
      if (dot(c, c) > 0) sum += c * (std::atan2(length(c), dot(a, b)) / length(c));
    }
    a = b;
  }
  // Counter-clockwise seen from in front is clockwise about directions from there.
  return sum * ((facing > 0 ? -1 : 1) / (2 * f64::k_pi));
}

// An ellipse of cosine space with conjugate half-diameters u, v.
double ellipse_form_factor(Vec3d center, Vec3d u, Vec3d v) {
  // Principal axes.
  Eigen::Matrix2d gram;
  gram << dot(u, u), dot(u, v), dot(u, v), dot(v, v);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(gram);
  const auto axis = [&](int k) {
    return u * axes.eigenvectors()(0, k) + v * axes.eigenvectors()(1, k);
  };
  const double half_x = length(axis(1)), half_y = length(axis(0));
  const Vec3d x = axis(1) / half_x;
  Vec3d z = normalize(cross(u, v));
  if (dot(z, center) < 0) z = -z;
  const Vec3d y = cross(z, x);
  const double distance = dot(z, center);
  if (!(distance > 0) || !(half_y > 0)) return 0;

  // The cone (x - x0 z)^2/a^2 + (y - y0 z)^2/b^2 = z^2 and its axes.
  const double a2 = std::pow(half_x / distance, 2), b2 = std::pow(half_y / distance, 2);
  const double x0 = dot(x, center) / distance, y0 = dot(y, center) / distance;
  Eigen::Matrix3d cone;
  cone << 1 / a2, 0, -x0 / a2, 0, 1 / b2, -y0 / b2, -x0 / a2, -y0 / b2,
      x0 * x0 / a2 + y0 * y0 / b2 - 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(cone);
  const Eigen::Vector3d e = principal.eigenvalues(); // ascending: one negative
  if (!(e[0] < 0 && e[1] > 0)) return 0;             // rounding: seen edge-on
  const double l1 = std::sqrt(-e[0] / e[1]), l2 = std::sqrt(-e[0] / e[2]);
  const double form_factor = l1 * l2 / std::sqrt((1 + l1 * l1) * (1 + l2 * l2));
  const Eigen::Vector3d d = principal.eigenvectors().col(0);
  Vec3d direction = x * d[0] + y * d[1] + z * d[2];
  if (dot(direction, center) < 0) direction = -direction;
  return form_factor * table::clipped_sphere_form_factor(direction.z, form_factor);
}

} // namespace

double published_polygon(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  const Vec3d f = polygon_vector(light, view, lobe);
  const double l = length(f);
  return l > 0 ? l * table::clipped_sphere_form_factor(f.z / l, l) : 0;
}

double published_polygon_fit(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  const Vec3d f = polygon_vector(light, view, lobe);
  const double l = length(f);
  return std::max((l * l + f.z) / (l + 1), 0.0);
}

double published_ellipse(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  Vec3d center = to_double(light.a) - view.position;
  Vec3d u = to_double(light.b), v = to_double(light.c);
  if (light.shape == LightShape::sphere) {
    const double d2 = dot(center, center), r2 = double(light.radius) * double(light.radius);
    if (d2 <= r2) return 0;
    const f64::Frame f = f64::shading_frame(center / std::sqrt(d2), center / std::sqrt(d2));
    const double k = 1 - r2 / d2, r = std::sqrt(r2 * k);
    center = center * k;
    u = f.t1 * r;
    v = f.t2 * r;
  } else if (dot(cross(u, v), center) >= 0 && !light.two_sided) {
    return 0;
  }
  return ellipse_form_factor(to_cosine_space(view, lobe, center), to_cosine_space(view, lobe, u),
                             to_cosine_space(view, lobe, v));
}

double published_line(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  const Vec3d from = f64::to_shading(view.frame, to_double(light.a) - view.position);
  const Vec3d to = f64::to_shading(view.frame, to_double(light.b) - view.position);
  Vec3d p = f64::to_cosine(lobe, from), q = f64::to_cosine(lobe, to);
  if (p.z <= 0 && q.z <= 0) return 0;
  // Width across the plane of the line and the point. Normals go by the transposed inverse of what
  // vectors go by: cross(M^-1 a, M^-1 b) = det(M^-1) M^T cross(a, b).
  const Vec3d across_shading = cross(from, to);
  const Vec3d across_cosine = cross(p, q);
  const double stretch = length(across_shading) * lobe.det / length(across_cosine);
  // Above the cosine's horizon.
  if (p.z < 0) p = p + (q - p) * (p.z / (p.z - q.z));
  if (q.z < 0) q = q + (p - q) * (q.z / (q.z - p.z));
  const Vec3d tangent = normalize(q - p);
  const double l1 = dot(p, tangent), l2 = dot(q, tangent);
  const Vec3d foot = p - tangent * l1;
  const double d = length(foot);
  const auto at_point = [&](double l) {
    return l / (d * (d * d + l * l)) + std::atan(l / d) / (d * d);
  };
  const auto along = [&](double l) { return l * l / (d * (d * d + l * l)); };
  // The paper's integral is per metre of radius.
  const double per_radius =
      ((at_point(l2) - at_point(l1)) * foot.z + (along(l2) - along(l1)) * tangent.z) / f64::k_pi;
  return std::max(0.5 * per_radius * stretch, 0.0);
}

double published_tube(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  const double radius = double(light.radius);
  double sum = published_line(light, view, lobe) * 2 * radius;
  if (light.shape != LightShape::tube_open) {
    const Vec3d axis = normalize(to_double(light.b) - to_double(light.a));
    const auto end = [&](Vec3f center, Vec3d outward) {
      const Vec3d x = to_double(center) - view.position;
      const double cosine = std::max(-dot(outward, x) / length(x), 0.0);
      const Vec3d w = f64::to_shading(view.frame, x / length(x));
      return f64::k_pi * radius * radius * f64::eval_lobe(lobe, w) * cosine / dot(x, x);
    };
    sum += end(light.a, -axis) + end(light.b, axis);
  }
  return std::min(sum, 1.0);
}

double published_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe) {
  switch (light.shape) {
  case LightShape::rectangle:
  case LightShape::polygon:
    return published_polygon(light, view, lobe);
  case LightShape::disk:
  case LightShape::ellipse:
  case LightShape::sphere:
    return published_ellipse(light, view, lobe);
  case LightShape::line:
    return published_line(light, view, lobe);
  default:
    return published_tube(light, view, lobe);
  }
}

} // namespace openltc::testing
