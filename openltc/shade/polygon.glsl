// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons: the sum over its edges
// (polygon_edges.glsl), or where it is small four parts that stand for it. Its sampling: polygon_points.glsl.
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
//   Real polygon_area(Polygon)                   square metres
//   Vec3 polygon_centroid(Polygon), polygon_spread_u(Polygon), polygon_spread_v(Polygon),
//   Real polygon_radius(Polygon)                 see PolygonMoments; around the centroid

/// A small polygon: where it is in shading space, and how far it spreads.
struct SmallPolygon {
  Vec3 center;      ///< its centroid
  Vec3 u;           ///< its spread, see PolygonMoments
  Vec3 v;           ///< and the one across
  Real area_height; ///< area times the distance from its plane
};

/// 2 pi times the vector irradiance of a part of a light around p: its density times its solid
/// angle (docs/method.md, section 9). A solid angle area h / |p|^3 is det |p|^3 / |o|^3 times that in cosine
/// space, o = M^-1 p.
FN Vec3 small_part_term(Vec3 p, Real area_height, Lobe lobe) {
  Vec3 o = to_cosine(lobe, p);
  Real inv_o2 = Real(1.0) / max(dot(o, o), Real(k_tiny));
  return o * (Real(2.0) * area_height * inv_o2 * (lobe.det * inv_o2));
}

/// 2 pi times the vector irradiance of a polygon that is small against its distance and wholly above
/// both horizons: four parts, which have its area, centroid and second moments.
FN Vec3 sum_small_polygon(SmallPolygon small, Lobe lobe) {
  Real quarter = Real(0.25) * small.area_height;
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 across = small.u;
  for (int i = 0; i < 2; ++i) {
    sum = sum + small_part_term(small.center + across, quarter, lobe) +
          small_part_term(small.center - across, quarter, lobe);
    across = small.v;
  }
  return sum;
}

/// Square of the angular radius below which the small form begins, 0.05.
CONSTANT k_small_radius2 = 0.0025;
/// Angular radius below which it is all.
CONSTANT k_wholly_small_radius = 0.03;
/// 1 over what lies between, over which the one fades into the other.
CONSTANT k_inv_small_range = 50.0;

/// How much of the edge sums a polygon wants, 0 to 1; the rest is its small form.
///
/// The edge terms of a small polygon nearly cancel, of which rounding makes 1e-7 over its angular
/// radius, and the coordinates' own rounding the same again. So from a twentieth downwards it is
/// handed over, without a step, to its small form, which is wrong by the fourth power of that radius.
FN Real polygon_exactness(Vec3 center, Real radius, Lobe lobe) {
  Vec3 o = to_cosine(lobe, center);
  Real reach2 = radius * radius * lobe_stretch2(lobe);
  Real o2 = max(dot(o, o), Real(k_tiny));
  // Uniform shortcut: no lane sees it small.
  if (all_lanes(reach2 >= Real(k_small_radius2) * o2)) {
    return Real(1.0);
  }
  Real reach = sqrt(reach2);
  Real inv_o = inversesqrt(o2);
  Real exact =
      min(max((reach * inv_o - Real(k_wholly_small_radius)) * Real(k_inv_small_range), Real(0.0)),
          Real(1.0));
  Mask above = center.z > radius && o.z > reach;
  return select(above, exact, Real(1.0));
}

