// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Closed forms of the API against radiometry's own: configuration factors of Lambert's floor
// (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors"), mirrors, white furnaces,
// and which side of what sees light.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace openltc;

namespace {

constexpr double k_pi = 3.14159265358979323846;
const Vec3f k_up(0, 1, 0);

/// A floor in y = 0 of albedo 1 and without a specular part.
Surface lambert(Vec3f position = {0, 0, 0}, Vec3f normal = k_up, Vec3f view = {0, 1, 1}) {
  Material material;
  material.specular = 0;
  return make_surface(position, normal, view, material, built_in_table());
}

Surface metal(float roughness, Vec3f view, const Lobes& lobes = built_in_table(),
              Vec3f color = {1, 1, 1}) {
  Material material;
  material.metallic = 1;
  material.roughness = roughness;
  material.base_color = color;
  return make_surface({0, 0, 0}, k_up, view, material, lobes);
}

/// Factor from a differential element to a parallel rectangle a x b at distance 1, one corner of
/// which lies over the element.
double corner_factor(double a, double b) {
  const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * k_pi);
}

/// A rectangle at height 1 over the floor that faces down, from (x0, z0) to (x1, z1).
Polygon ceiling(float x0, float z0, float x1, float z1, bool two_sided = false) {
  return Polygon::rectangle({(x0 + x1) / 2, 1, (z0 + z1) / 2}, {(x1 - x0) / 2, 0, 0},
                            {0, 0, (z1 - z0) / 2}, two_sided);
}

} // namespace

TEST_CASE("rectangle_over_a_lambertian_floor_gives_its_configuration_factor") {
  for (const double a : {0.01, 0.3, 1.0, 7.0})
    for (const double b : {0.02, 0.5, 2.0}) {
      CAPTURE(a);
      CAPTURE(b);
      // With the element under the corner, under the middle and beside it.
      CHECK(shade(lambert(), ceiling(0, 0, float(a), float(b))).x ==
            doctest::Approx(corner_factor(a, b)).epsilon(2e-5));
      CHECK(shade(lambert(), ceiling(float(-a), float(-b), float(a), float(b))).x ==
            doctest::Approx(4 * corner_factor(a, b)).epsilon(2e-5));
      const double beside = corner_factor(a + 1, b) - corner_factor(1, b);
      CHECK(shade(lambert(), ceiling(1, 0, float(a + 1), float(b))).x ==
            doctest::Approx(beside).epsilon(2e-4));
    }
}

TEST_CASE("the_diffuse_part_is_what_the_specular_one_leaves") {
  Material material;
  material.base_color = {0.5f, 0.25f, 1};
  material.roughness = 0.7f;
  const Surface s = make_surface({0, 0, 0}, k_up, {0, 1, 0}, material, built_in_table());
  const ShadedParts parts = shade_parts(s, ceiling(-1, -1, 1, 1));
  // Seen along its normal a dielectric reflects about 4 %, at this roughness somewhat less.
  const double factor = 4 * corner_factor(1, 1);
  CHECK(parts.diffuse.x < 0.5 * factor);
  CHECK(parts.diffuse.x > 0.5 * 0.96 * factor);
  CHECK(parts.diffuse.y == doctest::Approx(parts.diffuse.x / 2).epsilon(1e-6));
  CHECK(parts.diffuse.z == doctest::Approx(parts.diffuse.x * 2).epsilon(1e-6));
  CHECK(parts.specular.x > 0);
  CHECK(parts.specular.x < 0.04f);
  const Vec3f sum = shade(s, ceiling(-1, -1, 1, 1), {3, 3, 3});
  CHECK(sum.x == doctest::Approx(3 * (parts.diffuse.x + parts.specular.x)).epsilon(1e-6));
}

TEST_CASE("disk_and_sphere_over_a_lambertian_floor_give_their_configuration_factors") {
  for (const double radius : {0.01, 0.4, 2.0}) {
    CAPTURE(radius);
    // A disk parallel to the element, on its normal.
    const double factor = radius * radius / (1 + radius * radius);
    CHECK(shade(lambert(), disk({0, 1, 0}, {0, -1, 0}, float(radius))).x ==
          doctest::Approx(factor).epsilon(2e-5));
    // A sphere above the element's horizon, at the angle t from its normal.
    for (const double t : {0.0, 0.5, 1.0}) {
      const double distance = 4 * radius;
      if (std::cos(t) * distance < radius) continue;
      const Vec3f center(float(distance * std::sin(t)), float(distance * std::cos(t)), 0);
      CHECK(shade(lambert(), Sphere{center, float(radius)}).x ==
            doctest::Approx(std::cos(t) / 16).epsilon(2e-5));
    }
  }
}

