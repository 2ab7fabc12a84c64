// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons.
//
// Sources:
//   Lambert 1760; Baum, Rushmeier, Winget 1989, "Improving Radiosity Solutions Through the Use of
//     Analytically Determined Form-Factors", equation 9 (edge sum);
//   Heitz, Dupuy, Hill, Neubelt 2016, equations 4 to 11 (the integral under M^-1).
//
// For a polygon in cosine space, wholly above its horizon,
//   E = 1/(2 pi) sum over edges of theta_k (a_k x b_k)_z / |a_k x b_k|,
// theta_k being the angle between the edge's end points a_k and b_k as seen from the origin.
//
// Two horizons bound what counts: the surface's, z >= 0 before M^-1, and the cosine's, z_o >= 0
// after it. Together they leave a wedge whose apex is the line through the origin along which both
// planes meet. M^-1 keeps the y axis (see lobe.glsl), so that line is the y axis in either space.
//
// Each edge is clipped to the wedge by itself. Where it enters or leaves, the outline of the
// clipped polygon continues along one of the two planes, and we close it by an arc to the apex: to
// +y or -y, whichever the polygon's plane meets. Arcs on the same plane telescope, whatever the
// order of the edges, so concave outlines, holes and any number of vertices need no clip buffer and
// no search for neighbours: the result is a plain sum over edges. The arc to the apex q = (0, s, 0)
// has (p x q)_z = s p_x.
//
// The prelude of each target gives the polygon, the same for all lanes, in world space:
//   int  polygon_point_count(Polygon)            rings one after the other, each closed by
//                                                repeating its first point
//   Vec3 polygon_point(Polygon, int)             world space
//   bool polygon_starts_ring(Polygon, int)
//   Vec2 polygon_point_in_plane(Polygon, int)    the same point in the plane's own frame
//   Vec3 polygon_origin(Polygon), polygon_axis_u(Polygon), polygon_axis_v(Polygon),
//   Vec3 polygon_normal(Polygon)                 that frame; unit normal to the emitting side
//   bool polygon_two_sided(Polygon)

/// theta / sin(theta) from x = cos(theta) and sin2 = sin(theta)^2, for 0 <= theta < pi.
///
/// For x >= 0 a rational minimax fit of degree 3/3, relative error 1.0e-9; for x < 0 from
/// theta = pi - theta', which is exact. It grows without bound towards x = -1, where 1 - x^2 has no
/// digits left; so the caller, who knows the vectors, passes sin2 as well.
FN Real theta_over_sin(Real x, Real sin2) {
  Real y = min(abs(x), Real(1.0));
  Real p = Real(1.5707963252152057) +
           y * (Real(1.638642066993385) +
                y * (Real(0.35581734455759484) + y * Real(0.004572514079188905)));
  Real q = Real(1.0) + y * (Real(1.679811571269012) +
                            y * (Real(0.7959248032398663) + y * Real(0.09409187287776444)));
  Real v = p / q;
  Real inv_sin = inversesqrt(max(sin2, Real(k_tiny)));
  return select(x < Real(0.0), k_pi * inv_sin - v, v);
}

/// Contribution of the arc from a to b = a + d to the vector irradiance, times 2 pi. d is passed by
/// itself so that the cross product of a small, far edge does not cancel. Never longer than pi: a
/// vector over its length, times an angle.
FN Vec3 edge_term(Vec3 a, Vec3 b, Vec3 d) {
  Real inv_a = inversesqrt(max(dot(a, a), Real(k_tiny)));
  Real inv_b = inversesqrt(max(dot(b, b), Real(k_tiny)));
  Real x = dot(a, b) * inv_a * inv_b;
  Vec3 c = cross(a * inv_a, d * inv_b);
  return c * theta_over_sin(x, dot(c, c));
}

/// Contribution of the arc from p to the apex (0, s, 0), s = 1 or -1.
FN Vec3 apex_term(Vec3 p, Real s) {
  Vec3 u = p * inversesqrt(max(dot(p, p), Real(k_tiny)));
  Real weight = s * theta_over_sin(s * u.y, u.x * u.x + u.z * u.z);
  return Vec3(-weight * u.z, Real(0.0), weight * u.x);
}

