// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A grid over a plane, so that segments and points find their neighbours without comparing all
// with all.

#pragma once

#include "openltc/target/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace openltc::scene {

/// Two unit axes at right angles to each other and to a unit normal.
struct PlaneAxes {
  explicit PlaneAxes(Vec3d normal)
      : x(normalize(std::abs(normal.x) < 0.6 ? cross(Vec3d(1, 0, 0), normal)
                                             : cross(Vec3d(0, 1, 0), normal))),
        y(cross(normal, x)) {}
  Vec3d x, y;
  Vec2d in_plane(Vec3d p) const { return {dot(p, x), dot(p, y)}; }
};

/// About as many square cells as there are things, at most a quarter of a million, over the bounds
/// of `places`. Each holds numbers of what passes through it.
class SegmentGrid {
public:
  SegmentGrid(std::span<const Vec2d> places, std::size_t things) {
    Vec2d upper(-1e300, -1e300);
    lower_ = {1e300, 1e300};
    for (const Vec2d p : places) {
      lower_ = {std::min(lower_.x, p.x), std::min(lower_.y, p.y)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    const double width = std::max(upper.x - lower_.x, 0.0);
    const double height = std::max(upper.y - lower_.y, 0.0);
    const double longest = std::max({width, height, 1e-300});
    const double count = double(std::clamp<std::size_t>(things, 1, 1 << 18));
    // Square cells: width/size * height/size = count, but no more along a thin strip than count.
    size_ = std::max(std::sqrt(width * height / count), longest / count);
    columns_ = std::int64_t(width / size_) + 1;
    rows_ = std::int64_t(height / size_) + 1;
    cells_.resize(std::size_t(columns_ * rows_));
  }

  /// Puts `number` into every cell within `reach` of the segment.
  void add_segment(Vec2d a, Vec2d b, double reach, std::uint32_t number) {
    visit_along(a, b, reach, [&](std::vector<std::uint32_t>& cell) { cell.push_back(number); });
  }

  /// Calls visit(cell) for every cell within `reach` of the segment, each once.
  template <class Visit> void visit_along(Vec2d a, Vec2d b, double reach, const Visit& visit) {
    if (a.y > b.y) std::swap(a, b);
    const std::int64_t first = row_of(a.y - reach), last = row_of(b.y + reach);
    for (std::int64_t row = first; row <= last; ++row) {
      // The part of the segment in this row, and what reaches out of it.
      const double low = lower_.y + double(row) * size_ - reach;
      const double high = low + size_ + 2 * reach;
      const double rise = b.y - a.y;
      double from = a.x, to = b.x;
      if (rise > 0) {
        const auto x_at = [&](double y) {
          return a.x + (b.x - a.x) * std::clamp((y - a.y) / rise, 0.0, 1.0);
        };
        from = x_at(low);
        to = x_at(high);
      }
      if (from > to) std::swap(from, to);
      const std::int64_t begin = column_of(from - reach), end = column_of(to + reach);
      for (std::int64_t column = begin; column <= end; ++column)
        visit(cells_[std::size_t(row * columns_ + column)]);
    }
  }

  /// Calls visit(cell) for every cell that the box touches.
  template <class Visit> void visit_box(Vec2d lower, Vec2d upper, const Visit& visit) {
    for (std::int64_t row = row_of(lower.y); row <= row_of(upper.y); ++row)
      for (std::int64_t column = column_of(lower.x); column <= column_of(upper.x); ++column)
        visit(cells_[std::size_t(row * columns_ + column)]);
  }

  std::span<std::vector<std::uint32_t>> cells() { return cells_; }

private:
  std::int64_t row_of(double y) const { return index(y - lower_.y, rows_); }
  std::int64_t column_of(double x) const { return index(x - lower_.x, columns_); }
  std::int64_t index(double offset, std::int64_t count) const {
    return std::int64_t(std::clamp(offset / size_, 0.0, double(count - 1)));
  }

  Vec2d lower_;
  double size_ = 1;
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

} // namespace openltc::scene
