// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A picture in the precision of its file, for textures: as floats, a photograph of a few megabytes
// takes sixteen bytes a pixel.

#pragma once

#include "openltc/image/image.h"
#include "openltc/target/resources.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace openltc::image {

/// Pixels of 4 channels, looked at as linear floats; row 0 at the top. They cannot be changed, and
/// copies share them.
class Texels {
public:
  int width = 0;
  int height = 0;

  Texels() = default;
  /// Keeps the floats of a picture. 1 and 2 channels are grey (and alpha), 3 are opaque.
  Texels(Image picture);
  /// width x height pixels of `channels` (1 to 4, as above) integer samples, rows interleaved, top
  /// row first, largest value = 1. `is_srgb`: colours, but not alpha, are decoded from sRGB.
  Texels(int width, int height, int channels, std::vector<std::uint8_t> samples, bool is_srgb);
  Texels(int width, int height, int channels, std::shared_ptr<const std::uint8_t> samples,
         bool is_srgb);
  Texels(int width, int height, int channels, std::vector<std::uint16_t> samples, bool is_srgb);

  bool empty() const { return width == 0 || height == 0; }
  std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
  /// Of the samples.
  std::size_t byte_count() const;

  /// The same samples, their colours taken as sRGB or as linear; floats are always linear.
  Texels taken_as(bool is_srgb) const;

  /// One pixel, 0 <= x < width, 0 <= y < height.
  Vec4f rgba(int x, int y) const {
    const std::size_t at =
        (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels_);
    if (bits8_) return pixel_of(bits8_ + at, color8_, alpha8_);
    if (bits16_) return pixel_of(bits16_ + at, color16_, alpha16_);
    const float* p = floats_ + at;
    if (channels_ >= 3) return {p[0], p[1], p[2], channels_ == 4 ? p[3] : 1.0f};
    return {p[0], p[0], p[0], channels_ == 2 ? p[1] : 1.0f};
  }
  Vec3f rgb(int x, int y) const {
    const Vec4f p = rgba(x, y);
    return {p.x, p.y, p.z};
  }

  /// The largest value of each colour, 0 where none is positive.
  Vec3f largest_rgb() const;

  /// The samples, for whoever reads colours without alpha from place to place; they live as long as
  /// any copy of these texels. `channels` of a pixel is 3 or 4, and grey looks like three.
  TextureSamples colors() const;
  int color_channels() const { return channels_ < 3 ? 3 : channels_; }
  int channels() const { return channels_; }

  /// All pixels as floats, 3 channels where all of it is opaque by its format, else 4.
  Image to_image() const;

  /// Equal for those that look at the same samples in memory in the same way.
  std::pair<const void*, const void*> identity() const {
    return {samples_.get(), color8_ ? color8_ : color16_};
  }

private:
  template <class T> Vec4f pixel_of(const T* p, const float* color, const float* alpha) const {
    if (channels_ >= 3)
      return {color[p[0]], color[p[1]], color[p[2]], channels_ == 4 ? alpha[p[3]] : 1.0f};
    const float grey = color[p[0]];
    return {grey, grey, grey, channels_ == 2 ? alpha[p[1]] : 1.0f};
  }
  void choose_tables(bool is_srgb);

  int channels_ = 4;
  std::shared_ptr<const void> samples_; // owns what one of these three points to
  const std::uint8_t* bits8_ = nullptr;
  const std::uint16_t* bits16_ = nullptr;
  const float* floats_ = nullptr;
  const float* color8_ = nullptr; // what each of 256 values stands for, colours and alpha
  const float* alpha8_ = nullptr;
  const float* color16_ = nullptr; // of 65536
  const float* alpha16_ = nullptr;
};

} // namespace openltc::image