/// One edge of the outline, clipped to the wedge and closed towards the apex.
/// a_o, b_o: end points in cosine space; a_z, b_z: their heights above the surface's horizon.
FN Vec3 clipped_edge_term(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z, Real s) {
  Vec3 d = b_o - a_o;
  Mask a_inside = a_z >= Real(0.0) && a_o.z >= Real(0.0);
  Mask b_inside = b_z >= Real(0.0) && b_o.z >= Real(0.0);
  Mask whole = a_inside && b_inside;
  // Uniform shortcut: no lane needs to clip.
  if (all_lanes(whole)) {
    return edge_term(a_o, b_o, d);
  }

  // Interval [t0, t1] of the edge inside both half-spaces.
  Real surface_t = a_z / (a_z - b_z + select(a_z == b_z, Real(1.0), Real(0.0)));
  Real cosine_t = a_o.z / (a_o.z - b_o.z + select(a_o.z == b_o.z, Real(1.0), Real(0.0)));
  Mask surface_enters = a_z < Real(0.0) && b_z >= Real(0.0);
  Mask surface_leaves = a_z >= Real(0.0) && b_z < Real(0.0);
  Mask cosine_enters = a_o.z < Real(0.0) && b_o.z >= Real(0.0);
  Mask cosine_leaves = a_o.z >= Real(0.0) && b_o.z < Real(0.0);
  Real t0 = max(select(surface_enters, surface_t, Real(0.0)),
                select(cosine_enters, cosine_t, Real(0.0)));
  Real t1 = min(select(surface_leaves, surface_t, Real(1.0)),
                select(cosine_leaves, cosine_t, Real(1.0)));
  // t0 == t1 is not outside: an edge that leaves from, or ends at, a point on a horizon has no
  // length left but still opens or closes the outline there.
  Mask outside = (a_z < Real(0.0) && b_z < Real(0.0)) ||
                 (a_o.z < Real(0.0) && b_o.z < Real(0.0)) || t0 > t1;

  Vec3 p0 = a_o + d * t0;
  Vec3 p1 = a_o + d * t1;
  // A point cut at the cosine's horizon lies on it.
  p0.z = max(p0.z, Real(0.0));
  p1.z = max(p1.z, Real(0.0));
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 sum = edge_term(p0, p1, d * (t1 - t0));
  sum = sum - select(a_inside, none, apex_term(p0, s));
  sum = sum + select(b_inside, none, apex_term(p1, s));
  return select(outside, none, sum);
}

struct PolygonIntegral {
  Real diffuse;            // integral of cos/pi over the polygon, 0..1
  Real specular;           // integral of the lobe's density, both horizons respected, 0..1
  Vec3 specular_direction; // where that light comes from, unit, shading space; see below
};

/// v / |v|, or the normal where v has no direction to speak of.
FN Vec3 safe_direction(Vec3 v) {
  Real length2 = dot(v, v);
  Mask usable = length2 > Real(k_tiny);
  return select(usable, v * inversesqrt(max(length2, Real(k_tiny))),
                Vec3(Real(0.0), Real(0.0), Real(1.0)));
}

/// Side of the apex: the sign of y where the polygon's plane, at signed distance h along its
/// normal, meets the y axis.
FN Real apex_side(Real normal_y, Real h) {
  return select(normal_y * h < Real(0.0), Real(-1.0), Real(1.0));
}

/// Whether a point lies in a polygon's plane as far as single precision can tell: h, its distance,
/// is below what rounding of the coordinates may make of 0. Such a point, on the emitter itself or
/// on a wall flush with it, has no side, and gets no light from it.
FN Mask in_polygon_plane(Real h, Vec3 position, Vec3 origin) {
  Real size2 = dot(position, position) + dot(origin, origin);
  return h * h <= Real(k_plane_tolerance * k_plane_tolerance) * size2;
}

