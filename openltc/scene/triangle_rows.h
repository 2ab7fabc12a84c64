// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Triangles row by row, so that thin ones cost what they cover and not what is around them.

#pragma once

#include "openltc/target/vec.h"

#include <algorithm>
#include <cstddef>

namespace openltc::scene {

struct RowRange {
  double low = 1e300, high = -1e300; ///< of x; empty when low is above high
};

/// What a triangle covers of the strip between the heights y0 <= y1.
inline RowRange row_range(const Vec2d (&corner)[3], double y0, double y1) {
  RowRange range;
  const auto include = [&](double x) {
    range.low = std::min(range.low, x);
    range.high = std::max(range.high, x);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d a = corner[i], b = corner[(i + 1) % 3];
    if (a.y >= y0 && a.y <= y1) include(a.x);
    for (const double y : {y0, y1})
      if ((a.y > y) != (b.y > y)) include(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  return range;
}

} // namespace openltc::scene
