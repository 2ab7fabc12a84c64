// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "placed_lights.h"

#include "openltc/table/lobe_table.h"
#include "polygon_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace openltc::testing {

namespace {

constexpr double k_pi = std::numbers::pi;

double brdf(const f64::Surface& s, Vec3d towards) {
  const Vec3d wi = f64::to_shading(s.frame, normalize(towards));
  return f64::eval_ggx(s.wo, wi, s.alpha, s.f0, s.f90).x;
}

// What a patch of a light adds: `area` around p, with that normal.
double patch(const f64::Surface& s, Vec3d p, Vec3d normal, double area) {
  const double distance2 = dot(p, p), facing = -dot(p, normal) / std::sqrt(distance2);
  return facing > 0 ? brdf(s, p) * facing * area / distance2 : 0;
}

PlacedLight ellipse(Placed at) {
  const Vec3d normal = normalize(cross(at.u, at.v));
  const double area = k_pi * length(at.u) * length(at.v);
  return {[=](const f64::Surface& s) {
            f64::Ellipse light;
            light.center = at.center;
            light.half_u = at.u;
            light.half_v = at.v;
            light.two_sided = 0;
            return f64::shade_ellipse(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double r = std::sqrt((i + 0.5) / n), phi = 2 * k_pi * (j + 0.5) / n;
                sum += patch(s, at.center + at.u * (r * std::cos(phi)) + at.v * (r * std::sin(phi)),
                             normal, area / (n * n));
              }
            return sum;
          }};
}

PlacedLight sphere(Placed at) {
  const double radius = std::min(length(at.u), 0.95 * length(at.center));
  return {[=](const f64::Surface& s) {
            f64::Sphere light;
            light.center = at.center;
            light.radius = radius;
            return f64::shade_sphere(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            const double sine2 = radius * radius / dot(at.center, at.center);
            const double height = sine2 / (1 + std::sqrt(1 - sine2));
            const f64::Frame frame = f64::shading_frame(normalize(at.center), Vec3d(0.1, 0.3, 1));
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double down = height * (i + 0.5) / n, phi = 2 * k_pi * (j + 0.5) / n;
                const double across = std::sqrt(down * (2 - down));
                sum += brdf(s, frame.n * (1 - down) + frame.t1 * (across * std::cos(phi)) +
                                   frame.t2 * (across * std::sin(phi)));
              }
            return sum * 2 * k_pi * height / (n * n);
          }};
}

PlacedLight line(Placed at) {
  const Vec3d half = at.u * 2.0;
  return {[=](const f64::Surface& s) {
            f64::Line light;
            light.from = at.center - half;
            light.to = at.center + half;
            return f64::shade_line(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            const int steps = n * n / 4;
            for (int i = 0; i < steps; ++i) {
              const Vec3d p = at.center + half * (2 * (i + 0.5) / steps - 1);
              const double distance2 = dot(p, p);
              sum += brdf(s, p) * length(cross(p, half)) / (distance2 * std::sqrt(distance2));
            }
            return sum * 2 / steps;
          }};
}

// With round ends.
PlacedLight capsule(Placed at) {
  const Vec3d half = at.u * 1.5;
  const double radius = 0.2 * length(at.v), side = 2 * length(half);
  return {[=](const f64::Surface& s) {
            f64::Tube light;
            light.from = at.center - half;
            light.to = at.center + half;
            light.radius = radius;
            light.caps = 2;
            return f64::shade_tube(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            const Vec3d axis = normalize(half);
            const f64::Frame frame = f64::shading_frame(axis, Vec3d(0.13, 0.3, 1));
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double phi = 2 * k_pi * (j + 0.5) / n;
                const Vec3d normal = frame.t1 * std::cos(phi) + frame.t2 * std::sin(phi);
                sum += patch(s, at.center + half * (2 * (i + 0.5) / n - 1) + normal * radius,
                             normal, side * 2 * k_pi * radius / (n * n));
                const double height = (i + 0.5) / n, across = std::sqrt(1 - height * height);
                for (const double end : {-1.0, 1.0}) {
                  const Vec3d out = normal * across + axis * (end * height);
                  sum += patch(s, at.center + half * end + out * radius, out,
                               2 * k_pi * radius * radius / (n * n));
                }
              }
            return sum;
          }};
}

} // namespace

f64::Surface surface_of_form(LightForm form, double theta, double roughness, double f0,
                             double albedo) {
  // As `openltc render` has them: GGX itself with the albedo of the table of two lobes.
  const bool two = form != LightForm::lobe && form != LightForm::ratio;
  const LobeTableView table =
      two ? table::builtin_ggx_two_lobe_table().view() : table::builtin_ggx_table().view();
  const Vec3d wo(std::sin(theta), 0, std::cos(theta));
  f64::Surface s =
      f64::make_surface(f64::fetch_lobe_of_roughness(table, roughness, wo.z), Vec3d(0.0),
                        Vec3d(0, 0, 1), wo, Vec3d(albedo), Vec3d(f0), Vec3d(1.0), roughness);
  if (two) s = f64::add_second_lobe(s, f64::fetch_second_lobe_of_roughness(table, roughness, wo.z));
  if (form == LightForm::ratio || form == LightForm::two_lobes_ratio) s = f64::correct_at_mean(s);
  if (form == LightForm::adaptive) s = f64::make_adaptive(s);
  return form == LightForm::exact ? f64::make_exact(s) : s;
}

double visible_normals(const f64::Surface& s, int bits, const std::function<bool(Vec3d)>& meets) {
  const std::uint32_t count = 1u << bits;
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    double inverse = 0;
    for (int b = 0; b < bits; ++b)
      if (i >> b & 1) inverse += std::ldexp(1.0, -1 - b);
    const Vec3d wi =
        f64::sample_ggx(s.wo, s.alpha, Vec2d((i + 0.5) / count, inverse + 0.5 / count));
    if (wi.z <= 0 || !meets(f64::to_world(s.frame, wi))) continue;
    sum += f64::eval_ggx_terms(s.wo, wi, s.alpha).scale / f64::pdf_ggx(s.wo, wi, s.alpha);
  }
  return sum / count;
}

PlacedLight placed_quad(Placed at) {
  const Vec3d axis_u = normalize(at.u), axis_v = normalize(at.v), normal = cross(axis_u, axis_v);
  const double a = length(at.u), b = length(at.v);
  return {[=](const f64::Surface& s) {
            const TestPolygon polygon({testing::rectangle(2 * a, 2 * b)}, at.center, axis_u,
                                      axis_v);
            return f64::shade_polygon(s, polygon.view()).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j)
                sum += patch(
                    s, at.center + at.u * (2 * (i + 0.5) / n - 1) + at.v * (2 * (j + 0.5) / n - 1),
                    normal, 4 * a * b / (n * n));
            return sum;
          }};
}

const PlacedShape k_placed_shapes[5] = {{"quad", placed_quad},
                                        {"ellipse", ellipse},
                                        {"sphere", sphere},
                                        {"line", line},
                                        {"capsule", capsule}};

// Somewhere above, more or less towards the point.
Placed random_place(double size, Random& random) {
  const Vec3d w = random.hemisphere();
  const f64::Frame frame =
      f64::shading_frame(normalize(random.sphere() * 0.5 - w), Vec3d(0, 0.3, 1));
  return {w * 2.0, frame.t1 * (size * random.uniform(0.2, 1)),
          frame.t2 * (size * random.uniform(0.2, 1))};
}

} // namespace openltc::testing
