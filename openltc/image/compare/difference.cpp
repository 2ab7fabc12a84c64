// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/compare/difference.h"

#include "openltc/image/font.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace openltc::image {

namespace {

// Display-encoded colours.
const Vec3f k_background(0.11f);
const Vec3f k_ink(0.93f);
const Vec3f k_faint_ink(0.66f);
const Vec3f k_masked(0.30f);
const Vec3f k_not_a_number(0.1f, 1.0f, 0.3f);

// Sizes in dots of the font; a dot is `unit` pixels.
constexpr int k_margin = 10;
constexpr int k_gap = 8;
constexpr int k_bar_width = 12;
constexpr int k_tick = 3;
// A small picture is enlarged to at least this many pixels at its longer side.
constexpr int k_least_side = 480;

void fill(Image& image, int x0, int y0, int width, int height, Vec3f color) {
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x) {
      float* p = image.pixel(x, y);
      p[0] = color.x;
      p[1] = color.y;
      p[2] = color.z;
    }
}

// The least of 1, 2, 5 times a power of ten that is not below `value`.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value * (1.0 - 1e-6)) return factor * power;
  return 10.0 * power;
}

struct Tick {
  double at; // 0 bottom .. 1 top
  std::string label;
};

// Four or five intervals, so that the steps of a round scale are round themselves.
std::vector<Tick> make_ticks(double scale_max, const DifferencePictureOptions& options) {
  const double power = std::pow(10.0, std::floor(std::log10(scale_max * (1.0 + 1e-6))));
  const int leading = int(std::lround(scale_max / power));
  const int intervals = leading % 2 == 0 ? 4 : 5;
  const int first = options.is_signed ? -intervals : 0;
  std::vector<Tick> ticks;
  for (int i = first; i <= intervals; ++i) {
    const double value = scale_max * i / intervals * (options.percent ? 100.0 : 1.0);
    ticks.push_back({double(i - first) / (intervals - first),
                     fmt::format("{}{:.3g}{}", options.is_signed && i > 0 ? "+" : "", value,
                                 options.percent ? "%" : "")});
  }
  return ticks;
}

} // namespace

Image difference_map(const Image& a, const Image& b, DifferenceKind kind, double eps) {
  assert(a.width == b.width && a.height == b.height);
  Image map(a.width, a.height, 1);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const Vec3f va = a.rgb(x, y), vb = b.rgb(x, y);
      const auto difference = [&](float p, float q) {
        if (!std::isfinite(p) || !std::isfinite(q)) return std::numeric_limits<double>::quiet_NaN();
        const double d = double(p) - double(q);
        if (kind == DifferenceKind::absolute) return std::fabs(d);
        const double relative = d / (std::fabs(double(q)) + eps);
        return kind == DifferenceKind::relative ? std::fabs(relative) : relative;
      };
      map.pixel(x, y)[0] =
          float((difference(va.x, vb.x) + difference(va.y, vb.y) + difference(va.z, vb.z)) / 3.0);
    }
  return map;
}

float automatic_scale_max(const Image& map, std::span<const std::uint8_t> mask) {
  std::vector<float> sizes;
  for (std::size_t i = 0; i < map.data.size(); ++i)
    if ((mask.empty() || mask[i] != 0) && std::isfinite(map.data[i]))
      sizes.push_back(std::fabs(map.data[i]));
  if (sizes.empty()) return 1.0f;
  const auto at = sizes.begin() + std::ptrdiff_t(0.99 * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  float value = *at;
  // Where all but a few pixels are equal, these few are what there is to see.
  if (value <= 0.0f) value = *std::max_element(sizes.begin(), sizes.end());
  return value > 1e-30f ? float(round_up(double(value))) : 1.0f;
}

Image difference_picture(const Image& map, const DifferencePictureOptions& options) {
  assert(map.channels == 1 && !map.empty());
  assert(options.mask.empty() || options.mask.size() == map.pixel_count());
  const float scale_max =
      options.scale_max > 0.0f ? options.scale_max : automatic_scale_max(map, options.mask);
  const std::vector<Tick> ticks = make_ticks(double(scale_max), options);

  // Lay out: title above, scale to the right, caption below.
  const int zoom = std::max(1, k_least_side / std::max(map.width, map.height));
  const int width = map.width * zoom, height = map.height * zoom;
  const int unit = std::max(1, (std::max(width, height) + 320) / 640);
  const int margin = k_margin * unit, gap = k_gap * unit, line = k_glyph_height * unit;
  int label_width = 0;
  for (const Tick& tick : ticks)
    label_width = std::max(label_width, text_width(tick.label, unit));
  const int left = margin, top = margin + (options.title.empty() ? 0 : line + gap);
  // A very flat picture still gets a scale that holds its numbers.
  const int bar_height = std::max(height, int(ticks.size()) * (line + 2 * unit));
  const int bar_left = left + width + gap;
  const int label_left = bar_left + (k_bar_width + k_tick + 3) * unit;
  const int bottom = top + bar_height + (options.caption.empty() ? 0 : gap + line);
  Image picture(label_left + label_width + margin, bottom + margin, 3);
  fill(picture, 0, 0, picture.width, picture.height, k_background);

  // Colour the map.
  const auto color_of = [&](float value) {
    if (std::isnan(value)) return k_not_a_number;
    const float t = value / scale_max;
    return map_color(options.colormap, options.is_signed ? 0.5f + 0.5f * t : t);
  };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(map.width) + std::size_t(x);
      const bool masked = !options.mask.empty() && options.mask[i] == 0;
      fill(picture, left + x * zoom, top + y * zoom, zoom, zoom,
           masked ? k_masked : color_of(map.data[i]));
    }

  // Draw the scale.
  for (int y = 0; y < bar_height; ++y) {
    const float t = 1.0f - float(y) / float(std::max(bar_height - 1, 1));
    fill(picture, bar_left, top + y, k_bar_width * unit, 1, map_color(options.colormap, t));
  }
  for (const Tick& tick : ticks) {
    const int y = top + int(std::lround((1.0 - tick.at) * (bar_height - unit)));
    fill(picture, bar_left + k_bar_width * unit, y, k_tick * unit, unit, k_faint_ink);
    // The middle of the digits beside the tick, but inside of the picture's height.
    const int ascent = k_glyph_ascent * unit;
    const int text_y = std::clamp(y + unit / 2 - ascent / 2, top, top + bar_height - ascent);
    draw_text(picture, label_left, text_y, tick.label, k_ink, unit);
  }

  // Write the texts.
  const int text_space = picture.width - 2 * margin;
  draw_text(picture, left, margin, fit_text(options.title, text_space, unit), k_ink, unit);
  draw_text(picture, left, bottom - line, fit_text(options.caption, text_space, unit), k_faint_ink,
            unit);
  return picture;
}

} // namespace openltc::image
