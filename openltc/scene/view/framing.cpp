// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/view/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace openltc::scene {

namespace {

constexpr double k_azimuth_rad = 30 * std::numbers::pi / 180;
constexpr double k_elevation_rad = 20 * std::numbers::pi / 180;
constexpr double k_margin = 1.08;          // empty rim around the scene
constexpr double k_margin_on_ground = 1.3; // shadows and a piece of the ground
// Depth over width from which a scene is no chart any more and gets the full three-quarter view.
constexpr double k_solid_depth = 0.3;

// The extents of points in a view, each widened by the view's opening at the point's depth.
struct ViewExtent {
  Vec3d right, up, back; // of the camera
  double tan_x, tan_y;   // of half the opening, less the rim
  double left = -1e300, rightmost = -1e300, bottom = -1e300, top = -1e300;
  double nearest = -1e300;

  void add(Vec3d p) {
    const double x = dot(p, right), y = dot(p, up), towards = dot(p, back);
    rightmost = std::max(rightmost, x + tan_x * towards);
    left = std::max(left, -x + tan_x * towards);
    top = std::max(top, y + tan_y * towards);
    bottom = std::max(bottom, -y + tan_y * towards);
    nearest = std::max(nearest, towards);
  }
};

std::array<Vec3f, 8> corners_of(const Bounds& b) {
  std::array<Vec3f, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = Vec3f(i & 1 ? b.upper.x : b.lower.x, i & 2 ? b.upper.y : b.lower.y,
                       i & 4 ? b.upper.z : b.lower.z);
  return corners;
}

} // namespace

Vec3d view_from(double azimuth_rad, double elevation_rad) {
  return {std::sin(azimuth_rad) * std::cos(elevation_rad), std::sin(elevation_rad),
          std::cos(azimuth_rad) * std::cos(elevation_rad)};
}

Vec3d three_quarter_view(const Bounds& bounds) {
  const Vec3d size = to_double(bounds.upper) - to_double(bounds.lower);
  const double width = std::max(size.x, size.y);
  const double solid = width > 0 ? std::clamp(size.z / (k_solid_depth * width), 0.0, 1.0) : 1.0;
  return view_from(k_azimuth_rad * solid, k_elevation_rad * solid);
}

Camera camera_along(Vec3d back, double short_fov_rad, float aspect) {
  Camera camera;
  camera.name = "framed";
  const Vec3d across = cross(Vec3d(0, 1, 0), back);
  // Straight down or up, the top of the picture lies towards -Z or +Z.
  const Vec3d right = length(across) > 1e-6 ? normalize(across) : Vec3d(1, 0, 0);
  camera.right = to_float(right);
  camera.up = to_float(cross(back, right));
  camera.forward = to_float(-back);
  const double shape = aspect > 0 ? double(aspect) : 1;
  const double tan_short = std::tan(0.5 * short_fov_rad);
  camera.fov_y_rad = float(2 * std::atan(shape >= 1 ? tan_short : tan_short / shape));
  return camera;
}

Camera frame_points(std::span<const Vec3f> points, Vec3d back, float aspect, double margin,
                    double depth) {
  Camera camera = camera_along(back, k_framed_fov_rad, aspect);
  ViewExtent e;
  e.back = back;
  e.right = to_double(camera.right);
  e.up = to_double(camera.up);
  const double tan_y = std::tan(0.5 * double(camera.fov_y_rad));
  e.tan_x = tan_y * (aspect > 0 ? double(aspect) : 1) / margin;
  e.tan_y = tan_y / margin;
  if (points.empty()) {
    camera.position = to_float(back);
    return camera;
  }
  for (const Vec3f& p : points)
    e.add(to_double(p));

  // A point p is in view of a camera at (cx, cy, D) in these axes when
  //   |p_x - cx| <= tan_x (D - p_back), and likewise in y:
  // the right and left extents give cx where they balance, and D where both are just met.
  const double cx = 0.5 * (e.rightmost - e.left), cy = 0.5 * (e.top - e.bottom);
  double distance =
      std::max(0.5 * (e.rightmost + e.left) / e.tan_x, 0.5 * (e.top + e.bottom) / e.tan_y);
  distance = std::max(distance, e.nearest + depth);
  camera.position = to_float(e.right * cx + e.up * cy + e.back * distance);
  camera.near = float(0.5 * (distance - e.nearest));
  return camera;
}

Camera frame_subject(std::span<const Vec3f> points, const Subject& subject, Vec3d back,
                     float aspect) {
  const double margin = subject.has_backdrop ? k_margin_on_ground : k_margin;
  Camera camera = frame_points(points, back, aspect, margin, 0.05 * diagonal(subject.bounds));
  if (subject.has_backdrop) camera.near *= 0.01f; // the ground begins before the subject
  return camera;
}

Camera frame_scene(const Bounds& given, float aspect) {
  Bounds bounds = given;
  if (!(diagonal(bounds) > 0)) {
    bounds.lower = bounds.lower - Vec3f(0.5f);
    bounds.upper = bounds.upper + Vec3f(0.5f);
  }
  return frame_points(corners_of(bounds), three_quarter_view(bounds), aspect, k_margin,
                      0.05 * diagonal(bounds));
}

Camera frame_scene(const Scene& scene, float aspect) {
  const Subject subject = find_subject(scene);
  if (!(diagonal(subject.bounds) > 0)) return frame_scene(scene.bounds, aspect);
  const std::vector<Vec3f> points = points_of(scene, subject);
  return frame_subject(points, subject, three_quarter_view(subject.bounds), aspect);
}

} // namespace openltc::scene
