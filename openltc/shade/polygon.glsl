// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons.
//
// Source: the edge sum of edge.glsl.
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
//   Real polygon_area(Polygon)                   square metres

/// Side of the apex: the sign of y where the polygon's plane, at signed distance h along its
/// normal, meets the y axis.
FN Real apex_side(Real normal_y, Real h) {
  return select(normal_y * h < Real(0.0), Real(-1.0), Real(1.0));
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
FN LightIntegral integrate_polygon(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
  Vec3 normal = polygon_normal(polygon);
  Real h = dot(polygon_origin(polygon) - position, normal);
  EdgeSums sums =
      sum_edges(polygon, position, frame, lobe, apex_side(dot(frame.t2, normal), h));
  Real side = select(h < Real(0.0), Real(-1.0), polygon_two_sided(polygon) ? Real(1.0) : Real(0.0));
  side = select(lies_in_plane(h, position, polygon_origin(polygon)), Real(0.0), side);
  return light_integral(sums.diffuse * side, sums.specular * side, lobe);
}

/// Where a ray from `position` along the unit `direction` meets the polygon: the plane first, then
/// the parity of the outline's crossings with a line through the point. The density is that of
/// sampling its area evenly.
FN LightPoint intersect_polygon(Polygon polygon, Vec3 position, Vec3 direction) {
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
  Mask in_plane = lies_in_plane(dot(to_origin, normal), position, polygon_origin(polygon));
  LightPoint result;
  result.hit = inside && faces && t > Real(0.0) && !in_plane;
  result.direction = direction;
  result.distance = max(t, Real(0.0));
  result.cos_light = abs(slope);
  result.solid_angle = solid_angle_of_area(polygon_area(polygon), result.cos_light, t * t);
  return result;
}

/// The point of the polygon that `point` (world space, evenly distributed over its area) is.
FN LightPoint polygon_point_at(Polygon polygon, Vec3 position, Vec3 point) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  Vec3 normal = polygon_normal(polygon);
  Mask in_plane = lies_in_plane(dot(to_origin, normal), position, polygon_origin(polygon));
  return area_light_point(point - position, normal, polygon_area(polygon),
                          polygon_two_sided(polygon) ? Real(1.0) : Real(0.0), in_plane);
}
