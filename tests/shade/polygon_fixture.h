// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons for the tests, and their integrals by brute force.

#pragma once

#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"

#include <vector>

namespace openltc::testing {

using Ring =
    std::vector<Vec2d>; ///< outer rings counter-clockwise about the normal, holes clockwise

/// Owner of a PolygonView's arrays.
class TestPolygon {
public:
  /// Rings in the plane through `origin` spanned by orthonormal `axis_u`, `axis_v`.
  TestPolygon(const std::vector<Ring>& rings, Vec3d origin, Vec3d axis_u, Vec3d axis_v,
              bool two_sided = false);

  const PolygonView& view() const { return view_; }
  TestPolygon(const TestPolygon&) = delete;
  TestPolygon& operator=(const TestPolygon&) = delete;

private:
  std::vector<float> points_, in_plane_;
  PolygonView view_;
};

Ring rectangle(double width, double height, Vec2d center = {0, 0});
Ring l_shape(double size);
Ring star(int spikes, double outer, double inner);
Ring reversed(Ring ring);

/// Integral of the lobe's density over the polygon seen from `position`, both horizons honoured:
/// signed triangles of the polygon's plane, clipped, and Gauss points refined until they agree.
/// Nothing in it is shared with integrate_polygon but the density itself. With `front`, only what
/// lies in front of the plane through `position` of that normal, world space.
double brute_force_integral(const PolygonView& polygon, Vec3d position, const f64::Frame& frame,
                            const f64::Lobe& lobe, double tolerance, const Vec3d* front = nullptr);

/// Whether a point of the plane lies inside the outline: sum of the signed angles that its edges
/// subtend, 2 pi inside and 0 outside.
bool inside_by_winding(const PolygonView& polygon, Vec2d point);

/// A shading point: frame and position at random, and a lobe of the kind that fits give.
struct Setting {
  f64::Frame frame;
  f64::Lobe lobe;
  Vec3d position;
};
Setting random_setting(Random& random, double alpha);

/// One of five shapes about 1.5 across, kind 0..4: rectangle, L, star, rectangle with a hole, two
/// separate outlines.
std::vector<Ring> shape(int kind);

/// A plane near the position, facing it; near enough for many outlines to straddle a horizon.
struct Plane {
  Vec3d origin, u, v;
};
Plane random_plane(Random& random, Vec3d position);

} // namespace openltc::testing
