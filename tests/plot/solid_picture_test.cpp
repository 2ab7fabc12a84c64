// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/colormap.h"
#include "openltc/image/file.h"
#include "openltc/plot/direction_mesh.h"
#include "openltc/plot/matrix_lobe.h"
#include "openltc/plot/solid_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace openltc;
using namespace openltc::plot;

namespace {

Vec3f linear(Vec3f c) {
  return {image::linear_from_srgb(c.x), image::linear_from_srgb(c.y), image::linear_from_srgb(c.z)};
}

Vec3f density_color(const f64::Lobe& lobe, double peak, Vec3d w) {
  return image::map_color(image::Colormap::viridis, float(f64::eval_lobe(lobe, w) / peak));
}

} // namespace

TEST_CASE("a plain sphere shows the colour map's colour of the density at every pixel") {
  for (const LobeMatrix m :
       {LobeMatrix{}, LobeMatrix{0.2, 0, 0.1, 0}, LobeMatrix{0.6, -1, 0.5, 0.3}}) {
    const f64::Lobe lobe = lobe_of_matrix(m);
    const double peak = lobe_facts(lobe).peak;
    const Solid sphere{
        sphere_mesh(lobe, [&](Vec3d w) { return linear(density_color(lobe, peak, w)); }),
        Finish::plain};
    const View view = view_from(-120, 38, 1.1, 1.1);
    const auto picture = render_solids({&sphere, 1}, view, {220, 16, 0});
    REQUIRE(picture.ok());
    std::vector<double> differences;
    for (int y = 0; y < picture->height; ++y)
      for (int x = 0; x < picture->width; ++x) {
        const float* pixel = picture->pixel(x, y);
        if (pixel[3] < 0.999f) continue;
        Vec3d p = unproject(view, {2 * (x + 0.5) / 220 - 1, 1 - 2 * (y + 0.5) / 220, 0});
        const double pp = dot(p, p);
        if (pp > 0.95) continue; // the rim, where a pixel is many degrees wide
        const Vec3d w = p + view.towards * std::sqrt(1 - pp);
        const Vec3f wanted = density_color(lobe, peak, w);
        differences.push_back(
            double(std::max({std::abs(pixel[0] - wanted.x), std::abs(pixel[1] - wanted.y),
                             std::abs(pixel[2] - wanted.z)})));
      }
    std::sort(differences.begin(), differences.end());
    REQUIRE(differences.size() > 10000);
    // Where the density changes within a pixel its mean is another colour.
    CHECK(differences[differences.size() / 2] < 1.0 / 255);
    CHECK(differences[differences.size() * 99 / 100] < 6.0 / 255);
  }
}

TEST_CASE("pictures are transparent beside the solid and do not depend on threads") {
  const f64::Lobe lobe = lobe_of_matrix({0.4, -0.5, 0.3, 0});
  const double peak = lobe_facts(lobe).peak;
  const Solid solid{
      lobe_mesh(lobe, peak, [&](Vec3d w) { return linear(density_color(lobe, peak, w)); }),
      Finish::lit};
  const View view = view_from(-120, 38, 1.1, 1.1);
  const auto one = render_solids({&solid, 1}, view, {96, 8, 1});
  const auto many = render_solids({&solid, 1}, view, {96, 8, 3});
  REQUIRE(one.ok());
  REQUIRE(many.ok());
  CHECK(one->data == many->data);
  CHECK(one->pixel(0, 0)[3] == 0);
  double opaque = 0;
  for (std::size_t i = 3; i < one->data.size(); i += 4)
    opaque += double(one->data[i]);
  CHECK(opaque > 200);
  CHECK(opaque < 0.5 * 96 * 96);
}

TEST_CASE("the lobe's surface lies at the density over the scale") {
  const f64::Lobe lobe = lobe_of_matrix({0.3, 0.4, 0.2, 0.1});
  const scene::Mesh mesh = lobe_mesh(lobe, 2.0, [](Vec3d) { return Vec3f(1.0f); });
  double farthest = 0;
  for (const Vec3f& p : mesh.positions) {
    const Vec3d point = to_double(p);
    const double r = length(point);
    farthest = std::max(farthest, r);
    if (r < 1e-3) continue;
    CHECK(r == doctest::Approx(f64::eval_lobe(lobe, point / r) / 2.0).epsilon(1e-4));
  }
  CHECK(farthest == doctest::Approx(lobe_facts(lobe).peak / 2.0).epsilon(1e-3));
}
