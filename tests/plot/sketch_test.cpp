// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/polygon_figure.h"
#include "openltc/plot/sketch.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace openltc;
using namespace openltc::plot;

namespace {

std::string drawn(const char* text) {
  Sketch sketch{100, 50, ""};
  draw_text(sketch, 1, 2, text, {10});
  return sketch.body;
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("text is slanted, lowered and escaped as it is marked") {
  CHECK(contains(drawn("a < b & c > d"), "a &lt; b &amp; c &gt; d</text>"));
  CHECK(contains(drawn("*D* x"), "<tspan font-style=\"italic\">D</tspan> x</text>"));
  // After a lowered part the base line comes back, before a sign of several bytes too.
  CHECK(contains(drawn("D_{o}ω!"), ">o</tspan><tspan dy=\"-2.5\">ω</tspan>!</text>"));
  CHECK(contains(drawn("D_{o}"), "<tspan dy=\"2.5\" font-size=\"7.2\">o</tspan></text>"));
}

TEST_CASE("every theme defines every ink, and only automatic asks the reader") {
  Sketch sketch{100, 50, ""};
  draw_path(sketch, std::array{Vec2d(1, 2), Vec2d(3, 4)}, {Ink::orange, 2, "5 3", 0.5});
  CHECK(contains(sketch.body, "class=\"s-orange\""));
  for (const Theme theme : {Theme::automatic, Theme::light, Theme::dark}) {
    const std::string svg = to_svg(sketch, theme);
    CHECK(contains(svg, ".s-orange{stroke:"));
    CHECK(contains(svg, "prefers-color-scheme") == (theme == Theme::automatic));
    CHECK(contains(svg, "<rect class=\"f-paper\"") == (theme != Theme::automatic));
    CHECK(contains(svg, sketch.body.c_str()));
  }
  CHECK(to_svg(sketch, Theme::light) != to_svg(sketch, Theme::dark));
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
