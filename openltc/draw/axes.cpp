// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/axes.h"

#include "openltc/base/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc::draw {

namespace {

constexpr double k_label_size = 11;

// Dashes of the series: curves are told apart without their colours.
constexpr std::array<const char*, 4> k_dashes = {"", "7 4", "2 4", "10 3 2 3"};

Pen series_pen(int series) {
  Pen pen;
  pen.color = fmt::format("series{}", series % 4);
  pen.width = 2;
  pen.dash = k_dashes[std::size_t(series % 4)];
  return pen;
}

std::string tick_label(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  // As many decimals as the step has: two for 0.05, three for 0.025.
  int decimals = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 8);
  const double in_units = step * std::pow(10.0, decimals);
  if (std::abs(in_units - std::round(in_units)) > 1e-6 * in_units && decimals < 8) ++decimals;
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text[0] == '-') text = "−" + text.substr(1);
  return text;
}

std::string power_label(int exponent) {
  constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent >= -2 && exponent <= 3) return fmt::format("{:g}", std::pow(10.0, exponent));
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent)))
    text += digits[std::size_t(c - '0')];
  return text;
}

} // namespace

std::vector<Tick> ticks_of(const Axis& axis, int count) {
  if (!axis.ticks.empty()) return axis.ticks;
  std::vector<Tick> ticks;
  const double low = std::min(axis.from, axis.to), high = std::max(axis.from, axis.to);
  if (!(high > low)) return ticks;
  if (axis.logarithmic) {
    const int first = int(std::ceil(std::log10(low) - 1e-9));
    const int last = int(std::floor(std::log10(high) + 1e-9));
    const int step = std::max(1, (last - first + count - 1) / std::max(count, 1));
    for (int e = first; e <= last; e += step)
      ticks.push_back({std::pow(10.0, e), power_label(e)});
    return ticks;
  }
  const double step = round_step(high - low, count);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push_back({k * step, tick_label(k * step, step)});
  return ticks;
}

double share_along(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.from) / std::log(axis.to / axis.from);
  return (value - axis.from) / (axis.to - axis.from);
}

Vec2d place_in(const Panel& panel, double x, double y) {
  return Vec2d(panel.corner.x + panel.size.x * share_along(panel.x, x),
               panel.corner.y + panel.size.y * (1 - share_along(panel.y, y)));
}

void draw_axes(Figure& figure, const Panel& panel, bool grid) {
  const double left = panel.corner.x, top = panel.corner.y;
  const double right = left + panel.size.x, bottom = top + panel.size.y;
  const Pen rule{"rule", 1, "", 1, "none", 1}, soft{"soft", 1, "", 1, "none", 1};
  double widest = 0;
  for (const Tick& tick : ticks_of(panel.x, std::max(2, int(panel.size.x / 70)))) {
    const double x = left + panel.size.x * share_along(panel.x, tick.value);
    if (grid) draw_line(figure, Vec2d(x, top), Vec2d(x, bottom), rule);
    draw_line(figure, Vec2d(x, bottom), Vec2d(x, bottom + 4), soft);
    draw_text(figure, Vec2d(x, bottom + 16), tick.label,
              {k_label_size, Anchor::middle, "ink", false, false, 0});
  }
  for (const Tick& tick : ticks_of(panel.y, std::max(2, int(panel.size.y / 40)))) {
    const double y = bottom - panel.size.y * share_along(panel.y, tick.value);
    if (grid) draw_line(figure, Vec2d(left, y), Vec2d(right, y), rule);
    draw_line(figure, Vec2d(left - 4, y), Vec2d(left, y), soft);
    draw_text(figure, Vec2d(left - 7, y + 4), tick.label,
              {k_label_size, Anchor::end, "ink", false, false, 0});
    widest = std::max(widest, text_width(tick.label, k_label_size));
  }
  draw_rectangle(figure, panel.corner, panel.size, soft);
  if (!panel.x.label.empty())
    draw_text(figure, Vec2d((left + right) / 2, bottom + 33), panel.x.label,
              {k_label_size, Anchor::middle, "ink", false, false, 0});
  if (!panel.y.label.empty())
    draw_text(figure, Vec2d(left - 15 - widest, (top + bottom) / 2), panel.y.label,
              {k_label_size, Anchor::middle, "ink", false, false, -90});
  if (!panel.title.empty())
    draw_text(figure, Vec2d(left, top - 8), panel.title,
              {12, Anchor::start, "ink", true, false, 0});
}

