// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of a polygon: where rays meet it, and samples of it, evenly distributed over its solid angle
// (triangle.glsl) or its area.
//
// The prelude of each target gives, besides what polygon.glsl lists:
//   Vec2 polygon_point_in_plane(Polygon, int)    a point of the outline in the plane's own frame,
//   Vec3 polygon_axis_u(Polygon), polygon_axis_v(Polygon)   which is these and polygon_origin
//   int  polygon_triangle_count(Polygon)         triangles of the polygon's area
//   Vec3 polygon_triangle_corner(Polygon, int)   world space
//   Vec3 polygon_triangle_ab(Polygon, int), polygon_triangle_ac(Polygon, int)   edges from there
//   Vec3 polygon_area_point(Polygon, Vec2 u)     evenly distributed over the area, world space

/// Where a ray from `position` along the unit `direction` meets the polygon: the plane first, then
/// the parity of the outline's crossings with a line through the point. The density is that of
/// sampling its area evenly.
FN LightPoint intersect_polygon_by_area(Polygon polygon, Vec3 position, Vec3 direction) {
  ASSERT_THAT(is_unit(direction));
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real slope = dot(direction, normal);
  Real t = dot(to_origin, normal) / never_zero(slope);
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
      Real rise = never_zero(b.y - a.y);
      Mask crosses = straddles && x < a.x + (y - a.y) * (b.x - a.x) / rise;
      inside = inside != crosses;
    }
    a = b;
  }

  Mask faces = slope < Real(0.0);
  if (polygon_two_sided(polygon)) {
    faces = slope != Real(0.0);
  }
  Mask in_plane = lies_in_plane(dot(to_origin, normal), to_origin, Real(0.0));
  LightPoint result;
  result.hit = inside && faces && t > Real(0.0) && !in_plane;
  result.direction = direction;
  result.distance = max(t, Real(0.0));
  result.cos_light = abs(slope);
  result.solid_angle = solid_angle_of_area(polygon_area(polygon), result.cos_light, t * t);
  return result;
}

/// Where a unit direction that leads to the polygon meets it; the density is 1 / solid_angle.
FN LightPoint polygon_point_towards(Polygon polygon, Vec3 position, Vec3 direction,
                                    Real solid_angle) {
  ASSERT_THAT(is_unit(direction));
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real h = dot(to_origin, normal);
  Real slope = dot(direction, normal);
  Mask faces = slope < Real(0.0);
  if (polygon_two_sided(polygon)) {
    faces = slope != Real(0.0);
  }
  LightPoint result;
  result.direction = direction;
  result.distance = h / never_zero(slope);
  result.cos_light = abs(slope);
  result.solid_angle = solid_angle;
  result.hit = faces && result.distance > Real(0.0) && result.cos_light > Real(1.0e-6) &&
               !lies_in_plane(h, to_origin, Real(0.0));
  return result;
}

/// The point of the polygon that `point` (world space, evenly distributed over its area) is.
FN LightPoint polygon_point_at(Polygon polygon, Vec3 position, Vec3 point) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  Vec3 normal = polygon_normal(polygon);
  Mask in_plane = lies_in_plane(dot(to_origin, normal), to_origin, Real(0.0));
  return area_light_point(point - position, normal, polygon_area(polygon),
                          polygon_two_sided(polygon) ? Real(1.0) : Real(0.0), in_plane);
}

/// Polygons of so many triangles are sampled by their solid angle, others by their area.
const int k_max_seen_triangles = 8;

/// Steradians under which single precision can place a direction.
CONSTANT k_least_seen = 1.0e-3;

/// A polygon as a point sees it, for sampling by solid angle. Points that see it under very little, or
/// under nearly all of their half space, draw from its area instead: there single precision cannot place
/// a direction.
struct SeenPolygon {
  Real triangle[k_max_seen_triangles]; ///< solid angles, steradians
  Real total;                          ///< their sum
  Mask known;                          ///< where it is sampled by solid angle
  Mask sided;                          ///< where the point has a side of it
};

