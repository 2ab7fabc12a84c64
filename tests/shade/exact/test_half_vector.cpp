// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons lit by GGX itself, by integrals along their edges: against points of the polygon and
// against visible normals drawn evenly, in double precision, neither of which knows of edges.

#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "tests/shade/exact/lit_quads.h"
#include "tests/shade/placed_lights.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace openltc;
using testing::Errors;
using testing::midpoints;
using testing::Quad;
using testing::Random;
using testing::random_quad;
using testing::reflected;
using testing::TestPolygon;
using testing::visible_normals;

namespace {

constexpr double k_pi = std::numbers::pi;

// Without a diffuse part, of white metal or a dielectric, seen from `wo` of world space.
f64::Surface surface(Vec3d position, Vec3d normal, Vec3d wo, double roughness, double f0 = 1) {
  const f64::FittedLobe fitted = f64::fetch_lobe(
      table::builtin_ggx_table().view(), f64::alpha_from_roughness(roughness), dot(normal, wo));
  return f64::make_exact(f64::make_surface(fitted, position, normal, wo, Vec3d(0.0), Vec3d(f0),
                                           Vec3d(1.0), roughness));
}

f64::Surface surface(double theta, double roughness, double f0 = 1) {
  return surface(Vec3d(0.0), Vec3d(0, 0, 1), Vec3d(std::sin(theta), 0, std::cos(theta)), roughness,
                 f0);
}

f32::Surface surface_f32(double theta, double roughness) {
  const Vec3f wo = to_float(Vec3d(std::sin(theta), 0, std::cos(theta)));
  const f32::FittedLobe fitted = f32::fetch_lobe(table::builtin_ggx_table().view(),
                                                 f32::alpha_from_roughness(float(roughness)), wo.z);
  return f32::make_exact(f32::make_surface(fitted, Vec3f(0.0f), Vec3f(0, 0, 1), wo, Vec3f(0.0f),
                                           Vec3f(1.0f), Vec3f(1.0f), float(roughness)));
}

// What is found, without the caps of shading: the integral of f_s cos_i for F = 1.
double light_of(const f64::Surface& s, const PolygonView& polygon) {
  return f64::surface_polygon_integral(s, polygon).specular * s.fitted.n1 * s.inv_share;
}

double found(const f64::Surface& s, const Quad& quad) {
  const TestPolygon polygon = quad.polygon();
  return light_of(s, polygon.view());
}

double shade(const f64::Surface& s, const Quad& quad) {
  const TestPolygon polygon = quad.polygon();
  return f64::shade_polygon(s, polygon.view()).x;
}

} // namespace

TEST_CASE("exact polygons: quads of every size, against points of them") {
  for (const double size : {1.0, 0.25, 0.03}) {
    Random random(11);
    Errors exact, lobe, ratio;
    for (int i = 0; i < 200; ++i) {
      // What the points resolve.
      const double roughness = random.uniform(std::min(0.35, 0.1 + 0.25 * size), 1);
      const f64::Surface s = surface(random.uniform(0, 88.0 / 180 * k_pi), roughness);
      const Quad quad = random_quad(size, random);
      const double truth = midpoints(s, quad, 300);
      exact.add(found(s, quad), truth);
      f64::Surface plain = s;
      plain.exact = false;
      ratio.add(shade(plain, quad), truth);
      plain.corrected = false;
      lobe.add(shade(plain, quad), truth);
    }
    MESSAGE("size ", size, ": of the light ", exact.of_light(), " (lobe ", lobe.of_light(),
            ", ratio ", ratio.of_light(), "), mean ", exact.mean(), " (", lobe.mean(), ", ",
            ratio.mean(), "), worst ", exact.worst, " (", lobe.worst, ", ", ratio.worst, ")");
    CHECK(exact.mean() < 1e-4);
    CHECK(exact.of_light() < 1e-3);
    CHECK(exact.worst < 0.015);
    CHECK(exact.of_light() < 0.1 * ratio.of_light());
  }
}

