// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The directional albedo of GGX: what ggx-ms divides by.

#pragma once

namespace openltc::brdf {

/// Integral over wi of D V cos_i, height-correlated GGX with F = 1; 0 < cos_o <= 1, roughness 0..1.
///
/// Interpolates a table that the first call computes (k_albedo_error states the error); calls from
/// several threads are safe.
double ggx_albedo(double cos_o, double roughness);

/// Bound on the error of ggx_albedo; a test compares with a finer rule of another kind.
constexpr double k_albedo_error = 1e-5;

} // namespace openltc::brdf
