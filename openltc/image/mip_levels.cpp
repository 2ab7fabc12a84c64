// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/mip_levels.h"

#include "openltc/base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace openltc::image {

namespace {

// Keeps what a level shows.
template <class Level> Texels kept(const Level& level, int channels) {
  Image out(level.width, level.height, channels);
  parallel_for(out.height, 0, [&](std::int64_t row) {
    float* to = out.pixel(0, int(row));
    for (int x = 0; x < out.width; ++x, to += channels) {
      const Vec4f p = level.rgba(x, int(row));
      to[0] = p.x;
      if (channels == 2) to[1] = p.w;
      if (channels >= 3) {
        to[1] = p.y;
        to[2] = p.z;
      }
      if (channels == 4) to[3] = p.w;
    }
  });
  return Texels(std::move(out));
}

bool is_one_pixel(int width, int height) { return width <= 1 && height <= 1; }

} // namespace

MipLevels::MipLevels(Texels picture) : picture_(std::move(picture)) {
  if (picture_.empty() || is_one_pixel(picture_.width, picture_.height)) return;
  const int channels = picture_.channels();
  is_first_computed_ = picture_.pixel_count() > k_large_picture;
  const Half first(picture_);
  if (!is_first_computed_)
    kept_.push_back(kept(first, channels));
  else if (!is_one_pixel(first.width, first.height))
    kept_.push_back(kept(Half<Half<Texels>>(first), channels));
  while (!kept_.empty() && !is_one_pixel(kept_.back().width, kept_.back().height))
    kept_.push_back(kept(Half(kept_.back()), channels));
  count_ = int(kept_.size()) + (is_first_computed_ ? 1 : 0);
}

std::size_t MipLevels::byte_count(const Texels& picture) {
  std::size_t pixels = 0;
  int width = picture.width, height = picture.height;
  for (bool is_first = picture.pixel_count() > k_large_picture; !is_one_pixel(width, height);
       is_first = false) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    if (!is_first) pixels += std::size_t(width) * std::size_t(height);
  }
  return pixels * std::size_t(picture.channels()) * sizeof(float);
}

} // namespace openltc::image
