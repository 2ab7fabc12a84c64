// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/figure.h"

#include "openltc/base/markup.h"
#include "openltc/draw/palette.h"
#include "openltc/image/colormap.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace openltc::fit {

namespace {

// Palette entry 0 is transparent; 1..255 run along the colour map. What is not a number is 1.
std::uint8_t palette_index(double t) {
  if (!std::isfinite(t)) return 1;
  return std::uint8_t(1 + std::lround(254 * std::clamp(t, 0.0, 1.0)));
}

std::string png_uri(std::vector<std::uint8_t> indices, int width, int height, image::Colormap map) {
  draw::PaletteImage picture{width, height, std::move(indices), {{0, 0, 0, 0}}};
  const auto byte = [](float x) { return std::uint8_t(std::lround(255.0f * x)); };
  for (int i = 0; i < 255; ++i) {
    const Vec3f c = image::map_color(map, float(i) / 254.0f);
    picture.palette.push_back({byte(c.x), byte(c.y), byte(c.z), 255});
  }
  const Result<std::vector<std::uint8_t>> png = draw::encode_png(picture);
  return png ? "data:image/png;base64," + base64(*png) : ""; // only memory can be missing
}

std::string line(double x0, double y0, double x1, double y1, const char* style) {
  return fmt::format("<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>",
                     style, x0, y0, x1, y1);
}

std::string label_at(double x, double y, const char* style, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>", style, x, y,
                     markup_text(text));
}

// A vertical colour bar: labels from bottom to top.
std::string vertical_bar(image::Colormap map,
                         const std::vector<std::pair<double, std::string>>& labels) {
  std::vector<std::uint8_t> indices;
  for (int i = 0; i < 64; ++i)
    indices.push_back(palette_index(1 - i / 63.0));
  std::string svg = "<svg class=\"bar\" viewBox=\"0 0 74 176\" width=\"74\" height=\"176\" "
                    "role=\"img\" aria-label=\"colour scale\">";
  svg += fmt::format("<image x=\"4\" y=\"8\" width=\"10\" height=\"160\" "
                     "preserveAspectRatio=\"none\" href=\"{}\"/>",
                     png_uri(indices, 1, 64, map));
  for (const auto& [t, text] : labels) {
    const double y = 168 - 160 * t;
    svg += line(14, y, 18, y, "tick") + label_at(21, y + 3.5, "label", text);
  }
  return svg + "</svg>";
}

} // namespace

std::string html_number(double x) {
  if (!std::isfinite(x)) return "–";
  const double size = std::abs(x);
  if (size == 0) return "0";
  if (size < 1e-4) return fmt::format("{:.1e}", x);
  if (size < 1e-2) return fmt::format("{:.5f}", x);
  return size < 10 ? fmt::format("{:.4f}", x) : fmt::format("{:.1f}", x);
}

std::string heat_map(const ErrorMap& map, const MeasureOptions& region, const LobeErrorField& field,
                     double top, std::size_t region_index, std::size_t candidate_index,
                     const std::string& label) {
  constexpr double left = 46, upper = 6, side = 180;
  const auto columns = map.columns(), rows = map.rows();
  std::vector<std::uint8_t> indices;
  for (std::size_t row = rows; row-- > 0;) // grazing angles on top
    for (std::size_t column = 0; column < columns; ++column)
      indices.push_back(palette_index(map.at(column, row).*field.member / top));
  std::string svg = fmt::format(
      "<svg class=\"map\" viewBox=\"0 0 240 222\" width=\"240\" height=\"222\" role=\"img\" "
      "aria-label=\"{}\" data-region=\"{}\" data-candidate=\"{}\" data-field=\"{}\">",
      markup_text(label), region_index, candidate_index, field.name);
  svg += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                     "preserveAspectRatio=\"none\" href=\"{}\"/>",
                     left, upper, side, side,
                     png_uri(indices, int(columns), int(rows), image::Colormap::magma));
  svg += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", left,
                     upper, side, side);
  svg += "<rect class=\"cursor\" width=\"0\" height=\"0\"/>";
  const double low = region.roughness_from, high = region.roughness_to;
  const double step = round_step(high - low, 5);
  for (double r = std::ceil(low / step - 1e-9) * step; r <= high + 1e-9; r += step) {
    const double x = left + side * (r - low) / (high - low);
    svg += line(x, upper + side, x, upper + side + 4, "tick") +
           label_at(x, upper + side + 15, "label middle", fmt::format("{:.4g}", r));
  }
  svg += label_at(left + side / 2, upper + side + 30, "label middle", "roughness");
  for (int degrees = 0; degrees <= 90; degrees += 30) {
    // The axis is where the cells are: equidistant in theta or in sqrt(1 - cos theta).
    const double top_degrees = region.theta_to_degrees;
    const auto place = [&](double d) {
      const double radians = d * f64::k_pi / 180;
      return region.angle_axis == table::AngleAxis::theta ? d : std::sqrt(1 - std::cos(radians));
    };
    const double share = std::min(place(degrees) / place(top_degrees), 1.0);
    const double y = upper + side * (1 - share);
    svg += line(left - 4, y, left, y, "tick") +
           label_at(left - 7, y + 3.5, "label end", fmt::format("{}°", degrees));
  }
  svg += fmt::format("<text class=\"label middle\" transform=\"translate(9 {}) rotate(-90)\">view "
                     "angle θ</text>",
                     upper + side / 2);
  return svg + "</svg>";
}

