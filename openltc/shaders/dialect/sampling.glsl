// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What you call for shadows: points of lights, to which you send rays. The mean of eval_point over points of a
// light is what shade_X says, of those points that nothing hides it is the light with shadow. Multiply the
// closed form by the ratio of the two, each summed over pictures or neighbours: no noise is left where
// nothing is hidden (Heitz, Hill, McGuire 2018, "Combining Analytic Direct Illumination and Stochastic
// Shadows").
//
// draw_X gives a point from two numbers in [0, 1), meet_X where a ray meets the light, or none. With smooth
// surfaces draw a share of the points by meet_X along lobe_direction, and tell point_density that share.

/// A point of a parallelogram, evenly distributed over its area.
FN LightPoint draw_quad(Quad quad, Vec3 position, Vec2 u) {
  Vec3 to_center = quad.center - position;
  Vec3 normal = quad_normal(quad);
  Vec3 offset = to_center + quad.half_u * (Real(2.0) * u.x - Real(1.0)) +
                quad.half_v * (Real(2.0) * u.y - Real(1.0));
  return area_light_point(offset, normal, quad_area(quad), quad.two_sided,
                          lies_in_plane(dot(to_center, normal), to_center, Real(0.0)));
}

/// Where a ray from `position` along the unit `direction` meets it.
FN LightPoint meet_quad(Quad quad, Vec3 position, Vec3 direction) {
  Vec3 to_center = quad.center - position;
  Vec3 across = cross(quad.half_u, quad.half_v);
  Vec3 normal = quad_normal(quad);
  Real t = dot(to_center, normal) / never_zero(dot(direction, normal));
  Vec3 on_plane = direction * t - to_center;
  // By Cramer's rule, since the sides need not be at right angles.
  Real inv_area2 = Real(1.0) / max(dot(across, across), Real(k_tiny));
  Real x = dot(cross(on_plane, quad.half_v), across) * inv_area2;
  Real y = dot(cross(quad.half_u, on_plane), across) * inv_area2;
  LightPoint point = area_light_point(direction * t, normal, quad_area(quad), quad.two_sided,
                                      lies_in_plane(dot(to_center, normal), to_center, Real(0.0)));
  point.hit = point.hit && t > Real(0.0) && max(abs(x), abs(y)) <= Real(1.0);
  point.direction = direction;
  return point;
}

/// Whether a point of a polygon's plane lies in the polygon: by the edges that a line from there along an axis of
/// the plane crosses.
FN bool is_in_polygon(Polygon polygon, Vec3 point) {
  Vec3 u = any_perpendicular(polygon_normal(polygon));
  Vec3 v = cross(polygon_normal(polygon), u);
  bool inside = false;
  Vec2 a = Vec2(Real(0.0), Real(0.0));
  int count = polygon_point_count(polygon);
  for (int i = 0; i < count; ++i) {
    Vec3 corner = polygon_point(polygon, i) - point;
    Vec2 b = Vec2(dot(corner, u), dot(corner, v));
    if (!polygon_starts_ring(polygon, i)) {
      bool rises = b.y > a.y;
      if ((a.y > Real(0.0)) != (b.y > Real(0.0)) && (a.x * b.y > a.y * b.x) == rises) {
        inside = !inside;
      }
    }
    a = b;
  }
  return inside;
}

/// Square metres of the circle around a polygon, in which its points are drawn.
FN Real polygon_circle_area(Polygon polygon) {
  return k_pi * polygon_radius(polygon) * polygon_radius(polygon);
}

/// A point of a polygon's plane `offset` from the shaded one; no light comes from beside the polygon.
FN LightPoint polygon_circle_point(Polygon polygon, Vec3 position, Vec3 offset) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  LightPoint point = area_light_point(
      offset, polygon_normal(polygon), polygon_circle_area(polygon),
      polygon_two_sided(polygon) ? Real(1.0) : Real(0.0),
      lies_in_plane(dot(to_origin, polygon_normal(polygon)), to_origin, Real(0.0)));
  point.hit = point.hit && is_in_polygon(polygon, position + offset);
  return point;
}

