// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/sphere_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::plot {

namespace {

constexpr double k_step_rad = 0.04;
constexpr int k_circle_points = 180, k_segment_points = 48;

} // namespace

std::vector<Vec3d> great_arc(Vec3d a, Vec3d b) {
  a = normalize(a);
  b = normalize(b);
  const double angle = std::atan2(length(cross(a, b)), dot(a, b));
  if (angle < 1e-9) return {a, b};
  const int parts = std::max(2, int(std::ceil(angle / k_step_rad)));
  std::vector<Vec3d> points;
  for (int i = 0; i <= parts; ++i) {
    const double t = angle * i / parts;
    points.push_back((a * std::sin(angle - t) + b * std::sin(t)) / std::sin(angle));
  }
  return points;
}

std::vector<Vec3d> outline_on_sphere(std::span<const Vec3d> corners) {
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::vector<Vec3d> arc = great_arc(corners[i], corners[(i + 1) % corners.size()]);
    points.insert(points.end(), arc.begin() + (i > 0 ? 1 : 0), arc.end());
  }
  return points;
}

std::vector<Vec3d> circle(Vec3d normal, double radius, Vec3d center) {
  const Vec3d other = std::abs(normal.z) < 0.9 * length(normal) ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
  const Vec3d u = normalize(cross(other, normal)), v = normalize(cross(normal, u));
  std::vector<Vec3d> points;
  for (int i = 0; i <= k_circle_points; ++i) {
    const double t = 2 * std::numbers::pi * (i % k_circle_points) / k_circle_points;
    points.push_back(center + (u * std::cos(t) + v * std::sin(t)) * radius);
  }
  return points;
}

std::vector<Vec3d> segment(Vec3d a, Vec3d b) {
  std::vector<Vec3d> points;
  for (int i = 0; i <= k_segment_points; ++i)
    points.push_back(a + (b - a) * (double(i) / k_segment_points));
  return points;
}

std::vector<Vec3d> seen_half(Vec3d normal, Vec3d towards) {
  // A lune between the planes of both, whose corners are +-axis.
  const Vec3d axis = normalize(cross(towards, normal));
  Vec3d on_plane = cross(normal, axis), on_rim = cross(towards, axis);
  if (dot(on_plane, towards) < 0) on_plane = -on_plane;
  if (dot(on_rim, normal) < 0) on_rim = -on_rim;
  std::vector<Vec3d> points;
  constexpr int k_half = k_circle_points / 2;
  for (int i = 0; i <= k_half; ++i) {
    const double t = std::numbers::pi * i / k_half;
    points.push_back(axis * std::cos(t) + on_plane * std::sin(t));
  }
  for (int i = 1; i <= k_half; ++i) {
    const double t = std::numbers::pi * i / k_half;
    points.push_back(on_rim * std::sin(t) - axis * std::cos(t));
  }
  return points;
}

} // namespace openltc::plot
