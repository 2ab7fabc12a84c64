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

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace openltc;
using namespace openltc::light;

constexpr double k_pi = std::numbers::pi;
constexpr double k_inf = std::numeric_limits<double>::infinity();

struct Patch {
  Vec3d normal;
  double area;
};
using Patches = std::vector<Patch>;

// A sphere's upper part, z >= z0, about `axis`: rings of equal area.
void add_cap(Patches& patches, Vec3d axis, double radius, double z0) {
  const Vec3d u = normalize(cross(axis, Vec3d(0.3, -0.5, 0.8))), v = cross(axis, u);
  constexpr int rings = 400, sectors = 400;
  const double each = 2 * k_pi * radius * radius * (1 - z0) / (rings * sectors);
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < sectors; ++i) {
      const double z = z0 + (1 - z0) * (j + 0.5) / rings, s = std::sqrt(1 - z * z);
      const double phi = 2 * k_pi * (i + 0.5) / sectors;
      patches.push_back({u * (s * std::cos(phi)) + v * (s * std::sin(phi)) + axis * z, each});
    }
}

Patches patches_of(const SphereLight& light) {
  Patches patches;
  add_cap(patches, {0, 0, 1}, double(light.radius), -1);
  return patches;
}

Patches patches_of(const EllipseLight& light) {
  // Squares of a fine grid over the square around the ellipse, those whose middle is inside.
  const Vec3d n = cross(to_double(light.half_u), to_double(light.half_v));
  constexpr int cells = 1000;
  Patches patches;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const double x = 2 * (i + 0.5) / cells - 1, y = 2 * (j + 0.5) / cells - 1;
      if (x * x + y * y <= 1) patches.push_back({normalize(n), 4 * length(n) / (cells * cells)});
    }
  return patches;
}

Patches patches_of(const TubeLight& light) {
  const Vec3d along = to_double(light.to) - to_double(light.from), axis = normalize(along);
  const Vec3d u = normalize(cross(axis, Vec3d(0.3, -0.5, 0.8))), v = cross(axis, u);
  const double r = double(light.radius);
  Patches patches;
  constexpr int sectors = 20000;
  for (int i = 0; i < sectors; ++i) {
    const double phi = 2 * k_pi * (i + 0.5) / sectors;
    patches.push_back(
        {u * std::cos(phi) + v * std::sin(phi), 2 * k_pi * r / sectors * length(along)});
  }
  for (const double side : {-1.0, 1.0}) {
    if (light.caps == TubeCaps::flat) patches.push_back({axis * side, k_pi * r * r});
    if (light.caps == TubeCaps::round) add_cap(patches, axis * side, r, 0);
  }
  return patches;
}

// An L of three unit squares.
PolygonLight bent_polygon() {
  PolygonLight light;
  light.vertices = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
  light.ring_end = {6};
  return light;
}

Patches patches_of(const PolygonLight& light) { return Patches(3, {to_double(light.normal), 1}); }

// Flux of a patch of radiance 1: its emission over the hemisphere, ring by ring.
double summed_flux(const Patches& patches, double power) {
  constexpr int rings = 4000;
  double per_area = 0, area = 0;
  for (int i = 0; i < rings; ++i) {
    const double c = (i + 0.5) / rings;
    per_area += std::pow(c, power) * c * 2 * k_pi / rings;
  }
  for (const Patch& patch : patches)
    area += patch.area;
  return area * per_area;
}

double summed_intensity(const Patches& patches, double power, Vec3d direction) {
  double sum = 0;
  for (const Patch& patch : patches) {
    const double c = dot(patch.normal, direction);
    if (c > 0) sum += patch.area * std::pow(c, power + 1);
  }
  return sum;
}

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

TEST_CASE("usdlux_lights_are_nits_and_when_normalized_keep_their_flux") {
  UsdLuxEmission emission;
  emission.intensity = 3;
  emission.exposure = 2;
  emission.color = {1, 0.5f, 0};
  const Vec3f nits = *luminance_from_usdlux(emission, 0);
  CHECK(double(nits.x) == doctest::Approx(12));
  CHECK(double(nits.y) == doctest::Approx(6));
  CHECK(nits.z == 0.0f);

  emission.normalize = true;
  const auto check_flux = [&](const auto& light) {
    const Vec3f radiance = *luminance_from_usdlux(emission, area(light));
    CHECK(summed_flux(patches_of(light), 0) * double(radiance.x) ==
          doctest::Approx(12 * k_pi).epsilon(1e-3));
  };
  for (const float size : {0.1f, 3.0f}) {
    SphereLight sphere;
    sphere.radius = size;
    check_flux(sphere);
    EllipseLight disk;
    disk.half_u = {size, 0, 0};
    disk.half_v = {0, size, 0};
    check_flux(disk);
    TubeLight cylinder; // whose ends do not emit
    cylinder.caps = TubeCaps::none;
    cylinder.radius = size;
    check_flux(cylinder);
  }
  check_flux(bent_polygon());
}