TEST_CASE("line_and_thin_tube_over_a_lambertian_floor_give_the_integral_along_them") {
  // With I cd/m across it, at height h, from -l to l: E = I (l/(h^2 + l^2) + atan(l/h)/h).
  for (const double h : {0.5, 1.0, 3.0})
    for (const double l : {0.1, 1.0, 10.0}) {
      CAPTURE(h);
      CAPTURE(l);
      const double expected = (l / (h * h + l * l) + std::atan(l / h) / h) / k_pi;
      const Vec3f from(float(-l), float(h), 0), to(float(l), float(h), 0);
      CHECK(shade(lambert(), Line{from, to}).x == doctest::Approx(expected).epsilon(2e-5));
      // A tube of diameter d is such a line of radiance times d, but for its ends, which bulge
      // towards the floor: r/h of l at most.
      const float radius = 1e-3f;
      CHECK(shade(lambert(), Tube{from, to, radius, TubeCaps::none}, Vec3f(1 / (2 * radius))).x ==
            doctest::Approx(expected).epsilon(double(radius) / h));
    }
}

TEST_CASE("a_mirror_shows_the_light_where_it_is_and_nothing_beside_it") {
  for (const Lobes& lobes : {built_in_table(), built_in_polynomial()}) {
    // Seen at 45 degrees; the mirrored ray leads to (0, 1, -1).
    const Surface s = metal(0, {0, 1, 1}, lobes, {1, 0.5f, 0.25f});
    const Vec3f there =
        shade(s, Polygon::rectangle({0, 1, -1}, {0.3f, 0, 0}, {0, 0, 0.3f}), Vec3f(1.0f));
    // Schlick at 45 degrees adds (1 - cos)^5 = 0.0021 of what is missing to 1.
    CHECK(there.x == doctest::Approx(1).epsilon(0.01));
    CHECK(there.y == doctest::Approx(0.5).epsilon(0.02));
    CHECK(there.z == doctest::Approx(0.25).epsilon(0.03));
    for (const Vec3f center : {Vec3f(1, 1, -1), Vec3f(0, 1, 1), Vec3f(0, 1, -2)})
      CHECK(shade(s, Polygon::rectangle(center, {0.3f, 0, 0}, {0, 0, 0.3f})).x < 0.01f);
    CHECK(shade(s, Sphere{{0, 1, -1}, 0.3f}).x == doctest::Approx(1).epsilon(0.01));
    CHECK(shade(s, disk({0, 1, -1}, {0, -1, 0}, 0.3f)).x == doctest::Approx(1).epsilon(0.01));
    CHECK(shade(s, Tube{{-2, 1, -1}, {2, 1, -1}, 0.2f}).x == doctest::Approx(1).epsilon(0.01));
  }
}

TEST_CASE("white_furnace_a_white_dielectric_under_a_white_sky_is_white") {
  // A ceiling that fills the hemisphere but for 1e-4 radians over the horizon.
  const Polygon sky = ceiling(-1e4f, -1e4f, 1e4f, 1e4f);
  REQUIRE(sky.usable());
  for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f})
    for (const float z : {0.0f, 0.5f, 1.0f, 3.0f}) {
      CAPTURE(roughness);
      CAPTURE(z);
      Material material;
      material.roughness = roughness;
      const Surface s = make_surface({0, 0, 0}, k_up, {0, 1, z}, material, built_in_table());
      // What the specular part takes the diffuse one does not give.
      CHECK(shade(s, sky).x == doctest::Approx(1).epsilon(2e-3));
      // A white metal loses what leaves a microfacet by way of a second one, and gains nothing.
      const float reflected = shade(metal(roughness, {0, 1, z}), sky).x;
      CHECK(reflected <= 1.0f);
      CHECK(reflected > 0.3f);
    }
  // GGX of alpha 1, seen along the normal: the integral of D V cos is 1 - ln 2.
  CHECK(shade(metal(1, k_up), sky).x == doctest::Approx(1 - std::log(2.0)).epsilon(1e-3));
}

TEST_CASE("correct_at_mean_makes_a_small_light_the_exact_brdf") {
  const Vec3f view(0.9f, 0.4f, 0.1f);
  for (const float roughness : {0.3f, 0.6f}) {
    Surface s = metal(roughness, view);
    const Vec3f towards(-0.5f, 0.7f, 0.4f);
    const float radius = 0.01f, distance2 = 0.25f + 0.49f + 0.16f;
    const Ellipse light = disk(towards, {0.5f, -0.7f, -0.4f}, radius);
    const double exact =
        double(eval_surface(s, towards).x) * k_pi * double(radius * radius / distance2);
    const double lobe = double(shade(s, light).x);
    correct_at_mean(s);
    CHECK(double(shade(s, light).x) == doctest::Approx(exact).epsilon(1e-3));
    CHECK(std::abs(lobe - exact) > 0.03 * exact);
  }
}

