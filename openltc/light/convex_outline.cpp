// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/convex_outline.h"

#include <cmath>
#include <vector>

namespace openltc::light {

bool is_convex_outline(std::span<const Vec2d> points,
                       const std::function<bool(std::size_t)>& starts_ring) {
  if (points.size() < 4) return false;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (starts_ring(i)) return false;

  // The sides that have a direction.
  std::vector<Vec2d> sides;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2d side{points[i].x - points[i - 1].x, points[i].y - points[i - 1].y};
    if (side.x != 0 || side.y != 0) sides.push_back(side);
  }
  double turned = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec2d a = sides[i], b = sides[(i + 1) % sides.size()];
    const double turn = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    if (!(turn >= 0)) return false;
    turned += turn;
  }
  // A star that is drawn in one stroke turns the same way as well, but more than once around.
  return sides.size() >= 3 && turned < 3 * 3.141592653589793;
}

} // namespace openltc::light
