// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Intensity of a point or spot light by direction, from a measured profile.
//
// The profile is a grid regular in the very angles in which such light is measured, so that a file
// whose angles are multiples of the grid's step is interpolated here as it is there: bilinearly
// between its own nodes. Both angles come from one polynomial for the arc tangent. The angle to the
// axis is taken as atan2(sine, cosine), which unlike acos(cosine) keeps its precision near the axis,
// where narrow beams have all their light.
//
// The profile's own frame: z to the pole of the file's angles, x at azimuth 0, y at 90 degrees; with
// up = -z, y = cross(up, x). For type C that is the light's own frame, z to the nadir; for types A
// and B it lies across (light/photometry/ies.h), so that those are interpolated in their own angles as well.
//
// The prelude of each target gives
//   Vec2 profile_size(Profile)           columns, rows
//   Real profile_lookup(Profile, uv)     bilinear at uv in [0, 1], clamped borders; the fractions of
//                                        a texture unit have 8 bits

/// atan(x) for x in [0, 1]: odd minimax polynomial of degree 13, absolute error 2.5e-7.
FN Real atan_unit(Real x) {
  Real y = x * x;
  return x *
         (Real(0.999996111549571) +
          y * (Real(-0.33317368054749336) +
               y * (Real(0.19807815564989179) +
                    y * (Real(-0.13233342095574632) +
                         y * (Real(0.07962367236561659) + y * (Real(-0.033604220565024996) +
                                                               y * Real(0.006811793290873252)))))));
}

/// Angle of (x, y) from the x axis for y >= 0, in [0, pi]; 0 where both vanish.
FN Real half_turn_angle(Real x, Real y) {
  Real ax = abs(x);
  Real larger = max(ax, y);
  Real angle = atan_unit(min(ax, y) / max(larger, Real(k_tiny)));
  angle = select(y > ax, Real(0.5) * k_pi - angle, angle);
  return select(x < Real(0.0), k_pi - angle, angle);
}

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