TEST_CASE("two_lobes_are_nearer_to_the_integral_of_the_brdf_than_one_and_ggx_itself_is_that") {
  // A metal floor seen from low down; lights before and beside the mirrored view.
  double error[4] = {}, sum = 0;
  for (const float roughness : {0.2f, 0.35f, 0.5f})
    for (const float distance : {-6.0f, -4.0f, -2.0f, 1.0f}) {
      const Vec3f view(0, 0.2f, 1), center(0.3f, 0.6f, distance);
      const Vec3f half_u(0.4f, 0, 0), half_v(0, 0.3f, 0);
      const Polygon light = Polygon::rectangle(center, half_u, half_v, true);
      const Surface one = metal(roughness, view),
                    two = metal(roughness, view, built_in_two_lobe_table());
      double truth = 0;
      constexpr int n = 120;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const float a = float(2 * (i + 0.5) / n - 1), b = float(2 * (j + 0.5) / n - 1);
          const Vec3f p = center + half_u * a + half_v * b;
          const double d2 = double(dot(p, p)), cos_light = std::abs(double(p.z)) / std::sqrt(d2);
          truth += double(eval_surface(one, p).x) * cos_light / d2 * (0.8 * 0.6) / (n * n);
        }
      error[0] += std::abs(double(shade(one, light).x) - truth);
      error[1] += std::abs(double(shade(two, light).x) - truth);
      Surface adaptive = two, exact = one;
      make_adaptive(adaptive);
      make_exact(exact);
      error[2] += std::abs(double(shade(adaptive, light).x) - truth);
      error[3] += std::abs(double(shade(exact, light).x) - truth);
      sum += truth;
    }
  MESSAGE("relative to all light: one lobe ", error[0] / sum, ", two ", error[1] / sum,
          ", adaptive ", error[2] / sum, ", exact ", error[3] / sum);
  CHECK(error[1] < 0.7 * error[0]);
  CHECK(error[2] < 0.2 * error[0]);
  CHECK(error[3] < 0.02 * error[0]);
}

TEST_CASE("lights_shine_to_their_own_side_and_two_sided_ones_to_both") {
  // Facing up, away from the floor.
  const Polygon away = Polygon::rectangle({0, 1, 0}, {0, 0, 0.5f}, {0.5f, 0, 0});
  const Polygon both = Polygon::rectangle({0, 1, 0}, {0, 0, 0.5f}, {0.5f, 0, 0}, true);
  const Polygon towards = ceiling(-0.5f, -0.5f, 0.5f, 0.5f);
  CHECK(towards.normal().y == -1);
  CHECK(away.normal().y == 1);
  const Surface s = lambert();
  CHECK(shade(s, away).x == 0);
  CHECK(shade(s, both).x == doctest::Approx(shade(s, towards).x).epsilon(1e-6));
  CHECK(shade(s, disk({0, 1, 0}, k_up, 0.5f)).x == 0);
  CHECK(shade(s, disk({0, 1, 0}, k_up, 0.5f, true)).x ==
        doctest::Approx(0.2).epsilon(1e-5)); // r^2/(1 + r^2)
  // In the plane of a light, and inside of solid ones, there is none.
  CHECK(shade(lambert({0, 1, 0}, {1, 0, 0}, {1, 0, 0}), both).x == 0);
  CHECK(shade(s, Sphere{{0, 0.5f, 0}, 1}).x == 0);
  CHECK(shade(s, Tube{{-1, 0.1f, 0}, {1, 0.1f, 0}, 1}).x == 0);
}

TEST_CASE("lights_of_no_size_or_out_of_reach_are_dark") {
  const Surface s = lambert();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float size : {0.0f, -0.5f, 1e-13f, 2e8f, nan}) {
    CAPTURE(size);
    CHECK(shade(s, Sphere{{0, 1, 0}, size}).x == 0);
    CHECK(shade(s, disk({0, 1, 0}, {0, -1, 0}, size)).x == 0);
    CHECK(shade(s, Tube{{-1, 1, 0}, {1, 1, 0}, size}).x == 0);
    CHECK(!sample_light(s, Sphere{{0, 1, 0}, size}, {0.5f, 0.5f}).valid);
  }
  CHECK(shade(s, Tube{{0, 1, 0}, {0, 1, 0}, 0.1f}).x == 0);
  CHECK(shade(s, Line{{0, 1, 0}, {0, 1, 0}}).x == 0);
  CHECK(shade(s, Sphere{{0, 5e8f, 0}, 9e7f}).x == 0);
  CHECK(shade(s, Ellipse{{0, 1, 0}, {1, 0, 0}, {0.5f, 0, 0.5f}, true}).x == 0); // not perpendicular
  CHECK(shade(s, PointLight{{0, 5e8f, 0}, {1e20f, 1e20f, 1e20f}}).x == 0);
  CHECK(shade(s, DirectionalLight{{0, 0, 0}}).x == 0);
}

