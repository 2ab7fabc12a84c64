// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/polygon_moments.h"

#include <algorithm>
#include <cmath>

namespace openltc::light {

void set_spread(PolygonMoments& moments, double xx, double xy, double yy) {
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  const double u = std::sqrt(2 * std::max(mean + half, 0.0));
  const double v = std::sqrt(2 * std::max(mean - half, 0.0));
  moments.spread_u = Vec2d(std::cos(angle), std::sin(angle)) * u;
  moments.spread_v = Vec2d(-std::sin(angle), std::cos(angle)) * v;
}

} // namespace openltc::light
