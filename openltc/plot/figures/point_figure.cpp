// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/point_figure.h"

#include "openltc/draw/axes.h"
#include "openltc/image/tonemap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace openltc::plot {

namespace {

constexpr double k_left = 62, k_width = 260, k_gap = 30, k_bar_room = 84;
constexpr double k_head = 46, k_plot_top = 36, k_plot = 130, k_row_foot = 56;
// Differences count for the scale where there is this share of the brightest light.
constexpr double k_bright = 0.05;
constexpr const char* k_mark = "#e69f00"; // the scan line

Status check(const PointFigureOptions& options) {
  const PointSetup& s = options.setup;
  if (!(s.theta_degrees >= 0 && s.theta_degrees < 90))
    return Error{
        fmt::format("--theta {}: must be from 0 to less than 90 degrees", s.theta_degrees)};
  if (options.roughness.empty() || options.roughness.size() > 4)
    return Error{
        fmt::format("--roughness: {} values; a figure shows 1 to 4", options.roughness.size())};
  for (const double roughness : options.roughness)
    if (!(roughness >= 0.05 && roughness <= 1))
      return Error{fmt::format(
          "--roughness {}: must be from 0.05, below which pictures in single precision tell "
          "nothing, to 1",
          roughness)};
  const std::pair<const char*, double> shares[] = {
      {"--metallic", s.metallic}, {"--base-color", s.base_color}, {"--f0", s.f0}};
  for (const auto& [name, value] : shares)
    if (!(value >= 0 && value <= 1))
      return Error{fmt::format("{} {}: must be from 0 to 1", name, value)};
  return Success{};
}

std::string percent(double x, int digits) {
  return fmt::format("{}{:.{}f} %", x < 0 ? "−" : "+", std::abs(100 * x), digits);
}

// Four digits, without a power of ten where whole numbers do.
std::string luminance(double x) {
  return x >= 1000 ? fmt::format("{:.0f}", x) : fmt::format("{:.4g}", x);
}

// The end of the scale of relative differences: one of a few round shares.
double reach_of(std::span<const ScanPoint> scan, double brightest) {
  double most = 0;
  for (const ScanPoint& p : scan)
    if (p.luminance.exact > k_bright * brightest)
      most = std::max(most, std::abs(p.luminance.relative_difference()));
  for (const double reach : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5})
    if (most <= reach) return reach;
  return 1;
}

draw::Axis percent_axis(const std::string& label, double reach) {
  draw::Axis axis{label, -reach, reach, false, {}};
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
    axis.ticks.push_back({share * reach, share == 0 ? "0"
                                                    : fmt::format("{}{:g}", share < 0 ? "−" : "+",
                                                                  std::abs(share) * reach * 100)});
  return axis;
}

void draw_scan_line(draw::Figure& figure, Vec2d corner, Vec2d size, Scan scan) {
  const draw::Pen pen{.color = k_mark, .width = 1, .dash = "5 4"};
  if (scan == Scan::along)
    draw_line(figure, corner + Vec2d(size.x / 2, 0), corner + Vec2d(size.x / 2, size.y), pen);
  else
    draw_line(figure, corner + Vec2d(0, size.y / 2), corner + Vec2d(size.x, size.y / 2), pen);
}