TEST_CASE("nothing_comes_from_below_the_horizon_and_half_a_light_from_across_it") {
  const Surface s = lambert();
  const Polygon below = Polygon::rectangle({0, -1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, true);
  CHECK(shade(s, below).x == 0);
  CHECK(shade(s, Sphere{{0, -2, 0}, 1}).x == 0);
  // A wall that stands half in the floor gives what its upper half gives.
  const Polygon wall = Polygon::rectangle({0, 0, -1}, {1, 0, 0}, {0, 1, 0});
  const Polygon upper = Polygon::rectangle({0, 0.5f, -1}, {1, 0, 0}, {0, 0.5f, 0});
  CHECK(shade(s, wall).x == doctest::Approx(shade(s, upper).x).epsilon(1e-5));
  const Surface glossy = metal(0.4f, {0, 0.5f, 1});
  CHECK(shade(glossy, wall).x == doctest::Approx(shade(glossy, upper).x).epsilon(1e-4));
}

TEST_CASE("holes_take_away_what_they_cut_out") {
  const std::vector<Vec3f> outer = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  const std::vector<Vec3f> hole = {
      {-0.5f, 1, -0.5f}, {-0.5f, 1, 0.5f}, {0.5f, 1, 0.5f}, {0.5f, 1, -0.5f}};
  const Polygon ring = Polygon::from_rings({outer, hole});
  REQUIRE(ring.usable());
  CHECK(ring.area() == doctest::Approx(3));
  CHECK(shade(lambert(), ring).x ==
        doctest::Approx(4 * (corner_factor(1, 1) - corner_factor(0.5, 0.5))).epsilon(2e-5));
}

TEST_CASE("point_spot_and_directional_lights_follow_the_inverse_square_and_the_cone") {
  const Surface s = lambert();
  // L = E / pi of a white Lambertian floor.
  CHECK(shade(s, PointLight{{0, 2, 0}, {8, 4, 0}}).x ==
        doctest::Approx(8 / (4 * k_pi)).epsilon(1e-5));
  CHECK(shade(s, PointLight{{0, 2, 0}, {8, 4, 0}}).y ==
        doctest::Approx(4 / (4 * k_pi)).epsilon(1e-5));
  CHECK(shade(s, PointLight{{3, 4, 0}}).x == doctest::Approx(0.8 / (25 * k_pi)).epsilon(1e-5));
  CHECK(shade(s, PointLight{{0, -1, 0}}).x == 0);
  // max(1 - (d/range)^4, 0), the window that KHR_lights_punctual recommends.
  CHECK(shade(s, PointLight{{0, 2, 0}, {1, 1, 1}, 4}).x ==
        doctest::Approx((1 - 1.0 / 16) / (4 * k_pi)).epsilon(1e-5));
  CHECK(shade(s, PointLight{{0, 2, 0}, {1, 1, 1}, 2}).x == 0);

  CHECK(shade(s, DirectionalLight{{0, -3, 0}, {5, 5, 5}}).x ==
        doctest::Approx(5 / k_pi).epsilon(1e-5));
  CHECK(shade(s, DirectionalLight{{0, -1, 1}, {5, 5, 5}}).x ==
        doctest::Approx(5 * std::sqrt(0.5) / k_pi).epsilon(1e-5));
  CHECK(shade(s, DirectionalLight{{0, 1, 0}}).x == 0);

  SpotLight spot{{0, 1, 0}, {0, -2, 0}};
  spot.inner_angle = 0.2f;
  spot.outer_angle = 0.6f;
  CHECK(shade(s, spot).x == doctest::Approx(1 / k_pi).epsilon(1e-5));
  // The extension's own cone: the square of a ramp in the cosine, here between the two angles.
  const double angle = 0.4, x = std::tan(angle);
  const double ramp = (std::cos(angle) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
  CHECK(shade(lambert({float(x), 0, 0}), spot).x ==
        doctest::Approx(ramp * ramp * std::pow(std::cos(angle), 3) / k_pi).epsilon(1e-4));
  CHECK(shade(lambert({1, 0, 0}), spot).x == 0);
}
