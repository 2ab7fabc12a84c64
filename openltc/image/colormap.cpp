// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// magma and viridis: Nathaniel Smith, Stefan van der Walt (viridis with Eric Firing), "A Better
// Default Colormap for Matplotlib", SciPy 2015; their tables are in the public domain (CC0). Here
// are 17 colours of each, evenly spaced and interpolated linearly: within 3/255 (magma) and 6/255
// (viridis) of the 256 of the original in each channel.
//
// blue_red: made here, along straight lines in OKLab (Bjorn Ottosson, "A perceptual color space for
// image processing", 2020).

#include "openltc/image/colormap.h"

#include "openltc/image/file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace openltc::image {

namespace {

constexpr int k_intervals = 16;
using Table = std::uint8_t[k_intervals + 1][3];

constexpr Table k_magma = {{0, 0, 4},      {10, 8, 34},     {29, 17, 70},    {54, 16, 106},
                           {80, 18, 124},  {105, 28, 129},  {130, 38, 129},  {156, 46, 127},
                           {182, 55, 121}, {207, 65, 112},  {230, 81, 99},   {245, 105, 92},
                           {251, 135, 97}, {254, 165, 113}, {254, 195, 135}, {253, 224, 162},
                           {252, 253, 191}};

constexpr Table k_viridis = {
    {68, 1, 84},    {72, 24, 106},  {71, 45, 123},  {66, 64, 134},  {59, 82, 139},  {51, 99, 141},
    {44, 114, 142}, {38, 129, 142}, {33, 144, 140}, {31, 159, 136}, {40, 174, 128}, {62, 188, 116},
    {93, 201, 99},  {130, 211, 76}, {171, 220, 50}, {213, 226, 26}, {253, 231, 37}};

Vec3f look_up(const Table& table, float t) {
  const float at = t * float(k_intervals);
  const int i = std::min(int(at), k_intervals - 1);
  const float f = at - float(i);
  const auto mix = [&](int c) {
    return (float(table[i][c]) * (1.0f - f) + float(table[i + 1][c]) * f) / 255.0f;
  };
  return {mix(0), mix(1), mix(2)};
}

struct Oklab {
  float l, a, b;
};

Vec3f srgb_from_oklab(Oklab c) {
  const auto cube = [](float v) { return v * v * v; };
  const float l = cube(c.l + 0.3963377774f * c.a + 0.2158037573f * c.b);
  const float m = cube(c.l - 0.1055613458f * c.a - 0.0638541728f * c.b);
  const float s = cube(c.l - 0.0894841775f * c.a - 1.2914855480f * c.b);
  const auto encode = [](float v) { return srgb_from_linear(std::clamp(v, 0.0f, 1.0f)); };
  return {encode(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s),
          encode(-1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s),
          encode(-0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s)};
}

Vec3f blue_red(float t) {
  // Ends as colourful as the display allows at their lightness; blue and red rather than green and
  // red, which the commonest colour blindness confuses.
  constexpr Oklab middle = {0.97f, 0.0f, 0.0f};
  constexpr Oklab blue = {0.42f, -0.03f, -0.17f}, red = {0.42f, 0.15f, 0.07f};
  const Oklab& end = t < 0.5f ? blue : red;
  const float k = std::fabs(2.0f * t - 1.0f);
  return srgb_from_oklab({middle.l + k * (end.l - middle.l), middle.a + k * (end.a - middle.a),
                          middle.b + k * (end.b - middle.b)});
}

} // namespace

Vec3f map_color(Colormap map, float t) {
  t = t > 0.0f ? std::min(t, 1.0f) : 0.0f;
  if (map == Colormap::magma) return look_up(k_magma, t);
  if (map == Colormap::viridis) return look_up(k_viridis, t);
  return blue_red(t);
}

} // namespace openltc::image
