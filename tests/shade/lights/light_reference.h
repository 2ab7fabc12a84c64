// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a light's integral is, in double: two ways that share nothing with the shading source but
// the density of the lobe.

#pragma once

#include "tests/shade/lights/light_fixture.h"

namespace openltc::testing {

/// Vector irradiance of the part of the light above both horizons, cosine space: its z component is
/// the integral of the lobe over the light, its direction the mean direction there. Divided by the
/// tube's diameter for lines.
///
/// The boundary of what is seen, straight edges and conic arcs, cut where it crosses a horizon and
/// closed along the horizons; straight pieces by their angle, arcs by adaptive Gauss-Kronrod
/// quadrature of (1/2pi) o x do / |o|^2 to 1e-11. Lines by quadrature along the line.
/// `surface_horizon` false leaves the light below the surface in: what published formulas take.
Vec3d contour_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe,
                       bool surface_horizon = true);

/// The integral alone by quadrature of density * cosine / distance^2 over the light's surface, row
/// by row, rows cut where they cross a horizon or turn away. For lobes that are not too narrow.
/// With `front`, only what lies in front of the plane through the point of that normal, world
/// space.
double surface_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe,
                        double tolerance, const Vec3d* front = nullptr);

} // namespace openltc::testing