struct EdgeSums {
  Vec3 diffuse;  // 2 pi times the vector irradiance of the clipped polygon in shading space
  Vec3 specular; // the same in cosine space
};

/// The edge sums of a polygon, s being its apex_side. Positive z behind the polygon, negative in
/// front: there an outline that is counter-clockwise about the normal runs clockwise about
/// directions from the surface.
FN EdgeSums sum_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real s) {
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  Vec3 a = Vec3(Real(0.0), Real(0.0), Real(1.0));
  Vec3 a_o = a;
  int count = polygon_point_count(polygon);
  for (int i = 0; i < count; ++i) {
    Vec3 b = to_shading(frame, polygon_point(polygon, i) - position);
    Vec3 b_o = to_cosine(lobe, b);
    if (!polygon_starts_ring(polygon, i)) {
      sums.diffuse = sums.diffuse + clipped_edge_term(a, b, a.z, b.z, s);
      sums.specular = sums.specular + clipped_edge_term(a_o, b_o, a.z, b.z, s);
    }
    a = b;
    a_o = b_o;
  }
  return sums;
}

/// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
/// behind a one-sided polygon and in the plane of any.
///
/// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
/// is the integral; the direction is the mean direction of the part of the polygon that counts,
/// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
FN PolygonIntegral integrate_polygon(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
  Vec3 normal = polygon_normal(polygon);
  Real h = dot(polygon_origin(polygon) - position, normal);
  EdgeSums sums =
      sum_edges(polygon, position, frame, lobe, apex_side(dot(frame.t2, normal), h));
  Real side = select(h < Real(0.0), Real(-1.0), polygon_two_sided(polygon) ? Real(1.0) : Real(0.0));
  side = select(in_polygon_plane(h, position, polygon_origin(polygon)), Real(0.0), side);
  PolygonIntegral result;
  result.diffuse = min(max(sums.diffuse.z * side * k_half_inv_pi, Real(0.0)), Real(1.0));
  result.specular = min(max(sums.specular.z * side * k_half_inv_pi, Real(0.0)), Real(1.0));
  result.specular_direction =
      safe_direction(from_cosine(lobe, safe_direction(sums.specular * side)));
  return result;
}

struct PolygonHit {
  Mask hit;
  Real distance; // along the unit direction, world units
  Real cos_light; // cosine at the light, positive
};

/// Where a ray from `position` along the unit `direction` meets the polygon: the plane first, then
/// the parity of the outline's crossings with a line through the point.
FN PolygonHit intersect_polygon(Polygon polygon, Vec3 position, Vec3 direction) {
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real slope = dot(direction, normal);
  Real t = dot(to_origin, normal) / (slope + select(slope == Real(0.0), Real(1.0), Real(0.0)));
  Vec3 on_plane = direction * t - to_origin;
  Real x = dot(on_plane, polygon_axis_u(polygon));
  Real y = dot(on_plane, polygon_axis_v(polygon));

  Mask inside = Real(1.0) < Real(0.0);
  Vec2 a = Vec2(Real(0.0), Real(0.0));
  int count = polygon_point_count(polygon);
  for (int i = 0; i < count; ++i) {
    Vec2 b = polygon_point_in_plane(polygon, i);
    if (!polygon_starts_ring(polygon, i)) {
      Mask straddles = (a.y > y) != (b.y > y);
      Real rise = b.y - a.y + select(a.y == b.y, Real(1.0), Real(0.0));
      Mask crosses = straddles && x < a.x + (y - a.y) * (b.x - a.x) / rise;
      inside = inside != crosses;
    }
    a = b;
  }

  Mask faces = slope < Real(0.0);
  if (polygon_two_sided(polygon)) {
    faces = slope != Real(0.0);
  }
  PolygonHit result;
  Mask in_plane = in_polygon_plane(dot(to_origin, normal), position, polygon_origin(polygon));
  result.hit = inside && faces && t > Real(0.0) && !in_plane;
  result.distance = max(t, Real(0.0));
  result.cos_light = abs(slope);
  return result;
}
