// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/fit_figure.h"

#include "openltc/draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace openltc::plot {

namespace {

constexpr std::size_t k_most = 6; // cells along an axis
constexpr double k_decades = 3;   // below the brightest point, on the logarithmic scale
constexpr double k_left = 64, k_head = 42, k_note = 18, k_gap = 5, k_cell_gap = 22, k_row_gap = 12;
constexpr double k_foot = 62; // the two colour bars
constexpr double k_none = std::numeric_limits<double>::quiet_NaN();

double log_share(double x) { return x > 0 ? 1 + std::log10(x) / k_decades : 0; }

// What a colour map of 0..1 or -1..1 shows for a share of the brightest point.
double shown(double x, bool linear) { return linear ? x : std::clamp(log_share(x), 0.0, 1.0); }
double shown_signed(double x, bool linear, double reach) {
  if (linear) return x / reach;
  const double size = std::clamp(log_share(std::abs(x)), 0.0, 1.0);
  return x < 0 ? -size : size;
}

Status check(const FitFigureOptions& options) {
  if (options.theta_degrees.empty() || options.theta_degrees.size() > k_most)
    return Error{fmt::format("--theta: {} angles; a figure shows 1 to {}",
                             options.theta_degrees.size(), k_most)};
  if (options.roughness.empty() || options.roughness.size() > k_most)
    return Error{fmt::format("--roughness: {} values; a figure shows 1 to {}",
                             options.roughness.size(), k_most)};
  for (const double theta : options.theta_degrees)
    if (!(theta >= 0 && theta < 90))
      return Error{fmt::format("--theta {}: must be from 0 to less than 90 degrees", theta)};
  for (const double roughness : options.roughness)
    if (!(roughness >= 0 && roughness <= 1))
      return Error{fmt::format("--roughness {}: must be from 0 to 1", roughness)};
  return Success{};
}

// The horizon, the mirror direction (a cross) and the view direction (a ring), cut at the window.
void draw_marks(draw::Figure& figure, const FitCell& cell, Vec2d corner, double side) {
  begin_clip(figure, corner, Vec2d(side, side));
  const double scale = side / (2 * cell.window.half);
  const Vec2d center = corner + Vec2d(side / 2 - cell.window.center_x * scale, side / 2);
  draw_circle(figure, center, scale, {.color = "soft", .width = 1});
  const double x = fit::mirror_in_disc(std::cos(cell.theta_degrees * f64::k_pi / 180)) * scale;
  const draw::Pen pen{.color = "#d04a02", .width = 1.1};
  const Vec2d mirror = center + Vec2d(x, 0);
  draw_line(figure, mirror - Vec2d(4, 0), mirror + Vec2d(4, 0), pen);
  draw_line(figure, mirror - Vec2d(0, 4), mirror + Vec2d(0, 4), pen);
  draw_circle(figure, center - Vec2d(x, 0), 3, pen);
  end_clip(figure);
  if (cell.window.is_zoomed())
    draw_rectangle(figure, corner, Vec2d(side, side), {.color = "rule", .width = 0.8});
}

Status draw_disc(draw::Figure& figure, const FitCell& cell, Vec2d corner, double side, int pixels,
                 const std::vector<double>& values, image::Colormap map, double from) {
  image::Image picture = draw::color_values(values, pixels, pixels, map, from, 1);
  if (Status ok = draw_picture(figure, corner, Vec2d(side, side), draw::reduce_colors(picture, 96));
      !ok)
    return ok;
  draw_marks(figure, cell, corner, side);
  return Success{};
}

Status draw_cell(draw::Figure& figure, const FitCell& cell, Vec2d corner, double side, int pixels,
                 bool linear, double reach) {
  std::vector<double> brdf, lobe, difference = relative_difference(cell);
  for (std::size_t i = 0; i < cell.brdf.size(); ++i) {
    const bool above = cell.brdf[i] >= 0;
    brdf.push_back(above ? shown(cell.brdf[i] / cell.brightest, linear) : k_none);
    lobe.push_back(above ? shown(cell.lobe[i] / cell.brightest, linear) : k_none);
    difference[i] = above ? shown_signed(difference[i], linear, reach) : k_none;
  }
  const Vec2d step(side + k_gap, 0);
  const Vec2d top = corner + Vec2d(0, k_note);
  if (Status ok = draw_disc(figure, cell, top, side, pixels, brdf, image::Colormap::viridis, 0);
      !ok)
    return ok;
  if (Status ok =
          draw_disc(figure, cell, top + step, side, pixels, lobe, image::Colormap::viridis, 0);
      !ok)
    return ok;
  if (Status ok = draw_disc(figure, cell, top + step * 2.0, side, pixels, difference,
                            image::Colormap::blue_red, -1);
      !ok)
    return ok;
  std::string note = fmt::format("TV {:.4f}, L2 {:.4f}, peak {:.4f}", cell.error.tv, cell.error.l2,
                                 cell.error.peak);
  if (cell.window.is_zoomed()) note += fmt::format(", ×{:.3g}", 1.02 / cell.window.half);
  draw_text(figure, corner + Vec2d(0, k_note - 6), note, {.size = 11});
  return Success{};
}

} // namespace

