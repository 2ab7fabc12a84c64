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
constexpr Pen k_unseen = {Ink::none, 0, "", 0};

// The part of a polygon on the viewer's half of the sphere. Cut at that plane its corners still
// follow great circles: the rim is one.
void draw_front(Sketch& sketch, const Space& space, std::span<const Vec3d> corners,
                const Fill& fill) {
  const std::vector<Vec3d> front = clip_to_plane(corners, space.view.towards);
  if (front.size() >= 3) draw_area(sketch, space, outline_on_sphere(front), fill);
}

// What a half sphere hides of the viewer's half.
void veil(Sketch& sketch, const Space& space, Vec3d normal) {
  draw_area(sketch, space, seen_half(-normal, space.view.towards), {Ink::paper, 0.62});
}

void draw_dots(Sketch& sketch, std::span<const Vec2d> places, bool inside) {
  const double size = inside ? 3.2 : 2.2;
  draw_dots(sketch, places, Pen{Ink::black, size + 1.1, "", 0.75});
  draw_dots(sketch, places, Pen{inside ? Ink::signal : Ink::white, size});
}

void draw_samples(Sketch& sketch, const Space& space, const PolygonSpace& polygon, bool inside) {
  std::vector<Vec2d> places;
  for (std::size_t i = 0; i < polygon.samples.size(); ++i)
    if (polygon.inside[i] == inside && !sphere_hides(space.view, 1, polygon.samples[i]))
      places.push_back(place(space, polygon.samples[i]));
  draw_dots(sketch, places, inside);
}

void draw_axis(Sketch& sketch, const Space& space, Vec3d direction, Ink ink, const char* label,
               const Visibility& is_visible, bool even_if_hidden) {
  const Vec3d tip = direction * 1.22;
  if (!is_visible(tip) && !even_if_hidden) return;
  draw_line(sketch, space, segment(direction, tip), is_visible, {ink, 1.3},
            {ink, 0.9, "2 2.5", 0.8});
  const Vec2d at = place(space, tip), way = at - space.center;
  const Vec2d beyond = at + way * (11 / std::max(std::hypot(way.x, way.y), 11.0));
  draw_text(sketch, beyond.x, beyond.y + 4.5, label, {13.5, ink, Anchor::middle});
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

Status draw_polygon_panel(Sketch& sketch, const View& view, Vec2d center, double radius,
                          const PolygonPanel& panel) {
  const Space space{view, center, radius};
  const PolygonSpace& polygon = panel.polygon;
  const Solid sphere{sphere_mesh(panel.lobe,
                                 [&](Vec3d w) {
                                   return density_color(f64::eval_lobe(panel.lobe, w) / panel.peak);
                                 }),
                     Finish::plain};
  if (Status status = draw_solids(sketch, space, {&sphere, 1}, k_pixels, true); !status)
    return status;
  const auto is_visible = [&](Vec3d p) { return !sphere_hides(view, 1, p); };
  const auto always = [](Vec3d) { return true; };

  // What does not count is pale.
  veil(sketch, space, panel.surface_horizon);
  veil(sketch, space, panel.cosine_horizon);
  draw_line(sketch, space, circle(view.towards), always, {Ink::soft, 0.8, "", 0.7}, {});
  for (const Vec3d horizon : {panel.surface_horizon, panel.cosine_horizon})
    draw_front(sketch, space, clip_to_plane(polygon.corners, -horizon), {Ink::soft, 1, true});
  draw_line(sketch, space, circle(panel.surface_horizon), is_visible, {Ink::ink, 1.3, "", 0.95},
            {Ink::ink, 0.8, "2 4", 0.3});
  draw_line(sketch, space, circle(panel.cosine_horizon), is_visible,
            {Ink::ink, 1.3, "8 3 1.5 3", 0.95}, k_unseen);
  draw_line(sketch, space, outline_on_sphere(polygon.corners), is_visible,
            {Ink::ink, 1.3, "5 3", 0.9}, {Ink::ink, 0.9, "2 3", 0.55});

  draw_front(sketch, space, polygon.kept, {Ink::white, 0.14});
  draw_samples(sketch, space, polygon, false);
  const std::vector<Vec3d> kept = outline_on_sphere(polygon.kept);
  draw_line(sketch, space, kept, is_visible, {Ink::black, 3.8, "", 0.6}, k_unseen);
  draw_line(sketch, space, kept, is_visible, {Ink::white, 2.3}, k_unseen);
  draw_samples(sketch, space, polygon, true);

  draw_axis(sketch, space, {1, 0, 0}, Ink::soft, "*x*", is_visible, false);
  draw_axis(sketch, space, {0, 1, 0}, Ink::soft, "*y*", is_visible, false);
  draw_axis(sketch, space, {0, 0, 1}, Ink::soft, "*z*", is_visible, true);
  if (panel.wo) draw_axis(sketch, space, *panel.wo, Ink::orange, "*ω*_{o}", is_visible, true);
  return Success{};
}

void draw_sample_sign(Sketch& sketch, Vec2d at, bool inside) {
  draw_dots(sketch, {&at, 1}, inside);
}

} // namespace openltc::plot
