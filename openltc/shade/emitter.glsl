// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Emission that depends on direction.

/// Radiance at an angle from the emitter's normal over that along it, cos^power. power = 0 is
/// Lambert's emitter.
FN Real cosine_emission(Real cos_light, Real power) {
  Real factor = pow(min(max(cos_light, Real(1.0e-6)), Real(1.0)), power);
  return select(power > Real(0.0), factor, Real(1.0));
}