TEST_CASE("a_distant_light_lights_a_facing_surface_by_all_of_its_cone") {
  for (const double angle : {0.53, 60.0, 180.0, 250.0, 360.0}) {
    CAPTURE(angle);
    // Beyond the hemisphere the definition counts |cos|.
    const double t = angle * k_pi / 360;
    double sum = 0;
    constexpr int rings = 200000;
    for (int i = 0; i < rings; ++i) {
      const double c = 1 - (1 - std::cos(t)) * (i + 0.5) / rings;
      sum += std::abs(c) * 2 * k_pi * (1 - std::cos(t)) / rings;
    }
    UsdLuxEmission emission;
    emission.intensity = 50;
    emission.exposure = 1;
    CHECK(double(illuminance_from_usdlux_distant(emission, angle)->y) ==
          doctest::Approx(100 * sum).epsilon(1e-4));
    emission.normalize = true;
    CHECK(double(illuminance_from_usdlux_distant(emission, angle)->y) == doctest::Approx(100));
  }
  CHECK(*usdlux_distant_size_factor(0) == 1.0);
}

TEST_CASE("usdlux_emissions_come_back") {
  const Vec3f value(3, 40, 0.25f);
  for (const bool normalize : {false, true})
    for (const double exposure : {-3.0, 0.0, 8.5}) {
      const UsdLuxEmission area_light = *usdlux_from_luminance(value, exposure, normalize, 0.3);
      const UsdLuxEmission distant =
          *usdlux_distant_from_illuminance(value, exposure, normalize, 2.0);
      CHECK(area_light.exposure == exposure);
      CHECK(double(area_light.color.y) == doctest::Approx(1));
      for (const Vec3f back : {*luminance_from_usdlux(area_light, 0.3),
                               *illuminance_from_usdlux_distant(distant, 2.0)}) {
        CHECK(double(back.x) == doctest::Approx(3).epsilon(1e-6));
        CHECK(double(back.y) == doctest::Approx(40).epsilon(1e-6));
        CHECK(double(back.z) == doctest::Approx(0.25).epsilon(1e-6));
      }
    }
  const UsdLuxEmission black = *usdlux_from_luminance(Vec3f(0.0f), 0, false, 0);
  CHECK(black.intensity == 0);
  CHECK(luminance_from_usdlux(black, 0)->x == 0.0f);
}

TEST_CASE("blender_s_sphere_emits_its_watts_and_its_area_light_a_quarter_of_pi_of_them") {
  const double watts = 40;
  SphereLight sphere;
  sphere.radius = 0.2f;
  const double nits = *luminance_from_blender_sphere(watts, double(sphere.radius), 100);
  CHECK(summed_flux(patches_of(sphere), 0) * nits == doctest::Approx(watts * 100).epsilon(1e-3));
  CHECK(*blender_sphere_from_luminance(nits, double(sphere.radius), 100) == doctest::Approx(watts));

  // Seen from far away it is the point light that the exporter writes.
  const double standard =
      *gltf_intensity_from_blender(watts, PunctualType::point, GltfLightMode::standard);
  const double seen = summed_intensity(patches_of(sphere), 0, {0, 0, 1}) *
                      *luminance_from_blender_sphere(watts, double(sphere.radius));
  CHECK(seen == doctest::Approx(standard).epsilon(1e-3));

  EllipseLight disk;
  const double area_nits = *luminance_from_blender_area(watts, area(disk), 100);
  CHECK(summed_flux(patches_of(disk), 0) * area_nits ==
        doctest::Approx(watts * 100 * k_pi / 4).epsilon(1e-3));
  CHECK(*blender_area_from_luminance(area_nits, area(disk), 100) == doctest::Approx(watts));
}

TEST_CASE("the_exporter_s_modes_differ_by_efficacy_and_solid_angle") {
  const auto written = [](PunctualType type, GltfLightMode mode) {
    return *gltf_intensity_from_blender(10, type, mode);
  };
  CHECK(written(PunctualType::point, GltfLightMode::standard) ==
        doctest::Approx(6830 / (4 * k_pi)));
  CHECK(written(PunctualType::spot, GltfLightMode::unitless) == doctest::Approx(10 / (4 * k_pi)));
  CHECK(written(PunctualType::spot, GltfLightMode::raw) == 10);
  CHECK(written(PunctualType::directional, GltfLightMode::standard) == doctest::Approx(6830));
  CHECK(written(PunctualType::directional, GltfLightMode::unitless) == 10);
  CHECK(written(PunctualType::directional, GltfLightMode::raw) == 10);
  for (const auto type : {PunctualType::point, PunctualType::spot, PunctualType::directional})
    for (const auto mode : {GltfLightMode::standard, GltfLightMode::unitless, GltfLightMode::raw})
      CHECK(*blender_from_gltf_intensity(written(type, mode), type, mode) == doctest::Approx(10));
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
