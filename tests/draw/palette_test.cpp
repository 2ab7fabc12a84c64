// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/palette.h"
#include "openltc/image/colormap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace openltc;
using namespace openltc::draw;
using namespace openltc::image;

namespace {

// A disc in the colours of a map, soft at its rim, on nothing.
image::Image colored_disc(int side) {
  image::Image picture(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double r = std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0);
      const float alpha = float(std::clamp(side / 2.0 - 1 - r, 0.0, 1.0));
      const Vec3f c = image::map_color(image::Colormap::viridis, float(1 - r / side));
      float* pixel = picture.pixel(x, y);
      if (alpha > 0) pixel[0] = c.x, pixel[1] = c.y, pixel[2] = c.z, pixel[3] = alpha;
    }
  return picture;
}

int worst_step(const image::Image& picture, const PaletteImage& reduced, bool opaque_only) {
  int worst = 0;
  for (std::size_t i = 0; i < reduced.indices.size(); ++i) {
    if (opaque_only && picture.data[4 * i + 3] < 1.0f) continue;
    for (std::size_t c = 0; c < 4; ++c)
      worst = std::max(worst, std::abs(int(std::lround(picture.data[4 * i + c] * 255.0f)) -
                                       int(reduced.palette[reduced.indices[i]][c])));
  }
  return worst;
}

} // namespace

TEST_CASE("a picture along a colour map keeps its colours to two steps of 255") {
  const image::Image picture = colored_disc(200);
  const PaletteImage reduced = reduce_colors(picture);
  CHECK(reduced.width == 200);
  CHECK(reduced.indices.size() == picture.pixel_count());
  CHECK(reduced.palette.size() <= 256);
  CHECK(worst_step(picture, reduced, true) <= 2);
  CHECK(worst_step(picture, reduced, false) <= 40); // alpha at the rim
  CHECK(reduced.palette[reduced.indices[0]][3] == 0);
}

TEST_CASE("a palette is never larger than asked for, and exact when all colours fit") {
  const image::Image picture = colored_disc(60);
  for (const int colors : {2, 3, 16, 100})
    CHECK(int(reduce_colors(picture, colors).palette.size()) <= colors);
  image::Image few(4, 1, 4);
  for (int x = 0; x < 4; ++x)
    few.pixel(x, 0)[0] = float(x) / 3, few.pixel(x, 0)[3] = x == 0 ? 0.0f : 1.0f;
  CHECK(worst_step(few, reduce_colors(few), false) == 0);
  CHECK(reduce_colors(few).palette.size() == 4);
  CHECK(reduce_colors(image::Image(3, 3, 4)).palette.size() == 1);
}
