// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The white furnace: what a surface returns of uniform light from all sides, its albedo.

#include "directions.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/quadrature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace openltc;

namespace {

struct Albedo {
  double least = 1e9, largest = 0, largest_at_roughness = 0, largest_at_degrees = 0;
};

Albedo albedo_range(const brdf::Brdf& b, double roughness_from = 0, double max_degrees = 90) {
  Albedo range;
  for (const double roughness : test::roughnesses()) {
    if (roughness < roughness_from) continue;
    for (const double degrees : test::view_angles()) {
      if (degrees > max_degrees) continue;
      const double n1 =
          fit::make_quadrature(b, roughness, std::cos(test::radians(degrees)), {100, 100})->n1;
      range.least = std::min(range.least, n1);
      if (n1 > range.largest) range = {range.least, n1, roughness, degrees};
    }
  }
  return range;
}

const brdf::Brdf& entry(const char* name) { return *brdf::find_brdf(name); }

} // namespace

TEST_CASE("models that conserve energy do") {
  for (const char* name : {"ggx", "ggx-separable", "beckmann", "blinn", "phong"}) {
    const Albedo a = albedo_range(entry(name));
    MESSAGE(std::string(name), ": albedo ", a.least, " .. ", a.largest);
    CHECK(a.largest < 1 + 1e-3);
  }
}

TEST_CASE("models that return all light do") {
  for (const char* name : {"ggx-ms", "eon"}) {
    const Albedo a = albedo_range(entry(name));
    MESSAGE(std::string(name), ": albedo ", a.least, " .. ", a.largest);
    CHECK(a.largest < 1 + 1e-3);
    CHECK(a.least > 1 - 1e-3);
  }
}

// Known of the models, not of this code: they are fits to measurements or simulations.
TEST_CASE("models known to return more than they receive, and by how much") {
  struct Known {
    const char* name;
    double from, to; // of the largest albedo
  };
  for (const Known& known :
       {Known{"burley", 1.55, 1.57}, {"oren-nayar", 1.04, 1.06}, {"charlie", 1.5, 1.6}}) {
    const Albedo a = albedo_range(entry(known.name));
    MESSAGE(std::string(known.name), ": albedo ", a.least, " .. ", a.largest, " at roughness ",
            a.largest_at_roughness, ", ", a.largest_at_degrees, " degrees");
    CHECK(a.largest > known.from);
    CHECK(a.largest < known.to);
  }
  // Away from grazing views they do not, or hardly.
  CHECK(albedo_range(entry("burley"), 0, 60).largest < 1.06);
  CHECK(albedo_range(entry("oren-nayar"), 0, 60).largest < 1.002);
  CHECK(albedo_range(entry("charlie"), 0, 75).largest < 1);
  CHECK(albedo_range(entry("charlie"), 0.5).largest < 1);
}
