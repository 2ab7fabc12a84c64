// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What lights of all shapes share: their integral, a point of one, and the planes of flat ones.
//
// A shape X has a file of its own, and there, named alike:
//   integrate_X     its integral as a point sees it, for Lambert and for a lobe
//   X_heights       its extent over a plane through the point
//   surface_X_integral   the integral as a surface sees it: none without a side of a flat light, and
//                   without what the surface's triangle hides
//   shade_X_parts, shade_X   the light that the surface reflects of it, for radiance 1 and without shadow
//   X_seen          what sampling wants to know of it and of the point, once for all samples
//   sample_X, intersect_X, pdf_X   a point of it from random numbers, or where a ray meets it; its density.
//                   No ray meets a line

/// What shading wants to know of a light of radiance 1, whatever its shape, without shadow.
///
/// Both integrals are z components of vector irradiances, in shading space and in cosine space. The
/// vectors' directions are the mean directions of the part of the light that counts; of the
/// specular one, carried back by M, shading takes the Fresnel reflectance.
struct LightIntegral {
  Real diffuse;            ///< integral of cos/pi over the light, 0..1
  Real specular;           ///< integral of the lobe's density, both horizons respected, 0..1
  Vec3 diffuse_direction;  ///< shading space, unit
  Vec3 specular_direction; ///< shading space, unit
  Real second;             ///< integral of a second lobe's density, see with_second_lobe; else 0
  Vec3 first_direction;    ///< with a second lobe, specular_direction of the first alone
  Vec3 second_direction;   ///< and of the second
  Real concentration; ///< cosine space, 0..1: 1 for a light so small that it lies in one direction
  Real weight; ///< of GGX itself, mean of Schlick's weight over its light; else negative or not set
};

/// How closely a light keeps to its mean direction in cosine space, 0..1: R^4 (1 - |Phi|).
///
/// R is the length of the mean of the unit vectors to the points that make up the light's outline: its
/// cosine for a cone, 1 for a point, near 0 for a wall on all sides; outline2 is its square. Phi is the
/// vector irradiance, which is as long as 1 for a light that is all around.
FN Real light_concentration(Real outline2, Real vector_irradiance) {
  Real rest = max(Real(1.0) - vector_irradiance, Real(0.0));
  return min(outline2 * outline2, Real(1.0)) * rest;
}

/// From the vector irradiances times 2 pi; outline2: see light_concentration.
FN LightIntegral light_integral(Vec3 diffuse, Vec3 specular, Lobe lobe, Real outline2) {
  LightIntegral result;
  result.diffuse = min(max(diffuse.z * k_half_inv_pi, Real(0.0)), Real(1.0));
  result.specular = min(max(specular.z * k_half_inv_pi, Real(0.0)), Real(1.0));
  result.second = Real(0.0);
  result.diffuse_direction = safe_direction(diffuse);
  result.specular_direction = safe_direction(from_cosine(lobe, specular));
  result.concentration =
      light_concentration(outline2, sqrt(dot(specular, specular)) * k_half_inv_pi);
  return result;
}

/// Heights of a light's lowest and highest point over a plane through the shaded point, metres.
struct Heights {
  Real low;  ///< of the lowest point, metres
  Real high; ///< of the highest one, metres
};

/// Both 0, where nothing is asked of them.
FN Heights no_heights() {
  Heights heights;
  heights.low = Real(0.0);
  heights.high = Real(0.0);
  return heights;
}

/// Whether a point lies in a light's plane as far as can be told: h, its distance, is no more than
/// that to which the point is known, whose square is `error2`, or than what rounding makes of 0. Such a
/// point has no side, and gets no light. `to_origin` leads from the point to any point of the plane.
FN Mask lies_in_plane(Real h, Vec3 to_origin, Real error2) {
  return h * h <=
         max(error2, Real(k_plane_rounding * k_plane_rounding) * dot(to_origin, to_origin));
}

/// A divisor, or 1 where it is 0 and the quotient means nothing.
FN Real never_zero(Real x) { return x + select(x == Real(0.0), Real(1.0), Real(0.0)); }

/// A point of a light seen from a shaded point, met by a ray or drawn at random.
struct LightPoint {
  Mask hit;         ///< whether light comes from there: in front, on the emitting side
  Vec3 direction;   ///< to the point, unit, world space
  Real distance;    ///< metres
  Real cos_light;   ///< cosine at the light, 0..1
  Real solid_angle; ///< 1 / the density per solid angle with which the light's sampling draws it
};

/// a where the mask is set, b elsewhere.
FN LightPoint select_point(Mask m, LightPoint a, LightPoint b) {
  LightPoint point;
  point.hit = (m && a.hit) || (!m && b.hit);
  point.direction = select(m, a.direction, b.direction);
  point.distance = select(m, a.distance, b.distance);
  point.cos_light = select(m, a.cos_light, b.cos_light);
  point.solid_angle = select(m, a.solid_angle, b.solid_angle);
  return point;
}

/// Density per solid angle with which a light's sampling draws a point; 0 where no light comes from.
FN Real pdf_of_point(LightPoint point) {
  return select(point.hit, Real(1.0) / max(point.solid_angle, Real(k_tiny)), Real(0.0));
}

/// Solid angle of an area, turned by the cosine, at a distance: 1 / density per solid angle of
/// points that are evenly distributed over it.
FN Real solid_angle_of_area(Real area, Real cos_light, Real distance2) {
  ASSERT_THAT(area >= Real(0.0));
  return area * cos_light / max(distance2, Real(k_tiny));
}

/// A point of a planar light of that area, `offset` from the shaded point.
FN LightPoint area_light_point(Vec3 offset, Vec3 normal, Real area, Real two_sided, Mask in_plane) {
  Real distance2 = max(dot(offset, offset), Real(k_tiny));
  Real inv_distance = inversesqrt(distance2);
  LightPoint result;
  result.direction = offset * inv_distance;
  Real facing = -dot(result.direction, normal);
  result.cos_light = select(two_sided > Real(0.0), abs(facing), facing);
  result.hit = result.cos_light > Real(1.0e-6) && !in_plane;
  result.distance = distance2 * inv_distance;
  result.solid_angle = solid_angle_of_area(area, result.cos_light, distance2);
  return result;
}

/// Radiance at an angle from the emitter's normal over that along it, cos^power. power = 0 is
/// Lambert's emitter.
FN Real cosine_emission(Real cos_light, Real power) {
  Real factor = pow(min(max(cos_light, Real(1.0e-6)), Real(1.0)), power);
  return select(power > Real(0.0), factor, Real(1.0));
}
