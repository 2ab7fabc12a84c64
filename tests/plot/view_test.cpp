// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/direction_mesh.h"
#include "openltc/plot/solid_picture.h"
#include "openltc/plot/view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace openltc;
using namespace openltc::plot;

namespace {

// The middle of what is opaque in a picture, in window coordinates as project() gives them.
Vec2d opaque_center(const image::Image& picture) {
  double sum_x = 0, sum_y = 0, sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double alpha = double(picture.pixel(x, y)[3]);
      sum_x += alpha * (x + 0.5), sum_y += alpha * (y + 0.5), sum += alpha;
    }
  return {2 * sum_x / (sum * picture.width) - 1, 1 - 2 * sum_y / (sum * picture.height)};
}

// White.
scene::Mesh ball_mesh(Vec3d center, double radius) {
  scene::Mesh mesh = sphere_mesh(f64::cosine_lobe(), [&](Vec3d) { return Vec3f(1.0f); }, {32, 48});
  for (Vec3f& p : mesh.positions)
    p = p * float(radius) + to_float(center);
  return mesh;
}

} // namespace

TEST_CASE("the renderer shows a small ball where the projection says") {
  View view = view_from(-120, 38, 1.5, 1.0);
  view.center = {0.1, -0.2, 0.3};
  for (const Vec3d place : {Vec3d(0, 0, 0), Vec3d(0.5, 0.2, 0.4), Vec3d(-0.7, 0.6, -0.1)}) {
    const Solid ball{ball_mesh(place, 0.02), Finish::plain};
    const auto picture = render_solids({&ball, 1}, view, {300, 32, 0});
    REQUIRE(picture.ok());
    CHECK(picture->width == 300);
    CHECK(picture->height == 200);
    const Vec2d seen = opaque_center(*picture);
    const Vec3d said = project(view, place);
    // A pixel is 2/300 of the window.
    CHECK(std::abs(seen.x - said.x) < 0.001);
    CHECK(std::abs(seen.y - said.y) < 0.001);
  }
}

TEST_CASE("unproject is the inverse of project") {
  View view = view_from(40, 25, 2, 1);
  view.center = {1, 2, 3};
  const Vec3d p(0.3, -1.2, 0.8);
  CHECK(length(unproject(view, project(view, p)) - p) < 1e-14);
}

TEST_CASE("z points up in the picture, and right, up and towards make a right-handed frame") {
  const View view = view_from(-120, 38);
  CHECK(project(view, {0, 0, 1}).x == doctest::Approx(0));
  CHECK(project(view, {0, 0, 1}).y > 0);
  CHECK(length(cross(view.right, view.up) - view.towards) < 1e-14);
}

TEST_CASE("a line through a sphere is hidden from where it enters it") {
  const View view = view_from(0, 0); // from x
  const std::vector<Vec3d> line = {{0, -2, 0}, {0, 2, 0}};
  std::vector<Vec3d> fine;
  for (int i = 0; i <= 40; ++i)
    fine.push_back(line[0] + (line[1] - line[0]) * (i / 40.0));
  const auto strokes = cut_by_visibility(fine, [&](Vec3d p) { return !sphere_hides(view, 1, p); });
  REQUIRE(strokes.size() == 3);
  CHECK(strokes[0].visible);
  CHECK(!strokes[1].visible);
  CHECK(strokes[2].visible);
  CHECK(strokes[1].points.front().y == doctest::Approx(-1).epsilon(0.002));
  CHECK(strokes[1].points.back().y == doctest::Approx(1).epsilon(0.002));
  // The pieces together are the whole line.
  CHECK(length(strokes[0].points.back() - strokes[1].points.front()) == 0);
  CHECK(!sphere_hides(view, 1, {2, 0, 0}));
  CHECK(sphere_hides(view, 1, {-2, 0.5, 0}));
  CHECK(!sphere_hides(view, 1, {-2, 1.1, 0}));
  CHECK(!sphere_hides(view, 1, {1, 0, 0}));
}
