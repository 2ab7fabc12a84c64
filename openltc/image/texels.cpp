// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/texels.h"

#include "openltc/image/codec.h"
#include "openltc/image/file.h"

#include <type_traits>
#include <utility>

namespace openltc::image {

namespace {

const float* linear8() {
  static const std::vector<float> table = [] {
    std::vector<float> t(256);
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = float(i) * (1.0f / 255.0f);
    return t;
  }();
  return table.data();
}

const float* linear16() {
  static const std::vector<float> table = [] {
    std::vector<float> t(65536);
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = float(i) * (1.0f / 65535.0f);
    return t;
  }();
  return table.data();
}

const float* srgb16() {
  static const std::vector<float> table = [] {
    std::vector<float> t(65536);
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = linear_from_srgb(linear16()[i]);
    return t;
  }();
  return table.data();
}

} // namespace

Texels::Texels(Image picture)
    : width(picture.width), height(picture.height), channels_(picture.channels) {
  const auto kept = std::make_shared<const std::vector<float>>(std::move(picture.data));
  floats_ = kept->data();
  samples_ = kept;
}

Texels::Texels(int width_, int height_, int channels, std::vector<std::uint8_t> samples,
               bool is_srgb)
    : width(width_), height(height_), channels_(channels) {
  const auto kept = std::make_shared<const std::vector<std::uint8_t>>(std::move(samples));
  bits8_ = kept->data();
  samples_ = kept;
  choose_tables(is_srgb);
}

Texels::Texels(int width_, int height_, int channels, std::shared_ptr<const std::uint8_t> samples,
               bool is_srgb)
    : width(width_), height(height_), channels_(channels), samples_(samples),
      bits8_(samples.get()) {
  choose_tables(is_srgb);
}

Texels::Texels(int width_, int height_, int channels, std::vector<std::uint16_t> samples,
               bool is_srgb)
    : width(width_), height(height_), channels_(channels) {
  const auto kept = std::make_shared<const std::vector<std::uint16_t>>(std::move(samples));
  bits16_ = kept->data();
  samples_ = kept;
  choose_tables(is_srgb);
}

void Texels::choose_tables(bool is_srgb) {
  if (bits8_) {
    alpha8_ = linear8();
    color8_ = is_srgb ? codec::linear_from_srgb8().data() : alpha8_;
  } else if (bits16_) {
    alpha16_ = linear16();
    color16_ = is_srgb ? srgb16() : alpha16_;
  }
}

Texels Texels::taken_as(bool is_srgb) const {
  Texels other = *this;
  other.choose_tables(is_srgb);
  return other;
}

std::size_t Texels::byte_count() const {
  const std::size_t sample = bits8_ ? 1 : bits16_ ? 2 : floats_ ? 4 : 0;
  return pixel_count() * std::size_t(channels_) * sample;
}

TextureSamples Texels::colors() const {
  TextureSamples view;
  view.floats = floats_;
  view.bits8 = bits8_;
  view.bits16 = bits16_;
  view.table = bits8_ ? color8_ : color16_;
  view.grey_channels = channels_ < 3 ? std::size_t(channels_) : 0;
  return view;
}

Vec3f Texels::largest_rgb() const {
  // Tables rise, so the largest sample has the largest value.
  const std::size_t stride = std::size_t(channels_), count = pixel_count() * stride;
  const auto largest_of = [&](const auto* samples, const auto& value_of) {
    auto red = std::remove_cvref_t<decltype(*samples)>(0), green = red, blue = red;
    const std::size_t second = stride >= 3 ? 1 : 0, third = stride >= 3 ? 2 : 0;
    for (std::size_t i = 0; i < count; i += stride) {
      // Not a number is no larger than anything.
      red = samples[i] > red ? samples[i] : red;
      green = samples[i + second] > green ? samples[i + second] : green;
      blue = samples[i + third] > blue ? samples[i + third] : blue;
    }
    return Vec3f(value_of(red), value_of(green), value_of(blue));
  };
  if (bits8_) return largest_of(bits8_, [&](std::uint8_t v) { return color8_[v]; });
  if (bits16_) return largest_of(bits16_, [&](std::uint16_t v) { return color16_[v]; });
  return largest_of(floats_, [](float v) { return v; });
}

Image Texels::to_image() const {
  Image image(width, height, channels_ % 2 == 0 ? 4 : 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec4f p = rgba(x, y);
      float* const to = image.pixel(x, y);
      to[0] = p.x;
      to[1] = p.y;
      to[2] = p.z;
      if (image.channels == 4) to[3] = p.w;
    }
  return image;
}

} // namespace openltc::image
