// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Point, spot and directional lights: no extent, so no integral; the density of the light's one
// direction is evaluated.
//
// Source: KHR_lights_punctual (inverse square law, cone and range); docs/method.md, section 9, for the
// LTC form: the limit of the integral of D over a small light is D(w) times its solid angle.

/// Window that brings a light's contribution smoothly to zero at its range, as
/// KHR_lights_punctual recommends: max(min(1 - (d/r)^4, 1), 0). range = 0 means unlimited.
FN Real range_window(Real distance2, Real range) {
  ASSERT_THAT(distance2 >= Real(0.0));
  Real ratio2 = distance2 / max(range * range, Real(k_tiny));
  Real window = min(max(Real(1.0) - ratio2 * ratio2, Real(0.0)), Real(1.0));
  return select(range > Real(0.0), window, Real(1.0));
}

/// Spot cone: 1 inside cos_inner, 0 outside cos_outer, the square of a linear ramp between.
FN Real spot_cone(Real cos_angle, Real cos_inner, Real cos_outer) {
  Real ramp = (cos_angle - cos_outer) / max(cos_inner - cos_outer, Real(1.0e-4));
  Real clamped = min(max(ramp, Real(0.0)), Real(1.0));
  return clamped * clamped;
}

// Profiles.
//
// Intensity of a point or spot light by direction, from a measured profile.
//
// The profile is a grid regular in the very angles in which such light is measured, so that a file
// whose angles are multiples of the grid's step is interpolated here as it is there: bilinearly
// between its own nodes. Both angles come from one polynomial for the arc tangent (angle.glsl). The angle
// to the axis is taken as atan2(sine, cosine), which unlike acos(cosine) keeps its precision near the
// axis, where narrow beams have all their light.
//
// The profile's own frame: z to the pole of the file's angles, x at azimuth 0, y at 90 degrees; with
// up = -z, y = cross(up, x). For type C that is the light's own frame, z to the nadir; for types A
// and B it lies across (light/photometry/ies.h), so that those are interpolated in their own angles as well.
//
// The prelude of each target gives
//   Vec2 profile_size(Profile)           columns, rows
//   Real profile_lookup(Profile, uv)     bilinear at uv in [0, 1], clamped borders; the fractions of
//                                        a texture unit have 8 bits

/// Intensity over the profile's maximum, 0..1, in a direction of the profile's own frame, of any
/// length. Beside the interpolation, which is the profile's own, the angles err by
/// 2.5e-7 radians, 6e-7 in single precision.
FN Real eval_profile(Profile profile, Vec3 direction_profile) {
  Vec3 d = direction_profile;
  Vec2 size = profile_size(profile);
  Real vertical = half_turn_angle(d.z, sqrt(d.x * d.x + d.y * d.y)) * k_inv_pi;
  Real half_turn = half_turn_angle(d.x, abs(d.y)) * k_half_inv_pi;
  Real horizontal = select(d.y < Real(0.0), Real(1.0) - half_turn, half_turn);
  return profile_lookup(
      profile, Vec2(table_coordinate(horizontal, size.x), table_coordinate(vertical, size.y)));
}
