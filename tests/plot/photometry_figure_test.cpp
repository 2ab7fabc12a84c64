// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The polar diagram: its circles hold the peak, and it is whole where there is light above.

#include "openltc/light/photometry/photometry.h"
#include "openltc/plot/figures/photometry_figure.h"

#include <doctest/doctest.h>

namespace {

using namespace openltc;

plot::PhotometryOptions lamp(const std::string& vertical, const std::string& candela) {
  const auto profile = light::parse_ies(
      "TILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 0\n" + vertical + "\n0\n" + candela, "lamp.ies");
  REQUIRE(profile.ok());
  plot::PhotometryOptions options;
  options.profile = *profile;
  options.command = "openltc plot photometry lamp.ies";
  return options;
}

TEST_CASE("rings_hold_the_peak_and_are_few") {
  for (const double peak : {1e-3, 0.7, 1.0, 99.0, 100.0, 101.0, 1098.0, 54321.0, 1e9}) {
    const std::vector<double> rings = plot::rings_of(peak);
    REQUIRE(!rings.empty());
    CHECK(rings.back() >= peak * (1 - 1e-9));
    CHECK(rings.size() <= 12);
    // No more than one circle is empty.
    CHECK(rings.back() - rings.front() < peak * (1 + 1e-9));
  }
}

TEST_CASE("a_diagram_is_whole_where_light_goes_up") {
  const auto down = plot::make_photometry_figure(lamp("0 45 90", "100 50 0"));
  const auto both = plot::make_photometry_figure(lamp("0 90 180", "100 0 80"));
  REQUIRE(down.ok());
  REQUIRE(both.ok());
  CHECK(both->height > down->height + 150);
  CHECK(down->width == both->width);
  for (const draw::Figure* figure : {&*down, &*both}) {
    CHECK(figure->body.find("nan") == std::string::npos);
    CHECK(figure->caption.find("openltc plot photometry lamp.ies") != std::string::npos);
  }
  CHECK(both->body.find("180°") != std::string::npos);
  CHECK(down->body.find("180°") == std::string::npos);
  plot::PhotometryOptions relative = lamp("0 45 90", "100 50 0");
  relative.per_kilolumen = true;
  const auto share = plot::make_photometry_figure(relative);
  REQUIRE(share.ok());
  CHECK(share->body.find("cd/klm") != std::string::npos);
}

} // namespace
