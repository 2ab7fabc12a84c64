// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lambert's BRDF, albedo/pi. The functions below are for albedo 1 and include the cosine.

/// BRDF times cosine, 1/steradian; 0 below the horizon.
FN Real eval_lambert(Vec3 wi_shading) { return max(wi_shading.z, Real(0.0)) * k_inv_pi; }

/// Cosine-distributed direction from two numbers in [0, 1), shading space, z >= 0.
FN Vec3 sample_lambert(Vec2 u) {
  ASSERT_THAT(in_unit_square(u));
  Real radius = sqrt(u.x);
  Real phi = Real(2.0) * k_pi * u.y;
  return Vec3(radius * cos(phi), radius * sin(phi), sqrt(max(Real(1.0) - u.x, Real(0.0))));
}

/// Density of sample_lambert per solid angle.
FN Real pdf_lambert(Vec3 wi_shading) { return max(wi_shading.z, Real(0.0)) * k_inv_pi; }
