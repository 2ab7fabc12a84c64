// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights on which GGX hardly turns, by a few points of them: against many, in double precision.

#include "openltc/table/lobe_table.h"
#include "tests/shade/exact/lit_quads.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace openltc;
using testing::Errors;
using testing::midpoints;
using testing::Quad;
using testing::Random;

namespace {

/// White metal with two lobes and their ratio.
f64::Surface metal(double theta, double roughness) {
  const auto table = table::builtin_ggx_two_lobe_table().view();
  const double cosine = std::cos(theta);
  const f64::Surface s = f64::make_surface(
      f64::fetch_lobe_of_roughness(table, roughness, cosine), Vec3d(0.0), Vec3d(0, 0, 1),
      Vec3d(std::sin(theta), 0, cosine), Vec3d(0.0), Vec3d(1.0), Vec3d(1.0), roughness);
  return f64::correct_at_mean(
      f64::add_second_lobe(s, f64::fetch_second_lobe_of_roughness(table, roughness, cosine)));
}

/// At a distance of 1, half of them around a direction that the metal reflects to.
Quad quad_somewhere(const f64::Surface& s, Random& random) {
  const Vec3d any = random.hemisphere();
  const Vec3d mirrored =
      f64::sample_ggx(s.wo, s.alpha, {random.uniform(0, 1), random.uniform(0, 1)});
  const Vec3d wi = random.uniform(0, 1) < 0.5 ? any : mirrored;
  const f64::Frame frame =
      f64::shading_frame(normalize(random.sphere() * 0.7 - wi), Vec3d(0, 0.3, 1));
  const double size = std::pow(10, random.uniform(-2, 0)), aspect = random.uniform(0.5, 2);
  return {wi, frame.t1 * (size * aspect), frame.t2 * (size / aspect)};
}

/// By those forms of `s` alone, for white metal.
double shade(const f64::Surface& s, const PolygonView& polygon) {
  return f64::shade_polygon(s, polygon).x;
}

} // namespace

TEST_CASE("few points: quads that are nothing else, against many points of them") {
  Random random(71);
  Errors nine, ratio_of_nine, four, ratio_of_four;
  double relative = 0, relative_ratio = 0; // of four points
  for (int i = 0; i < 40000; ++i) {
    const f64::Surface lobes =
        metal(random.uniform(0, 88.0 / 180 * std::numbers::pi), random.uniform(0.1, 1));
    const Quad quad = quad_somewhere(lobes, random);
    if (quad.center.z <= 0) continue;
    const testing::TestPolygon polygon = quad.polygon();
    const f64::Surface exact = f64::make_exact(lobes), adaptive = f64::make_adaptive(lobes);
    const bool is_nine = f64::ways_of_polygon(exact, polygon.view()).points >= 1;
    const bool is_four = f64::ways_of_polygon(adaptive, polygon.view()).points >= 1;
    if (!is_nine && !is_four) continue;
    const double truth = midpoints(lobes, quad, 60);
    if (truth > 0.5 * lobes.fitted.n1) continue; // limited by the albedo
    if (is_nine) {
      nine.add(shade(exact, polygon.view()), truth);
      ratio_of_nine.add(shade(lobes, polygon.view()), truth);
    }
    if (is_four) {
      four.add(shade(adaptive, polygon.view()), truth);
      relative += std::abs(shade(adaptive, polygon.view()) / truth - 1);
      relative_ratio += std::abs(shade(lobes, polygon.view()) / truth - 1);
      ratio_of_four.add(shade(lobes, polygon.view()), truth);
    }
  }
  MESSAGE(nine.count, " by nine points: of the light ", nine.of_light(),
          ", by two lobes with the ratio ", ratio_of_nine.of_light(), "; ", four.count,
          " by four points: ", four.of_light(), ", by lobes ", ratio_of_four.of_light(),
          ", mean relative error ", relative / four.count, ", by lobes ",
          relative_ratio / four.count);
  CHECK(nine.count > 1000);
  CHECK(four.count > 1000);
  CHECK(nine.of_light() < 5e-5);
  CHECK(four.of_light() < 4e-3);
  CHECK(nine.of_light() < 0.1 * ratio_of_nine.of_light());
  CHECK(relative < 0.5 * relative_ratio);
}

TEST_CASE("few points: one that rounding puts below the horizon has no light, and takes none") {
  const f64::Surface s = metal(1.4, 0.3);
  const Vec3d above(0.3, 0.2, 0.5), below(-0.9, 0.1, -1e-3);
  const f64::FewPoints one = f64::add_point(s, 0.3, f64::no_points(), above, 1.0);
  const f64::FewPoints both = f64::add_point(s, 0.3, one, below, 1.0);
  CHECK(one.scale > 0);
  CHECK(both.scale == one.scale);
  CHECK(both.bias == one.bias);
  CHECK(both.cosine == one.cosine);
}
