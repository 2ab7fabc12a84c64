// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Materials by the words of glTF 2.0, Appendix B, KHR_materials_ior and KHR_materials_specular.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace openltc;

namespace {

void check_equal(Vec3f v, double x, double y, double z) {
  CHECK(v.x == doctest::Approx(x).epsilon(1e-6));
  CHECK(v.y == doctest::Approx(y).epsilon(1e-6));
  CHECK(v.z == doctest::Approx(z).epsilon(1e-6));
}

} // namespace

TEST_CASE("dielectrics_reflect_0.04_and_metals_their_colour") {
  Material m;
  m.base_color = {0.8f, 0.4f, 0.2f};
  Reflectance r = reflectance_of(m);
  check_equal(r.f0, 0.04, 0.04, 0.04); // the specification's value for index 1.5
  CHECK(r.f90 == 1);
  check_equal(r.albedo, 0.8, 0.4, 0.2);

  m.metallic = 1;
  r = reflectance_of(m);
  check_equal(r.f0, 0.8, 0.4, 0.2);
  CHECK(r.f90 == 1);
  check_equal(r.albedo, 0, 0, 0);

  m.metallic = 0.25f; // a mix: lerp(dielectric, metal, metallic)
  r = reflectance_of(m);
  check_equal(r.f0, 0.75 * 0.04 + 0.25 * 0.8, 0.75 * 0.04 + 0.25 * 0.4, 0.75 * 0.04 + 0.25 * 0.2);
  check_equal(r.albedo, 0.75 * 0.8, 0.75 * 0.4, 0.75 * 0.2);
}

TEST_CASE("index_of_refraction_and_specular_colour_are_those_of_the_extensions") {
  Material m;
  m.ior = 1.33f; // water: 2.0 %
  CHECK(reflectance_of(m).f0.x == doctest::Approx(0.02006).epsilon(1e-3));
  m.ior = 2.42f; // diamond: 17.2 %
  CHECK(reflectance_of(m).f0.x == doctest::Approx(0.1724).epsilon(1e-3));
  m.ior = 1;
  CHECK(reflectance_of(m).f0.x == 0);
  m.ior = 0; // KHR_materials_ior: as an infinite index
  CHECK(reflectance_of(m).f0.x == 1);
  CHECK(dielectric_f0(std::numeric_limits<float>::infinity()) == 1);

  m.ior = 1.5f;
  m.specular = 0.5f;
  m.specular_color = {1, 0.5f, 100};
  const Reflectance r = reflectance_of(m);
  check_equal(r.f0, 0.02, 0.01, 0.5); // min(0.04 colour, 1) specular
  CHECK(r.f90 == doctest::Approx(0.5));
}

TEST_CASE("material_values_outside_of_their_range_are_clamped") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Material m;
  m.base_color = {2, -1, nan};
  m.metallic = -3;
  m.roughness = 7;
  Reflectance r = reflectance_of(m);
  check_equal(r.albedo, 1, 0, 0);
  CHECK(r.roughness == 1);
  m.metallic = m.roughness = m.specular = m.ior = nan;
  m.specular_color = {nan, 0, 0};
  r = reflectance_of(m);
  for (const float value : {r.f0.x, r.f0.y, r.f0.z, r.f90, r.albedo.z, r.roughness}) {
    CHECK(value >= 0);
    CHECK(value <= 1);
  }
}
