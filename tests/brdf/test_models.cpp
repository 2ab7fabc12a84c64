// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Each model against what its paper promises of its parts.

#include "directions.h"
#include "openltc/brdf/beckmann.h"
#include "openltc/brdf/blinn.h"
#include "openltc/brdf/brdf.h"
#include "openltc/brdf/charlie.h"
#include "openltc/brdf/ggx_albedo.h"
#include "openltc/fit/quadrature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>

using namespace openltc;
using test::direction;
using test::radians;

namespace {

using Normals = std::function<double(Vec3d h, double alpha)>;

// Integral of D(h) g(h) over the hemisphere, crowded about slopes of alpha.
double over_normals(const Normals& distribution, double alpha,
                    const std::function<double(Vec3d)>& g) {
  constexpr int n_theta = 4000, n_phi = 64;
  double sum = 0;
  for (int i = 0; i < n_theta; ++i) {
    const double u = (i + 0.5) / n_theta, slope = alpha * u / (1 - u);
    const double theta = std::atan(slope);
    const double d_theta = alpha / ((1 - u) * (1 - u)) / (1 + slope * slope) / n_theta;
    for (int j = 0; j < n_phi; ++j) {
      const Vec3d h = direction(theta, f64::k_pi * (j + 0.5) / n_phi);
      sum += distribution(h, alpha) * g(h) * std::sin(theta) * d_theta;
    }
  }
  return sum * 2 * f64::k_pi / n_phi;
}

double blinn(Vec3d h, double alpha) {
  return brdf::blinn_distribution(h, brdf::blinn_exponent(alpha));
}

const brdf::Brdf& entry(const char* name) { return *brdf::find_brdf(name); }

double f_pi(const brdf::Brdf& b, Vec3d wo, Vec3d wi, double roughness) {
  return b.eval(wo, wi, roughness).scale / wi.z * f64::k_pi;
}

} // namespace

TEST_CASE("distributions of normals are normalised: integral of D cos is 1") {
  const auto cosine = [](Vec3d h) { return h.z; };
  for (const double alpha : {1e-4, 0.01, 0.1, 0.5, 1.0}) {
    CAPTURE(alpha);
    CHECK(over_normals(brdf::beckmann_distribution, alpha, cosine) ==
          doctest::Approx(1).epsilon(1e-5));
    CHECK(over_normals(blinn, alpha, cosine) == doctest::Approx(1).epsilon(1e-5));
    if (alpha > 0.01)
      CHECK(over_normals(brdf::charlie_distribution, alpha, cosine) ==
            doctest::Approx(1).epsilon(1e-3));
  }
}

// Heitz 2014, what defines G1: the visible facets' projected area is that of the surface.
TEST_CASE("Beckmann's exact Lambda: visible normals fill the projected area") {
  for (const double alpha : {0.01, 0.2, 0.7, 1.0}) {
    for (const double degrees : {5.0, 45.0, 75.0, 87.0}) {
      const Vec3d wo = direction(radians(degrees), 0);
      // Seen along the normal nothing is masked: V = G1/(4 cos).
      const double g1 = 4 * wo.z * brdf::beckmann_visibility(wo.z, 1, alpha);
      const double area = over_normals(brdf::beckmann_distribution, alpha,
                                       [&](Vec3d h) { return std::max(0.0, dot(wo, h)); });
      CAPTURE(alpha);
      CAPTURE(degrees);
      CHECK(g1 * area == doctest::Approx(wo.z).epsilon(1e-3));
    }
  }
}

TEST_CASE("Charlie's Lambda comes close to Smith's integral and is continuous") {
  double worst = 0;
  for (const double alpha : {0.1, 0.3, 0.6, 1.0}) {
    for (const double degrees : {5.0, 30.0, 50.0, 70.0, 80.0}) {
      const Vec3d wo = direction(radians(degrees), 0);
      const double area = over_normals(brdf::charlie_distribution, alpha,
                                       [&](Vec3d h) { return std::max(0.0, dot(wo, h)); });
      const double g1 = 1 / (1 + brdf::charlie_lambda(wo.z, alpha));
      worst = std::max(worst, std::abs(g1 - wo.z / area));
    }
    CHECK(brdf::charlie_lambda(0.5 - 1e-9, alpha) ==
          doctest::Approx(brdf::charlie_lambda(0.5 + 1e-9, alpha)).epsilon(1e-6));
  }
  MESSAGE("largest difference of G1 ", worst);
  CHECK(worst < 0.05);
}

TEST_CASE("the albedo that ggx-ms divides by keeps its stated error") {
  std::mt19937 bits(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 1500; ++i) {
    const double roughness = uniform(bits);
    const double cos_o = i % 2 == 0 ? 1 - uniform(bits) : std::pow(10.0, -5 * uniform(bits));
    const double exact = fit::make_quadrature(entry("ggx"), roughness, cos_o, {64, 64})->n1;
    worst = std::max(worst, std::abs(brdf::ggx_albedo(cos_o, roughness) - exact));
  }
  MESSAGE("largest error ", worst);
  CHECK(worst < brdf::k_albedo_error);
}

