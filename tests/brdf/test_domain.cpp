// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What every entry promises on its whole domain, and the symmetries of its function.

#include "directions.h"
#include "openltc/brdf/brdf.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

using namespace openltc;
using test::direction;

namespace {

// Pairs of directions in general position, away from the horizon.
struct Pair {
  Vec3d wo, wi;
  double roughness;
};

std::vector<Pair> random_pairs(int n) {
  std::mt19937 bits(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Pair> pairs;
  for (int i = 0; i < n; ++i) {
    const Vec3d wo = direction(1.5 * uniform(bits), 6.28 * uniform(bits));
    const Vec3d wi = direction(1.5 * uniform(bits), 6.28 * uniform(bits));
    pairs.push_back({wo, wi, 0.1 + 0.9 * uniform(bits)});
  }
  return pairs;
}

Vec3d turned(Vec3d w, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return Vec3d(c * w.x - s * w.y, s * w.x + c * w.y, w.z);
}

// Largest relative difference between eval at each pair and what `other` makes of it.
template <class Other> double worst_difference(const brdf::Brdf& b, Other other) {
  double worst = 0;
  for (const Pair& p : random_pairs(2000)) {
    const double here = b.eval(p.wo, p.wi, p.roughness).scale, there = other(p);
    worst = std::max(worst, std::abs(here - there) / std::max(here + there, 1e-12));
  }
  return worst;
}

} // namespace

TEST_CASE("names are unique and every string is filled in") {
  std::set<std::string> names;
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    CHECK(names.insert(b.name).second);
    CHECK(brdf::find_brdf(b.name) == &b);
    CHECK_FALSE(b.name.empty());
    CHECK_FALSE(b.variant.empty());
    CHECK_FALSE(b.source.empty());
    CHECK(b.has_parameter());
    for (const std::string& text : {b.name, b.variant, b.source, b.parameter})
      CHECK(text.find('\n') == std::string::npos);
  }
  for (const char* name : {"ggx", "ggx-separable", "ggx-ms", "beckmann", "blinn", "phong", "burley",
                           "oren-nayar", "eon", "charlie"})
    CHECK_MESSAGE(names.count(name) == 1, name);
}

TEST_CASE("finite and not negative everywhere above the horizon") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    bool finite = true, positive = true, ordered = true;
    const auto check = [&](Vec3d wo, Vec3d wi, double roughness) {
      if (!(wo.z > 0 && wi.z > 0)) return;
      const brdf::BrdfValue v = b.eval(wo, wi, roughness);
      finite = finite && std::isfinite(v.scale) && std::isfinite(v.bias);
      positive = positive && v.scale >= 0;
      ordered = ordered && v.bias >= 0 && v.bias <= v.scale;
    };
    for (const double roughness : test::roughnesses()) {
      std::vector<double> angles = test::view_angles();
      angles.insert(angles.end(), {1e-8, 1e-3, 89.999, 89.999999});
      for (const double degrees : angles) {
        const Vec3d wo = direction(test::radians(degrees), 0);
        check(wo, wo, roughness);
        check(wo, test::mirrored(wo), roughness);
        for (const double nearby : {1e-9, 1e-6, 1e-4, 1e-2}) {
          check(wo, normalize(test::mirrored(wo) + Vec3d(nearby, 0, 0)), roughness);
          check(wo, normalize(test::mirrored(wo) + Vec3d(0, nearby, 0)), roughness);
          check(wo, normalize(wo + Vec3d(0, nearby, 0)), roughness);
        }
        for (const double other : angles)
          for (const double phi : {0.0, 1e-7, 30.0, 90.0, 120.0, 179.0, 180.0})
            check(wo, direction(test::radians(other), test::radians(phi)), roughness);
      }
    }
    CHECK(finite);
    CHECK(positive);
    CHECK(ordered);
  }
}

TEST_CASE("isotropic: turning both directions about the normal changes nothing") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    CHECK(worst_difference(b, [&](const Pair& p) {
            return b.eval(turned(p.wo, 1.1), turned(p.wi, 1.1), p.roughness).scale;
          }) < 1e-9);
  }
}

TEST_CASE("symmetric about the plane of incidence") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    CHECK(worst_difference(b, [&](const Pair& p) {
            return b
                .eval(Vec3d(p.wo.x, -p.wo.y, p.wo.z), Vec3d(p.wi.x, -p.wi.y, p.wi.z), p.roughness)
                .scale;
          }) < 1e-9);
  }
}

TEST_CASE("reciprocal, all but ggx-ms") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    CAPTURE(b.name);
    const double worst = worst_difference(
        b, [&](const Pair& p) { return b.eval(p.wi, p.wo, p.roughness).scale / p.wo.z * p.wi.z; });
    if (b.name == "ggx-ms")
      CHECK(worst > 0.01); // divided by the albedo of one direction only
    else
      CHECK(worst < 1e-9);
  }
}
