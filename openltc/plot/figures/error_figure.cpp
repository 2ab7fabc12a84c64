// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/error_figure.h"

#include "openltc/base/markup.h"
#include "openltc/draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace openltc::plot {

namespace {

constexpr double k_side_of_one = 320, k_side_of_two = 200; // a map's width; 3/4 of it high
constexpr double k_left = 52, k_gap = 22; // room for the labels of y, and between two maps
constexpr double k_bar_gap = 12, k_bar = 12, k_bar_room = 96;
constexpr double k_head = 30, k_row_head = 42, k_row_foot = 20;
// Colours end where 2 % of the cells lie beyond: a few cells would take the scale from all others.
constexpr double k_shown = 0.98;
constexpr double k_least_top = 1e-4; // of a scale, where nothing errs

Vec2d side_of(std::size_t maps) {
  const double width = maps > 1 ? k_side_of_two : k_side_of_one;
  return Vec2d(width, 0.75 * width);
}

struct NormText {
  std::string_view name;
  const char* title;
  const char* unit;
};

constexpr std::array<NormText, 9> k_texts = {{
    {"tv", "Total variation: energy in the wrong place", "TV (share of the energy)"},
    {"bound", "Bound of the error of any light", "bound (share of its radiance)"},
    {"l1", "Relative L1 distance", "L1 (relative to the BRDF's)"},
    {"l2", "Relative L2 distance", "L2 (relative to the BRDF's)"},
    {"l3", "Relative L3 distance", "L3 (relative to the BRDF's)"},
    {"peak", "Error of the peak", "peak (relative to the BRDF's)"},
    {"leak", "Leak: lobe below the surface", "leak (share of the lobe)"},
    {"n1", "Error of the amplitude n1", "n1 (albedo)"},
    {"n5", "Error of the amplitude n5", "n5 (albedo)"},
}};

NormText text_of(const fit::LobeErrorField& norm) {
  for (const NormText& text : k_texts)
    if (text.name == norm.name) return text;
  return {norm.name, norm.name, norm.name};
}

std::vector<double> values_of(const fit::ErrorMap& map, const fit::LobeErrorField& norm) {
  std::vector<double> values;
  for (const fit::LobeError& cell : map.cells)
    values.push_back(cell.*norm.member);
  return values;
}

// As fit::summarise takes it.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size() - 1))];
}

std::vector<double> sizes(std::vector<double> values) {
  for (double& v : values)
    v = std::abs(v);
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values)
    sum += v;
  return sum / double(values.size());
}

// The round end of a scale that shows all of these values but a few.
double top_of(const std::vector<double>& values) {
  const double top = std::max(quantile(values, k_shown), k_least_top);
  const double step = round_step(top, 4);
  return step * std::ceil(top / step - 1e-9);
}

std::string number(double x, bool with_sign = false) {
  const double size = std::abs(x);
  std::string text = size == 0     ? "0"
                     : size < 1e-4 ? fmt::format("{:.1e}", size)
                                   : fmt::format("{:.{}f}", size, size < 0.01 ? 5 : 4);
  return x < 0 ? "−" + text : with_sign && x > 0 ? "+" + text : text;
}

