// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
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
