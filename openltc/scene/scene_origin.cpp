// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The middle is the weighted median of the boxes' centres, axis by axis; the radius is the weighted
// median of how far boxes reach from there. Both ignore outliers of less than half the weight.

#include "openltc/scene/scene_origin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace openltc::scene {

namespace {

// The value below which half the weight lies; `values` are (value, weight), at least one.
double weighted_median(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double total = 0;
  for (const auto& [value, weight] : values)
    total += weight;
  double below = 0;
  for (const auto& [value, weight] : values) {
    below += weight;
    if (below >= 0.5 * total) return value;
  }
  return values.back().first;
}

} // namespace

void OriginFinder::add(Vec3d lower, Vec3d upper, double weight) {
  boxes_.push_back({(lower + upper) * 0.5, (upper - lower) * 0.5, weight});
}

Vec3d OriginFinder::origin() const {
  if (boxes_.empty()) return {0, 0, 0};
  const auto median_of = [&](const auto& value) {
    std::vector<std::pair<double, double>> values;
    values.reserve(boxes_.size());
    for (const Box& box : boxes_)
      values.emplace_back(value(box), box.weight);
    return weighted_median(std::move(values));
  };
  const Vec3d middle(median_of([](const Box& b) { return b.center.x; }),
                     median_of([](const Box& b) { return b.center.y; }),
                     median_of([](const Box& b) { return b.center.z; }));
  double radius =
      median_of([&](const Box& b) { return length(b.center - middle) + length(b.half); });
  if (!(radius > 0)) radius = 1; // points: a lamp, say, of unknown size
  const double step = std::exp2(std::ceil(std::log2(16 * radius)));
  const auto rounded = [&](double x) { return std::round(x / step) * step + 0.0; }; // no -0
  return {rounded(middle.x), rounded(middle.y), rounded(middle.z)};
}

} // namespace openltc::scene
