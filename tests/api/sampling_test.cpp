// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sampling of lights: its mean is the closed form, where that is exact; its density is that of
// where its points lie.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace openltc;

namespace {

constexpr double k_pi = 3.14159265358979323846;

struct Random {
  std::mt19937 engine{7};
  std::uniform_real_distribution<float> uniform{0, 1};
  Vec2f two() { return {uniform(engine), uniform(engine)}; }
};

/// Surfaces of Lambert, whose closed form is exact: facing the light, across its horizon, and with
/// a triangle's plane that cuts it.
std::vector<Surface> surfaces() {
  Material material;
  material.specular = 0;
  const Lobes lobes = built_in_polynomial();
  return {make_surface({0, 0, 0}, {0, 1, 0}, {0, 1, 0.3f}, material, lobes),
          make_surface({0.2f, 0.1f, 0}, {1, 0.3f, 0.1f}, {1, 1, 0.3f}, material, lobes),
          make_surface({0.1f, 0, 0.1f}, {0.3f, 1, 0}, {0.1f, 1, 0.3f}, material, lobes,
                       {1, 0.6f, 0.2f})};
}

/// The mean of an estimator over samples, and its standard error.
struct Mean {
  double sum = 0, square = 0;
  int count = 0;
  void add(double x) {
    sum += x;
    square += x * x;
    ++count;
  }
  double value() const { return sum / count; }
  double error() const {
    return std::sqrt(std::max(square / count - value() * value(), 0.0) / count);
  }
};

template <class AreaLight> void check_mean(const AreaLight& light, Random& random) {
  int index = 0;
  for (const Surface& surface : surfaces()) {
    CAPTURE(index++);
    Mean mean;
    for (int k = 0; k < 20000; ++k) {
      const LightSample sample = sample_light(surface, light, random.two());
      mean.add(sample.valid ? double(eval_surface(surface, sample.direction).x) / double(sample.pdf)
                            : 0);
    }
    const double closed = double(shade(surface, light).x);
    CHECK(closed > 1e-3);
    // Five standard errors, and the rounding of single precision in both.
    CHECK(std::abs(mean.value() - closed) < 5 * mean.error() + 1e-4 * closed);
  }
}

template <class AreaLight> void check_density(const AreaLight& light, Random& random) {
  int index = 0;
  for (const Surface& surface : surfaces()) {
    CAPTURE(index++);
    Mean valid;
    double largest = 0;
    for (int k = 0; k < 4000; ++k) {
      const LightSample sample = sample_light(surface, light, random.two());
      valid.add(sample.valid ? 1 : 0);
      if (!sample.valid) continue;
      REQUIRE(double(length(sample.direction)) == doctest::Approx(1).epsilon(1e-5));
      REQUIRE(double(length(surface.point.position + sample.direction * sample.distance -
                            sample.position)) < 1e-5);
      // A ray there meets it there, with the same density; but where the ray just misses the rim.
      const LightSample met = intersect_light(surface, light, sample.direction);
      if (!met.valid) continue;
      REQUIRE(met.pdf == doctest::Approx(sample.pdf).epsilon(2e-3));
      REQUIRE(double(met.distance) == doctest::Approx(double(sample.distance)).epsilon(2e-3));
      largest = std::max(largest, double(sample.pdf));
    }
    // The density's integral over all directions is the share of samples that count.
    Mean mass;
    for (int k = 0; k < 60000; ++k) {
      const Vec2f u = random.two();
      const double z = 1 - 2 * double(u.x), r = std::sqrt(1 - z * z), phi = 2 * k_pi * double(u.y);
      const Vec3f direction(float(r * std::cos(phi)), float(r * std::sin(phi)), float(z));
      mass.add(4 * k_pi * double(pdf_light(surface, light, direction)));
    }
    CHECK(largest > 0);
    CHECK(std::abs(mass.value() - valid.value()) < 5 * (mass.error() + valid.error()) + 2e-3);
  }
}

template <class AreaLight> void check_solid(const AreaLight& light) {
  Random random;
  check_mean(light, random);
  check_density(light, random);
}

} // namespace

TEST_CASE("polygon_samples_average_to_the_closed_form_with_their_density") {
  check_solid(Polygon::rectangle({0.2f, 0.8f, 0.1f}, {0.6f, 0, 0}, {0, 0, 0.4f}));
  // More triangles than are sampled by solid angle: a ring of 32 corners with a hole.
  std::vector<Vec3f> outer, hole;
  for (int i = 0; i < 16; ++i) {
    const float angle = float(2 * k_pi * i / 16);
    outer.push_back({0.2f + std::cos(angle), 0.9f, std::sin(angle)});
    hole.push_back({0.2f + 0.4f * std::cos(angle), 0.9f, -0.4f * std::sin(angle)});
  }
  const Polygon ring = Polygon::from_rings({outer, hole});
  REQUIRE(ring.usable());
  check_solid(ring);
}

TEST_CASE("ellipse_samples_average_to_the_closed_form_with_their_density") {
  check_solid(Ellipse{{0.2f, 0.8f, 0.1f}, {0.6f, 0.1f, 0}, {0, 0, 0.3f}});
  check_solid(disk({0.3f, 0.6f, 0}, {-0.5f, -1, 0.2f}, 0.4f, true));
}

TEST_CASE("sphere_samples_average_to_the_closed_form_with_their_density") {
  check_solid(Sphere{{0.3f, 0.9f, 0.1f}, 0.5f});
}

TEST_CASE("tube_samples_average_to_the_closed_form_with_their_density") {
  for (const TubeCaps caps : {TubeCaps::none, TubeCaps::flat, TubeCaps::round})
    check_solid(Tube{{-0.5f, 0.9f, 0.1f}, {0.9f, 0.7f, 0.3f}, 0.2f, caps});
}

TEST_CASE("line_samples_average_to_the_closed_form") {
  Random random;
  check_mean(Line{{-0.5f, 0.9f, 0.1f}, {0.9f, 0.7f, 0.3f}}, random);
}

TEST_CASE("what_cannot_be_seen_gives_no_valid_sample") {
  const Surface s = surfaces()[0];
  Random random;
  const Polygon away = Polygon::rectangle({0, 1, 0}, {0, 0, 0.5f}, {0.5f, 0, 0});
  for (int k = 0; k < 100; ++k) {
    const Vec2f u = random.two();
    CHECK(!sample_light(s, away, u).valid);
    CHECK(!sample_light(s, Sphere{{0, -2, 0}, 1}, u).valid);   // below the horizon
    CHECK(!sample_light(s, Sphere{{0, 0.5f, 0}, 1}, u).valid); // around the point
    CHECK(!sample_light(s, Ellipse{{0, -1, 0}}, u).valid);
    CHECK(!sample_light(s, Line{{-1, -1, 0}, {1, -1, 0}}, u).valid);
  }
  CHECK(pdf_light(s, away, {0, 1, 0}) == 0);
  CHECK(pdf_light(s, Sphere{{0, 2, 0}, 1}, {1, 0.1f, 0}) == 0);
  CHECK(pdf_light(s, Sphere{{0, 2, 0}, 1}, {0, 5, 0}) > 0);
}
