// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: CIE 102-1993 and the data sheets of the trade: the aim (gamma = 0) points downwards, C0
// and C90 lie to the right, C180 and C270 to the left, C0-C180 is solid and C90-C270 dashed.

#include "openltc/plot/figures/photometry_figure.h"

#include "openltc/base/markup.h"
#include "openltc/light/photometry/photometry_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::plot {

namespace {

constexpr double k_radius = 230, k_side = 44; // of the diagram; room for its labels
constexpr double k_gap = 34, k_facts = 250;
constexpr double k_label = 11;
constexpr double k_dark = 0.005; // of the peak: less than this upwards needs no upper half

using light::PlanePoint;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

struct Diagram {
  Vec2d center{0, 0};
  double outermost = 1; ///< intensity at k_radius
  bool is_whole = false;
};

// Downwards at 0, to the right for positive angles.
Vec2d place_at(const Diagram& diagram, double degrees, double intensity) {
  const double r = k_radius * intensity / diagram.outermost, a = radians(degrees);
  return diagram.center + Vec2d(r * std::sin(a), r * std::cos(a));
}

std::string intensity_label(double value) {
  return value >= 1e5 ? fmt::format("{:.4g}k", value / 1000) : fmt::format("{:.6g}", value);
}

void draw_web(draw::Figure& figure, const Diagram& diagram, const std::vector<double>& rings,
              const std::string& unit) {
  const draw::Pen rule{.color = "rule"};
  const double reach = diagram.is_whole ? 180 : 90;
  for (const double ring : rings) {
    std::vector<Vec2d> arc;
    for (double a = -reach; a <= reach + 1e-9; a += 2)
      arc.push_back(place_at(diagram, a, ring));
    draw_path(figure, arc, {.color = "rule", .width = ring == rings.back() ? 1.4 : 1.0},
              diagram.is_whole);
  }
  for (double a = -reach; a <= reach - (diagram.is_whole ? 15 : 0); a += 15) {
    // Where rays crowd they begin at the first circle.
    const bool is_main = std::abs(std::remainder(a, 90)) < 1e-9;
    draw_line(figure, place_at(diagram, a, is_main ? 0 : rings.front()),
              place_at(diagram, a, diagram.outermost), rule);
    if (std::abs(std::remainder(a, 30)) > 1e-9) continue;
    const double room = k_radius + 12, r = radians(a);
    const Vec2d at = diagram.center + Vec2d(room * std::sin(r), room * std::cos(r));
    const draw::Anchor anchor = std::abs(std::sin(r)) < 0.01 ? draw::Anchor::middle
                                : a > 0                      ? draw::Anchor::start
                                                             : draw::Anchor::end;
    draw_text(figure, at + Vec2d(0, 4), fmt::format("{:g}°", std::abs(a)),
              {k_label, anchor, "soft"});
  }
  // Beside the upright ray of a whole diagram, above the level one of a half.
  for (const double ring : rings) {
    const std::string text =
        intensity_label(ring) + (ring == rings.back() ? " " + unit : std::string());
    if (diagram.is_whole) {
      const Vec2d at = place_at(diagram, 180, ring) + Vec2d(5, 13);
      if (ring != rings.back())
        draw_rectangle(figure, at - Vec2d(2, 10), Vec2d(draw::text_width(text, k_label) + 4, 13),
                       {.color = "none", .fill = "paper", .fill_opacity = 0.8});
      draw_text(figure, at, text, {k_label, draw::Anchor::start, "soft"});
    } else {
      const bool is_last = ring == rings.back();
      draw_text(figure, place_at(diagram, 90, ring) - Vec2d(0, 8), text,
                {k_label, is_last ? draw::Anchor::start : draw::Anchor::middle, "soft"});
    }
  }
}

void draw_curve(draw::Figure& figure, const Diagram& diagram, const std::vector<PlanePoint>& curve,
                double factor, int series) {
  std::vector<Vec2d> points;
  for (const PlanePoint& p : curve) {
    if (!diagram.is_whole && std::abs(p.degrees) > 90 + 1e-9) continue;
    points.push_back(place_at(diagram, p.degrees, factor * p.candela));
  }
  if (series == 0)
    draw_path(figure, points, {.color = "none", .fill = "series0", .fill_opacity = 0.1}, true);
  draw_path(figure, points,
            {.color = series == 0 ? "series0" : "series1",
             .width = 2.2,
             .dash = series == 0 ? "" : "7 4"},
            diagram.is_whole);
}

bool are_alike(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b, double peak) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i].candela - b[i].candela) > 1e-4 * peak) return false;
  return true;
}

std::string angle(double degrees) {
  return degrees >= 360 ? "all around" : fmt::format("{:.1f}°", degrees);
}

const char* words_of(light::PhotometricSymmetry symmetry) {
  switch (symmetry) {
  case light::PhotometricSymmetry::axis:
    return "about the axis";
  case light::PhotometricSymmetry::both:
    return "four quarters alike";
  case light::PhotometricSymmetry::plane_c0:
    return "about C0–C180";
  case light::PhotometricSymmetry::plane_c90:
    return "about C90–C270";
  default:
    return "none";
  }
}

struct Fact {
  std::string what, value;
};