std::string color_bar(double top) {
  std::string svg = "<svg class=\"bar\" viewBox=\"0 0 240 36\" width=\"240\" height=\"36\" "
                    "role=\"img\" aria-label=\"colour scale\">";
  std::vector<std::uint8_t> indices;
  for (int i = 0; i < 64; ++i)
    indices.push_back(palette_index(i / 63.0));
  svg += fmt::format("<image x=\"46\" y=\"2\" width=\"180\" height=\"10\" "
                     "preserveAspectRatio=\"none\" href=\"{}\"/>",
                     png_uri(indices, 64, 1, image::Colormap::magma));
  const double step = round_step(top, 4);
  for (double v = 0; v <= top * 1.0001; v += step) {
    const double x = 46 + 180 * v / top;
    svg += line(x, 12, x, 16, "tick") + label_at(x, 28, "label middle", fmt::format("{:.3g}", v));
  }
  return svg + "</svg>";
}

std::string lobe_disc(const LobePicture& picture, const WorstCell& cell, const std::string& label) {
  constexpr double side = 170, margin = 3;
  std::vector<std::uint8_t> indices;
  for (const double density : picture.disc) {
    if (density < 0) {
      indices.push_back(0);
      continue;
    }
    const double t = density > 0 ? 1 + std::log10(density / cell.peak) / 3 : 0;
    indices.push_back(palette_index(t));
  }
  std::string svg = fmt::format("<svg class=\"disc\" viewBox=\"0 0 176 176\" width=\"176\" "
                                "height=\"176\" role=\"img\" aria-label=\"{}\">",
                                markup_text(label));
  svg += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"{}\"/>", margin, margin, side,
      side, png_uri(indices, WorstCell::k_side, WorstCell::k_side, image::Colormap::viridis));
  // The horizon and the mirror direction, in a nested viewport that cuts what lies outside.
  const double scale = side / (2 * cell.window.half);
  const double center_x = side / 2 - cell.window.center_x * scale, center_y = side / 2;
  const double mirror = mirror_in_disc(std::cos(cell.theta_degrees * f64::k_pi / 180));
  const double mirror_x = center_x + mirror * scale;
  svg +=
      fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">", margin, margin, side, side);
  svg += fmt::format("<circle class=\"horizon\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>",
                     center_x, center_y, scale);
  svg += line(mirror_x - 5, center_y, mirror_x + 5, center_y, "mirror") +
         line(mirror_x, center_y - 5, mirror_x, center_y + 5, "mirror");
  return svg + "</svg></svg>";
}

std::string disc_color_bar() {
  return vertical_bar(image::Colormap::viridis,
                      {{0, "≤ 1/1000"}, {1 / 3.0, "1/100"}, {2 / 3.0, "1/10"}, {1, "peak"}});
}

std::string lobe_cuts(const WorstCell& cell) {
  constexpr double left = 36, upper = 8, width = 300, height = 130;
  const double low = cell.cut_degrees.front(), high = cell.cut_degrees.back();
  double top = cell.peak;
  for (const double v : cell.brdf.cut)
    top = std::max(top, v);
  for (const LobePicture& lobe : cell.lobes)
    for (const double v : lobe.cut)
      top = std::max(top, v);
  top = std::min(top, 3 * cell.peak) * 1.05 / cell.peak;
  std::string svg = "<svg class=\"cut\" viewBox=\"0 0 344 176\" width=\"344\" height=\"176\" "
                    "role=\"img\" aria-label=\"density in the plane of incidence\">";
  const double y_step = round_step(top, 4);
  for (double v = 0; v <= top; v += y_step) {
    const double y = upper + height * (1 - v / top);
    svg += line(left, y, left + width, y, "grid") +
           label_at(left - 6, y + 3.5, "label end", fmt::format("{:.3g}", v));
  }
  const double step = round_step(high - low, 6);
  for (double d = std::ceil(low / step - 1e-9) * step; d <= high + 1e-9; d += step) {
    const double x = left + width * (d - low) / (high - low);
    svg += line(x, upper + height, x, upper + height + 4, "tick") +
           label_at(x, upper + height + 15, "label middle",
                    fmt::format("{:.4g}°", std::abs(d) < 1e-9 ? 0.0 : d));
  }
  svg += label_at(left + width / 2, upper + height + 31, "label middle",
                  "direction in the plane of incidence, from the normal");
  const auto curve = [&](const std::vector<double>& values, const std::string& style) {
    std::string points;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double x = left + width * double(i) / double(values.size() - 1);
      const double v = std::isfinite(values[i]) ? std::min(values[i] / cell.peak, top) : 0;
      points += fmt::format("{:.1f},{:.1f} ", x, upper + height * (1 - v / top));
    }
    return fmt::format("<polyline class=\"{}\" points=\"{}\"/>", style, points);
  };
  svg += curve(cell.brdf.cut, "curve brdf");
  for (std::size_t c = 0; c < cell.lobes.size(); ++c)
    svg += curve(cell.lobes[c].cut, fmt::format("curve series{}", c % 4));
  return svg + "</svg>";
}

} // namespace openltc::fit
