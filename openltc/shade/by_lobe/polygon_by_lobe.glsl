// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of a polygon, distributed as what a lobe has of it above both horizons: a triangle of it first, by what
// each has, then a point of that (triangle_slices.glsl).

/// Least of 2 pi times the lobe's integral over a polygon that is sampled so.
CONSTANT k_least_by_lobe = 1.0e-4;
/// And of what is left of the sum that cancels to it, of which single precision has 1e-7.
CONSTANT k_least_left_by_lobe = 1.0e-3;

/// Polygons of so many triangles are sampled by lobes.
const int k_max_lobe_triangles = 32;

/// A polygon as a point sees it through a lobe, for sampling.
struct PolygonByLobe {
  Real mass[k_max_lobe_triangles]; ///< of each triangle
  Real total;                      ///< 2 pi times the integral of the lobe over the polygon
  Mask known;                      ///< where it can be sampled
};

/// For polygons of up to k_max_lobe_triangles triangles; of others nothing is known. `position`: world space.
FN PolygonByLobe polygon_by_lobe(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
  PolygonByLobe seen;
  seen.total = Real(0.0);
  seen.known = Real(1.0) < Real(0.0);
  int count = polygon_triangle_count(polygon);
  if (count > k_max_lobe_triangles) {
    return seen;
  }
  LobeWedge wedge = lobe_wedge(lobe);
  Real size = Real(0.0);
  for (int i = 0; i < count; ++i) {
    Vec2 part = lobe_mass(
        lobe_corners(lobe, wedge, to_shading(frame, polygon_triangle_corner(polygon, i) - position),
                     to_shading(frame, polygon_triangle_ab(polygon, i)),
                     to_shading(frame, polygon_triangle_ac(polygon, i))),
        wedge);
    seen.mass[i] = part.x;
    seen.total = seen.total + part.x;
    size = size + part.y;
  }
  seen.known = seen.total > max(Real(k_least_by_lobe), Real(k_least_left_by_lobe) * size);
  return seen;
}

/// A point of the polygon from two numbers in [0, 1), where seen.known; frame and lobe are those of `seen`. Its
/// density per solid angle, 1 / solid_angle, is 2 pi / seen.total times that of the lobe.
FN LightPoint sample_polygon_by_lobe(Polygon polygon, PolygonByLobe seen, Vec3 position,
                                     Frame frame, Lobe lobe, Vec2 u) {
  ASSERT_THAT(in_unit_square(u));
  // Choose a triangle and use what is left of the number.
  Real wanted = u.x * seen.total;
  Vec3 corner = polygon_triangle_corner(polygon, 0);
  Vec3 ab = polygon_triangle_ab(polygon, 0);
  Vec3 ac = polygon_triangle_ac(polygon, 0);
  Real before = Real(0.0);
  Real mass = seen.mass[0];
  Real sum = seen.mass[0];
  int count = polygon_triangle_count(polygon);
  for (int i = 1; i < count; ++i) {
    Mask later = wanted >= sum && seen.mass[i] > Real(0.0);
    corner = select(later, polygon_triangle_corner(polygon, i), corner);
    ab = select(later, polygon_triangle_ab(polygon, i), ab);
    ac = select(later, polygon_triangle_ac(polygon, i), ac);
    before = select(later, sum, before);
    mass = select(later, seen.mass[i], mass);
    sum = sum + seen.mass[i];
  }
  Real rest = min(max((wanted - before) / max(mass, Real(k_tiny)), Real(0.0)), Real(1.0));
  LobeWedge wedge = lobe_wedge(lobe);
  LobeTriangle triangle =
      lobe_triangle(lobe_corners(lobe, wedge, to_shading(frame, corner - position),
                                 to_shading(frame, ab), to_shading(frame, ac)),
                    wedge);
  LobeSlice slice = slice_of_share(triangle, rest);
  Real begin = Real(2.0) * (angle_of(slice.c, slice.s) + slice.c * slice.s);
  Vec2 latitude = latitude_of(begin + Real(2.0) * u.y * slice.width);
  Vec3 o = Vec3(latitude.x * slice.x, latitude.y, latitude.x * slice.z);

  // M takes a solid angle around o to one det^2 / |M' o|^3 times as large, M' = det M.
  Vec3 m_o = from_cosine(lobe, o);
  Real inv_length = inversesqrt(max(dot(m_o, m_o), Real(k_tiny)));
  Vec3 w = safe_direction(m_o);
  Real shrink = lobe.det * inv_length;
  Real solid_angle =
      seen.total * (shrink * shrink) * inv_length / max(Real(2.0) * o.z, Real(k_tiny));
  // What rounding may have taken beside the polygon does not count.
  LightPoint point = intersect_polygon_by_area(polygon, position, to_world(frame, w));
  point.solid_angle = solid_angle;
  point.hit = point.hit && seen.known && mass > Real(0.0) && slice.width > Real(0.0) &&
              o.z > Real(0.0) && w.z > Real(0.0);
  return point;
}

/// Density per solid angle of sample_polygon_by_lobe in a direction to the polygon; 0 where it draws nothing.
FN Real density_by_lobe(PolygonByLobe seen, Lobe lobe, Vec3 wi_shading) {
  return select(seen.known,
                eval_lobe(lobe, wi_shading) * (Real(2.0) * k_pi) / max(seen.total, Real(k_tiny)),
                Real(0.0));
}
