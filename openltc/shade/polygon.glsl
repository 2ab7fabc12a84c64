// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons: the sum over its edges
// (polygon_edges.glsl), or where it is small an expansion around its middle. Its sampling: polygon_points.glsl.
//
// The prelude of each target gives the polygon, the same for all lanes, in world space:
//   int  polygon_point_count(Polygon)            rings one after the other, each closed by
//                                                repeating its first point
//   Vec3 polygon_point(Polygon, int)             world space
//   bool polygon_starts_ring(Polygon, int)
//   Vec3 polygon_origin(Polygon)                 a point of its plane
//   Vec3 polygon_normal(Polygon)                 unit, to the emitting side
//   bool polygon_two_sided(Polygon)
//   bool polygon_is_parallelogram(Polygon)       of four corners; where that is known beforehand
//   Vec3 polygon_half_u(Polygon), polygon_half_v(Polygon)  of one that is: from its middle to that of
//                                                the side from corner 1 to 2, and of that from 2 to 3
//   Real polygon_area(Polygon)                   square metres
//   Vec3 polygon_centroid(Polygon), polygon_spread_u(Polygon), polygon_spread_v(Polygon),
//   Real polygon_radius(Polygon)                 see PolygonMoments; around the centroid

/// A small polygon: where it is in shading space, and how far it spreads.
struct SmallPolygon {
  Vec3 center;      ///< its centroid
  Vec3 u;           ///< its spread, see PolygonMoments
  Vec3 v;           ///< and the one across
  Real radius;      ///< around the centroid
  Real area_height; ///< area times the distance from its plane
};

/// What its small form has of a polygon's integral over one lobe.
struct SmallShare {
  Vec3 sum;      ///< its part of 2 pi times the vector irradiance
  Real by_edges; ///< the share, 0..1, of the sums over the edges, which are the rest
};

/// All by the edges.
FN SmallShare no_small_share() {
  SmallShare share;
  share.sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  share.by_edges = Real(1.0);
  return share;
}

/// Square of the angular radius below which the small form is all, 0.03.
CONSTANT k_wholly_small_radius2 = 0.0009;
/// Square of the one below which it begins, 0.05.
CONSTANT k_small_radius2 = 0.0025;
/// 1 over what lies between, over which the one fades into the other.
CONSTANT k_inv_small_range = 625.0;

/// What a polygon's small form has of its integral: all of one that is small against its distance and wholly above
/// both horizons. With `cut`, what the plane with unit normal `front` may cut is the edges', however small.
///
/// The edge terms of a small polygon nearly cancel, of which rounding makes 1e-7 over its angular
/// radius, and the coordinates' own rounding the same again. So from a twentieth downwards it is handed over, without a
/// step, to its area, centroid and second moments. At p, o = M^-1 p, a solid angle area h / |p|^3 is det |p|^3 / |o|^3
/// times that in cosine space, so that the density makes o / |o|^4 of it (docs/method.md, section 9). The mean of
/// that over the polygon is here to second order around the centroid: with x = o.u / |o|^2, and y for v,
///   (o (1 + 6 (x^2 + y^2) - (u^2 + v^2) / |o|^2) - 2 (x u + y v)) / |o|^4,
/// wrong by the fourth power of the angular radius, or the third of a lopsided one: 2e-6 or 1e-5 at 0.03.
FN_INLINE SmallShare small_share(SmallPolygon small, Lobe lobe, bool cut, Vec3 front) {
  Vec3 o = to_cosine(lobe, small.center);
  Vec3 u = to_cosine(lobe, small.u);
  Vec3 v = to_cosine(lobe, small.v);
  Real inv_o2 = reciprocal(max(dot(o, o), Real(k_tiny)));
  Real reach2 = small.radius * small.radius * lobe_stretch2(lobe) * inv_o2;
  Mask above = small.center.z > small.radius && o.z > Real(0.0) && o.z * o.z * inv_o2 > reach2;
  if (cut) {
    above = above && dot(front, small.center) > small.radius;
  }
  SmallShare share;
  share.by_edges =
      select(above,
             min(max((reach2 - Real(k_wholly_small_radius2)) * Real(k_inv_small_range), Real(0.0)),
                 Real(1.0)),
             Real(1.0));
  Real x = dot(o, u) * inv_o2;
  Real y = dot(o, v) * inv_o2;
  Real middle = Real(1.0) + Real(6.0) * (x * x + y * y) - (dot(u, u) + dot(v, v)) * inv_o2;
  Vec3 mean = o * middle - (u * x + v * y) * Real(2.0);
  Real rest = Real(2.0) * small.area_height * (Real(1.0) - share.by_edges);
  share.sum = select(share.by_edges < Real(1.0), mean * (rest * inv_o2 * (lobe.det * inv_o2)),
                     Vec3(Real(0.0), Real(0.0), Real(0.0)));
  return share;
}

