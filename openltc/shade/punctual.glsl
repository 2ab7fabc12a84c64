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