/// A point evenly distributed over the circle around a polygon, with or without light.
FN LightPoint draw_polygon(Polygon polygon, Vec3 position, Vec2 u) {
  Vec3 axis = any_perpendicular(polygon_normal(polygon));
  Real radius = polygon_radius(polygon) * sqrt(u.x);
  Real phi = Real(2.0) * k_pi * u.y;
  Vec3 in_circle =
      axis * (radius * cos(phi)) + cross(polygon_normal(polygon), axis) * (radius * sin(phi));
  return polygon_circle_point(polygon, position, polygon_centroid(polygon) - position + in_circle);
}

/// Where a ray from `position` along the unit `direction` meets the polygon.
FN LightPoint meet_polygon(Polygon polygon, Vec3 position, Vec3 direction) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real t =
      dot(to_origin, polygon_normal(polygon)) / never_zero(dot(direction, polygon_normal(polygon)));
  LightPoint point = polygon_circle_point(polygon, position, direction * t);
  point.hit = point.hit && t > Real(0.0);
  point.direction = direction;
  return point;
}

/// A point of an ellipse, evenly distributed over its area.
FN LightPoint draw_ellipse(Ellipse ellipse, Vec3 position, Vec2 u) {
  return sample_ellipse_by_area(ellipse, position, u);
}

/// Where a ray from `position` along the unit `direction` meets it.
FN LightPoint meet_ellipse(Ellipse ellipse, Vec3 position, Vec3 direction) {
  return intersect_ellipse_by_area(ellipse, position, direction);
}

/// A point of a sphere, evenly distributed over the solid angle.
FN LightPoint draw_sphere(Sphere sphere, Vec3 position, Vec2 u) {
  return sample_sphere(sphere, sphere_seen(sphere, position), u);
}

/// Where a ray from `position` along the unit `direction` meets it.
FN LightPoint meet_sphere(Sphere sphere, Vec3 position, Vec3 direction) {
  return intersect_sphere(sphere, sphere_seen(sphere, position), direction);
}

/// A point of a tube, evenly distributed over its surface; none comes from the far side.
FN LightPoint draw_tube(Tube tube, Vec3 position, Vec2 u) {
  return sample_tube_by_area(tube, position, u);
}

/// Where a ray from `position` along the unit `direction` meets it.
FN LightPoint meet_tube(Tube tube, Vec3 position, Vec3 direction) {
  return intersect_tube_by_area(tube, position, direction);
}

/// A point of a line, evenly distributed over the angle that it spans. No ray meets a line.
FN LightPoint draw_line(Line line, Vec3 position, Vec2 u) {
  return sample_line(line, position, u.x);
}

/// A unit direction in which the surface reflects the view, drawn from GGX; it may lead below the horizon.
FN Vec3 lobe_direction(Surface s, Vec2 u) {
  return to_world(s.frame, sample_ggx(s.wo, s.alpha, u));
}

/// Density per solid angle with which a point was drawn, of points whose share by_lobe, 0..1, comes of
/// lobe_direction, the others of the light; 0 where all do.
FN Real point_density(Surface s, LightPoint point, Real by_lobe) {
  Real drawn = (Real(1.0) - by_lobe) / max(point.solid_angle, Real(k_tiny));
  return drawn + by_lobe * pdf_ggx(s.wo, to_shading(s.frame, point.direction), s.alpha);
}

/// What a surface reflects of a light of radiance 1 by a point of that density, in the mean over points.
FN Vec3 eval_point(Surface s, LightPoint point, Real density) {
  Mask seen = point.hit && point.solid_angle > Real(0.0) &&
              !hidden_by_triangle(s, point.direction * point.distance);
  Vec3 light = eval_surface(s, to_shading(s.frame, point.direction)) / max(density, Real(k_tiny));
  return select(seen, light, Vec3(Real(0.0), Real(0.0), Real(0.0)));
}