TEST_CASE("ggx-ms: white for F = 1, Schlick's part that of ggx") {
  const Vec3d wo = direction(0.9, 0);
  for (const double roughness : {0.0, 0.3, 1.0}) {
    const Vec3d wi = direction(0.8, 3.0);
    const brdf::BrdfValue plain = entry("ggx").eval(wo, wi, roughness);
    const brdf::BrdfValue white = entry("ggx-ms").eval(wo, wi, roughness);
    CHECK(white.scale >= plain.scale);
    CHECK(white.bias == plain.bias);
  }
}

TEST_CASE("separable masking is darker than correlated, and the same where one direction is free") {
  for (const double degrees : {20.0, 60.0, 85.0}) {
    const Vec3d wo = direction(radians(degrees), 0), n(0, 0, 1);
    for (const double roughness : {0.2, 0.6, 1.0}) {
      for (const double other : {10.0, 50.0, 80.0}) {
        const Vec3d wi = direction(radians(other), 2.5);
        CHECK(entry("ggx-separable").eval(wo, wi, roughness).scale <
              entry("ggx").eval(wo, wi, roughness).scale);
      }
      CHECK(entry("ggx-separable").eval(wo, n, roughness).scale ==
            doctest::Approx(entry("ggx").eval(wo, n, roughness).scale).epsilon(1e-12));
    }
  }
}

TEST_CASE("Blinn at roughness 1 is GGX at roughness 1") {
  for (const double degrees : {0.0, 40.0, 80.0}) {
    const Vec3d wo = direction(radians(degrees), 0), wi = direction(1.0, 2.0);
    CHECK(entry("blinn").eval(wo, wi, 1).scale ==
          doctest::Approx(entry("ggx").eval(wo, wi, 1).scale).epsilon(1e-12));
  }
}

TEST_CASE("Beckmann, Blinn and Phong have the same width at low roughness") {
  // At normal incidence, half-vector slope alpha: Beckmann has fallen to 1/e.
  for (const double roughness : {0.02, 0.1}) {
    const double alpha = roughness * roughness;
    const Vec3d n(0, 0, 1), wi = direction(2 * std::atan(alpha), 0);
    for (const char* name : {"beckmann", "blinn", "phong"}) {
      CAPTURE(name);
      CHECK(entry(name).eval(n, wi, roughness).scale / entry(name).eval(n, n, roughness).scale ==
            doctest::Approx(std::exp(-1.0)).epsilon(3 * alpha));
    }
  }
}

TEST_CASE("Phong's lobe is round about the mirror direction and whole at normal incidence") {
  const double tilt = 0.2;
  const Vec3d wo = direction(0.7, 0);
  const Vec3d mirror = test::mirrored(wo), side(0, 1, 0), up = cross(side, mirror);
  const double first =
      f_pi(entry("phong"), wo, mirror * std::cos(tilt) + side * std::sin(tilt), 0.5);
  const double second =
      f_pi(entry("phong"), wo, mirror * std::cos(tilt) + up * std::sin(tilt), 0.5);
  CHECK(first == doctest::Approx(second).epsilon(1e-12));
  for (const double roughness : {0.0, 0.1, 0.5, 1.0})
    CHECK(fit::make_quadrature(entry("phong"), roughness, 1, {100, 8})->n1 ==
          doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("Oren-Nayar and EON at roughness 0 are Lambert exactly") {
  for (const char* name : {"oren-nayar", "eon"})
    for (const double a : test::view_angles())
      for (const double b : test::view_angles())
        for (const double phi : {0.0, 1.0, 2.0, 3.0}) {
          const Vec3d wi = direction(radians(b), phi);
          CHECK(entry(name).eval(direction(radians(a), 0), wi, 0).scale == f64::k_inv_pi * wi.z);
        }
}

TEST_CASE("rough diffuse models send light back to where it came from") {
  const Vec3d wo = direction(radians(70), 0);
  for (const char* name : {"oren-nayar", "eon", "burley"}) {
    CAPTURE(name);
    CHECK(f_pi(entry(name), wo, wo, 1) > 1.1 * f_pi(entry(name), wo, test::mirrored(wo), 1));
  }
}

// Burley 2012, section 5.3: grazing retroreflection of F_D90^2, normal incidence Lambert.
TEST_CASE("Burley's limits") {
  const Vec3d grazing = direction(radians(89.9999), 0), n(0, 0, 1);
  for (const double roughness : {0.0, 0.5, 1.0}) {
    const double f_d90 = 0.5 + 2 * roughness;
    CHECK(f_pi(entry("burley"), grazing, grazing, roughness) ==
          doctest::Approx(f_d90 * f_d90).epsilon(1e-3));
    CHECK(f_pi(entry("burley"), n, n, roughness) == doctest::Approx(1));
  }
}