TEST_CASE("exact polygons: Schlick's weight is integrated too, against points of them") {
  const struct { double size, bound; } cases[] = {{1, 8e-3}, {0.25, 6e-4}, {0.03, 1e-4}};
  for (const auto& one : cases) {
    Random random(43);
    Errors exact, at_mean;
    for (int i = 0; i < 200; ++i) {
      const f64::Surface s =
          surface(random.uniform(0, 88.0 / 180 * k_pi),
                  random.uniform(std::min(0.35, 0.1 + 0.25 * one.size), 1), 0.04);
      const Quad quad = random_quad(one.size, random);
      const TestPolygon polygon = quad.polygon();
      const double truth = midpoints(s, quad, 200);
      const f64::LightIntegral integral = f64::surface_polygon_integral(s, polygon.view());
      exact.add(f64::shade_integral(s, integral).specular.x, truth);
      at_mean.add(
          f64::specular_reflectance(s, integral.specular_direction, f64::filled_share(s, integral))
              .x,
          truth);
    }
    MESSAGE("size ", one.size, ": of the light ", exact.of_light(),
            " (weight in the mean direction ", at_mean.of_light(), "), worst ", exact.worst, " (",
            at_mean.worst, ")");
    CHECK(exact.of_light() < one.bound);
    CHECK(exact.of_light() < 0.4 * at_mean.of_light());
  }
}

TEST_CASE("exact ellipses, disks and spheres, against points of them") {
  for (const double size : {1.0, 0.25, 0.02}) {
    Random random(19);
    Errors ellipses, spheres;
    double widest = 0; // single precision against double
    for (int i = 0; i < 150; ++i) {
      const double theta = random.uniform(0, 88.0 / 180 * k_pi), roughness = random.uniform(0.3, 1);
      const f64::Surface s = surface(theta, roughness);
      const double scale = s.fitted.n1 * s.inv_share;
      const Quad at = random_quad(size, random);
      const double ratio = i % 2 ? 1 : length(at.v) / length(at.u);
      const f64::Ellipse ellipse = {at.center, at.u, normalize(at.v) * (ratio * length(at.u)), 0};
      constexpr int n = 200;
      const Vec3d normal = f64::ellipse_normal(ellipse);
      double exact = 0;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          const double r = std::sqrt((a + 0.5) / n), phi = 2 * k_pi * (b + 0.5) / n;
          const Vec3d p = at.center + ellipse.half_u * (r * std::cos(phi)) +
                          ellipse.half_v * (r * std::sin(phi));
          const double distance2 = dot(p, p), facing = -dot(p, normal) / std::sqrt(distance2);
          const Vec3d wi = f64::to_shading(s.frame, normalize(p));
          if (facing > 0)
            exact += f64::eval_ggx_terms(s.wo, wi, s.alpha).scale * facing / distance2;
        }
      const double of_ellipse = f64::surface_ellipse_integral(s, ellipse).specular * scale;
      ellipses.add(of_ellipse, exact * f64::ellipse_area(ellipse) / (n * n));
      const f32::LightIntegral single = f32::surface_ellipse_integral(
          surface_f32(theta, roughness),
          {to_float(ellipse.center), to_float(ellipse.half_u), to_float(ellipse.half_v), 0});
      widest = std::max(widest, std::abs(double(single.specular) * scale - of_ellipse));

      const f64::Sphere sphere = {at.center, std::min(length(at.u), 0.95 * length(at.center))};
      const double sine2 = sphere.radius * sphere.radius / dot(at.center, at.center);
      const double height = sine2 / (1 + std::sqrt(1 - sine2));
      const f64::Frame frame = f64::shading_frame(normalize(at.center), Vec3d(0.1, 0.3, 1));
      exact = 0;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          const double down = height * (a + 0.5) / n, phi = 2 * k_pi * (b + 0.5) / n;
          const double across = std::sqrt(down * (2 - down));
          const Vec3d w = frame.n * (1 - down) + frame.t1 * (across * std::cos(phi)) +
                          frame.t2 * (across * std::sin(phi));
          exact += f64::eval_ggx_terms(s.wo, f64::to_shading(s.frame, w), s.alpha).scale;
        }
      spheres.add(f64::surface_sphere_integral(s, sphere).specular * scale,
                  exact * 2 * k_pi * height / (n * n));
    }
    MESSAGE("size ", size, ": ellipses ", ellipses.of_light(), " of the light, worst ",
            ellipses.worst, "; spheres ", spheres.of_light(), ", worst ", spheres.worst,
            "; single precision, worst ", widest);
    CHECK(ellipses.of_light() < 1e-3);
    CHECK(ellipses.worst < 3e-3);
    CHECK(spheres.of_light() < 1e-3);
    CHECK(spheres.worst < 8e-3);
    CHECK(widest < 1e-4);
  }
}

