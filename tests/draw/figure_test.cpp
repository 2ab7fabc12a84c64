// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Figures as files: both themes, escaped text, the same bytes, pictures that are not blank.

#include "openltc/draw/axes.h"
#include "openltc/draw/figure_file.h"
#include "openltc/image/file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

using namespace openltc;
using draw::Axis;
using draw::Curve;
using draw::Figure;
using draw::Panel;
using draw::Theme;

namespace {

Figure small_figure() {
  Figure figure;
  figure.title = "One < two & three";
  figure.caption = "A curve. openltc plot nothing";
  figure.width = 300;
  figure.height = 220;
  Panel panel;
  panel.corner = Vec2d(50, 20);
  panel.size = Vec2d(230, 150);
  panel.x = Axis{"angle (degrees)", 0, 90, false, {}};
  panel.y = Axis{"density (1/sr)", 0.01, 100, true, {}};
  draw_axes(figure, panel);
  Curve curve{"a", {}, 1};
  for (int i = 0; i <= 90; ++i)
    curve.points.push_back(Vec2d(i, i == 45 ? std::nan("") : 0.05 * (i + 1)));
  draw_curves(figure, panel, std::span(&curve, 1));
  draw_legend(figure, Vec2d(60, 40), std::span(&curve, 1));
  return figure;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++n;
  return n;
}

// Share of pixels that differ from the first.
double drawn(const image::Image& picture) {
  double n = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      n += length(picture.rgb(x, y) - picture.rgb(0, 0)) > 0.1f ? 1 : 0;
  return n / double(picture.pixel_count());
}

} // namespace

TEST_CASE("a figure's text is text, escaped; its colours follow the reader's page") {
  const std::string svg = to_svg(small_figure(), Theme::automatic);
  CHECK(svg.find("One &lt; two &amp; three") != std::string::npos);
  CHECK(svg.find("One < two") == std::string::npos);
  CHECK(svg.find("prefers-color-scheme:dark") != std::string::npos);
  CHECK(svg.find(">angle (degrees)</text>") != std::string::npos);
  CHECK(svg == to_svg(small_figure(), Theme::automatic));
  CHECK(to_svg(small_figure(), Theme::dark).find("prefers") == std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  // The gap at 45 degrees leaves two pieces.
  CHECK(count(svg, "<path") == 2);
}

TEST_CASE("ticks are round, within the axis, and labelled") {
  for (const auto& [from, to] : {std::pair{0.0, 1.0}, {0.0, 90.0}, {-0.3, 0.3}, {3.0, 3.004}}) {
    const std::vector<draw::Tick> ticks = ticks_of(Axis{"", from, to, false, {}});
    CHECK(ticks.size() >= 3);
    CHECK(ticks.size() <= 9);
    for (const draw::Tick& tick : ticks) {
      CHECK(tick.value >= from - 1e-9);
      CHECK(tick.value <= to + 1e-9);
    }
  }
  const std::vector<draw::Tick> powers = ticks_of(Axis{"", 1e-6, 1, true, {}});
  CHECK(powers.front().label == "10⁻⁶");
  CHECK(share_along(Axis{"", 0.01, 100, true, {}}, 1) == doctest::Approx(0.5));
}

TEST_CASE("figures are written as SVG and as PNG, light and dark; nothing else") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "openltc_test_figure";
  fs::create_directories(folder);
  const std::string svg = (folder / "a.svg").string(), png = (folder / "a.png").string();
  CHECK(write_figure(svg, small_figure(), Theme::automatic).ok());
  CHECK(fs::file_size(svg) > 1000);
  const Status other = write_figure((folder / "a.jpg").string(), small_figure(), Theme::light);
  REQUIRE_FALSE(other.ok());
  CHECK(other.error().message.find(".svg or .png") != std::string::npos);
  const Status written = write_figure(png, small_figure(), Theme::light, 1.5);
  if (!draw::check_extension(png).ok()) {
    CHECK_FALSE(written.ok()); // a build without librsvg says so
  } else {
    REQUIRE(written.ok());
    const Result<image::Image> light = image::read(png);
    REQUIRE(write_figure(png, small_figure(), Theme::dark, 1.5).ok());
    const Result<image::Image> dark = image::read(png);
    REQUIRE(light.ok());
    REQUIRE(dark.ok());
    CHECK(light->width == 504); // (300 + 2 * 18) * 1.5
    for (const auto* picture : {&*light, &*dark}) {
      CHECK(drawn(*picture) > 0.005);
      CHECK(drawn(*picture) < 0.5);
    }
    CHECK(light->rgb(0, 0).x > 0.9f);
    CHECK(dark->rgb(0, 0).x < 0.1f);
  }
  fs::remove_all(folder);
}
