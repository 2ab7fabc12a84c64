// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/tonemap.h"

#include "openltc/image/file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace openltc::image {

namespace {

// The saturation-based sensitivity's 78 / (100 q) with lens factor q = 0.65.
constexpr float k_saturation = 1.2f;

} // namespace

float exposure_from_ev100(float ev100) { return 1.0f / (k_saturation * std::exp2(ev100)); }

float ev100_from_exposure(float exposure) { return -std::log2(k_saturation * exposure); }

float luminance(Vec3f rgb) { return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z; }

namespace {

float usable(double exposure) {
  return float(std::clamp(exposure, double(std::numeric_limits<float>::min()),
                          double(std::numeric_limits<float>::max())));
}

} // namespace

float exposure_below_white(const Image& image, float exposure, const AutoExposureOptions& options) {
  std::vector<float> brightest; // of each pixel's channels
  brightest.reserve(image.pixel_count());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec3f c = image.rgb(x, y);
      const float value = std::max({c.x, c.y, c.z});
      if (std::isfinite(luminance(c)) && value > 0.0f) brightest.push_back(value);
    }
  std::sort(brightest.begin(), brightest.end(), std::greater<>());
  const auto above = std::size_t(double(options.highlight_fraction) * double(image.pixel_count()));
  // Brings those pixels to `white` of which `above` are brighter, beginning with the first.
  const auto lowered = [&](double from, std::size_t first, float white, float stops) {
    if (first + above >= brightest.size()) return from;
    const double for_white = double(white) / double(brightest[first + above]);
    return std::min(from, std::max(for_white, double(exposure) * std::exp2(-double(stops))));
  };
  if (!std::isfinite(options.light))
    return usable(lowered(double(exposure), 0, options.white, options.light_stops));
  std::size_t lights = 0;
  while (lights < brightest.size() && brightest[lights] >= options.light)
    ++lights;
  const double for_surfaces =
      lowered(double(exposure), lights, options.white, options.surface_stops);
  return usable(lowered(for_surfaces, 0, options.light_white, options.light_stops));
}

float auto_exposure(const Image& image, const AutoExposureOptions& options) {
  std::vector<float> values;
  values.reserve(image.pixel_count());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float l = luminance(image.rgb(x, y));
      if (std::isfinite(l) && l > 0.0f) values.push_back(l);
    }
  if (values.empty()) return 1.0f;
  // Known lights do not count, unless there is hardly anything else.
  const auto surfaces = std::size_t(
      std::count_if(values.begin(), values.end(), [&](float l) { return l < options.light; }));
  if (surfaces >= values.size() / 20)
    std::erase_if(values, [&](float l) { return l >= options.light; });
  std::sort(values.begin(), values.end());

  // Drop the background, measured against the bright part of what is lit; not against the brightest
  // pixel, which may be a single spark.
  const auto sparks = std::size_t(double(options.highlight_fraction) * double(values.size()));
  const float bright = values[values.size() - 1 - std::min(sparks, values.size() - 1)];
  values.erase(values.begin(),
               std::lower_bound(values.begin(), values.end(), bright * options.black));

  // Geometric mean of the middle nine tenths.
  const std::size_t margin = values.size() / 20;
  double sum = 0.0;
  for (std::size_t i = margin; i < values.size() - margin; ++i)
    sum += std::log(double(values[i]));
  const double mean = std::exp(sum / double(values.size() - 2 * margin));
  return exposure_below_white(image, usable(double(options.middle_grey) / mean), options);
}

// Khronos Group, "PBR Neutral Tone Mapper" specification, 2024 (Emmett Lalish). With the smallest
// channel x, F90 = 0.04, Ks = 0.8 - F90, Kd = 0.15:
//   f = x - x^2 / (4 F90) for x <= 2 F90, else F90;    c' = c - f
//   p = max(c');  for p <= Ks the result is c', else
//   pn = 1 - (1 - Ks)^2 / (p + 1 - 2 Ks),  g = 1 / (Kd (p - pn) + 1),  c' pn / p * g + pn (1 - g).
Vec3f pbr_neutral(Vec3f rgb) {
  constexpr float f90 = 0.04f, start = 0.8f - f90, desaturation = 0.15f;
  const float x = std::min({rgb.x, rgb.y, rgb.z});
  const float offset = x <= 2.0f * f90 ? x - x * x / (4.0f * f90) : f90;
  const Vec3f c = rgb - Vec3f(offset);
  const float peak = std::max({c.x, c.y, c.z});
  if (peak <= start) return c;
  constexpr float d = 1.0f - start;
  const float new_peak = 1.0f - d * d / (peak + d - start);
  const float g = 1.0f / (desaturation * (peak - new_peak) + 1.0f);
  return c * (new_peak / peak * g) + Vec3f(new_peak * (1.0f - g));
}

namespace {

// (a x^2 + b x) / (c x^2 + d x + e) with x the value times 0.6.
constexpr float k_aces_exposure = 0.6f;
constexpr float k_aces_a = 2.51f, k_aces_b = 0.03f, k_aces_c = 2.43f, k_aces_d = 0.59f,
                k_aces_e = 0.14f;

} // namespace

float aces(float value) {
  const float x = k_aces_exposure * std::clamp(value, 0.0f, 1e6f); // keeps x^2 finite
  return std::min(x * (k_aces_a * x + k_aces_b) / (x * (k_aces_c * x + k_aces_d) + k_aces_e), 1.0f);
}

float inverse_aces(float y) {
  // The positive root of (a - c y) x^2 + (b - d y) x - e y = 0.
  const float a = k_aces_a - k_aces_c * y, b = k_aces_b - k_aces_d * y, c = -k_aces_e * y;
  return (-b + std::sqrt(b * b - 4.0f * a * c)) / (2.0f * a) / k_aces_exposure;
}

Vec3f apply_tonemap(Vec3f rgb, Tonemap tonemap) {
  // Beyond 1e6 every curve has reached white; this keeps infinity and NaN out of the arithmetic.
  const auto bounded = [](float v) { return v > 0.0f ? std::min(v, 1e6f) : 0.0f; };
  const Vec3f c(bounded(rgb.x), bounded(rgb.y), bounded(rgb.z));
  Vec3f out = c;
  if (tonemap == Tonemap::neutral) out = pbr_neutral(c);
  if (tonemap == Tonemap::aces) out = {aces(c.x), aces(c.y), aces(c.z)};
  return {std::clamp(out.x, 0.0f, 1.0f), std::clamp(out.y, 0.0f, 1.0f),
          std::clamp(out.z, 0.0f, 1.0f)};
}

Image to_display(const Image& image, float exposure, Tonemap tonemap) {
  Image out(image.width, image.height, image.channels == 4 ? 4 : 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Vec3f v = apply_tonemap(image.rgb(x, y) * exposure, tonemap);
      float* to = out.pixel(x, y);
      to[0] = srgb_from_linear(v.x);
      to[1] = srgb_from_linear(v.y);
      to[2] = srgb_from_linear(v.z);
      if (image.channels == 4) {
        const float alpha = image.pixel(x, y)[3];
        to[3] = alpha > 0.0f ? std::min(alpha, 1.0f) : 0.0f;
      }
    }
  return out;
}

} // namespace openltc::image
