// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The clipped sphere's form factor against brute-force quadrature and the published table.

#include "openltc/table/clipped_sphere.h"
#include "openltc/table/container/container.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

using namespace openltc;
using table::clipped_sphere_form_factor;

namespace {

// (1/pi) integral of max(0, cos) over the cap / sin^2 sigma, by rings about the cap's centre.
double by_quadrature(double z, double form_factor) {
  const double sigma = std::asin(std::sqrt(form_factor)), sin_w = std::sqrt(1 - z * z);
  const int rings = 1000, points = 2000;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double t = sigma * (i + 0.5) / rings;
    double ring = 0;
    for (int j = 0; j < points; ++j) {
      const double p = 2 * std::numbers::pi * (j + 0.5) / points;
      ring += std::max(0.0, std::cos(t) * z - std::sin(t) * sin_w * std::cos(p));
    }
    sum += ring * std::sin(t);
  }
  return sum * (sigma / rings) * (2 / double(points)) / form_factor;
}

} // namespace

TEST_CASE("the closed form is the integral") {
  for (const double form_factor : {0.001, 0.1, 0.35, 0.72, 0.95, 1.0})
    for (const double z : {-0.99, -0.8, -0.4, -0.05, 0.0, 0.03, 0.3, 0.66, 0.9, 1.0}) {
      CAPTURE(form_factor);
      CAPTURE(z);
      CHECK(clipped_sphere_form_factor(z, form_factor) ==
            doctest::Approx(by_quadrature(z, form_factor)).epsilon(1e-4).scale(0.05));
    }
}

TEST_CASE("the limits: a small sphere, a hemisphere, the whole above or below the horizon") {
  for (const double z : {-1.0, -0.6, 0.0, 0.2, 1.0}) {
    CHECK(clipped_sphere_form_factor(z, 0.0) == std::max(z, 0.0));
    CHECK(clipped_sphere_form_factor(z, 1e-9) == doctest::Approx(std::max(z, 0.0)).epsilon(1e-4));
    CHECK(clipped_sphere_form_factor(z, 1.0) == doctest::Approx(0.5 * (1 + z)));
  }
  CHECK(clipped_sphere_form_factor(0.9, 0.5) == 0.9);
  CHECK(clipped_sphere_form_factor(-0.9, 0.5) == 0.0);
}

TEST_CASE("the published table's fourth channel is this function, to half precision") {
  std::ifstream file(OPENLTC_SHARED_DIR "/tables/ltc_code_2.dds", std::ios::binary);
  if (!file) {
    MESSAGE("skipped: the published table is not there, see tests/CMakeLists.txt");
    return;
  }
  const table::Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Result<table::Texture> read = table::decode_dds(bytes, "ltc_code_2.dds");
  REQUIRE(read);
  double worst = 0;
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) {
      const double value = clipped_sphere_form_factor(2.0 * i / 63 - 1, j / 63.0);
      const float published = read->values[std::size_t((j * 64 + i) * 4 + 3)];
      worst = std::max(worst, std::abs(value - double(published)));
    }
  MESSAGE("largest difference: ", worst);
  CHECK(worst < 0x1p-12); // half a step of a half just below 1
}
