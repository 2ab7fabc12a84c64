// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The formulas of the document that this project began with, taken literally, and what they
// integrate to. They are wrong; docs/source_document.md says why. Only `openltc plot literal` draws
// them: nothing shades with them. Sections are those of that document.
//
// Directions are unit, in shading space, and point away from the surface. Integrals are sums over
// points of the sphere, those of lobes good to 1 in 1000 for view angles up to 60 degrees.

#pragma once

#include "openltc/target/shade_f64.h"

namespace openltc::plot {

/// A quantity by the corrected formula and by the source document's.
struct Slip {
  double correct = 0;
  double literal = 0;
};

/// Section 0.1, the specular term D G / (4 cos_o cos_i) with F = 1 and the G of 0.1.1, times cos_i.
/// That G is the visibility, which already holds the denominator.
double literal_ggx(Vec3d wo, Vec3d wi, double alpha);

/// Section 0.1.1, F0 + (1 - F0) (1 - cos^5): the exponent stands inside the bracket.
double literal_schlick(double f0, double cos_theta);

/// Section 0.1.2, D(w) with |M^-1| read as the Frobenius norm, as the bars beside it are norms. It
/// even depends on the scale of M^-1, here 1 in the middle.
double literal_lobe(const f64::Lobe& lobe, Vec3d wi);

/// Section 0.1.3, I_specular with k_s = 1: no 1/pi, no amplitude, and |M^-1 w| for |M^-1|.
double literal_point_light(const f64::Lobe& lobe, Vec3d wi);

/// The same where |M^-1 w| is understood as the determinant: pi D(w).
double literal_point_light_by_determinant(const f64::Lobe& lobe, Vec3d wi);

/// What a white surface, F = 1, reflects of a white sky: the integral of BRDF times cosine.
Slip white_furnace(double alpha, double cos_theta);

/// Schlick's reflectance at a smooth surface, whose normal is the half vector.
Slip fresnel_reflectance(double f0, double cos_theta);

/// The specular reflectance if k_s is F as well: Fresnel once, and twice.
Slip fresnel_twice(double f0, double cos_theta);

/// The integral of the lobe over the sphere, with the determinant and with the norm.
Slip lobe_integral(const f64::Lobe& lobe);

/// What the integral of BRDF times cosine is, F0 n1 + (1 - F0) n5, and what D ~ BRDF cos takes it
/// for: the integral of D.
Slip lobe_amplitude(const f64::FittedLobe& fitted, double f0);

/// The integrals of both readings of I_specular over the sphere.
struct PointLightIntegrals {
  double by_length = 0;
  double by_determinant = 0;
};
PointLightIntegrals point_light_integrals(const f64::Lobe& lobe);

} // namespace openltc::plot
