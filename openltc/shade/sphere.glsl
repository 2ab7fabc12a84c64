// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a sphere, exact, clipped to both horizons: the cone of directions that
// touch it is that of a disk. See cone.glsl.

/// A sphere, which emits outwards.
struct Sphere {
  Vec3 center; ///< world space
  Real radius; ///< metres
};

/// Semi-axes of a disk around p that fills the same directions as the sphere of that radius around
/// p, |p| > radius: its radius is |p| tan s with sin s = radius / |p|.
FN Real tangent_disk_radius(Real distance2, Real radius) {
  // tan^2 = sin^2 / (1 - sin^2); the difference is formed of lengths so that it does not cancel.
  Real distance = sqrt(distance2);
  Real leg2 = max((distance - radius) * (distance + radius), Real(1.0e-12) * distance2);
  return distance * radius * inversesqrt(max(leg2, Real(k_tiny)));
}

/// integrate_sphere; where `cut`, over what is in front of the plane with unit normal `front` (shading
/// space).
FN LightIntegral integrate_sphere_part(Sphere sphere, Vec3 position, Frame frame, Lobe lobe,
                                       Vec3 front, bool cut) {
  ASSERT_THAT(sphere.radius >= Real(0.0));
  ASSERT_THAT(!cut || all_lanes(is_unit(front)));
  Vec3 center = to_shading(frame, sphere.center - position);
  Real distance2 = dot(center, center);
  Vec3 axis = center * inversesqrt(max(distance2, Real(k_tiny)));
  Real radius = tangent_disk_radius(distance2, sphere.radius);
  Vec3 u = any_perpendicular(axis);
  Vec3 v = cross(axis, u) * radius;
  u = u * radius;
  ConeSums sums = sum_ellipse_cone(center, u, v, lobe, front, cut);
  // Below the horizon it gives nothing, rounding or not.
  Mask seen = distance2 > sphere.radius * sphere.radius && center.z + sphere.radius > Real(0.0);
  Real outside = select(seen, Real(1.0), Real(0.0));
  return light_integral(sums.diffuse * outside, sums.specular * outside, lobe, sums.outline2);
}

/// Integrals over a sphere seen from `position` (world space), for Lambert and for `lobe`. Zero
/// inside: it emits outwards.
FN LightIntegral integrate_sphere(Sphere sphere, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_sphere_part(sphere, position, frame, lobe, Vec3(Real(0.0), Real(0.0), Real(1.0)),
                               false);
}

/// Of a sphere over the plane through `position` with that unit normal, world space.
FN Heights sphere_heights(Sphere sphere, Vec3 position, Vec3 normal) {
  Real middle = dot(normal, sphere.center - position);
  Heights heights;
  heights.low = middle - sphere.radius;
  heights.high = middle + sphere.radius;
  return heights;
}

/// The integral over a sphere with its specular part exact.
FN_CALL LightIntegral exact_sphere_integral(GIVEN(Surface) s, GIVEN(Sphere) sphere) {
  Vec3 center = to_shading(s.frame, sphere.center - s.position);
  Real distance2 = dot(center, center);
  Vec3 axis = center * inversesqrt(max(distance2, Real(k_tiny)));
  Real radius = tangent_disk_radius(distance2, sphere.radius);
  Vec3 u = any_perpendicular(axis);
  Vec3 v = cross(axis, u) * radius;
  LightIntegral integral = exact_cone_integral(s, make_cone(center, u * radius, v), 6);
  Mask seen = distance2 > sphere.radius * sphere.radius && center.z + sphere.radius > Real(0.0);
  integral.diffuse = select(seen, integral.diffuse, Real(0.0));
  integral.specular = select(seen, integral.specular, Real(0.0));
  integral.second = select(seen, integral.second, Real(0.0));
  return integral;
}

/// The integral over a sphere as a surface sees it; see surface_polygon_integral.
FN LightIntegral surface_sphere_integral(GIVEN(Surface) s, Sphere sphere) {
  Heights heights = no_heights();
  bool cut = false;
  if (s.tilted) {
    heights = sphere_heights(sphere, s.position, s.geometric);
    cut = any_lane(heights.low < Real(0.0));
  }
  if (s.exact && !cut) {
    return exact_sphere_integral(s, sphere);
  }
  LightIntegral integral =
      integrate_sphere_part(sphere, s.position, s.frame, s.fitted.lobe, front_shading(s), cut);
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_sphere_part(sphere, s.position, s.frame, s.second, front_shading(s), cut));
  }
  if (s.exact) {
    // What a triangle cuts keeps the lobe.
    integral = lobe_where(heights.low < Real(0.0), integral, exact_sphere_integral(s, sphere));
  }
  if (cut) {
    return unless_hidden(s, heights, integral);
  }
  return integral;
}

