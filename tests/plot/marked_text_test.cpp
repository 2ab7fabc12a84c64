// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/figure.h"
#include "openltc/draw/marked_text.h"
#include "openltc/plot/figures/polygon_figure.h"

#include <doctest/doctest.h>

#include <string>

using namespace openltc;
using namespace openltc::draw;
using namespace openltc::plot;

TEST_CASE("text is slanted, lowered and escaped as it is marked") {
  CHECK(marked_text("a < b & c", 10) == "a &lt; b &amp; c");
  CHECK(marked_text("*D* x", 10) == "<tspan font-style=\"italic\">D</tspan> x");
  CHECK(marked_text("D_{o}", 10) == "D<tspan dy=\"2.5\" font-size=\"7.2\">o</tspan>");
  // After a lowered part the base line comes back, with a sign of several bytes too.
  CHECK(marked_text("D_{o}ω!", 10) ==
        "D<tspan dy=\"2.5\" font-size=\"7.2\">o</tspan><tspan dy=\"-2.5\">ω</tspan>!");
  CHECK(marked_text("D_{o}*x*y", 10) ==
        "D<tspan dy=\"2.5\" font-size=\"7.2\">o</tspan><tspan font-style=\"italic\"><tspan "
        "dy=\"-2.5\">x</tspan></tspan>y");
  CHECK(marked_text("D_{o", 10) == "D_{o");
  // Without being marked, text is what it is.
  Figure figure;
  draw_text(figure, {1, 2}, "2*3*4 _{x}");
  CHECK(figure.body.find("2*3*4 _{x}</text>") != std::string::npos);
}

TEST_CASE("corners are read as they are written, and nothing else is") {
  const auto corners = parse_points(" 1,2,3  -1e-1,.5,0\t0,0,-7 ");
  REQUIRE(corners.ok());
  REQUIRE(corners->size() == 3);
  CHECK((*corners)[1].x == -0.1);
  CHECK((*corners)[1].y == 0.5);
  CHECK((*corners)[2].z == -7);
  for (const char* text : {"1,2", "1,2,3,4", "1,2,x", "1;2;3", "1,,3", "1,2,3 4", ","}) {
    CAPTURE(text);
    const auto refused = parse_points(text);
    REQUIRE(!refused.ok());
    CHECK(refused.error().message.rfind("--points: '", 0) == 0);
  }
}
