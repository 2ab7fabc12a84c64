// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Surfaces: normals, sides, one's own lobes, and a BRDF that integrates and samples as it should.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace openltc;

namespace {

constexpr double k_pi = 3.14159265358979323846;

Material glossy(float roughness, float metallic = 0) {
  Material material;
  material.roughness = roughness;
  material.metallic = metallic;
  material.base_color = {0.9f, 0.6f, 0.3f};
  return material;
}

const Polygon& lamp() {
  static const Polygon polygon = Polygon::rectangle({0.3f, 1, -1}, {0.5f, 0, 0}, {0, 0, 0.5f});
  return polygon;
}

float light_of(const Surface& s) { return shade(s, lamp()).x; }

} // namespace

TEST_CASE("normals_and_views_may_have_any_length") {
  const Surface one =
      make_surface({0, 0, 0}, {0, 1, 0}, {0, 0.8f, 0.6f}, glossy(0.3f), built_in_table());
  REQUIRE(one.usable);
  for (const float length : {1e-6f, 0.3f, 100.0f, 1e9f})
    CHECK(light_of(make_surface({0, 0, 0}, {0, length, 0}, {0, 0.8f * length, 0.6f * length},
                                glossy(0.3f), built_in_table())) ==
          doctest::Approx(light_of(one)).epsilon(1e-5));
}

TEST_CASE("what_is_no_surface_is_black") {
  const Lobes lobes = built_in_table();
  CHECK(!make_surface({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, Material(), lobes).usable);
  CHECK(!make_surface({0, 0, 0}, {0, 1, 0}, {0, 0, 0}, Material(), lobes).usable);
  CHECK(!make_surface({0, 5e8f, 0}, {0, 1, 0}, {0, 1, 0}, Material(), lobes).usable);
  CHECK(!make_surface({0, 0, 0}, {0, 1, 0}, {0, 1, 0}, Material(), Lobes()).usable);
  CHECK(!make_surface({0, 0, 0}, {0, 1, 0}, {0, 1, 0}, Material(), lobes, {0, 0, 0}).usable);
  const Surface none;
  CHECK(light_of(none) == 0);
  CHECK(eval_surface(none, {0, 1, 0}).x == 0);
  CHECK(pdf_surface(none, {0, 1, 0}) == 0);
  CHECK(!sample_surface(none, {0.5f, 0.5f}).valid);
  CHECK(!sample_light(none, lamp(), {0.5f, 0.5f}).valid);
}

TEST_CASE("the_triangle_hides_what_is_behind_it_whatever_the_shading_normal_says") {
  // A wall in the plane x = 0 whose shading normal is bent to +y. The light above reaches from x =
  // -0.2 to 0.8.
  const Vec3f geometric(1, 0, 0), shading(0.6f, 0.8f, 0), view(1, 0.5f, 0);
  const Surface bent = make_surface({0, 0, 0}, shading, view, glossy(0.5f), built_in_table());
  const Surface known =
      make_surface({0, 0, 0}, shading, view, glossy(0.5f), built_in_table(), geometric);
  const Polygon behind = Polygon::rectangle({-1, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f});
  CHECK(shade(bent, behind).x > 0.01f);
  CHECK(shade(known, behind).x == 0);
  CHECK(eval_surface(known, {-1, 1, 0}).x == 0);
  CHECK(pdf_surface(known, {-1, 1, 0}) == 0);
  CHECK(sample_light(bent, behind, {0.5f, 0.5f}).valid);
  CHECK(!sample_light(known, behind, {0.5f, 0.5f}).valid);
  CHECK(pdf_light(bent, behind, {-1, 1, 0}) > 0);
  CHECK(pdf_light(known, behind, {-1, 1, 0}) == 0);
  // Of a light across the plane the front part counts.
  const Polygon whole = Polygon::rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1});
  const Polygon front = Polygon::rectangle({0.5f, 1, 0}, {0.5f, 0, 0}, {0, 0, 1});
  CHECK(shade(known, whole).x == doctest::Approx(shade(bent, front).x).epsilon(1e-4));
  CHECK(shade(known, whole).x < shade(bent, whole).x);
  // So it is with the other shapes.
  CHECK(shade(known, Sphere{{-1, 1, 0}, 0.5f}).x == 0);
  CHECK(shade(known, disk({-1, 1, 0}, {0, -1, 0}, 0.5f)).x == 0);
  CHECK(shade(known, Tube{{-1, 1, -1}, {-1, 1, 1}, 0.2f}).x == 0);
  CHECK(shade(known, Line{{-1, 1, -1}, {-1, 1, 1}}).x == 0);
  CHECK(shade(known, PointLight{{-1, 1, 0}}).x == 0);
  CHECK(shade(bent, PointLight{{-1, 1, 0}}).x > 0);
}

TEST_CASE("back_faces_are_turned_round_by_their_triangle") {
  // Seen from below: the same as a surface that faces down.
  const Vec3f view(0.3f, -1, 0.2f);
  const Polygon lamp_below = Polygon::rectangle({0.3f, -1, -1}, {0, 0, 0.5f}, {0.5f, 0, 0});
  const Surface turned =
      make_surface({0, 0, 0}, {0.1f, 1, 0}, view, glossy(0.4f), built_in_table(), {0, 1, 0});
  const Surface down =
      make_surface({0, 0, 0}, {-0.1f, -1, 0}, view, glossy(0.4f), built_in_table(), {0, -1, 0});
  CHECK(shade(down, lamp_below).x > 0);
  CHECK(shade(turned, lamp_below).x == shade(down, lamp_below).x);
}

