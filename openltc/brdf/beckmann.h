// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The parts of a Beckmann microfacet BRDF.

#pragma once

#include "openltc/target/vec.h"

namespace openltc::brdf {

/// Distribution of normals, 1/steradian; integral of D cos over the hemisphere is 1. alpha > 0.
double beckmann_distribution(Vec3d h, double alpha);

/// Height-correlated Smith visibility G2 / (4 cos_o cos_i) with the exact Lambda; cosines > 0.
double beckmann_visibility(double cos_o, double cos_i, double alpha);

} // namespace openltc::brdf
