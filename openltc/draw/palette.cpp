// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Median cut: P. Heckbert 1982, "Color Image Quantization for Frame Buffer Display", section 4.2.
// The box with the longest side is cut rather than the fullest: every colour counts alike, so no
// error is large. The cut is at the middle of that side.

#include "openltc/draw/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace openltc::draw {

namespace {

using Color = std::array<std::uint8_t, 4>;

// A pixel at the rim shows its alpha less than an area its colour: steps of alpha count so much
// less.
constexpr int k_alpha_steps = 16;

struct ColorCount {
  Color color;
  std::int64_t count;
};

struct Box {
  std::size_t from, to; // of the list of colours
  int channel;          // of the longest side
  int length;
};

Box make_box(const std::vector<ColorCount>& colors, std::size_t from, std::size_t to) {
  Box box{from, to, 0, -1};
  for (int c = 0; c < 4; ++c) {
    int low = 255, high = 0;
    for (std::size_t i = from; i < to; ++i) {
      low = std::min(low, int(colors[i].color[std::size_t(c)]));
      high = std::max(high, int(colors[i].color[std::size_t(c)]));
    }
    const int length = c == 3 ? (high - low) / k_alpha_steps : high - low;
    if (length > box.length) box.length = length, box.channel = c;
  }
  return box;
}

Color byte_color(const float* pixel) {
  Color color;
  for (std::size_t c = 0; c < 4; ++c)
    color[c] = std::uint8_t(std::lround(std::clamp(pixel[c], 0.0f, 1.0f) * 255.0f));
  return color[3] == 0 ? Color{0, 0, 0, 0} : color;
}

Color mean_color(const std::vector<ColorCount>& colors, const Box& box) {
  std::array<std::int64_t, 4> sum{};
  std::int64_t count = 0;
  for (std::size_t i = box.from; i < box.to; ++i) {
    for (std::size_t c = 0; c < 4; ++c)
      sum[c] += colors[i].color[c] * colors[i].count;
    count += colors[i].count;
  }
  Color mean;
  for (std::size_t c = 0; c < 4; ++c)
    mean[c] = std::uint8_t((sum[c] + count / 2) / count);
  return mean;
}

} // namespace

PaletteImage reduce_colors(const image::Image& display, int colors) {
  std::map<Color, std::int64_t> counts; // in the order of the colours: the same on every machine
  for (int y = 0; y < display.height; ++y)
    for (int x = 0; x < display.width; ++x)
      ++counts[byte_color(display.pixel(x, y))];
  std::vector<ColorCount> list;
  for (const auto& [color, count] : counts)
    if (color[3] != 0) list.push_back({color, count});
  const bool has_clear = list.size() < counts.size();

  std::vector<Box> boxes;
  if (!list.empty()) boxes.push_back(make_box(list, 0, list.size()));
  while (int(boxes.size()) < colors - (has_clear ? 1 : 0)) {
    const auto longest = std::max_element(
        boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.length < b.length; });
    if (longest == boxes.end() || longest->length == 0) break;
    const Box box = *longest;
    const std::size_t channel = std::size_t(box.channel);
    const auto first = list.begin() + std::ptrdiff_t(box.from);
    const auto last = list.begin() + std::ptrdiff_t(box.to);
    int low = 255, high = 0;
    for (auto at = first; at != last; ++at) {
      low = std::min(low, int(at->color[channel]));
      high = std::max(high, int(at->color[channel]));
    }
    const auto cut = std::stable_partition(
        first, last, [&](const ColorCount& c) { return 2 * c.color[channel] < low + high; });
    const std::size_t middle = std::size_t(cut - list.begin());
    *longest = make_box(list, box.from, middle);
    boxes.push_back(make_box(list, middle, box.to));
  }

  PaletteImage result;
  result.width = display.width;
  result.height = display.height;
  std::map<Color, std::uint8_t> index_of;
  if (has_clear || boxes.empty()) {
    result.palette.push_back({0, 0, 0, 0});
    index_of[{0, 0, 0, 0}] = 0;
  }
  for (const Box& box : boxes) {
    for (std::size_t i = box.from; i < box.to; ++i)
      index_of[list[i].color] = std::uint8_t(result.palette.size());
    result.palette.push_back(mean_color(list, box));
  }
  for (int y = 0; y < display.height; ++y)
    for (int x = 0; x < display.width; ++x)
      result.indices.push_back(index_of[byte_color(display.pixel(x, y))]);
  return result;
}

} // namespace openltc::draw
