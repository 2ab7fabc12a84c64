// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The parts of the Charlie sheen; charlie.cpp has the formulas.

#pragma once

#include "openltc/target/vec.h"

namespace openltc::brdf {

/// Distribution of normals, 1/steradian; integral of D cos over the hemisphere is 1. 0 < alpha
/// <= 1.
double charlie_distribution(Vec3d h, double alpha);

/// Smith's Lambda as the paper fits it; 0 <= cosine <= 1.
double charlie_lambda(double cosine, double alpha);

} // namespace openltc::brdf