std::vector<Fact> facts_of(const PhotometryOptions& options, const light::PhotometricSummary& s) {
  const light::IesProfile& profile = options.profile;
  std::vector<Fact> facts;
  facts.push_back({"Flux", fmt::format("{:.5g} lm", s.flux_lumens)});
  facts.push_back({"downwards", fmt::format("{:.1f} %", 100 * s.downward_share)});
  if (profile.lamp_lumens > 0)
    facts.push_back({"of the lamps’", fmt::format("{:.5g} lm: {:.1f} %", profile.lamp_lumens,
                                                  100 * s.flux_lumens / profile.lamp_lumens)});
  facts.push_back({"Peak", fmt::format("{:.5g} cd", s.peak_candela)});
  facts.push_back(
      {"at", fmt::format("γ {:.4g}°, C {:.4g}°", s.peak_c.vertical, s.peak_c.horizontal)});
  facts.push_back({"Beam, 50 %", angle(s.beam_degrees[0]) + " / " + angle(s.beam_degrees[1])});
  facts.push_back({"Field, 10 %", angle(s.field_degrees[0]) + " / " + angle(s.field_degrees[1])});
  facts.push_back({"Symmetry", words_of(s.symmetry)});
  if (profile.input_watts > 0)
    facts.push_back({"Power", fmt::format("{:.4g} W, {:.3g} lm/W", profile.input_watts,
                                          s.flux_lumens / profile.input_watts)});
  return facts;
}

} // namespace

std::vector<double> rings_of(double peak) {
  const double step = round_step(peak, 5);
  std::vector<double> rings;
  const int count = std::max(1, int(std::ceil(peak / step - 1e-9)));
  for (int i = 1; i <= count; ++i)
    rings.push_back(i * step);
  return rings;
}

Result<draw::Figure> make_photometry_figure(const PhotometryOptions& options) {
  const light::IesProfile& profile = options.profile;
  if (options.per_kilolumen && !(profile.flux_lumens > 0))
    return Error{profile.name + ": has no flux that intensities could be a share of"};
  const double factor = options.per_kilolumen ? 1000 / profile.flux_lumens : 1;
  const std::string unit = options.per_kilolumen ? "cd/klm" : "cd";
  const light::PhotometricSummary summary = light::summarise(profile);
  const std::vector<PlanePoint> along = light::plane_curve(profile, 0);
  const std::vector<PlanePoint> across = light::plane_curve(profile, 90);
  double largest = 0, largest_up = 0;
  for (const std::vector<PlanePoint>* curve : {&along, &across})
    for (const PlanePoint& p : *curve) {
      largest = std::max(largest, p.candela);
      if (std::abs(p.degrees) > 90 + 1e-9) largest_up = std::max(largest_up, p.candela);
    }
  // Both planes may miss the light.
  const std::vector<double> rings =
      rings_of(factor * (largest > 0 ? largest : profile.max_candela));

  draw::Figure figure;
  figure.title = profile.name;
  Diagram diagram;
  diagram.is_whole = largest_up > k_dark * profile.max_candela;
  diagram.outermost = rings.back();
  const double top = 30;
  diagram.center = Vec2d(k_side + k_radius, top + (diagram.is_whole ? k_radius : 0));
  draw_web(figure, diagram, rings, unit);
  const bool alike = are_alike(along, across, profile.max_candela);
  draw_curve(figure, diagram, along, factor, 0);
  if (!alike) draw_curve(figure, diagram, across, factor, 1);

  const double left = 2 * (k_side + k_radius) + k_gap;
  double y = top + 4;
  const auto legend = [&](const char* text, const draw::Pen& pen) {
    draw_line(figure, Vec2d(left, y - 4), Vec2d(left + 30, y - 4), pen);
    draw_text(figure, Vec2d(left + 38, y), text, {12});
    y += 19;
  };
  const bool is_c = profile.type == light::PhotometricType::c;
  legend(alike  ? "C0–C180 and C90–C270, alike"
         : is_c ? "C0–C180, C0 to the right"
                : "H = 0, V > 0 to the right",
         {.color = "series0", .width = 2.2});
  if (!alike)
    legend(is_c ? "C90–C270, C90 to the right" : "V = 0, H < 0 to the right",
           {.color = "series1", .width = 2.2, .dash = "7 4"});
  y += 14;
  for (const Fact& fact : facts_of(options, summary)) {
    draw_text(figure, Vec2d(left, y), fact.what, {12, draw::Anchor::start, "soft"});
    draw_text(figure, Vec2d(left + 96, y), fact.value, {12});
    y += 19;
  }
  figure.width = left + k_facts;
  figure.height = std::max(diagram.center.y + k_radius + 28, y + 4);
  const char* const letter = is_c ? "C" : profile.type == light::PhotometricType::b ? "B" : "A";
  figure.caption = fmt::format(
      "Luminous intensity in {} over the angle γ from the luminaire’s axis, which points "
      "downwards. "
      "Type {} photometry; flux is the integral over the sphere. Beam and field angle: where "
      "intensity is at least a half and a tenth of its plane’s maximum, in {} / {}.",
      unit, letter, is_c ? "C0–C180" : "H = 0", is_c ? "C90–C270" : "V = 0");
  if (!options.command.empty()) figure.caption += "\n" + options.command;
  return figure;
}

} // namespace openltc::plot
