// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The numbers of the figure of literal formulas: those that the documentation states, and bounds
// that hold for the corrected formulas alone.

#include "openltc/plot/figures/literal_figure.h"
#include "openltc/plot/literal_formulas.h"
#include "openltc/table/lobe_table.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

using namespace openltc;
using doctest::Approx;
using plot::Slip;

namespace {

double cos_degrees(double degrees) { return std::cos(degrees * f64::k_pi / 180); }

f64::FittedLobe fitted(double roughness, double degrees) {
  return f64::fetch_lobe(table::builtin_ggx_table().view(), roughness * roughness,
                         cos_degrees(degrees));
}

// The example of docs/method.md: GGX of roughness 0.5 at 64 degrees.
const f64::Lobe k_lobe =
    f64::lobe_from_mirror(Vec4d(0.5353, -0.3892, 1.0576, 0.8763), 0.25, 7.0 / 16);

} // namespace

TEST_CASE("literal: a white surface under a white sky reflects 14.7 times what comes in") {
  const Slip at_85 = plot::white_furnace(0.1, cos_degrees(85));
  CHECK(at_85.correct == Approx(0.886).epsilon(0.002));
  CHECK(at_85.literal == Approx(14.7).epsilon(0.01));
  for (const double degrees : {0.0, 30.0, 60.0, 80.0, 89.0}) {
    CAPTURE(degrees);
    const Slip furnace = plot::white_furnace(0.1, cos_degrees(degrees));
    CHECK(furnace.correct <= 1);
    CHECK(furnace.correct == Approx(fitted(std::sqrt(0.1), degrees).n1).epsilon(0.01));
  }
  CHECK(plot::white_furnace(0.1, cos_degrees(0)).literal < 0.5); // too dark when seen from above
}

TEST_CASE("literal: Fresnel's curve stands on its head, and is taken twice") {
  const Slip at_60 = plot::fresnel_reflectance(0.04, 0.5);
  CHECK(at_60.correct == Approx(0.070));
  CHECK(at_60.literal == Approx(0.970));
  CHECK(plot::fresnel_reflectance(0.04, 1).literal == Approx(0.04)); // they meet at both ends
  CHECK(plot::fresnel_reflectance(0.04, 0).literal == Approx(1));
  const Slip twice = plot::fresnel_twice(0.04, 1);
  CHECK(twice.correct / twice.literal == Approx(25));
}

TEST_CASE("literal: the lobe is a density with the determinant, not with the norm") {
  const Slip example = plot::lobe_integral(k_lobe);
  CHECK(example.correct == Approx(1).epsilon(1e-3));
  CHECK(example.literal == Approx(8.3).epsilon(0.01));
  for (const double roughness : {0.1, 0.2, 0.5, 1.0})
    for (const double degrees : {0.0, 30.0, 60.0}) {
      CAPTURE(roughness);
      CAPTURE(degrees);
      const f64::Lobe lobe = fitted(roughness, degrees).lobe;
      const Slip slip = plot::lobe_integral(lobe);
      CHECK(slip.correct == Approx(1).epsilon(1e-3));
      CHECK(slip.literal > 1.5);
      // The norm is constant: it is a factor before the density.
      CHECK(slip.literal == Approx(std::sqrt(f64::lobe_stretch2(lobe)) / lobe.det).epsilon(1e-3));
    }
  const double middle = plot::lobe_integral(fitted(0.5, 60).lobe).literal;
  CHECK(middle > 3);
  CHECK(middle < 20);
}

TEST_CASE("literal: I_specular integrates to pi with the determinant, to more with the length") {
  const plot::PointLightIntegrals example = plot::point_light_integrals(k_lobe);
  CHECK(example.by_determinant == Approx(f64::k_pi).epsilon(1e-3));
  CHECK(example.by_length == Approx(8.6).epsilon(0.01));
  const plot::PointLightIntegrals table = plot::point_light_integrals(fitted(0.5, 60).lobe);
  CHECK(table.by_determinant == Approx(f64::k_pi).epsilon(1e-3));
  CHECK(table.by_length > 3);
}

TEST_CASE("literal: without its amplitude the lobe of glass is 10 times too bright, and more") {
  for (const double roughness : {0.1, 0.5, 1.0}) {
    CAPTURE(roughness);
    const Slip white = plot::lobe_amplitude(fitted(roughness, 60), 1);
    const Slip glass = plot::lobe_amplitude(fitted(roughness, 60), 0.04);
    CHECK(white.correct < 1);
    CHECK(white.literal == Approx(1).epsilon(2e-3));
    CHECK(glass.literal > 10 * glass.correct);
  }
}

TEST_CASE("literal: the figure draws every curve in one piece, with the numbers of the formulas") {
  const draw::Figure figure = plot::make_literal_figure();
  std::size_t paths = 0;
  for (std::size_t at = 0; (at = figure.body.find("<path", at)) != std::string::npos; ++at)
    ++paths;
  CHECK(paths == 14); // a value that is not finite would cut a curve in two
  const double middle = plot::lobe_integral(fitted(0.5, 60).lobe).literal;
  for (const double number : {middle, plot::white_furnace(0.1, cos_degrees(85)).literal}) {
    CAPTURE(number);
    CHECK(figure.body.find(fmt::format(">{:.1f}</text>", number)) != std::string::npos);
  }
  CHECK(figure.caption.find("openltc plot literal") != std::string::npos);
}
