// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Cameras for scenes that come without: what is in view from a given side.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/view/subject.h"

#include <span>

namespace openltc::scene {

/// Full angle of a framed view over the shorter side of the picture: a 57 mm lens on 24 x 36 mm.
inline constexpr double k_framed_fov_rad = 0.61086523819801535; // 35 degrees

/// The usual side to look from: unit, from the scene to the camera, three quarters and slightly
/// above; the flatter the box is along Z, a chart or a picture, the more from the front.
Vec3d three_quarter_view(const Bounds& bounds);

/// Unit, from the scene to the camera: `azimuth_rad` turns from +Z to +X, `elevation_rad` is above
/// the horizon.
Vec3d view_from(double azimuth_rad, double elevation_rad);

/// A camera that looks along -`back` (unit), at the middle of (0, 0, 0), upright, with the angle
/// over the shorter side. `aspect` is width / height.
Camera camera_along(Vec3d back, double short_fov_rad, float aspect);

/// A camera that looks along -`back` (unit) and shows all `points`, filling the picture but for a
/// rim: `margin` is the size of the picture over that of the points, from 1. `depth` is the least
/// distance to a point, metres. No points give a camera 1 m before the origin.
Camera frame_points(std::span<const Vec3f> points, Vec3d back, float aspect, double margin,
                    double depth);

/// Shows the subject from `back`: with a narrow rim by itself, with more around it when it stands
/// before a backdrop, which then is not cut off before the subject.
Camera frame_subject(std::span<const Vec3f> points, const Subject& subject, Vec3d back,
                     float aspect);

/// The subject of the scene (find_subject) in a three-quarter view, without regard to what may
/// stand in the way; render::choose_view looks for a view without.
Camera frame_scene(const Scene& scene, float aspect);

/// The same for a box of which nothing else is known.
Camera frame_scene(const Bounds& bounds, float aspect);

} // namespace openltc::scene
