// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a luminaire gives, against closed forms of cosine lobes.

#include "ies_samples.h"
#include "openltc/light/photometry/photometry_summary.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::light;
using openltc::testing::angles;
using openltc::testing::IesFile;

constexpr double k_pi = std::numbers::pi, k_degree = k_pi / 180;

PhotometricSummary summary_of(const IesFile& file,
                              const std::function<double(double, double)>& candela) {
  const Result<IesProfile> profile = parse_ies(file.text(candela), "lamp.ies");
  REQUIRE(profile.ok());
  return summarise(*profile);
}

TEST_CASE("a_cosine_lobe_has_its_flux_peak_and_angles") {
  IesFile file;
  file.vertical = angles(0, 90, 0.5);
  file.horizontal = {0};
  const PhotometricSummary s =
      summary_of(file, [](double v, double) { return 1000 * std::cos(v * k_degree); });
  CHECK(s.flux_lumens == doctest::Approx(1000 * k_pi).epsilon(1e-4));
  CHECK(s.downward_share == doctest::Approx(1));
  CHECK(s.peak_candela == doctest::Approx(1000));
  CHECK(s.peak.vertical == 0);
  CHECK(s.symmetry == PhotometricSymmetry::axis);
  for (int i = 0; i < 2; ++i) {
    CHECK(s.beam_degrees[i] == doctest::Approx(120).epsilon(1e-3));
    CHECK(s.field_degrees[i] == doctest::Approx(2 * std::acos(0.1) / k_degree).epsilon(1e-3));
  }
}

TEST_CASE("a_narrow_lobe_of_types_a_and_b_has_the_angles_of_its_planes") {
  // (cos V)^m (cos H)^n: in the plane H = 0 it is half where cos V = 2^(-1/m).
  for (const char* kind : {"2 2 0 0 0", "3 2 0 0 0"}) {
    CAPTURE(kind);
    IesFile file;
    file.kind = kind;
    file.vertical = file.horizontal = angles(-90, 90, 1);
    const PhotometricSummary s = summary_of(file, [](double v, double h) {
      return 500 * std::pow(std::cos(v * k_degree), 30) * std::pow(std::cos(h * k_degree), 8);
    });
    CHECK(s.peak_candela == doctest::Approx(500));
    CHECK(s.peak.vertical == doctest::Approx(0));
    CHECK(s.peak.horizontal == doctest::Approx(0));
    CHECK(s.beam_degrees[0] ==
          doctest::Approx(2 * std::acos(std::pow(0.5, 1.0 / 30)) / k_degree).epsilon(2e-3));
    CHECK(s.beam_degrees[1] ==
          doctest::Approx(2 * std::acos(std::pow(0.5, 1.0 / 8)) / k_degree).epsilon(2e-3));
    CHECK(s.symmetry == PhotometricSymmetry::both);
    CHECK(s.downward_share == doctest::Approx(1).epsilon(1e-3));
  }
  // Aimed up and to the right: the peak in both systems of angles.
  IesFile file;
  file.kind = "3 2 0 0 0";
  file.vertical = angles(-90, 90, 5);
  file.horizontal = angles(-90, 90, 5);
  const PhotometricSummary s =
      summary_of(file, [](double v, double h) { return v == 30 && h == 0 ? 100 : 1; });
  CHECK(s.peak.vertical == doctest::Approx(30));
  CHECK(s.peak_c.vertical == doctest::Approx(30)); // in the plane H = 0 V is gamma
  CHECK(s.peak_c.horizontal == doctest::Approx(0));
  CHECK(s.symmetry == PhotometricSymmetry::plane_c0);
}

TEST_CASE("symmetries_and_shares") {
  IesFile file;
  file.vertical = angles(0, 180, 10);
  file.horizontal = angles(0, 360, 15);
  const auto with = [](double (*around)(double)) {
    return [around](double v, double h) {
      return 100 + std::sin(v * k_degree) * around(h * k_degree);
    };
  };
  const PhotometricSummary even = summary_of(file, [](double, double) { return 100; });
  CHECK(even.flux_lumens == doctest::Approx(400 * k_pi));
  CHECK(even.downward_share == doctest::Approx(0.5));
  CHECK(even.beam_degrees[0] == 360);
  CHECK(even.symmetry == PhotometricSymmetry::axis);
  const auto symmetry = [&](double (*around)(double)) {
    return summary_of(file, with(around)).symmetry;
  };
  CHECK(symmetry([](double h) { return 50 * std::cos(h); }) == PhotometricSymmetry::plane_c0);
  CHECK(symmetry([](double h) { return 50 * std::sin(h); }) == PhotometricSymmetry::plane_c90);
  CHECK(symmetry([](double h) { return 50 * std::cos(2 * h); }) == PhotometricSymmetry::both);
  CHECK(symmetry([](double h) { return 50 * std::sin(2 * h); }) == PhotometricSymmetry::none);
  // All light upwards.
  file.vertical = angles(90, 180, 10);
  const PhotometricSummary up =
      summary_of(file, [](double v, double) { return -100 * std::cos(v * k_degree); });
  CHECK(up.downward_share == doctest::Approx(0).epsilon(1e-3));
  CHECK(up.peak.vertical == 180);
  CHECK(up.beam_degrees[1] == doctest::Approx(120).epsilon(1e-2));
}

} // namespace