TEST_CASE(
    "exact spheres: the axes of a round cone, which are any, change nothing, nor does rounding") {
  Random random(31);
  double turned = 0, rounded = 0; // of what the brightest would reflect
  for (int i = 0; i < 2000; ++i) {
    const double theta = random.uniform(0, 89.0 / 180 * k_pi), roughness = random.uniform(0.14, 1);
    const f64::Surface s = surface(theta, roughness);
    // About the mirror direction, where smooth surfaces are bright.
    const Vec3d center = normalize(Vec3d(-std::sin(theta), 0, std::cos(theta)) +
                                   random.sphere() * random.uniform(0, 0.5));
    const double radius = random.uniform(0.05, 0.6);
    if (center.z < -radius) continue;
    const auto light = [&](double turn) {
      const f64::Frame axes = f64::shading_frame(center, Vec3d(0.1, 0.3, 1));
      f64::Cone cone;
      cone.e1 = axes.t1 * std::cos(turn) + axes.t2 * std::sin(turn);
      cone.e3 = center;
      cone.e2 = cross(center, cone.e1);
      cone.k1 = cone.k2 = radius;
      cone.c1 = cone.c2 = std::sqrt(1 - radius * radius);
      const f64::ExactIntegral integral = f64::exact_cone(s, cone, 6);
      return std::array{integral.light, integral.bias};
    };
    const auto one = light(0), other = light(random.uniform(0, 6));
    turned = std::max({turned, std::abs(other[0] - one[0]), std::abs(other[1] - one[1])});
    const f64::Sphere sphere = {center, radius};
    const f32::Surface single = surface_f32(theta, roughness);
    rounded = std::max(
        rounded, std::abs(double(f32::shade_sphere(single, {to_float(center), float(radius)}).x) -
                          f64::shade_sphere(s, sphere).x));
  }
  MESSAGE("turned ", turned, "; single precision ", rounded);
  CHECK(turned < 1e-6);
  CHECK(rounded < 5e-5);
}

TEST_CASE("exact lines, against points of them") {
  Random random(23);
  Errors errors;
  for (int i = 0; i < 300; ++i) {
    const f64::Surface s =
        surface(random.uniform(0, 88.0 / 180 * k_pi), random.log_uniform(0.1, 1));
    const Vec3d center = random.hemisphere() * random.uniform(1, 4);
    const Vec3d part = random.sphere() * random.log_uniform(0.01, 4);
    constexpr int n = 20000;
    double exact = 0;
    for (int k = 0; k < n; ++k) {
      const Vec3d p = center + part * (2 * (k + 0.5) / n - 1);
      const double distance2 = dot(p, p);
      exact += f64::eval_ggx_terms(s.wo, f64::to_shading(s.frame, normalize(p)), s.alpha).scale *
               length(cross(p, part)) / (distance2 * std::sqrt(distance2));
    }
    const f64::Line line = {center - part, center + part};
    errors.add(f64::shade_line(s, line).x, exact * 2 / n);
  }
  MESSAGE("of the light ", errors.of_light(), ", worst ", errors.worst);
  CHECK(errors.of_light() < 1e-3);
}

TEST_CASE(
    "exact polygons: concave ones, holes and islands, cut by both horizons and by a triangle, "
    "against visible normals") {
  for (const bool tilted : {false, true}) {
    Random random(13);
    Errors errors;
    for (int i = 0; i < 120; ++i) {
      const testing::Setting setting = testing::random_setting(random, 0.3);
      const double theta = random.uniform(0, 88.0 / 180 * k_pi);
      const Vec3d wo = setting.frame.n * std::cos(theta) + setting.frame.t1 * std::sin(theta);
      f64::Surface s = surface(setting.position, setting.frame.n, wo, random.log_uniform(0.02, 1));
      if (tilted)
        s = f64::set_geometric_normal(s, normalize(setting.frame.n + random.sphere() * 0.5));
      const testing::Plane plane = testing::random_plane(random, setting.position);
      const bool two_sided = i % 3 == 0;
      const TestPolygon polygon(testing::shape(i % 5), plane.origin, plane.u, plane.v, two_sided);
      const Vec3d normal = cross(plane.u, plane.v);
      const double h = dot(plane.origin - setting.position, normal);
      const auto meets = [&](Vec3d wi) {
        const double t = h / dot(wi, normal);
        if (t <= 0 || (h > 0 && !two_sided)) return false;
        if (tilted && dot(wi, s.geometric) <= 0) return false;
        const Vec3d p = setting.position + wi * t - plane.origin;
        return testing::inside_by_winding(polygon.view(), Vec2d(dot(p, plane.u), dot(p, plane.v)));
      };
      errors.add(light_of(s, polygon.view()), visible_normals(s, 13, meets));
    }
    MESSAGE(std::string(tilted ? "cut by triangles" : "whole"), ": mean ", errors.mean(),
            ", of the light ", errors.of_light(), ", worst ", errors.worst);
    CHECK(errors.light > 5);
    // Of which the points have most.
    CHECK(errors.mean() < 1e-3);
    CHECK(errors.worst < 0.015);
  }
}