TEST_CASE("a_normal_that_faces_away_is_bent_not_dark") {
  const Vec3f view(0, 0.1f, 1);
  const Surface away = make_surface({0, 0, 0}, {0, 1, -0.2f}, view, glossy(0.5f), built_in_table());
  REQUIRE(away.usable);
  CHECK(light_of(away) > 0);
}

TEST_CASE("a_point_has_no_side_of_a_flat_light_that_it_may_lie_in") {
  // Half a millimetre in front of a wall's lamp, on a floor that runs into the wall.
  const Polygon wall = Polygon::rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Surface s = make_surface({0, 0, 5e-4f}, {0, 1, 0}, {0, 1, 1}, Material(), built_in_table());
  const auto valid_samples = [&] {
    int count = 0;
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
        count += sample_light(s, wall, {(float(i) + 0.5f) / 10, (float(j) + 0.5f) / 10}).valid;
    return count;
  };
  CHECK(shade(s, wall).x > 0.1f); // half of what a floor in front of an endless wall has
  CHECK(valid_samples() > 10);
  CHECK(intersect_light(s, wall, {0, 1, -0.01f}).valid);
  set_position_error(s, 1e-4f);
  CHECK(shade(s, wall).x > 0.1f);
  set_position_error(s, 1e-3f);
  CHECK(shade(s, wall).x == 0);
  CHECK(shade(s, disk({0, 0, 0}, {0, 0, 1}, 1)).x == 0);
  CHECK(valid_samples() == 0);
  CHECK(!intersect_light(s, wall, {0, 1, -0.01f}).valid);
  const float more = s.point.position_error2;
  for (const float less : {0.0f, -1.0f, 1e-5f, std::numeric_limits<float>::quiet_NaN()}) {
    set_position_error(s, less);
    CHECK(s.point.position_error2 == more);
  }
}

TEST_CASE("ones_own_table_or_polynomial_serves_as_well_as_the_built_in") {
  const std::vector<float> copy(std::begin(k_ggx_table), std::end(k_ggx_table));
  Lobes own;
  own.table = {copy.data(), 64, 64};
  const auto light = [](const Lobes& lobes) {
    return light_of(make_surface({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, glossy(0.37f), lobes));
  };
  CHECK(light(own) == light(built_in_table()));
  const std::vector<float> terms(std::begin(k_ggx_polynomial), std::end(k_ggx_polynomial));
  own.polynomial = {terms.data(), 4};
  CHECK(light(own) == light(built_in_polynomial()));
  // Two fits of one BRDF; the lobes alone, in the middle of the reflection and beside it.
  for (const float roughness : {0.15f, 0.37f, 0.8f})
    for (const float x : {0.0f, 0.5f}) {
      CAPTURE(roughness);
      CAPTURE(x);
      const auto reflected = [&](const Lobes& lobes) {
        const Surface s =
            make_surface({x, 0, 0}, {0, 1, 0}, {0, 1, 1}, glossy(roughness, 1), lobes);
        return double(shade(s, Sphere{{0, 1, -1}, 0.4f}).x);
      };
      CHECK(std::abs(reflected(built_in_table()) - reflected(built_in_polynomial())) < 0.02);
    }
}

TEST_CASE("sampled_directions_average_to_the_integral_of_the_brdf") {
  // Under a white sky of radiance 1, by sampling and by a product rule over the hemisphere.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (const float roughness : {0.25f, 0.5f, 1.0f}) {
    for (const bool tilted : {false, true}) {
      CAPTURE(roughness);
      CAPTURE(tilted);
      const Vec3f view(0, 1, 0.7f);
      const Surface s =
          tilted ? make_surface({0, 0, 0}, {0, 1, 0}, view, glossy(roughness), built_in_table(),
                                {0.4f, 1, 0.2f})
                 : make_surface({0, 0, 0}, {0, 1, 0}, view, glossy(roughness), built_in_table());
      double expected = 0, mass = 0;
      const int n = 400;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) { // even in cos^2 and azimuth: cosine-weighted
          const double sin2 = (i + 0.5) / n, phi = (j + 0.5) / n * k_pi, r = std::sqrt(sin2);
          const double c = std::sqrt(1 - sin2);
          const Vec3f wi(float(r * std::cos(phi)), float(c), float(r * std::sin(phi)));
          const double solid_angle = k_pi / (n * 2 * n) / c;
          expected += double(eval_surface(s, wi).x) * solid_angle;
          mass += double(pdf_surface(s, wi)) * solid_angle;
        }
      double sum = 0, square = 0, valid = 0;
      const int samples = 40000;
      for (int k = 0; k < samples; ++k) {
        const DirectionSample d = sample_surface(s, {uniform(random), uniform(random)});
        if (!d.valid) continue;
        CHECK(double(length(d.direction)) == doctest::Approx(1).epsilon(1e-5));
        const double x = double(d.value.x) / double(d.pdf);
        sum += x;
        square += x * x;
        valid += 1;
      }
      const double mean = sum / samples;
      const double error = std::sqrt((square / samples - mean * mean) / samples);
      // Five standard errors, and what the rule's cells leave at the rim of the tilted plane.
      CHECK(std::abs(mean - expected) < 5 * error + 2e-3 * expected);
      // The density holds as much as there are samples that count.
      const double share = valid / samples;
      CHECK(std::abs(mass - share) < 5 * std::sqrt(share * (1 - share) / samples) + 3e-3);
    }
  }
}