Result<draw::Figure> make_fit_figure(const FitFigureOptions& options) {
  if (Status ok = check(options); !ok) return ok.error();
  const std::size_t columns = options.roughness.size(), rows = options.theta_degrees.size();
  const double side = columns <= 1 ? 200 : columns <= 2 ? 130 : 88;
  const int pixels = int(side * (columns <= 2 ? 1.0 : 1.1));
  const auto cells = make_fit_cells(options.brdf, options.lobes,
                                    {options.roughness, options.theta_degrees}, pixels);
  if (!cells) return cells.error();

  // The linear scale of differences: the largest of all cells, rounded up to tenths.
  double reach = 0.01;
  for (const FitCell& cell : *cells)
    for (const double d : relative_difference(cell))
      reach = std::max(reach, std::abs(d));
  reach = std::ceil(reach * 20 - 1e-9) / 20;

  draw::Figure figure;
  figure.title =
      fmt::format("{}: the BRDF's lobe, the fitted one, and their difference", options.brdf.name);
  const double cell_width = 3 * side + 2 * k_gap, cell_height = k_note + side;
  figure.width =
      std::max(k_left + double(columns) * cell_width + double(columns - 1) * k_cell_gap + 4, 560.0);
  for (std::size_t column = 0; column < columns; ++column) {
    const double x = k_left + double(column) * (cell_width + k_cell_gap);
    if (options.brdf.has_parameter())
      draw_text(figure, Vec2d(x + cell_width / 2, 14),
                fmt::format("roughness {:g}", options.roughness[column]),
                {.size = 13, .anchor = draw::Anchor::middle, .bold = true});
    const char* names[] = {"ρ/E", "D", "D − ρ/E"};
    for (int k = 0; k < 3; ++k)
      draw_text(figure, Vec2d(x + side / 2 + k * (side + k_gap), 33), names[k],
                {.size = 12, .anchor = draw::Anchor::middle, .color = "soft", .italic = true});
  }
  for (std::size_t row = 0; row < rows; ++row) {
    const double y = k_head + double(row) * (cell_height + k_row_gap);
    draw_text(figure, Vec2d(0, y + k_note + side / 2 + 4),
              fmt::format("θ = {:g}°", options.theta_degrees[row]), {.size = 13, .bold = true});
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = k_left + double(column) * (cell_width + k_cell_gap);
      if (Status ok = draw_cell(figure, (*cells)[row * columns + column], Vec2d(x, y), side, pixels,
                                options.linear, reach);
          !ok)
        return ok.error();
    }
  }
  const double y = k_head + double(rows) * (cell_height + k_row_gap) + 10;
  const double bar_width = std::min(220.0, figure.width / 2 - k_left);
  draw::Axis lobes{"density (share of the brightest point of ρ/E)", 0, 1, false, {}};
  draw::Axis differences{"difference (share of the same)", -1, 1, false, {}};
  if (options.linear) {
    differences.ticks = {
        {-1, fmt::format("−{:g}", reach)}, {0, "0"}, {1, fmt::format("{:g}", reach)}};
  } else {
    lobes.ticks = {{0, "≤ 1/1000"}, {1 / 3.0, "1/100"}, {2 / 3.0, "1/10"}, {1, "1"}};
    differences.ticks = {
        {-1, "−1"}, {-2 / 3.0, "−1/10"}, {0, "≤ 1/1000"}, {2 / 3.0, "1/10"}, {1, "1"}};
  }
  if (Status ok = draw_color_bar(figure, Vec2d(k_left, y), Vec2d(bar_width, 12),
                                 image::Colormap::viridis, lobes);
      !ok)
    return ok.error();
  if (Status ok = draw_color_bar(figure, Vec2d(k_left + bar_width + 70, y), Vec2d(bar_width, 12),
                                 image::Colormap::blue_red, differences);
      !ok)
    return ok.error();
  figure.height = std::ceil(y + k_foot);
  figure.caption = fmt::format(
      "The hemisphere from above, equal areas for equal solid angles; the outer circle is the "
      "horizon, + the mirror direction, o the view direction. Lobes: {}, {}. Colours are {}, "
      "for each cell by itself. × says how far a cell is zoomed in on its lobe.",
      options.lobes.label,
      options.lobes.horizon == fit::Horizon::clipped ? "divided by their share above the horizon"
                                                     : "as they are, with their leak lost",
      options.linear ? "linear" : "logarithmic over three decades");
  if (!options.command.empty()) figure.caption += "\n" + options.command;
  return figure;
}

} // namespace openltc::plot
