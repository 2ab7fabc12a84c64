// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/polygon_panel.h"

#include "openltc/plot/direction_mesh.h"
#include "openltc/plot/lobe_panel.h"
#include "openltc/plot/sphere_lines.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace openltc::plot {

namespace {

constexpr double k_margin = 1.02; // of the picture around the sphere
constexpr int k_pixels = 640;
const draw::Pen k_unseen = {"none", 0, "", 0};

// The part of a polygon on the viewer's half of the sphere. Cut at that plane its corners still
// follow great circles: the rim is one.
void draw_front(draw::Figure& figure, const Space& space, std::span<const Vec3d> corners,
                const draw::Pen& style) {
  const std::vector<Vec3d> front = clip_to_plane(corners, space.view.towards);
  if (front.size() >= 3) draw_area(figure, space, outline_on_sphere(front), style);
}

// What a half sphere hides of the viewer's half.
void veil(draw::Figure& figure, const Space& space, Vec3d normal) {
  draw_area(figure, space, seen_half(-normal, space.view.towards), filled("paper", 0.62));
}

void draw_dots(draw::Figure& figure, std::span<const Vec2d> places, bool inside) {
  const double size = inside ? 3.2 : 2.2;
  draw_dots(figure, places, draw::Pen{"#000000", size + 1.1, "", 0.75});
  draw_dots(figure, places, draw::Pen{inside ? "#ff7a45" : "#ffffff", size});
}

void draw_samples(draw::Figure& figure, const Space& space, const PolygonSpace& polygon,
                  bool inside) {
  std::vector<Vec2d> places;
  for (std::size_t i = 0; i < polygon.samples.size(); ++i)
    if (polygon.inside[i] == inside && !sphere_hides(space.view, 1, polygon.samples[i]))
      places.push_back(place(space, polygon.samples[i]));
  draw_dots(figure, places, inside);
}

void draw_axis(draw::Figure& figure, const Space& space, Vec3d direction, const char* ink,
               const char* label, const Visibility& is_visible, bool even_if_hidden) {
  const Vec3d tip = direction * 1.22;
  if (!is_visible(tip) && !even_if_hidden) return;
  draw_line(figure, space, segment(direction, tip), is_visible, {ink, 1.3},
            {ink, 0.9, "2 2.5", 0.8});
  const Vec2d at = place(space, tip), way = at - space.center;
  const Vec2d beyond = at + way * (11 / std::max(std::hypot(way.x, way.y), 11.0));
  draw_text(figure, beyond + Vec2d(0, 4.5), label,
            {13.5, draw::Anchor::middle, ink, false, false, 0, true});
}

} // namespace

View polygon_view(const PolygonEquivalence& spaces, Vec3d lobe_direction) {
  Vec3d sum = lobe_direction;
  for (const PolygonSpace* space : {&spaces.shading, &spaces.cosine})
    for (const Vec3d& corner : space->kept)
      sum += normalize(corner) / double(space->kept.size());
  const double across = std::hypot(sum.x, sum.y);
  // Right above there is no side to look from; then the one of figures of lobes.
  const double azimuth = across > 0.05 ? std::atan2(sum.y, sum.x) * 180 / f64::k_pi : -120;
  const double height = std::atan2(sum.z, across) * 180 / f64::k_pi;
  return view_from(azimuth, height > 60 ? 50 : 31, k_margin, k_margin);
}

Status draw_polygon_panel(draw::Figure& figure, const View& view, Vec2d center, double radius,
                          const PolygonPanel& panel) {
  const Space space{view, center, radius};
  const PolygonSpace& polygon = panel.polygon;
  const Solid sphere{sphere_mesh(panel.lobe,
                                 [&](Vec3d w) {
                                   return density_color(f64::eval_lobe(panel.lobe, w) / panel.peak);
                                 }),
                     Finish::plain};
  if (Status status = draw_solids(figure, space, {&sphere, 1}, k_pixels, true); !status)
    return status;
  const auto is_visible = [&](Vec3d p) { return !sphere_hides(view, 1, p); };
  const auto always = [](Vec3d) { return true; };

  // What does not count is pale.
  veil(figure, space, panel.surface_horizon);
  veil(figure, space, panel.cosine_horizon);
  draw_line(figure, space, circle(view.towards), always, {"soft", 0.8, "", 0.7}, {});
  for (const Vec3d horizon : {panel.surface_horizon, panel.cosine_horizon})
    draw_front(figure, space, clip_to_plane(polygon.corners, -horizon), filled(k_hatch));
  draw_line(figure, space, circle(panel.surface_horizon), is_visible, {"ink", 1.3, "", 0.95},
            {"ink", 0.8, "2 4", 0.3});
  draw_line(figure, space, circle(panel.cosine_horizon), is_visible,
            {"ink", 1.3, "8 3 1.5 3", 0.95}, k_unseen);
  draw_line(figure, space, outline_on_sphere(polygon.corners), is_visible, {"ink", 1.3, "5 3", 0.9},
            {"ink", 0.9, "2 3", 0.55});

  draw_front(figure, space, polygon.kept, filled("#ffffff", 0.14));
  draw_samples(figure, space, polygon, false);
  const std::vector<Vec3d> kept = outline_on_sphere(polygon.kept);
  draw_line(figure, space, kept, is_visible, {"#000000", 3.8, "", 0.6}, k_unseen);
  draw_line(figure, space, kept, is_visible, {"#ffffff", 2.3}, k_unseen);
  draw_samples(figure, space, polygon, true);

  draw_axis(figure, space, {1, 0, 0}, "soft", "*x*", is_visible, false);
  draw_axis(figure, space, {0, 1, 0}, "soft", "*y*", is_visible, false);
  draw_axis(figure, space, {0, 0, 1}, "soft", "*z*", is_visible, true);
  if (panel.wo) draw_axis(figure, space, *panel.wo, "series1", "*ω*_{o}", is_visible, true);
  return Success{};
}

void define_hatch(draw::Figure& figure) {
  figure.body += "<pattern id=\"hatch\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
                 "patternTransform=\"rotate(45)\"><path class=\"s-soft\" stroke-width=\"1.5\" "
                 "stroke-opacity=\".8\" d=\"M0 3h6\"/></pattern>\n";
}

void draw_sample_sign(draw::Figure& figure, Vec2d at, bool inside) {
  draw_dots(figure, {&at, 1}, inside);
}

} // namespace openltc::plot
