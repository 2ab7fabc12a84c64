// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The smaller copies of a texture, for looking at it from afar.

#pragma once

#include "openltc/image/texels.h"

#include <cstddef>
#include <vector>

namespace openltc::image {

/// What `Level` shows (width, height, rgba(x, y)) half as wide and high, at least one pixel: the
/// means of 2 x 2 pixels, the last row or column of an odd size left out. Each is computed when it
/// is looked at, and nothing is kept.
template <class Level> struct Half {
  const Level* finer;
  int width, height;

  explicit Half(const Level& of)
      : finer(&of), width(of.width > 1 ? of.width / 2 : 1),
        height(of.height > 1 ? of.height / 2 : 1) {}

  /// One pixel, 0 <= x < width, 0 <= y < height.
  Vec4f rgba(int x, int y) const {
    const int x0 = finer->width > 1 ? 2 * x : 0, x1 = finer->width > 1 ? x0 + 1 : 0;
    const int y0 = finer->height > 1 ? 2 * y : 0, y1 = finer->height > 1 ? y0 + 1 : 0;
    const Vec4f a = finer->rgba(x0, y0), b = finer->rgba(x1, y0), c = finer->rgba(x0, y1),
                d = finer->rgba(x1, y1);
    return {0.25f * (a.x + b.x + c.x + d.x), 0.25f * (a.y + b.y + c.y + d.y),
            0.25f * (a.z + b.z + c.z + d.z), 0.25f * (a.w + b.w + c.w + d.w)};
  }
};

/// All copies of a picture, each a Half of the one before, down to one pixel. They are linear
/// floats, with as many channels as the picture has, and kept; but of a picture of more than
/// k_large_picture pixels the largest copy is computed when it is looked at, because it would take
/// four times as much as an 8-bit picture itself.
class MipLevels {
public:
  static constexpr std::size_t k_large_picture = std::size_t(1) << 22;

  /// The picture's samples live as long as this.
  explicit MipLevels(Texels picture);

  /// How many there are, without the picture itself.
  int count() const { return count_; }
  /// Calls look(level) with copy 1 to count(): something with width, height and rgba(x, y).
  template <class Look> auto look_at(int level, const Look& look) const {
    return level == 1 && is_first_computed_
               ? look(Half(picture_))
               : look(kept_[std::size_t(level) - (is_first_computed_ ? 2 : 1)]);
  }

  /// What the copies of a picture take, at most.
  static std::size_t byte_count(const Texels& picture);

private:
  Texels picture_;
  int count_ = 0;
  bool is_first_computed_ = false;
  std::vector<Texels> kept_;
};

} // namespace openltc::image