std::string shortened(std::string text, double width, double size) {
  if (draw::text_width(text, size) <= width) return text;
  while (!text.empty() && draw::text_width(text + "…", size) > width) {
    // Whole characters of UTF-8.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0u) == 0x80u)
      text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

// The axis of the maps is uniform where their cells are; its ticks are round angles.
draw::Axis angle_axis(const fit::MeasureOptions& region) {
  const auto place = [&](double degrees) {
    return region.angle_axis == table::AngleAxis::theta
               ? degrees
               : std::sqrt(1 - std::cos(degrees * f64::k_pi / 180));
  };
  draw::Axis axis;
  axis.from = 0;
  axis.to = place(region.theta_to_degrees);
  for (int degrees = 0; degrees <= region.theta_to_degrees; degrees += 20)
    axis.ticks.push_back({place(degrees), fmt::format("{}", degrees)});
  return axis;
}

draw::Panel panel_at(const ErrorFigureOptions& options, Vec2d corner, bool first_column,
                     bool last_row) {
  draw::Panel panel;
  panel.corner = corner;
  panel.size = side_of(options.lobes.size());
  panel.x.from = options.region.roughness_from;
  panel.x.to = options.region.roughness_to;
  panel.x.ticks = ticks_of(panel.x, 5);
  panel.y = angle_axis(options.region);
  if (first_column)
    panel.y.label = "view angle θ (degrees)";
  else
    for (draw::Tick& tick : panel.y.ticks)
      tick.label.clear();
  if (last_row)
    panel.x.label = "roughness";
  else
    for (draw::Tick& tick : panel.x.ticks)
      tick.label.clear();
  return panel;
}

// A map in its panel. Rows of a map begin at the normal, those of a picture on top.
Status draw_map(draw::Figure& figure, const draw::Panel& panel, const fit::ErrorMap& map,
                const std::vector<double>& values, image::Colormap colors, double from, double to) {
  const std::size_t columns = map.columns(), rows = map.rows();
  std::vector<double> from_top;
  for (std::size_t row = rows; row-- > 0;)
    for (std::size_t column = 0; column < columns; ++column)
      from_top.push_back(values[row * columns + column]);
  const image::Image picture =
      draw::color_values(from_top, int(columns), int(rows), colors, from, to);
  if (Status ok = draw_picture(figure, panel.corner, panel.size, picture, false); !ok) return ok;
  draw_axes(figure, panel, false);
  return Success{};
}

void draw_note(draw::Figure& figure, const draw::Panel& panel, const std::string& note) {
  draw_text(figure, panel.corner - Vec2d(0, 7), note,
            {11, draw::Anchor::start, "soft", false, false, 0});
}

Status draw_row(draw::Figure& figure, const ErrorFigureOptions& options,
                std::span<const fit::ErrorMap> maps, const fit::LobeErrorField& norm, double top,
                bool last_row) {
  const NormText text = text_of(norm);
  draw_text(figure, Vec2d(k_left, top + 14), text.title,
            {12.5, draw::Anchor::start, "ink", true, false, 0});
  std::vector<std::vector<double>> values;
  std::vector<double> all;
  for (const fit::ErrorMap& map : maps) {
    values.push_back(values_of(map, norm));
    all.insert(all.end(), values.back().begin(), values.back().end());
  }
  const double end = top_of(all);
  const Vec2d side = side_of(maps.size()), bar(k_bar, side.y);
  Vec2d corner(k_left, top + k_row_head);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const draw::Panel panel = panel_at(options, corner, i == 0, last_row);
    if (Status ok = draw_map(figure, panel, maps[i], values[i], image::Colormap::magma, 0, end);
        !ok)
      return ok;
    const fit::TableError error = fit::summarise(maps[i]);
    draw_note(figure, panel,
              fmt::format("mean {}, p95 {}", number(error.mean.*norm.member),
                          number(error.p95.*norm.member)));
    corner.x += side.x + k_gap;
  }
  corner.x += k_bar_gap - k_gap;
  draw::Axis scale{text.unit, 0, end, false, {}};
  if (Status ok = draw_color_bar(figure, corner, bar, image::Colormap::magma, scale);
      !ok || maps.size() < 2)
    return ok;

  std::vector<double> difference = values[1];
  for (std::size_t i = 0; i < difference.size(); ++i)
    difference[i] -= values[0][i];
  const double reach = top_of(sizes(difference));
  corner.x += k_bar_room;
  const draw::Panel panel = panel_at(options, corner, false, last_row);
  if (Status ok =
          draw_map(figure, panel, maps[0], difference, image::Colormap::blue_red, -reach, reach);
      !ok)
    return ok;
  draw_note(figure, panel,
            fmt::format("mean {}, p95 of size {}", number(mean(difference), true),
                        number(quantile(sizes(difference), 0.95))));
  corner.x += side.x + k_bar_gap;
  scale = {"difference", -reach, reach, false, {}};
  return draw_color_bar(figure, corner, bar, image::Colormap::blue_red, scale);
}

} // namespace

Result<fit::LobeErrorField> find_norm(const std::string& name) {
  std::string names;
  for (const fit::LobeErrorField& field : fit::lobe_error_fields()) {
    if (name == field.name) return field;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", field.name);
  }
  return Error{fmt::format("no norm is named '{}'; there are: {}", name, names)};
}

Result<std::vector<fit::ErrorMap>> measure_errors(const ErrorFigureOptions& options) {
  if (options.lobes.empty() || options.lobes.size() > 2)
    return Error{"a figure of errors compares one or two sets of lobes"};
  if (options.norms.empty()) return Error{"a figure of errors needs at least one norm"};
  for (const std::string& name : options.norms)
    if (const Result<fit::LobeErrorField> norm = find_norm(name); !norm) return norm.error();
  if (!(options.region.roughness_from < options.region.roughness_to))
    return Error{"a figure of errors needs a range of roughness, the lower first"};
  return fit::measure_maps(options.brdf, options.lobes, fit::midpoint_axes(options.region),
                           options.region.quadrature);
}

Result<draw::Figure> make_error_figure(const ErrorFigureOptions& options) {
  const Result<std::vector<fit::ErrorMap>> maps = measure_errors(options);
  if (!maps) return maps.error();
  const bool two = maps->size() == 2;
  draw::Figure figure;
  figure.title = fmt::format("{}: error over roughness and view angle", options.brdf.name);
  const Vec2d side = side_of(maps->size());
  figure.width = k_left + side.x + k_bar_gap + k_bar_room;
  if (two) figure.width += side.x + k_gap + side.x + k_bar_gap + k_bar_room;

  // Whose lobes: above each column.
  double x = k_left;
  for (const fit::MeasuredLobes& lobes : options.lobes) {
    draw_text(figure, Vec2d(x, 16), shortened(lobes.label, side.x, 12),
              {12, draw::Anchor::start, "ink", false, true, 0});
    x += side.x + k_gap;
  }
  if (two)
    draw_text(figure, Vec2d(x - k_gap + k_bar_gap + k_bar_room, 16), "second − first",
              {12, draw::Anchor::start, "ink", false, true, 0});

  double top = k_head;
  for (std::size_t i = 0; i < options.norms.size(); ++i) {
    const bool last = i + 1 == options.norms.size();
    const Result<fit::LobeErrorField> norm = find_norm(options.norms[i]);
    if (Status ok = draw_row(figure, options, *maps, *norm, top, last); !ok) return ok.error();
    top += k_row_head + side.y + k_row_foot;
  }
  figure.height = top + 18; // labels of the last row's axes
  figure.caption = fmt::format(
      "{} points per axis, uniform in roughness {:g} to {:g} and in √(1 − cos θ) up to {:g}°. "
      "Bright is bad; the scales end where 2 % of the cells lie beyond. p95: 95th percentile.{}",
      options.region.points, options.region.roughness_from, options.region.roughness_to,
      options.region.theta_to_degrees,
      two ? " On the right, blue: the second errs less; red: more." : "");
  if (!options.command.empty()) figure.caption += "\n" + options.command;
  return figure;
}

} // namespace openltc::plot
