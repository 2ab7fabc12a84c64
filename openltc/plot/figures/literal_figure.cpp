// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/literal_figure.h"

#include "openltc/draw/axes.h"
#include "openltc/plot/literal_formulas.h"
#include "openltc/table/lobe_table.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <vector>

namespace openltc::plot {

namespace {

constexpr double k_panel_width = 330, k_panel_height = 180;
constexpr double k_column_step = 425, k_row_step = 308;
constexpr double k_f0 = 0.04;         // glass
constexpr double k_view_degrees = 60; // of the lobes

// A line of text in the panel, in the colour of its curve.
struct Label {
  std::string text;
  Vec2d place; // values
  draw::Anchor anchor = draw::Anchor::start;
  int series = 0;
  bool dot = false; // at the place, and the text `shift` pixels from there
  Vec2d shift{-8, -7};
};

struct Sketch {
  draw::Panel panel;
  std::vector<draw::Curve> curves;
  std::vector<Label> labels;
  std::string note;
  double limit = 0; // above it, where positive, no surface can be
};

double cos_degrees(double degrees) { return std::cos(degrees * f64::k_pi / 180); }

f64::FittedLobe fitted_lobe(double roughness) {
  return f64::fetch_lobe(table::builtin_ggx_table().view(), f64::alpha_from_roughness(roughness),
                         cos_degrees(k_view_degrees));
}

draw::Axis angle_axis(const std::string& label) {
  return draw::Axis{label, 0, 90, false, {{0, "0"}, {30, "30"}, {60, "60"}, {90, "90"}}};
}

// Below 0.1 the curves go on as they are, and (e) leaves the page.
draw::Axis roughness_axis() {
  return draw::Axis{
      "roughness √α", 0.1, 1, false, {{0.1, "0.1"}, {0.4, "0.4"}, {0.7, "0.7"}, {1, "1"}}};
}

// Both curves of a slip over equal steps of x.
std::vector<draw::Curve> curves_of(double from, double to, int steps,
                                   const std::function<Slip(double)>& slip) {
  std::vector<draw::Curve> curves = {{"", {}, 0}, {"", {}, 1}};
  for (int i = 0; i <= steps; ++i) {
    const double x = from + (to - from) * i / steps;
    const Slip y = slip(x);
    curves[0].points.push_back(Vec2d(x, y.correct));
    curves[1].points.push_back(Vec2d(x, y.literal));
  }
  return curves;
}

Sketch denominator_sketch() {
  constexpr double k_alpha = 0.1, k_at = 85;
  const auto furnace = [](double degrees) { return white_furnace(k_alpha, cos_degrees(degrees)); };
  Sketch sketch;
  sketch.panel.title = "(a) The denominator, counted twice";
  sketch.panel.x = angle_axis("view angle θ (degrees)");
  sketch.panel.y = draw::Axis{"reflected share of a white sky", 0.1, 100, true, {}};
  sketch.curves = curves_of(0, 89, 89, furnace);
  const Slip at = furnace(k_at);
  sketch.labels = {
      {fmt::format("{:.3f}", at.correct), Vec2d(k_at, at.correct), draw::Anchor::end, 0, true},
      {fmt::format("{:.1f}", at.literal), Vec2d(k_at, at.literal), draw::Anchor::end, 1, true},
      {"D V F", Vec2d(3, 1.2), draw::Anchor::start, 0, false},
      {"D G F / (4 cos θₒ cos θᵢ),  G = V", Vec2d(3, 0.15), draw::Anchor::start, 1, false}};
  sketch.limit = 1;
  sketch.labels.push_back({"more light than came in", Vec2d(3, 35), draw::Anchor::start, 1, false});
  sketch.note = "A white furnace: α = 0.1, F = 1. No surface reflects more than 1. The source's G "
                "already is the visibility V, which holds the denominator.";
  return sketch;
}

Sketch schlick_sketch() {
  constexpr double k_at = 60;
  const auto reflectance = [](double degrees) {
    return fresnel_reflectance(k_f0, cos_degrees(degrees));
  };
  Sketch sketch;
  sketch.panel.title = "(b) Schlick's exponent, inside the bracket";
  sketch.panel.x = angle_axis("angle to the facet's normal (degrees)");
  sketch.panel.y =
      draw::Axis{"Fresnel reflectance F",
                 0,
                 1,
                 false,
                 {{0, "0"}, {0.2, "0.2"}, {0.4, "0.4"}, {0.6, "0.6"}, {0.8, "0.8"}, {1, "1"}}};
  sketch.curves = curves_of(0, 90, 90, reflectance);
  const Slip at = reflectance(k_at);
  sketch.labels = {{fmt::format("{:.3f}", at.correct), Vec2d(k_at, at.correct), draw::Anchor::start,
                    0, true, Vec2d(9, 8)},
                   {fmt::format("{:.3f}", at.literal), Vec2d(k_at, at.literal), draw::Anchor::start,
                    1, true, Vec2d(7, 15)},
                   {"F₀ + (1 − F₀)(1 − cos θ)⁵", Vec2d(25, 0.13), draw::Anchor::start, 0, false},
                   {"F₀ + (1 − F₀)(1 − cos⁵ θ)", Vec2d(43, 0.62), draw::Anchor::start, 1, false}};
  sketch.note = "Glass, F₀ = 0.04. The curve is turned over: at 60° glass becomes a mirror. The "
                "source also has the normal's cosine for that of the half vector.";
  return sketch;
}

Sketch twice_sketch() {
  const auto twice = [](double degrees) { return fresnel_twice(k_f0, cos_degrees(degrees)); };
  Sketch sketch;
  sketch.panel.title = "(c) Fresnel, applied twice";
  sketch.panel.x = angle_axis("angle to the facet's normal (degrees)");
  sketch.panel.y = draw::Axis{"specular reflectance", 0.001, 1, true, {}};
  sketch.curves = curves_of(0, 90, 90, twice);
  const Slip at = twice(0);
  sketch.labels = {{"F", Vec2d(3, 0.055), draw::Anchor::start, 0, false},
                   {"kₛ F, if kₛ = F", Vec2d(3, 0.0023), draw::Anchor::start, 1, false},
                   {fmt::format("at 0°: {:.0f} times too dark", at.correct / at.literal),
                    Vec2d(3, 0.0055), draw::Anchor::start, 1, false}};
  sketch.note = "Glass, F₀ = 0.04. The source has both F and a weight kₛ. F already is the share "
                "that is reflected; where kₛ is set to F, as many do, Fresnel is squared.";
  return sketch;
}

Sketch amplitude_sketch() {
  Sketch sketch;
  sketch.panel.title = "(d) A density without its amplitude";
  sketch.panel.x = roughness_axis();
  sketch.panel.y = draw::Axis{"reflected share of a white sky", 0.01, 3, true, {}};
  sketch.curves =
      curves_of(0.1, 1, 45, [](double r) { return lobe_amplitude(fitted_lobe(r), k_f0); });
  draw::Curve metal{"", {}, 0};
  for (int i = 0; i <= 45; ++i) {
    const double r = 0.1 + 0.9 * i / 45;
    metal.points.push_back(Vec2d(r, lobe_amplitude(fitted_lobe(r), 1).correct));
  }
  sketch.curves.push_back(metal);
  sketch.labels = {{"∫ D dω, for every material", Vec2d(0.12, 1.2), draw::Anchor::start, 1, false},
                   {"E, white metal (F₀ = 1)", Vec2d(0.12, 0.6), draw::Anchor::start, 0, false},
                   {"E, glass (F₀ = 0.04)", Vec2d(0.12, 0.041), draw::Anchor::start, 0, false}};
  sketch.note =
      "θ = 60°. The source has D ≈ ρ cos θ. But D integrates to 1, and ρ cos θ to the albedo, "
      "E = F₀ n₁ + (F₉₀ − F₀) n₅. So ρ cos θ ≈ E D.";
  return sketch;
}

Sketch determinant_sketch() {
  Sketch sketch;
  sketch.panel.title = "(e) A determinant, read as a norm";
  sketch.panel.x = roughness_axis();
  sketch.panel.y = draw::Axis{"integral of D over the sphere", 0.3, 300, true, {}};
  const auto integral = [](double r) { return lobe_integral(fitted_lobe(r).lobe); };
  sketch.curves = curves_of(0.1, 1, 45, integral);
  const double middle = integral(0.5).literal;
  sketch.labels = {{"|det M⁻¹|", Vec2d(0.12, 0.6), draw::Anchor::start, 0, false},
                   {"‖M⁻¹‖", Vec2d(0.3, 40), draw::Anchor::start, 1, false},
                   {fmt::format("{:.1f}", middle), Vec2d(0.5, middle), draw::Anchor::start, 1, true,
                    Vec2d(7, -7)}};
  sketch.note = "θ = 60°, lobes of the built-in table. The source's |M⁻¹| stands beside norms and "
                "looks like one. With a norm, here Frobenius', D is no density.";
  return sketch;
}

Sketch point_light_sketch() {
  constexpr double k_roughness = 0.5;
  const f64::FittedLobe fitted = fitted_lobe(k_roughness);
  const double share = f64::share_above_horizon(fitted.lobe);
  draw::Curve correct{"", {}, 0}, by_length{"", {}, 1}, by_determinant{"", {}, 2};
  for (int i = -90; i <= 90; ++i) {
    const double angle = i * f64::k_pi / 180;
    const Vec3d wi(-std::sin(angle), 0, std::cos(angle));
    correct.points.push_back(Vec2d(i, fitted.n1 * f64::eval_lobe(fitted.lobe, wi) / share));
    by_length.points.push_back(Vec2d(i, literal_point_light(fitted.lobe, wi)));
    by_determinant.points.push_back(Vec2d(i, literal_point_light_by_determinant(fitted.lobe, wi)));
  }
  const PointLightIntegrals integrals = point_light_integrals(fitted.lobe);
  Sketch sketch;
  sketch.panel.title = "(f) A point light without 1/π and amplitude";
  sketch.panel.x = draw::Axis{
      "angle of the light (degrees)",
      -90,
      90,
      false,
      {{-90, "−90"}, {-60, "−60"}, {-30, "−30"}, {0, "0"}, {30, "30"}, {60, "60"}, {90, "90"}}};
  sketch.panel.y = draw::Axis{
      "radiance per irradiance (1/sr)", 0, 16, false, {{0, "0"}, {5, "5"}, {10, "10"}, {15, "15"}}};
  correct.label = fmt::format("n₁ D(ω): integral {:.2f}", fitted.n1);
  by_length.label = fmt::format("with |M⁻¹ω|: integral {:.1f}", integrals.by_length);
  by_determinant.label = fmt::format("with |det M⁻¹|: integral {:.2f}", integrals.by_determinant);
  sketch.curves = {correct, by_length, by_determinant};
  sketch.note = "θ = 60°, roughness 0.5, F = 1, lights in the plane of incidence. The source has "
                "|M⁻¹ω| for the determinant; even with it the integral is π, for any material.";
  return sketch;
}

void draw_sketch(draw::Figure& figure, Sketch& sketch, int column, int row) {
  draw::Panel& panel = sketch.panel;
  panel.corner = Vec2d(55 + column * k_column_step, 56 + row * k_row_step);
  panel.size = Vec2d(k_panel_width, k_panel_height);
  if (sketch.limit > 0)
    draw_rectangle(
        figure, panel.corner,
        Vec2d(k_panel_width, place_in(panel, panel.x.from, sketch.limit).y - panel.corner.y),
        {"none", 1, "", 1, "series1", 0.08});
  draw_axes(figure, panel);
  draw_curves(figure, panel, sketch.curves);
  if (!sketch.curves[0].label.empty())
    draw_legend(figure, panel.corner + Vec2d(14, 22), sketch.curves);
  for (const Label& label : sketch.labels) {
    Vec2d place = place_in(panel, label.place.x, label.place.y);
    const std::string color = fmt::format("series{}", label.series);
    if (label.dot) {
      draw_circle(figure, place, 3.5, {"paper", 1.5, "", 1, color, 1});
      place = place + label.shift;
    }
    draw_text(figure, place, label.text, {11, label.anchor, color, label.dot, false, 0});
  }
  draw_paragraph(figure, panel.corner + Vec2d(0, k_panel_height + 54), k_panel_width, sketch.note,
                 {11, draw::Anchor::start, "soft", false, false, 0});
}

} // namespace

draw::Figure make_literal_figure() {
  draw::Figure figure;
  figure.title = "The source document's formulas, taken literally";
  figure.caption =
      "Dashed: the formulas of docs/source_document.md, taken literally. Solid: corrected.\n"
      "openltc plot literal";
  figure.width = 55 + k_column_step + k_panel_width + 10;
  figure.height = 3 * k_row_step + 24;
  const std::vector<draw::Curve> legend = {{"corrected", {}, 0}, {"the source, literally", {}, 1}};
  draw_legend(figure, Vec2d(55, 12), std::span(legend).first(1));
  draw_legend(figure, Vec2d(175, 12), std::span(legend).last(1));
  Sketch sketches[] = {denominator_sketch(), schlick_sketch(),     twice_sketch(),
                       amplitude_sketch(),   determinant_sketch(), point_light_sketch()};
  for (int i = 0; i < 6; ++i)
    draw_sketch(figure, sketches[i], i % 2, i / 2);
  return figure;
}

} // namespace openltc::plot
