// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/lobe_panel.h"

#include "openltc/image/colormap.h"
#include "openltc/image/file.h"
#include "openltc/plot/direction_mesh.h"
#include "openltc/plot/sphere_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace openltc::plot {

namespace {

// From between -x and -y: lobes of BRDFs lean towards -x, away from the viewer's side of the
// surface, and so are seen from the front.
constexpr double k_azimuth_degrees = -120, k_elevation_degrees = 32;
constexpr double k_sphere_radius = 47, k_sphere_margin = 1.04;
constexpr double k_lobe_unit = 58;
// The longest that a lobe is drawn, and the farthest that it reaches to the right or left, world
// units.
constexpr double k_lobe_length = 1.3, k_lobe_reach = 1.08;
constexpr int k_sphere_pixels = 208, k_lobe_pixels = 240;

// Whether the solid lobe is in front of a point, or around it: a march towards the viewer.
bool lobe_hides(const View& view, const f64::Lobe& lobe, double scale, Vec3d point) {
  constexpr int k_steps = 500;
  for (int i = 0; i <= k_steps; ++i) {
    const Vec3d at = point + view.towards * (0.002 + 2 * k_lobe_length * i / k_steps);
    const double r = length(at);
    if (!(r > 1e-9) || r < f64::eval_lobe(lobe, at / r) / scale) return true;
  }
  return false;
}

// How long the lobe's peak is drawn: wide lobes are shorter.
double fitting_length(const View& view, const f64::Lobe& lobe, double peak) {
  constexpr int k_rings = 60, k_spokes = 48;
  double reach = 0; // in peaks
  for (int i = 0; i <= k_rings; ++i)
    for (int j = 0; j < k_spokes; ++j) {
      const double t = 0.5 * f64::k_pi * i / k_rings, p = 2 * f64::k_pi * j / k_spokes;
      const Vec3d o(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
      const Vec3d w = normalize(f64::from_cosine(lobe, o));
      reach = std::max(reach, std::abs(dot(view.right, w)) * f64::eval_lobe(lobe, w) / peak);
    }
  return std::min(k_lobe_length, k_lobe_reach / std::max(reach, 1e-3));
}

Status draw_sphere(draw::Figure& figure, Vec2d center, const f64::Lobe& lobe,
                   const LobeFacts& facts) {
  const Space space{
      view_from(k_azimuth_degrees, k_elevation_degrees, k_sphere_margin, k_sphere_margin), center,
      k_sphere_radius};
  const Solid sphere{
      sphere_mesh(lobe,
                  [&](Vec3d w) { return density_color(f64::eval_lobe(lobe, w) / facts.peak); }),
      Finish::plain};
  if (Status status = draw_solids(figure, space, {&sphere, 1}, k_sphere_pixels, true); !status)
    return status;
  const auto is_visible = [&](Vec3d p) { return !sphere_hides(space.view, 1, p); };
  draw_line(figure, space, circle({0, 0, 1}), is_visible, {"#ffffff", 0.9, "", 0.8},
            {"none", 0, "", 0});
  draw_arrow(figure, space, facts.mean_direction, facts.mean_direction * 1.42, is_visible,
             {"ink", 1.5}, {"ink", 0.9, "1.5 2", 0.55});
  return Success{};
}

Status draw_lobe(draw::Figure& figure, Vec2d origin, const LobeMatrix& matrix,
                 const f64::Lobe& lobe, const LobeFacts& facts, bool label_axes) {
  Space space{view_from(k_azimuth_degrees, k_elevation_degrees, 1.34, 0.92), origin, k_lobe_unit};
  // The horizon lies in the lower part of the window.
  constexpr double k_raised = 0.36;
  space.view.center = space.view.up * k_raised;
  space.center.y -= k_raised * k_lobe_unit;
  const double drawn_length = fitting_length(space.view, lobe, facts.peak);
  const double scale = facts.peak / drawn_length;
  const auto is_visible = [&](Vec3d p) { return !lobe_hides(space.view, lobe, scale, p); };
  const std::vector<Vec3d> horizon = circle({0, 0, 1});

  draw_area(figure, space, horizon, filled("rule", 0.4));
  for (const Vec3d axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0)})
    draw_line(figure, space, std::array{-axis, axis}, [](Vec3d) { return true; },
              {"soft", 0.5, "", 0.45}, {});

  const Solid solid{
      lobe_mesh(lobe, scale,
                [&](Vec3d w) { return density_color(f64::eval_lobe(lobe, w) / facts.peak); }),
      Finish::lit};
  if (Status status = draw_solids(figure, space, {&solid, 1}, k_lobe_pixels, false); !status)
    return status;

  draw_line(figure, space, horizon, is_visible, {"soft", 0.8, "", 0.9},
            {"soft", 0.7, "1.5 2.5", 0.5});
  // M is known up to a scale: the longest column is as long as the lobe.
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, length(column(matrix, axis)));
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d tip = column(matrix, axis) * (drawn_length / longest);
    draw_arrow(figure, space, {0, 0, 0}, tip, is_visible, {k_axis_inks[axis], 1.8},
               {k_axis_inks[axis], 1.2, "1.5 2", 0.85});
    const Vec2d at = place(space, tip), start = place(space, {0, 0, 0});
    const Vec2d way = at - start;
    const double l = std::hypot(way.x, way.y);
    if (!label_axes || l < 12) continue;
    const Vec2d label = at + way * (13 / l);
    // Not over the lobe: there is nothing between the viewer and a point far behind it.
    const Vec2d offset = (label - space.center) * (1 / k_lobe_unit);
    if (!is_visible(space.view.center + space.view.right * offset.x - space.view.up * offset.y -
                    space.view.towards * k_lobe_length))
      continue;
    const char* const names[3] = {"*M* x", "*M* y", "*M* z"};
    draw_text(figure, label + Vec2d(0, 3.5), names[axis],
              {10.5, draw::Anchor::middle, k_axis_inks[axis], false, false, 0, true});
  }
  return Success{};
}

} // namespace

Vec3f density_color(double share) {
  const Vec3f c = image::map_color(image::Colormap::viridis, float(share));
  return {image::linear_from_srgb(c.x), image::linear_from_srgb(c.y), image::linear_from_srgb(c.z)};
}

Status draw_lobe_panel(draw::Figure& figure, Vec2d corner, const LobeMatrix& matrix,
                       const LobeFacts& facts, bool label_axes) {
  const f64::Lobe lobe = lobe_of_matrix(matrix);
  if (Status status = draw_sphere(figure, corner + Vec2d(50, 74), lobe, facts); !status)
    return status;
  return draw_lobe(figure, corner + Vec2d(170, 96), matrix, lobe, facts, label_axes);
}

} // namespace openltc::plot
