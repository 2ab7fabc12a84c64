// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of lights in shader files: their mean over all points is the light itself.

#include "openltc/api/ggx_polynomial.inc"
#include "tests/shaders/light_sample.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using namespace openltc::testing;

namespace {

// What a grid of 48^2 numbers misses: a polygon's outline in its circle, the far side of a tube.
// Measured: 0.0012 and 0.01 for quads, disks 0.0016 and 0.01, spheres 0.0018 and 0.01; polygons
// 0.0066 and 0.023; tubes 0.0078 and 0.058; lines 1.3e-5 and 1.2e-4.
struct Bounds {
  double mean, worst;
};
constexpr Bounds k_bounds[] = {{0.003, 0.02}, {0.01, 0.04}, {0.003, 0.02},
                               {0.003, 0.02}, {0.01, 0.08}, {5e-5, 5e-4}};

constexpr int k_cases = 50, k_side = 48, k_directions = 96;

f64::Surface surface_of(const metal_run::Case& at) {
  const double metallic = double(at.metallic), roughness = double(at.roughness);
  const Vec3d n = load(at.normal), wo = load(at.view), base = load(at.base_color);
  LobePolynomialView view;
  view.coefficients = k_ggx_polynomial;
  view.degree = k_ggx_polynomial_degree;
  const double alpha = f64::alpha_from_roughness(roughness);
  const f64::Surface s = f64::make_surface(
      f64::eval_lobe_polynomial(view, alpha, dot(n, wo)), load(at.position), n, wo,
      base * (1 - metallic), Vec3d(0.04) * (1 - metallic) + base * metallic, Vec3d(1.0), roughness);
  return at.tilted ? f64::set_geometric_normal(s, load(at.geometric)) : s;
}

/// A light in double precision.
struct Light {
  metal_run::Shape shape;
  PackedPolygon polygon;
  f64::Ellipse disk;
  f64::Sphere sphere;
  f64::Tube tube;
  f64::Line line;

  explicit Light(const LightSample& sample) : shape(sample.at.shape) {
    const float* l = sample.at.light;
    const Vec3d a = load(l), b = load(l + 3);
    polygon = shape == metal_run::k_quad ? corners_of(sample.at) : sample.packed;
    const Vec3d u = f64::any_perpendicular(b);
    disk = {a, u * double(l[6]), cross(b, u) * double(l[6]), double(l[7])};
    sphere = {a, double(l[3])};
    tube = {a, b, double(l[6]), double(l[7])};
    line = {a, b};
  }

  // What a matte surface reflects of it, without an approximation unless its triangle is tilted and
  // the light round.
  Vec3d diffuse(const f64::Surface& s) const {
    switch (shape) {
    case metal_run::k_disk:
      return f64::shade_ellipse_parts(s, disk).diffuse;
    case metal_run::k_sphere:
      return f64::shade_sphere_parts(s, sphere).diffuse;
    case metal_run::k_tube:
      return f64::shade_tube_parts(s, tube).diffuse;
    case metal_run::k_line:
      return f64::shade_line_parts(s, line).diffuse;
    default:
      return f64::shade_polygon_parts(s, polygon.view).diffuse;
    }
  }

  bool is_met(const f64::Surface& s, Vec3d direction) const {
    switch (shape) {
    case metal_run::k_disk:
      return f64::intersect_ellipse_by_area(disk, s.position, direction).hit;
    case metal_run::k_sphere:
      return f64::intersect_sphere(sphere, f64::sphere_seen(sphere, s.position), direction).hit;
    case metal_run::k_tube:
      return f64::intersect_tube_by_area(tube, s.position, direction).hit;
    default:
      return f64::intersect_polygon_by_area(polygon.view, s.position, direction).hit;
    }
  }
};

bool is_hidden(const f64::Surface& s, Vec3d direction) {
  return s.tilted && dot(direction, s.geometric) <= 0;
}

// By the directions in which GGX reflects, a line by its pieces.
Vec3d mirrored_light(const f64::Surface& s, const Light& light) {
  Vec3d sum(0.0);
  const auto add = [&](Vec3d wi, double weight) {
    sum = sum + f64::eval_ggx(s.wo, wi, s.alpha, s.f0, s.f90) * weight;
  };
  if (light.shape == metal_run::k_line) {
    constexpr int k_pieces = 20000;
    const Vec3d axis = light.line.to - light.line.from;
    for (int i = 0; i < k_pieces; ++i) {
      const Vec3d to = light.line.from + axis * ((i + 0.5) / k_pieces) - s.position;
      const double r = std::sqrt(dot(to, to));
      const Vec3d across = cross(axis, to * (1 / r));
      if (!is_hidden(s, to))
        add(f64::to_shading(s.frame, to * (1 / r)),
            std::sqrt(dot(across, across)) / (r * r) / k_pieces);
    }
    return sum;
  }
  for (int i = 0; i < k_directions; ++i)
    for (int j = 0; j < k_directions; ++j) {
      const Vec3d wi =
          f64::sample_ggx(s.wo, s.alpha, Vec2d((i + 0.5) / k_directions, (j + 0.5) / k_directions));
      const double density = f64::pdf_ggx(s.wo, wi, s.alpha);
      const Vec3d direction = f64::to_world(s.frame, wi);
      if (density > 0 && !is_hidden(s, direction) && light.is_met(s, direction))
        add(wi, 1 / density / (k_directions * k_directions));
    }
  return sum;
}

} // namespace

TEST_CASE("the mean of eval_point over points is the light: Lambert's in closed form, GGX by its "
          "own directions") {
  for (int shape = 0; shape < metal_run::k_textured; ++shape) {
    Random random(std::uint64_t(shape) + 11);
    double mean = 0, worst = 0;
    for (int lit = 0; lit < k_cases;) {
      LightSample sample = make_light_sample(random, metal_run::Shape(shape));
      metal_run::Case& at = sample.at;
      at.polygon = sample.elements.data();
      at.tilted = at.tilted && (at.shape == metal_run::k_quad || at.shape == metal_run::k_polygon);
      const f64::Surface s = surface_of(at);
      const Light light(sample);
      const Vec3d expected = light.diffuse(s) + mirrored_light(s, light);
      const double most = std::max({expected.x, expected.y, expected.z});
      if (most < 0.01) continue;
      ++lit;
      const float by_lobe = at.shape != metal_run::k_line && at.roughness < 0.4f ? 0.5f : 0.0f;
      double out[3];
      metal_run::shade_by_points(at, k_side, by_lobe, out);
      const double error = std::max({std::abs(out[0] - expected.x), std::abs(out[1] - expected.y),
                                     std::abs(out[2] - expected.z)}) /
                           most;
      mean += error / k_cases;
      worst = std::max(worst, error);
    }
    MESSAGE(fmt::format("shape {}: mean {:.2g}, worst {:.2g}", shape, mean, worst));
    CHECK(mean < k_bounds[shape].mean);
    CHECK(worst < k_bounds[shape].worst);
  }
}