TEST_CASE("exact polygons: one that shrinks becomes the exact point light") {
  Random random(17);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const f64::Surface s = surface(random.uniform(0, 1.5), random.uniform(0.1, 1));
    const Quad quad = random_quad(0.001, random);
    const double exact = midpoints(s, quad, 20);
    if (exact < 1e-12 || quad.center.z < 0.05) continue;
    worst = std::max(worst, std::abs(found(s, quad) - exact) / exact);
  }
  MESSAGE("worst ", worst);
  CHECK(worst < 1e-5);
}

TEST_CASE("exact polygons: a quad in two halves") {
  Random random(29);
  double split = 0, light = 0;
  for (int i = 0; i < 300; ++i) {
    const f64::Surface s = surface(random.uniform(0, 1.55), random.log_uniform(0.02, 1));
    const Quad whole = random_quad(1, random);
    light += found(s, whole);
    split += std::abs(found(s, {whole.center - whole.u * 0.5, whole.u * 0.5, whole.v}) +
                      found(s, {whole.center + whole.u * 0.5, whole.u * 0.5, whole.v}) -
                      found(s, whole));
  }
  MESSAGE("of the light ", split / light);
  CHECK(split / light < 3e-4);
}

TEST_CASE("exact lights: a second lobe changes nothing") {
  Random random(37);
  for (const double weight : {0.0, 0.3, 1.0}) {
    const f64::Surface one = surface(1, 0.4);
    const f64::Surface two = f64::add_second_lobe(one, {surface(1, 0.7).fitted.lobe, weight});
    const Quad quad = random_quad(1, random);
    CHECK(shade(two, quad) == doctest::Approx(shade(one, quad)).epsilon(1e-9));
    const f64::Sphere sphere = {quad.center, 0.5 * length(quad.center)};
    const double of_one = f64::shade_sphere(one, sphere).x;
    CHECK(f64::shade_sphere(two, sphere).x == doctest::Approx(of_one).epsilon(1e-9));
  }
}

TEST_CASE("exact polygons: single precision, and nothing that is not a number") {
  Random random(31);
  Errors errors;
  for (int i = 0; i < 20000; ++i) {
    // Every tenth at a limit.
    const double theta = i % 10 == 0 ? 0.5 * k_pi : i % 10 == 1 ? 0 : random.uniform(0, 1.57);
    const double roughness = i % 10 == 2 ? 0 : i % 10 == 3 ? 1 : random.uniform();
    Quad quad = random_quad(random.log_uniform(1e-4, 30), random);
    if (i % 10 == 4) quad.center = quad.center - Vec3d(0, 0, quad.center.z); // in the horizon
    if (i % 10 == 5) quad.v = quad.u - quad.v * (dot(quad.u, quad.v) / dot(quad.v, quad.v));
    const TestPolygon polygon = quad.polygon();
    const f64::Surface s = surface(theta, roughness);
    const double precise = f64::shade_polygon(s, polygon.view()).x;
    const double single =
        double(f32::shade_polygon(surface_f32(theta, roughness), polygon.view()).x);
    CHECK(std::isfinite(precise));
    CHECK(std::isfinite(single));
    CHECK(single >= 0);
    CHECK(single <= 1.001);
    const f32::Surface s32 = surface_f32(theta, roughness);
    const f32::Ellipse ellipse = {to_float(quad.center), to_float(quad.u), to_float(quad.v), 1};
    const f32::Sphere sphere = {to_float(quad.center), float(length(quad.u))};
    for (const double round :
         {double(f32::shade_ellipse(s32, ellipse).x), double(f32::shade_sphere(s32, sphere).x)}) {
      CHECK(std::isfinite(round));
      CHECK(round >= 0);
      CHECK(round <= 1.001);
    }
    if (roughness >= 0.05 && theta < 1.56) errors.add(single, precise);
  }
  MESSAGE("mean ", errors.mean(), ", worst ", errors.worst);
  CHECK(errors.mean() < 2e-6);
  CHECK(errors.worst < 1e-4);
}
