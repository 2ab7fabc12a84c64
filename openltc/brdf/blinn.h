// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The distribution of normals of Blinn-Phong.

#pragma once

#include "openltc/target/vec.h"

namespace openltc::brdf {

/// The exponent whose lobe is as wide as Beckmann's of that alpha: 2/alpha^2 - 2; 0 < alpha <= 1.
double blinn_exponent(double alpha);

/// Distribution of normals, 1/steradian; integral of D cos over the hemisphere is 1.
double blinn_distribution(Vec3d h, double exponent);

} // namespace openltc::brdf
