// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The sRGB transfer function: IEC 61966-2-1:1999, section 5.2.

#include "openltc/image/codec.h"

#include <cmath>

namespace openltc::image {

namespace {

// The standard's two pieces meet at these two points, which belong together to its four digits.
constexpr float k_knee_linear = 0.0031308f;
constexpr float k_knee_srgb = 0.04045f;

} // namespace

float srgb_from_linear(float linear) {
  const float x = std::fabs(linear);
  const float y = x <= k_knee_linear ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return std::copysign(y, linear);
}

float linear_from_srgb(float srgb) {
  const float x = std::fabs(srgb);
  const float y = x <= k_knee_srgb ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  return std::copysign(y, srgb);
}

const std::array<float, 256>& codec::linear_from_srgb8() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t;
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = linear_from_srgb(float(i) / 255.0f);
    return t;
  }();
  return table;
}

} // namespace openltc::image
