// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Each conversion against its definition, by adding up what every patch of a light sends in every
// direction, and against its inverse.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"
#include "openltc/light/shapes.h"
#include "openltc/light/units/blender.h"
#include "openltc/light/units/units.h"
#include "openltc/light/units/usdlux.h"
#include "openltc/target/shade_f64.h"
#include "tests/light/light_patches.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace openltc;
using namespace openltc::light;
using namespace openltc::light::test;

constexpr double k_pi = std::numbers::pi;
constexpr double k_inf = std::numeric_limits<double>::infinity();

template <class Light> void check_light(Light light, Vec3d direction, double sides_of_flux = 1) {
  for (const float power : {0.0f, 1.0f, 2.5f, 40.0f}) {
    CAPTURE(power);
    light.cosine_power = power;
    const Patches patches = patches_of(light);
    CHECK(flux_per_radiance(light) ==
          doctest::Approx(sides_of_flux * summed_flux(patches, double(power))).epsilon(1e-3));
    CHECK(intensity_per_radiance(light) ==
          doctest::Approx(summed_intensity(patches, double(power), direction)).epsilon(1e-3));

    light.radiance = Vec3f(0, 250, 3);
    const Vec3f flux = *flux_from_radiance(light, light.radiance);
    CHECK(double(flux.y) == doctest::Approx(double(flux_lumens(light).y)).epsilon(1e-6));
    const Vec3f intensity = *intensity_from_radiance(light, light.radiance);
    for (const Vec3f back :
         {*radiance_from_flux(light, flux), *radiance_from_intensity(light, intensity)}) {
      CHECK(back.x == 0.0f);
      CHECK(double(back.y) == doctest::Approx(250).epsilon(1e-6));
      CHECK(double(back.z) == doctest::Approx(3).epsilon(1e-6));
    }
  }
}

TEST_CASE("flux_and_intensity_are_the_sums_over_the_surface_and_all_directions") {
  SphereLight sphere;
  sphere.radius = 0.3f;
  check_light(sphere, normalize(Vec3d(1, 2, -1)));

  EllipseLight ellipse;
  ellipse.half_u = {0, 2, 0};
  ellipse.half_v = {0, 0, 0.5f};
  check_light(ellipse, {1, 0, 0});
  ellipse.two_sided = true;
  check_light(ellipse, {1, 0, 0}, 2);

  check_light(bent_polygon(), {0, 0, 1});

  TubeLight tube;
  tube.from = {1, 0, 0};
  tube.to = {1, 3, 0};
  tube.radius = 0.25f;
  for (const TubeCaps caps : {TubeCaps::none, TubeCaps::flat, TubeCaps::round}) {
    tube.caps = caps;
    check_light(tube, normalize(Vec3d(1, 0, 2)));
  }
}

TEST_CASE("a_line_sends_the_sine_of_the_angle_to_it_times_its_length") {
  LineLight line;
  line.to = line.from + Vec3f(0, 0, 2);
  double sum = 0;
  constexpr int rings = 100000;
  for (int i = 0; i < rings; ++i) {
    const double c = 2 * (i + 0.5) / rings - 1;
    sum += 2 * std::sqrt(1 - c * c) * 4 * k_pi / rings;
  }
  CHECK(flux_per_intensity(line) == doctest::Approx(sum).epsilon(1e-5));
  CHECK(double(flux_from_intensity(line, Vec3f(3.0f))->x) ==
        doctest::Approx(3 * flux_per_intensity(line)));
  CHECK(double(intensity_from_flux(line, Vec3f(50.0f))->x) ==
        doctest::Approx(50 / flux_per_intensity(line)));
}

TEST_CASE("flux_of_point_and_spot_lights_is_their_intensity_over_all_directions") {
  PunctualLight point;
  CHECK(flux_per_intensity(point) == doctest::Approx(4 * k_pi));
  PunctualLight spot;
  spot.type = PunctualType::spot;
  for (const auto& [inner, outer] : {std::pair{1.0f, 0.7f}, {0.9f, 0.1f}, {0.5f, 0.5f}}) {
    spot.cos_inner = inner;
    spot.cos_outer = outer;
    double sum = 0;
    constexpr int rings = 1000000;
    for (int i = 0; i < rings; ++i)
      sum += f64::spot_cone(2 * (i + 0.5) / rings - 1, double(inner), double(outer));
    CHECK(flux_per_intensity(spot) == doctest::Approx(sum * 4 * k_pi / rings).epsilon(1e-4));
    const Vec3f flux = *flux_from_intensity(spot, Vec3f(7.0f));
    CHECK(double(intensity_from_flux(spot, flux)->y) == doctest::Approx(7).epsilon(1e-6));
  }
  PunctualLight sun;
  sun.type = PunctualType::directional;
  CHECK(!flux_from_intensity(sun, Vec3f(1.0f)).ok());
}