Result<double> draw_row(draw::Figure& figure, const PointFigureOptions& options,
                        const fit::LobeFunction& lobes, double roughness, double top) {
  const PointView view = frame_highlight(options.setup, roughness);
  const auto pictures = render_point(options.setup, view, roughness, options.source);
  if (!pictures) return pictures.error();
  const auto scan = scan_highlight(options.setup, view, options.scan, roughness, lobes);
  double brightest = 0, highest = 0;
  for (const ScanPoint& p : scan) {
    brightest = std::max(brightest, p.luminance.exact);
    highest = std::max({highest, p.luminance.exact, p.luminance.ltc});
  }
  const double reach = reach_of(scan, brightest);
  const PointLuminance mirror = shade_floor(options.setup, roughness, lobes, Vec2d(0, 0));

  draw_text(figure, Vec2d(k_left, top + 16),
            fmt::format("roughness {:g}: {} at the mirror direction, {} instead of {} cd/m²",
                        roughness, percent(mirror.relative_difference(), 2), luminance(mirror.ltc),
                        luminance(mirror.exact)),
            {.size = 13, .bold = true});
  const Vec2d size(k_width, k_width * view.height / view.width);
  Vec2d corner(k_left, top + k_head);
  const char* names[] = {"exact: D V F cos", "LTC: F n₁ D", "(LTC − exact) / exact"};
  std::vector<double> difference;
  for (std::size_t i = 0; i < pictures->exact.data.size(); ++i)
    difference.push_back(double(pictures->ltc.data[i]) / double(pictures->exact.data[i]) - 1);
  for (int k = 0; k < 3; ++k) {
    draw_text(figure, corner - Vec2d(0, 7), names[k], {.size = 12, .color = "soft"});
    image::Image shown = k == 2
                             ? draw::color_values(difference, view.width, view.height,
                                                  image::Colormap::blue_red, -reach, reach)
                             : image::to_display(k == 0 ? pictures->exact : pictures->ltc,
                                                 float(1.2 / brightest), image::Tonemap::neutral);
    Status ok = k == 2 ? draw_picture(figure, corner, size, draw::reduce_colors(shown, 128))
                       : draw_picture(figure, corner, size, shown);
    if (!ok) return ok.error();
    draw_scan_line(figure, corner, size, options.scan);
    draw_rectangle(figure, corner, size, {.color = "rule", .width = 0.8});
    corner.x += size.x + k_gap;
  }
  if (Status ok = draw_color_bar(figure, corner - Vec2d(k_gap - 12, 0), Vec2d(12, size.y),
                                 image::Colormap::blue_red, percent_axis("difference (%)", reach));
      !ok)
    return ok.error();

  draw::Panel panel;
  panel.corner = Vec2d(k_left, top + k_head + size.y + k_plot_top);
  panel.size = Vec2d(2 * k_width + k_gap - 40, k_plot);
  panel.title = "";
  panel.x = {options.scan == Scan::along
                 ? "position on the floor from the mirror point, towards the light (m)"
                 : "position on the floor from the mirror point, to the right (m)",
             scan.front().position_m,
             scan.back().position_m,
             false,
             {}};
  panel.y = {"luminance (cd/m²)", 0, 1.05 * highest, false, {}};
  draw::Curve exact{"exact", {}, 0}, ltc{"LTC", {}, 1}, relative{"", {}, 2};
  for (const ScanPoint& p : scan) {
    exact.points.push_back(Vec2d(p.position_m, p.luminance.exact));
    ltc.points.push_back(Vec2d(p.position_m, p.luminance.ltc));
    relative.points.push_back(Vec2d(p.position_m, p.luminance.relative_difference()));
  }
  const std::vector<draw::Curve> curves = {exact, ltc};
  draw_axes(figure, panel);
  draw_curves(figure, panel, curves);
  draw_legend(figure, panel.corner + Vec2d(panel.size.x - 90, 16), curves);
  panel.corner.x = k_left + 2 * (k_width + k_gap);
  panel.size.x = k_width;
  panel.x.label = "position (m)";
  panel.x.ticks = ticks_of(panel.x, 4);
  panel.y = percent_axis("difference (%)", reach);
  draw_axes(figure, panel);
  begin_clip(figure, panel.corner, panel.size);
  draw_curves(figure, panel, {&relative, 1});
  end_clip(figure);
  return panel.corner.y + panel.size.y + k_row_foot;
}

} // namespace

Result<draw::Figure> make_point_figure(const PointFigureOptions& options) {
  if (Status ok = check(options); !ok) return ok.error();
  const fit::LobeFunction lobes =
      options.lobes ? options.lobes : fit::lobes_of(table::builtin_ggx_table());
  draw::Figure figure;
  const PointSetup& s = options.setup;
  figure.title = fmt::format("One point light at θ = {:g}°: the exact BRDF and the LTC's density",
                             s.theta_degrees);
  figure.width = k_left + 3 * k_width + 2 * k_gap + k_bar_room;
  double top = 0;
  for (const double roughness : options.roughness) {
    const Result<double> bottom = draw_row(figure, options, lobes, roughness, top);
    if (!bottom) return bottom.error();
    top = *bottom;
  }
  figure.height = std::ceil(top - 10);
  figure.caption = fmt::format(
      "A floor under a light of {:g} cd, seen from the opposite side; light and camera are {:g} m "
      "from the mirror point, in the middle of the pictures. Metallic {:g}, base colour {:g}{}; no "
      "shadow. Lobes: {}. One exposure for both pictures; scales of the difference end where the "
      "scan does above {:g} % of its maximum. The dashed line is the scan.",
      s.intensity_cd, s.distance_m, s.metallic, s.base_color,
      s.metallic < 1 ? fmt::format(", F0 {:g}", s.f0) : "", options.label, 100 * k_bright);
  if (!options.command.empty()) figure.caption += "\n" + options.command;
  return figure;
}

} // namespace openltc::plot
