// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself in white furnaces: four walls and a ceiling that hide the sky send back the albedo,
// which visible normals drawn evenly know, and no edge of a wall.

#include "openltc/table/lobe_table.h"
#include "tests/shade/exact/lit_quads.h"
#include "tests/shade/placed_lights.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace openltc;
using testing::Quad;
using testing::Random;
using testing::TestPolygon;

namespace {

constexpr double k_pi = std::numbers::pi;

struct Room {
  double theta, roughness;
  Quad walls[5];
};

// The point is in the middle of the floor, `off` 0, or up to that much of the way to the walls.
Room random_room(double theta, double roughness, double off, Random& random) {
  const double turn = random.uniform(0, 2 * k_pi), h = random.uniform(0.3, 2.3);
  const Vec3d x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0), down(0, 0, -h / 2);
  const double a = random.uniform(0.5, 2), b = random.uniform(0.5, 2);
  const Vec3d here = x * (off * a * random.uniform(-1, 1)) + y * (off * b * random.uniform(-1, 1));
  return {theta,
          roughness,
          {{here - down * 2.0, y * b, x * a},
           {here - down + x * a, y * b, down},
           {here - down - x * a, y * -b, down},
           {here - down + y * b, x * -a, down},
           {here - down - y * b, x * a, down}}};
}

// What a room reflects of 1, by quadrature and by the sums along edges, without the caps of
// shading: for F = 1, and what Schlick's weight leaves of it.
struct Reflected {
  double light = 0, bias = 0;
};

f64::Surface surface_in(const Room& room) {
  const Vec3d wo(std::sin(room.theta), 0, std::cos(room.theta));
  const f64::FittedLobe fitted = f64::fetch_lobe(table::builtin_ggx_table().view(),
                                                 f64::alpha_from_roughness(room.roughness), wo.z);
  return f64::make_exact(f64::make_surface(fitted, Vec3d(0.0), Vec3d(0, 0, 1), wo, Vec3d(0.0),
                                           Vec3d(1.0), Vec3d(1.0), room.roughness));
}

Reflected found_in(const Room& room) {
  const f64::Surface s = surface_in(room);
  Reflected sum;
  for (const Quad& wall : room.walls) {
    const TestPolygon polygon = wall.polygon();
    const f64::LightIntegral integral = f64::surface_polygon_integral(s, polygon.view());
    const double light = integral.specular * s.fitted.n1 * s.inv_share;
    sum.light += light;
    sum.bias += light * integral.weight;
  }
  return sum;
}

// 4096 visible normals.
Reflected expected_in(const Room& room) {
  const f64::Surface s = surface_in(room);
  constexpr int k_bits = 12;
  Reflected sum;
  for (int i = 0; i < 1 << k_bits; ++i) {
    double inverse = 0;
    for (int bit = 0; bit < k_bits; ++bit)
      if (i >> bit & 1) inverse += std::ldexp(0.5, -bit);
    const double half = std::ldexp(0.5, -k_bits);
    const Vec3d wi =
        f64::sample_ggx(s.wo, s.alpha, {std::ldexp(i, -k_bits) + half, inverse + half});
    if (wi.z <= 0) continue;
    const f64::GgxTerms terms = f64::eval_ggx_terms(s.wo, wi, s.alpha);
    const double scale = std::ldexp(1 / f64::pdf_ggx(s.wo, wi, s.alpha), -k_bits);
    sum.light += terms.scale * scale;
    sum.bias += terms.bias * scale;
  }
  return sum;
}

struct Range {
  double least = 2, most = 0;

  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

} // namespace

TEST_CASE("exact polygons: five walls of a white furnace, from any place between them") {
  Random random(41);
  Range metal, dielectric;
  for (int i = 0; i < 6000; ++i) {
    const double theta = random.uniform(i % 3 ? 1.05 : 0, i % 3 ? 1.55 : 1.05);
    // In the middle no ceiling has an azimuth.
    const Room room = random_room(theta, random.log_uniform(0.1, 1), i % 2 ? 0.95 : 0, random);
    const Reflected found = found_in(room), expected = expected_in(room);
    metal.add(found.light / expected.light);
    // A white base returns what is not reflected: 1 is what is right.
    const double more = 0.04 * (found.light - expected.light) + 0.96 * (found.bias - expected.bias);
    dielectric.add(1 + more);
  }
  MESSAGE("metal ", metal.least, " to ", metal.most, ", dielectric over a white base ",
          dielectric.least, " to ", dielectric.most);
  CHECK(metal.least > 0.99);
  CHECK(metal.most < 1.01);
  CHECK(dielectric.least > 0.985);
  CHECK(dielectric.most < 1.01);
}

TEST_CASE("exact polygons: five walls of a white furnace, around mirrors") {
  Random random(29);
  Range mirrors;
  for (int i = 0; i < 6000; ++i) {
    const double theta = random.uniform(0, 1.55);
    const Room room = random_room(theta, random.log_uniform(0.02, 0.1), i % 2 ? 0.95 : 0, random);
    mirrors.add(found_in(room).light / expected_in(room).light);
  }
  MESSAGE("furnace ", mirrors.least, " to ", mirrors.most);
  CHECK(mirrors.least > 0.985);
  CHECK(mirrors.most < 1.01);
}