TEST_CASE("a_small_light_s_illuminance_is_its_solid_angle_times_luminance") {
  // A sphere of 1000 nits and 1 cm seen from 3 m: E = L pi sin(t)^2, exact.
  SphereLight sphere;
  sphere.radius = 0.01f;
  const double intensity = double(intensity_from_radiance(sphere, Vec3f(1000.0f))->x);
  const double sine = 0.01 / 3;
  CHECK(*illuminance_from_intensity(intensity, 3) ==
        doctest::Approx(1000 * k_pi * sine * sine).epsilon(1e-6));
  CHECK(*illuminance_from_intensity(8, 2, 0.5) == doctest::Approx(1));
  CHECK(*intensity_from_illuminance(*illuminance_from_intensity(42, 7, 0.3), 7, 0.3) ==
        doctest::Approx(42));
}

TEST_CASE("exitance_is_what_a_square_metre_sends_into_the_hemisphere") {
  for (const double power : {0.0, 1.0, 6.5}) {
    CHECK(*exitance_from_luminance(20, power) ==
          doctest::Approx(20 * summed_flux({{{0, 0, 1}, 1}}, power)).epsilon(1e-5));
    CHECK(*luminance_from_exitance(*exitance_from_luminance(20, power), power) ==
          doctest::Approx(20));
  }
}

TEST_CASE("watts_become_lumens_by_a_stated_efficacy") {
  CHECK(*lumens_from_watts(2) == doctest::Approx(1366));
  for (const double efficacy : {k_efficacy_555nm, k_efficacy_even_white, k_efficacy_d65, 15.0})
    CHECK(*watts_from_lumens(*lumens_from_watts(3, efficacy), efficacy) == doctest::Approx(3));
}

TEST_CASE("exposure_values_are_what_the_two_meters_ask_for") {
  // N^2 / t = L S / K and = E S / C at S = 100; f/16 and 1/125 s is close to EV 15.
  const double ev = std::log2(16.0 * 16.0 * 125);
  CHECK(*luminance_from_ev100(ev) == doctest::Approx(16.0 * 16.0 * 125 * 12.5 / 100));
  CHECK(*illuminance_from_ev100(ev) == doctest::Approx(16.0 * 16.0 * 125 * 250 / 100));
  CHECK(*luminance_from_ev100(3) == doctest::Approx(1));
  CHECK(*illuminance_from_ev100(0) == doctest::Approx(2.5));
  for (const double x : {-6.0, 0.0, 15.3}) {
    CHECK(*ev100_from_luminance(*luminance_from_ev100(x)) == doctest::Approx(x));
    CHECK(*ev100_from_illuminance(*illuminance_from_ev100(x)) == doctest::Approx(x));
  }
}

template <class T> void refused(const Result<T>& result, const char* words) {
  REQUIRE(!result.ok());
  INFO(result.error().message);
  CHECK(result.error().message.find(words) != std::string::npos);
}

TEST_CASE("quantities_that_are_negative_or_not_finite_are_refused_by_name") {
  for (const double bad : {-1.0, -1e-300, k_inf, -k_inf, std::nan("")}) {
    CAPTURE(bad);
    refused(lumens_from_watts(bad), "power");
    refused(lumens_from_watts(1, bad), "efficacy");
    refused(watts_from_lumens(bad), "flux");
    refused(exitance_from_luminance(bad), "luminance");
    refused(exitance_from_luminance(1, bad), "cosine power");
    refused(luminance_from_exitance(bad), "exitance");
    refused(illuminance_from_intensity(bad, 1), "intensity");
    refused(illuminance_from_intensity(1, bad), "distance");
    refused(intensity_from_illuminance(1, 1, bad), "cosine of incidence");
    refused(ev100_from_luminance(bad), "luminance");
    refused(ev100_from_illuminance(bad), "illuminance");
    refused(luminance_from_blender_sphere(bad, 1), "strength");
    refused(luminance_from_blender_sphere(1, bad), "radius");
    refused(luminance_from_blender_area(1, bad), "area");
    refused(blender_area_from_luminance(bad, 1), "luminance");
    refused(gltf_intensity_from_blender(bad, PunctualType::point, GltfLightMode::raw), "strength");
    refused(blender_from_gltf_intensity(bad, PunctualType::spot, GltfLightMode::raw), "intensity");
    UsdLuxEmission emission;
    emission.intensity = bad;
    refused(luminance_from_usdlux(emission, 1), "inputs:intensity");
    emission = {};
    emission.normalize = true;
    refused(luminance_from_usdlux(emission, bad), "area");
    emission = {};
    emission.color.y = float(bad);
    if (emission.color.y != 0) refused(luminance_from_usdlux(emission, 1), "inputs:color");
    SphereLight sphere;
    const Vec3f color(1, 1, float(bad) == 0 ? -1.0f : float(bad));
    refused(flux_from_radiance(sphere, color), "radiance");
    refused(radiance_from_flux(sphere, color), "flux");
    refused(radiance_from_intensity(sphere, color), "intensity");
  }
  refused(ev100_from_luminance(0), "luminance");
  refused(lumens_from_watts(1, 0), "efficacy");
  refused(luminance_from_ev100(std::nan("")), "exposure");
  refused(luminance_from_ev100(2000), "exposure");
  refused(lumens_from_watts(1e308), "too large");
  SphereLight none;
  none.radius = 0;
  refused(radiance_from_flux(none, Vec3f(1.0f)), "no extent");
  refused(flux_from_radiance(SphereLight{}, Vec3f(1e38f)), "too large");
}

} // namespace