void draw_curves(Figure& figure, const Panel& panel, std::span<const Curve> curves) {
  begin_clip(figure, panel.corner - Vec2d(0, 1), panel.size + Vec2d(0, 2));
  for (const Curve& curve : curves) {
    std::vector<Vec2d> piece;
    const auto flush = [&] {
      if (piece.size() > 1) draw_path(figure, piece, series_pen(curve.series));
      piece.clear();
    };
    for (const Vec2d& p : curve.points) {
      Vec2d q = place_in(panel, p.x, p.y);
      if (!std::isfinite(q.x) || !std::isfinite(q.y)) {
        flush();
        continue;
      }
      // Far outside of the panel is outside.
      q.y = std::clamp(q.y, panel.corner.y - 1000, panel.corner.y + panel.size.y + 1000);
      piece.push_back(q);
    }
    flush();
  }
  end_clip(figure);
}

void draw_legend(Figure& figure, Vec2d place, std::span<const Curve> curves) {
  for (const Curve& curve : curves) {
    draw_line(figure, Vec2d(place.x, place.y - 4), Vec2d(place.x + 30, place.y - 4),
              series_pen(curve.series));
    draw_text(figure, Vec2d(place.x + 37, place.y), curve.label,
              {k_label_size, Anchor::start, "ink", false, false, 0});
    place.y += 17;
  }
}

image::Image color_values(std::span<const double> values, int columns, int rows,
                          image::Colormap map, double from, double to) {
  image::Image picture(columns, rows, 4);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    float* pixel = picture.data.data() + 4 * i;
    if (!std::isfinite(values[i])) continue;
    const Vec3f color = image::map_color(map, float((values[i] - from) / (to - from)));
    pixel[0] = color.x;
    pixel[1] = color.y;
    pixel[2] = color.z;
    pixel[3] = 1;
  }
  return picture;
}

Status draw_color_bar(Figure& figure, Vec2d corner, Vec2d size, image::Colormap map,
                      const Axis& axis) {
  const bool lying = size.x > size.y;
  constexpr int k_steps = 128;
  std::vector<double> values(k_steps);
  for (int i = 0; i < k_steps; ++i)
    values[std::size_t(i)] = (lying ? i : k_steps - 1 - i) / double(k_steps - 1);
  const image::Image bar =
      color_values(values, lying ? k_steps : 1, lying ? 1 : k_steps, map, 0, 1);
  if (Status ok = draw_picture(figure, corner, size, bar); !ok) return ok;
  const Pen soft{"soft", 1, "", 1, "none", 1};
  draw_rectangle(figure, corner, size, soft);
  double widest = 0;
  for (const Tick& tick : ticks_of(axis, lying ? 5 : 6)) {
    const double share = share_along(axis, tick.value);
    if (lying) {
      const double x = corner.x + size.x * share, y = corner.y + size.y;
      draw_line(figure, Vec2d(x, y), Vec2d(x, y + 4), soft);
      draw_text(figure, Vec2d(x, y + 16), tick.label,
                {k_label_size, Anchor::middle, "ink", false, false, 0});
    } else {
      const double x = corner.x + size.x, y = corner.y + size.y * (1 - share);
      draw_line(figure, Vec2d(x, y), Vec2d(x + 4, y), soft);
      draw_text(figure, Vec2d(x + 8, y + 4), tick.label,
                {k_label_size, Anchor::start, "ink", false, false, 0});
      widest = std::max(widest, text_width(tick.label, k_label_size));
    }
  }
  if (axis.label.empty()) return Success{};
  if (lying)
    draw_text(figure, Vec2d(corner.x + size.x / 2, corner.y + size.y + 32), axis.label,
              {k_label_size, Anchor::middle, "ink", false, false, 0});
  else
    draw_text(figure, Vec2d(corner.x + size.x + 22 + widest, corner.y + size.y / 2), axis.label,
              {k_label_size, Anchor::middle, "ink", false, false, -90});
  return Success{};
}

} // namespace openltc::draw