/// Light that a surface reflects of a sphere of radiance 1, without shadow.
FN ShadedLight shade_sphere_parts(GIVEN(Surface) s, Sphere sphere) {
  return shade_integral(s, surface_sphere_integral(s, sphere));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_sphere_parts, both together.
FN Vec3 shade_sphere(GIVEN(Surface) s, Sphere sphere) {
  return both_parts(shade_sphere_parts(s, sphere));
}

/// A sphere as a point sees it, for sampling by solid angle: its cone of directions.
struct SeenSphere {
  Vec3 axis;          ///< unit
  Real distance2;     ///< square of the distance of its centre
  Real one_minus_cos; ///< of the half angle
  Mask outside;       ///< whether the point is outside of the sphere
};

/// The cone of a sphere from `position`, world space.
FN SeenSphere sphere_seen(Sphere sphere, Vec3 position) {
  ASSERT_THAT(sphere.radius >= Real(0.0));
  Vec3 to_center = sphere.center - position;
  SeenSphere seen;
  seen.distance2 = max(dot(to_center, to_center), Real(k_tiny));
  seen.axis = to_center * inversesqrt(seen.distance2);
  Real sin2 = min(sphere.radius * sphere.radius / seen.distance2, Real(1.0));
  // 1 - cos = sin^2 / (1 + cos) does not cancel.
  seen.one_minus_cos = sin2 / (Real(1.0) + sqrt(max(Real(1.0) - sin2, Real(0.0))));
  seen.outside = seen.distance2 > sphere.radius * sphere.radius;
  return seen;
}

/// The sphere's near point along a unit direction with cosine 1 - one_minus_cos to its centre; `hit`
/// is left for the caller.
FN LightPoint sphere_point(Sphere sphere, SeenSphere seen, Vec3 direction, Real one_minus_cos) {
  Real cos_axis = Real(1.0) - one_minus_cos;
  Real sin2 = max(one_minus_cos * (Real(1.0) + cos_axis), Real(0.0));
  // Half of the chord, over the radius, is the cosine at the surface.
  Real chord2 = max(sphere.radius * sphere.radius - seen.distance2 * sin2, Real(0.0));
  Real half_chord = sqrt(chord2);
  LightPoint result;
  result.hit = seen.outside;
  result.direction = direction;
  result.distance = max(sqrt(seen.distance2) * cos_axis - half_chord, Real(0.0));
  result.cos_light = min(half_chord / max(sphere.radius, Real(k_tiny)), Real(1.0));
  result.solid_angle = Real(2.0) * k_pi * seen.one_minus_cos;
  return result;
}

/// Where a ray along the unit `direction` meets the sphere. The density is that of
/// sample_sphere.
FN LightPoint intersect_sphere(Sphere sphere, SeenSphere seen, Vec3 direction) {
  ASSERT_THAT(is_unit(direction));
  // |direction - axis|^2 = 2 (1 - cos), exact where the cosine itself is not.
  Vec3 d = direction - seen.axis;
  Real one_minus_cos = Real(0.5) * dot(d, d);
  LightPoint result = sphere_point(sphere, seen, direction, one_minus_cos);
  result.hit = result.hit && one_minus_cos <= seen.one_minus_cos;
  return result;
}

/// A point of the sphere, evenly distributed over the solid angle, from two numbers in [0, 1).
FN LightPoint sample_sphere(Sphere sphere, SeenSphere seen, Vec2 u) {
  ASSERT_THAT(in_unit_square(u));
  Real one_minus_cos = u.x * seen.one_minus_cos;
  Real sin_axis = sqrt(max(one_minus_cos * (Real(2.0) - one_minus_cos), Real(0.0)));
  Real phi = Real(2.0) * k_pi * u.y;
  Vec3 e1 = any_perpendicular(seen.axis);
  Vec3 e2 = cross(seen.axis, e1);
  Vec3 direction = seen.axis * (Real(1.0) - one_minus_cos) + e1 * (sin_axis * cos(phi)) +
                   e2 * (sin_axis * sin(phi));
  return sphere_point(sphere, seen, normalize(direction), one_minus_cos);
}

/// Density per solid angle with which sample_sphere draws a unit direction.
FN Real pdf_sphere(Sphere sphere, SeenSphere seen, Vec3 direction) {
  return pdf_of_point(intersect_sphere(sphere, seen, direction));
}
