// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a flat ellipse or disk, exact, clipped to both horizons: a cone in
// shading space for Lambert, and its image under M^-1 for the lobe. See cone.glsl.

/// A flat ellipse in world space; emits along half_u x half_v.
struct Ellipse {
  Vec3 center;
  Vec3 half_u; // semi-axes, perpendicular
  Vec3 half_v;
  Real two_sided; // 0 or 1
};

/// Integrals over an ellipse seen from `position` (world space), for Lambert and for `lobe`. Zero
/// behind a one-sided ellipse and in the plane of any.
FN LightIntegral integrate_ellipse(Ellipse ellipse, Vec3 position, Frame frame, Lobe lobe) {
  Vec3 center = to_shading(frame, ellipse.center - position);
  Vec3 u = to_shading(frame, ellipse.half_u);
  Vec3 v = to_shading(frame, ellipse.half_v);
  Vec3 up = Vec3(Real(0.0), Real(0.0), Real(1.0));
  Vec3 diffuse = clipped_cone(make_cone(center, u, v), up);
  Vec3 specular =
      clipped_cone(make_cone(to_cosine(lobe, center), to_cosine(lobe, u), to_cosine(lobe, v)),
                   horizon_normal_cosine(lobe));
  Vec3 normal = cross(u, v);
  Real h = dot(center, normal) * inversesqrt(max(dot(normal, normal), Real(k_tiny)));
  Real side = select(h < Real(0.0), Real(1.0), ellipse.two_sided);
  side = select(lies_in_plane(h, center, Real(0.0)), Real(0.0), side);
  // Its highest point: an ellipse below the horizon gives nothing, rounding or not.
  Real reach = sqrt(u.z * u.z + v.z * v.z);
  side = select(center.z + reach > Real(0.0), side, Real(0.0));
  return light_integral(diffuse * side, specular * side, lobe);
}

/// Where a ray from `position` along the unit `direction` meets the ellipse. The density is that of
/// sample_ellipse.
FN LightPoint intersect_ellipse(Ellipse ellipse, Vec3 position, Vec3 direction) {
  Vec3 normal = cross(ellipse.half_u, ellipse.half_v);
  Real area = sqrt(dot(normal, normal)) * k_pi;
  normal = normal * (k_pi / max(area, Real(k_tiny)));
  Vec3 to_center = ellipse.center - position;
  Real h = dot(to_center, normal);
  Real slope = dot(direction, normal);
  Real t = h / (slope + select(slope == Real(0.0), Real(1.0), Real(0.0)));
  Vec3 on_plane = direction * t - to_center;
  Real x = dot(on_plane, ellipse.half_u) / max(dot(ellipse.half_u, ellipse.half_u), Real(k_tiny));
  Real y = dot(on_plane, ellipse.half_v) / max(dot(ellipse.half_v, ellipse.half_v), Real(k_tiny));
  LightPoint result = area_light_point(direction * t, normal, area, ellipse.two_sided,
                                       lies_in_plane(h, to_center, Real(0.0)));
  result.hit = result.hit && t > Real(0.0) && x * x + y * y <= Real(1.0);
  result.direction = direction;
  return result;
}

/// A point evenly distributed over the ellipse, from two numbers in [0, 1).
FN LightPoint sample_ellipse(Ellipse ellipse, Vec3 position, Vec2 u) {
  Vec3 normal = cross(ellipse.half_u, ellipse.half_v);
  Real area = sqrt(dot(normal, normal)) * k_pi;
  normal = normal * (k_pi / max(area, Real(k_tiny)));
  Real radius = sqrt(u.x);
  Real phi = Real(2.0) * k_pi * u.y;
  Vec3 to_center = ellipse.center - position;
  Vec3 offset = to_center + ellipse.half_u * (radius * cos(phi)) +
                ellipse.half_v * (radius * sin(phi));
  return area_light_point(offset, normal, area, ellipse.two_sided,
                          lies_in_plane(dot(to_center, normal), to_center, Real(0.0)));
}
