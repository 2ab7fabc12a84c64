// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons of any outline are four-component vectors that the caller provides, one polygon after the
// other:
//   0  number of points, two-sided (0 or 1), area, 0
//   1  origin: a point of its plane, 0
//   2, 3  not read
//   4  normal: unit, to the emitting side, 0
//   5  centroid of its area, distance of the farthest point from there
//   6  spread u, 0     7  spread v, 0
//   8 and on: its points, 1 where a ring begins, else 0
// Rings run counter-clockwise as seen from the front, holes clockwise, and each ends with its first point
// again. The spreads are sqrt(2) times the standard deviations of the area along its principal axes, as
// vectors; for a rectangle those are half of its sides times sqrt(2/3).

/// Number of points.
FN int polygon_point_count(Polygon polygon) { return int(polygon_data(polygon, 0).x); }

/// Whether it emits to both sides.
FN bool polygon_two_sided(Polygon polygon) { return polygon_data(polygon, 0).y != Real(0.0); }

/// Square metres.
FN Real polygon_area(Polygon polygon) { return polygon_data(polygon, 0).z; }

/// A point of its plane.
FN Vec3 polygon_origin(Polygon polygon) { return polygon_data(polygon, 1).xyz; }

/// Unit, to the emitting side.
FN Vec3 polygon_normal(Polygon polygon) { return polygon_data(polygon, 4).xyz; }

/// The middle of its area.
FN Vec3 polygon_centroid(Polygon polygon) { return polygon_data(polygon, 5).xyz; }

/// The distance of the farthest point from there.
FN Real polygon_radius(Polygon polygon) { return polygon_data(polygon, 5).w; }

/// How far it spreads.
FN Vec3 polygon_spread_u(Polygon polygon) { return polygon_data(polygon, 6).xyz; }

/// And across.
FN Vec3 polygon_spread_v(Polygon polygon) { return polygon_data(polygon, 7).xyz; }

/// Point i.
FN Vec3 polygon_point(Polygon polygon, int i) { return polygon_data(polygon, 8 + i).xyz; }

/// Whether a ring begins with it.
FN bool polygon_starts_ring(Polygon polygon, int i) {
  return polygon_data(polygon, 8 + i).w != Real(0.0);
}