/// What the small form has of a polygon, of which `exact` is its edges' (polygon_exactness).
FN Vec3 small_rest(SmallPolygon small, Lobe lobe, Real exact) {
  return select(exact < Real(1.0), sum_small_polygon(small, lobe) * (Real(1.0) - exact),
                Vec3(Real(0.0), Real(0.0), Real(0.0)));
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

/// A polygon as a point sees it, for its small form; side: see lit_side.
FN SmallPolygon small_polygon(Polygon polygon, Vec3 center, Frame frame, Real h, Real side) {
  SmallPolygon small;
  small.center = center;
  small.u = to_shading(frame, polygon_spread_u(polygon));
  small.v = to_shading(frame, polygon_spread_v(polygon));
  small.area_height = polygon_area(polygon) * abs(h) * abs(side);
  return small;
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

/// polygon_exactness of a polygon whose centroid is at `center`, shading space; what the plane with unit normal
/// `front` may cut is summed by its edges, however small.
FN Real exactness_in_front(Vec3 center, Real radius, Lobe lobe, bool cut, Vec3 front) {
  Real exact = polygon_exactness(center, radius, lobe);
  if (cut) {
    exact = select(dot(front, center) > radius, exact, Real(1.0));
  }
  return exact;
}

/// The sums over its edges in whichever way suits its outline and what cuts it.
FN EdgeSums sum_polygon_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h,
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
FN LightIntegral integrate_polygon_part(Polygon polygon, Vec3 position, Frame frame, Lobe lobe,
                                        bool cut, Vec3 front) {
  PolygonSight sight = see_polygon(polygon, position);
  Vec3 center = sight.to_center;
  Real exact_diffuse = Real(1.0);
  Real exact_specular = Real(1.0);
  // Uniform shortcut.
  if (!sight.large) {
    center = to_shading(frame, sight.to_center);
    exact_diffuse = exactness_in_front(center, sight.radius, cosine_lobe(), cut, front);
    exact_specular = exactness_in_front(center, sight.radius, lobe, cut, front);
  }

  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  sums.outline2 = Real(1.0);
  // Uniform shortcuts: no lane is on a lit side, or wants one form or the other.
  Mask lit = sight.side != Real(0.0);
  if (any_lane(lit && (exact_diffuse > Real(0.0) || exact_specular > Real(0.0)))) {
    sums = sum_polygon_edges(polygon, position, frame, lobe, sight.h, cut, front);
    sums.diffuse = sums.diffuse * (sight.side * exact_diffuse);
    sums.specular = sums.specular * (sight.side * exact_specular);
  }
  if (any_lane(lit && (exact_diffuse < Real(1.0) || exact_specular < Real(1.0)))) {
    SmallPolygon small = small_polygon(polygon, center, frame, sight.h, sight.side);
    sums.diffuse = sums.diffuse + small_rest(small, cosine_lobe(), exact_diffuse);
    sums.specular = sums.specular + small_rest(small, lobe, exact_specular);
  }
  return light_integral(sums.diffuse, sums.specular, lobe, small_outline2(sums, exact_specular));
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
  Vec3 center = sight.to_center;
  Real exact_diffuse = Real(1.0);
  Real exact_first = Real(1.0);
  Real exact_second = Real(1.0);
  // Uniform shortcut.
  if (!sight.large) {
    center = to_shading(frame, sight.to_center);
    exact_diffuse = polygon_exactness(center, sight.radius, cosine_lobe());
    exact_first = polygon_exactness(center, sight.radius, first);
    exact_second = polygon_exactness(center, sight.radius, second);
  }
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  EdgeSums a;
  a.diffuse = none;
  a.specular = none;
  a.outline2 = Real(1.0);
  EdgeSums b = a;
  // Uniform shortcuts: no lane is on a lit side, or wants one form or the other.
  Mask lit = sight.side != Real(0.0);
  Real most = max(exact_diffuse, max(exact_first, exact_second));
  if (any_lane(lit && most > Real(0.0))) {
    a = sum_polygon_edges(polygon, position, frame, first, sight.h, false, none);
    b = sum_polygon_edges(polygon, position, frame, second, sight.h, false, none);
    a.diffuse = a.diffuse * (sight.side * exact_diffuse);
    a.specular = a.specular * (sight.side * exact_first);
    b.specular = b.specular * (sight.side * exact_second);
  }
  Real least = min(exact_diffuse, min(exact_first, exact_second));
  if (any_lane(lit && least < Real(1.0))) {
    SmallPolygon small = small_polygon(polygon, center, frame, sight.h, sight.side);
    a.diffuse = a.diffuse + small_rest(small, cosine_lobe(), exact_diffuse);
    a.specular = a.specular + small_rest(small, first, exact_first);
    b.specular = b.specular + small_rest(small, second, exact_second);
  }
  TwoIntegrals both;
  both.first = light_integral(a.diffuse, a.specular, first, small_outline2(a, exact_first));
  both.second = light_integral(a.diffuse, b.specular, second, small_outline2(b, exact_second));
  return both;
}

/// integrate_polygon_part over all of it.
FN LightIntegral integrate_polygon(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
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
