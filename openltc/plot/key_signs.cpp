// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/key_signs.h"

#include "openltc/image/colormap.h"

#include <array>

namespace openltc::plot {

void draw_line_sign(Sketch& sketch, Vec2d at, const Pen& pen, std::string_view text) {
  draw_path(sketch, std::array{Vec2d(at.x, at.y - 4), Vec2d(at.x + 24, at.y - 4)}, pen);
  draw_sign_text(sketch, at, text);
}

void draw_sign_text(Sketch& sketch, Vec2d at, std::string_view text) {
  draw_text(sketch, at.x + 31, at.y, text, {11, Ink::soft});
}

Status draw_density_bar(Sketch& sketch, Vec2d corner, double width,
                        const std::vector<std::pair<double, std::string>>& ticks,
                        std::string_view label) {
  constexpr double k_height = 9;
  image::Image bar(128, 1, 4);
  for (int i = 0; i < bar.width; ++i) {
    const Vec3f c = image::map_color(image::Colormap::viridis, float(i) / float(bar.width - 1));
    float* pixel = bar.pixel(i, 0);
    pixel[0] = c.x, pixel[1] = c.y, pixel[2] = c.z, pixel[3] = 1;
  }
  if (Status status = draw_picture(sketch, corner, {width, k_height}, bar, true); !status)
    return status;
  const double y = corner.y + k_height;
  for (const auto& [share, text] : ticks) {
    const double x = corner.x + width * share;
    draw_path(sketch, std::array{Vec2d(x, y), Vec2d(x, y + 4)}, {Ink::soft, 1});
    draw_text(sketch, x, y + 16, text, {10.5, Ink::soft, Anchor::middle});
  }
  draw_text(sketch, corner.x + width + 14, y, label, {11, Ink::soft});
  return Success{};
}

} // namespace openltc::plot
