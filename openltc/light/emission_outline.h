// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The outline of a flat light in its plane, as its texture's axes lie there, and how much of each
// texel of a grid is inside.

#pragma once

#include "openltc/light/light.h"

#include <algorithm>
#include <vector>

namespace openltc::light {

/// A plane with a frame, orthonormal: the texture's u axis and what is across it. World space,
/// metres.
struct PlaneFrame {
  Vec3d origin, u, v;
  Vec2d in_plane(Vec3d p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
};

/// A rectangle along the axes of a plane's frame, metres; empty until a point is added.
struct PlaneBox {
  Vec2d lower{1e300, 1e300}, upper{-1e300, -1e300};
  void add(Vec2d p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
  }
};

/// A polygon's edges, those of its holes too.
struct PolygonOutline {
  struct Edge {
    Vec2d a, b;
  };
  std::vector<Edge> edges;

  /// What is inside along the line of constant `y`: pairs of x, ascending.
  void spans_at(double y, std::vector<double>& spans) const;
};

/// Points s axis_0 + t axis_1 with s^2 + t^2 <= 1 about a centre.
struct EllipseOutline {
  Vec2d center, axis_0, axis_1;

  /// As PolygonOutline's.
  void spans_at(double y, std::vector<double>& spans) const;
};

/// The frame of a light's plane, `normal` of unit length; `origin` may be anywhere in the plane. v
/// is on the side that the texture's own v axis points to. False if the texture's u axis runs along
/// the normal.
bool make_frame(const Emitter& light, Vec3d origin, Vec3d normal, PlaneFrame& frame);

/// A light's outline in a frame of its plane; what it takes is added to `box`.
PolygonOutline outline_of(const PolygonLight& light, const PlaneFrame& frame, PlaneBox& box);
EllipseOutline outline_of(const EllipseLight& light, const PlaneFrame& frame, PlaneBox& box);

/// The light's share of each texel of the grid over `box`, 0 to 1, row after row: exact along
/// lines, four of them a row.
std::vector<float> coverage(const PolygonOutline& outline, const PlaneBox& box, int columns,
                            int rows);
std::vector<float> coverage(const EllipseOutline& outline, const PlaneBox& box, int columns,
                            int rows);

} // namespace openltc::light