/// Triangle i of a polygon as `position`, world space, sees it.
FN SphericalTriangle polygon_triangle_seen(Polygon polygon, int i, Vec3 position) {
  return spherical_triangle(polygon_triangle_corner(polygon, i) - position,
                            polygon_triangle_ab(polygon, i), polygon_triangle_ac(polygon, i));
}

/// error2: square of the metres within which the position is known.
FN SeenPolygon polygon_seen(Polygon polygon, Vec3 position, Real error2) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  SeenPolygon seen;
  seen.sided = !lies_in_plane(dot(to_origin, polygon_normal(polygon)), to_origin, error2);
  seen.total = Real(0.0);
  seen.known = Real(1.0) < Real(0.0);
  int count = polygon_triangle_count(polygon);
  if (count > k_max_seen_triangles) {
    return seen;
  }
  // Uniform shortcut: no lane sees it under enough, since all of it is as far as its nearest point.
  Vec3 to_center = polygon_centroid(polygon) - position;
  Real nearest = max(sqrt(dot(to_center, to_center)) - polygon_radius(polygon), Real(0.0));
  if (all_lanes(polygon_area(polygon) < Real(0.99) * Real(k_least_seen) * nearest * nearest)) {
    return seen;
  }
  for (int i = 0; i < count; ++i) {
    seen.triangle[i] = polygon_triangle_seen(polygon, i, position).solid_angle;
    seen.total = seen.total + seen.triangle[i];
  }
  seen.known = seen.total > Real(k_least_seen) && seen.total < Real(6.2);
  return seen;
}

/// A point of the polygon from two numbers in [0, 1). Its density per solid angle is 1 / solid_angle.
FN LightPoint sample_polygon(Polygon polygon, SeenPolygon seen, Vec3 position, Vec2 u) {
  ASSERT_THAT(in_unit_square(u));
  LightPoint by_area;
  LightPoint by_angle;
  if (!all_lanes(seen.known)) {
    by_area = polygon_point_at(polygon, position, polygon_area_point(polygon, u));
    by_area.hit = by_area.hit && seen.sided;
  }
  if (!any_lane(seen.known)) {
    return by_area;
  }
  // Choose a triangle and use what is left of the number.
  Real x = u.x * seen.total;
  Vec3 corner = polygon_triangle_corner(polygon, 0);
  Vec3 ab = polygon_triangle_ab(polygon, 0);
  Vec3 ac = polygon_triangle_ac(polygon, 0);
  Real before = Real(0.0);
  Real part = seen.triangle[0];
  Real sum = seen.triangle[0];
  int count = polygon_triangle_count(polygon);
  for (int i = 1; i < count; ++i) {
    Mask later = x >= sum;
    corner = select(later, polygon_triangle_corner(polygon, i), corner);
    ab = select(later, polygon_triangle_ab(polygon, i), ab);
    ac = select(later, polygon_triangle_ac(polygon, i), ac);
    before = select(later, sum, before);
    part = select(later, seen.triangle[i], part);
    sum = sum + seen.triangle[i];
  }
  Real rest = min(max((x - before) / max(part, Real(k_tiny)), Real(0.0)), Real(1.0));
  Vec3 direction =
      sample_spherical_triangle(spherical_triangle(corner - position, ab, ac), Vec2(rest, u.y));
  by_angle = polygon_point_towards(polygon, position, direction, seen.total);
  by_angle.hit = by_angle.hit && seen.sided;
  if (all_lanes(seen.known)) {
    return by_angle;
  }
  return select_point(seen.known, by_angle, by_area);
}

/// Where a ray meets the polygon; its density is that of sample_polygon.
FN LightPoint intersect_polygon(Polygon polygon, SeenPolygon seen, Vec3 position, Vec3 direction) {
  LightPoint point = intersect_polygon_by_area(polygon, position, direction);
  point.hit = point.hit && seen.sided;
  point.solid_angle = select(seen.known, seen.total, point.solid_angle);
  return point;
}

/// Density per solid angle with which sample_polygon draws a unit direction.
FN Real pdf_polygon(Polygon polygon, SeenPolygon seen, Vec3 position, Vec3 direction) {
  return pdf_of_point(intersect_polygon(polygon, seen, position, direction));
}
