// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where a figure looks at directions and solids from: one projection for the renderer's camera and
// for what is drawn over its picture.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/target/vec.h"

#include <functional>
#include <span>
#include <vector>

namespace openltc::plot {

/// Parallel projection onto a window around `center`. World space is the figure's own: z up.
struct View {
  Vec3d right{1, 0, 0}, up{0, 0, 1}; ///< unit, perpendicular
  Vec3d towards{0, -1, 0};           ///< unit, to the viewer: right x up
  Vec3d center{0, 0, 0};
  double half_width = 1, half_height = 1; ///< of the window, world units
};

/// The viewer stands at `azimuth_degrees` from x towards y and `elevation_degrees` above the plane
/// z = 0; z points up in the picture. Elevations of 90 degrees and more are not meant.
View view_from(double azimuth_degrees, double elevation_degrees, double half_width = 1,
               double half_height = 1);

/// Position in the window: (-1, -1) is its lower left, (1, 1) its upper right corner; z is the
/// height over the plane through the centre, towards the viewer, in world units.
Vec3d project(const View& view, Vec3d point);

/// The inverse of project.
Vec3d unproject(const View& view, Vec3d projected);

/// The renderer's camera of that view, for a picture whose sides are as those of the window.
scene::Camera camera_of(const View& view);

/// A part of a line, all seen or all hidden.
struct Stroke {
  std::vector<Vec3d> points;
  bool visible = true;
};

/// Cuts a line into its seen and hidden parts, at most 1e-4 of a segment beside the true place.
/// Segments shorter than what hides them find every change.
std::vector<Stroke> cut_by_visibility(std::span<const Vec3d> line,
                                      const std::function<bool(Vec3d)>& is_visible);

/// Whether a sphere around the origin hides a point from the viewer. Points on it, to a thousandth,
/// count as outside.
bool sphere_hides(const View& view, double radius, Vec3d point);

} // namespace openltc::plot
