// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A picture in memory: 32-bit float channels, interleaved, top row first.

#pragma once

#include "openltc/target/vec.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace openltc::image {

/// width x height pixels of `channels` floats each (1 grey, 3 RGB, 4 RGBA with straight alpha).
/// Row 0 is the top of the picture. Colours are scene-linear Rec.709 unless a function says
/// otherwise.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 3;
  std::vector<float> data;

  Image() = default;
  Image(int width_, int height_, int channels_ = 3)
      : width(width_), height(height_), channels(channels_),
        data(std::size_t(width_) * std::size_t(height_) * std::size_t(channels_), 0.0f) {}

  bool empty() const { return data.empty(); }
  std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
  float* pixel(int x, int y) { return data.data() + offset(x, y); }
  const float* pixel(int x, int y) const { return data.data() + offset(x, y); }
  Vec3f rgb(int x, int y) const {
    const float* p = pixel(x, y);
    return channels >= 3 ? Vec3f(p[0], p[1], p[2]) : Vec3f(p[0]);
  }

private:
  std::size_t offset(int x, int y) const {
    return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
  }
};

/// One named part of an EXR file, e.g. {"", radiance} and {"stderr", standard error}.
/// The first layer of a file has the empty name and holds the picture itself.
struct Layer {
  std::string name;
  Image image;
};

} // namespace openltc::image