/// EdgeSums.outline2 for what fades into the small form, which lies in one direction.
FN Real small_outline2(EdgeSums sums, Real exact) {
  return Real(1.0) + (sums.outline2 - Real(1.0)) * exact;
}

/// Points of a ring of four corners: the first stands at its end again.
const int k_quad_points = 5;

/// The sign that its edge sums want: -1 in front, 1 behind a two-sided one, else 0. h: signed distance of
/// its plane along its normal.
FN Real lit_side(Polygon polygon, Real h, Vec3 to_origin) {
  Real side = select(h < Real(0.0), Real(-1.0), polygon_two_sided(polygon) ? Real(1.0) : Real(0.0));
  return select(lies_in_plane(h, to_origin, Real(0.0)), Real(0.0), side);
}

/// What a point knows of a polygon before it asks a lobe.
struct PolygonSight {
  Real h;         ///< signed distance of its plane, along its normal
  Real side;      ///< see lit_side
  Vec3 to_center; ///< its centroid, from the point, world space
  Real radius;    ///< around the centroid
  bool large;     ///< whether no lane sees it small, in shading space or in any lobe's cosine space
};

/// Of a point at `position`, world space.
FN PolygonSight see_polygon(Polygon polygon, Vec3 position) {
  PolygonSight sight;
  Vec3 to_origin = polygon_origin(polygon) - position;
  sight.h = dot(to_origin, polygon_normal(polygon));
  sight.side = lit_side(polygon, sight.h, to_origin);
  sight.to_center = polygon_centroid(polygon) - position;
  sight.radius = polygon_radius(polygon);
  // What is not small in shading space is not in cosine space, where its radius counts as much longer as the
  // distance can become.
  sight.large = all_lanes(sight.radius * sight.radius >=
                          Real(k_small_radius2) * dot(sight.to_center, sight.to_center));
  return sight;
}

/// A polygon as that point sees it, for its small form; center: its centroid, shading space.
FN_INLINE SmallPolygon small_polygon(Polygon polygon, PolygonSight sight, Vec3 center,
                                     Frame frame) {
  SmallPolygon small;
  small.center = center;
  small.u = to_shading(frame, polygon_spread_u(polygon));
  small.v = to_shading(frame, polygon_spread_v(polygon));
  small.radius = sight.radius;
  small.area_height = polygon_area(polygon) * abs(sight.h) * abs(sight.side);
  return small;
}

/// The sums over its edges in whichever way suits its outline and what cuts it.
FN_INLINE EdgeSums sum_polygon_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h,
                                     bool cut, Vec3 front) {
  if (one_lane()) {
    if (polygon_is_parallelogram(polygon)) {
      return sum_quad_in_one_lane(polygon, position, frame, lobe, h, cut, front);
    }
    return sum_edges_in_one_lane(polygon, position, frame, lobe, cut, front);
  }
  if (cut) {
    return sum_edges_in_front(polygon, position, frame, lobe, h, front);
  }
  if (polygon_point_count(polygon) == k_quad_points) {
    return sum_quad_edges(polygon, position, frame, lobe, h);
  }
  return sum_edges(polygon, position, frame, lobe, h);
}

/// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
/// behind a one-sided polygon and in the plane of any; whoever knows `position` less well than its
/// last digit asks has_side (surface.glsl) as well. With `cut`, of what is in front of the plane with
/// unit normal `front` (shading space).
///
/// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
/// is the integral; the direction is the mean direction of the part of the polygon that counts,
/// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
FN_INLINE LightIntegral integrate_polygon_part(Polygon polygon, Vec3 position, Frame frame,
                                               Lobe lobe, bool cut, Vec3 front) {
  PolygonSight sight = see_polygon(polygon, position);
  SmallShare diffuse = no_small_share();
  SmallShare specular = diffuse;
  // Uniform shortcut.
  if (!sight.large) {
    SmallPolygon small = small_polygon(polygon, sight, to_shading(frame, sight.to_center), frame);
    diffuse = small_share(small, cosine_lobe(), cut, front);
    specular = small_share(small, lobe, cut, front);
  }

  EdgeSums sums = no_edge_sums();
  // Uniform shortcut: no lane is on a lit side and wants the edges.
  if (any_lane(sight.side != Real(0.0) &&
               (diffuse.by_edges > Real(0.0) || specular.by_edges > Real(0.0)))) {
    sums = sum_polygon_edges(polygon, position, frame, lobe, sight.h, cut, front);
  }
  return light_integral(sums.diffuse * (sight.side * diffuse.by_edges) + diffuse.sum,
                        sums.specular * (sight.side * specular.by_edges) + specular.sum, lobe,
                        small_outline2(sums, specular.by_edges));
}

/// The integrals over a polygon for two lobes.
struct TwoIntegrals {
  LightIntegral first;  ///< and Lambert's
  LightIntegral second; ///< its diffuse part is the first's
};

/// integrate_polygon for two lobes: corners and Lambert's sum serve both.
FN TwoIntegrals integrate_polygon_twice(Polygon polygon, Vec3 position, Frame frame, Lobe first,
                                        Lobe second) {
  PolygonSight sight = see_polygon(polygon, position);
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  SmallShare diffuse = no_small_share();
  SmallShare one = diffuse;
  SmallShare two = diffuse;
  // Uniform shortcut.
  if (!sight.large) {
    SmallPolygon small = small_polygon(polygon, sight, to_shading(frame, sight.to_center), frame);
    diffuse = small_share(small, cosine_lobe(), false, none);
    one = small_share(small, first, false, none);
    two = small_share(small, second, false, none);
  }
  EdgeSums a = no_edge_sums();
  EdgeSums b = a;
  // Uniform shortcut: no lane is on a lit side and wants the edges.
  Real most = max(diffuse.by_edges, max(one.by_edges, two.by_edges));
  if (any_lane(sight.side != Real(0.0) && most > Real(0.0))) {
    a = sum_polygon_edges(polygon, position, frame, first, sight.h, false, none);
    b = sum_polygon_edges(polygon, position, frame, second, sight.h, false, none);
  }
  Vec3 lambert = a.diffuse * (sight.side * diffuse.by_edges) + diffuse.sum;
  TwoIntegrals both;
  both.first = light_integral(lambert, a.specular * (sight.side * one.by_edges) + one.sum, first,
                              small_outline2(a, one.by_edges));
  both.second = light_integral(lambert, b.specular * (sight.side * two.by_edges) + two.sum, second,
                               small_outline2(b, two.by_edges));
  return both;
}

/// integrate_polygon_part over all of it.
FN_INLINE LightIntegral integrate_polygon(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_polygon_part(polygon, position, frame, lobe, false,
                                Vec3(Real(0.0), Real(0.0), Real(1.0)));
}

/// And over what is in front of the plane with unit normal `front` (shading space). A call, so that nearly all
/// groups of points, which no triangle cuts, need not carry it along.
FN_CALL LightIntegral integrate_polygon_in_front(Polygon polygon, Vec3 position, GIVEN(Frame) frame,
                                                 GIVEN(Lobe) lobe, Vec3 front) {
  ASSERT_THAT(is_unit(front));
  return integrate_polygon_part(polygon, position, frame, lobe, true, front);
}

/// Of a polygon over the plane through `position` with that unit normal, world space.
FN_CALL Heights polygon_heights(Polygon polygon, Vec3 position, Vec3 normal) {
  Heights heights;
  heights.low = dot(normal, polygon_point(polygon, 0) - position);
  heights.high = heights.low;
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Real height = dot(normal, polygon_point(polygon, i) - position);
    heights.low = min(heights.low, height);
    heights.high = max(heights.high, height);
  }
  return heights;
}

/// Whether the plane of some lane's triangle may cut a polygon.
FN bool triangle_may_cut(GIVEN(Surface) s, Polygon polygon) {
  return s.tilted && any_lane(dot(s.geometric, polygon_centroid(polygon) - s.position) <
                              polygon_radius(polygon));
}
