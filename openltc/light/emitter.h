// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What holds for lights of every shape.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

#include <string>

namespace openltc::light {

bool is_finite(Vec3f v);
/// Whether `p` is finite and no further out than a light of the largest size can reach from the
/// scene's own origin: 4 k_max_metres along each axis.
bool is_place(Vec3f p);
/// Whether a size has a length that shading can square: between 1e-12 m and k_max_metres.
bool is_extent(double metres);
bool is_non_negative(Vec3f v);
bool is_unit(Vec3f v); ///< within 1e-3

/// The error of a light that cannot be shaded: its name and what is wrong.
Error wrong_light(const std::string& name, const char* what);

/// Luminous exitance over radiance, in steradians: the integral of cos^p cos over the hemisphere,
/// 2 pi / (p + 2), which is pi for Lambert's emitter; twice that when two-sided.
double exitance_per_radiance(const Emitter& light);

/// Whether radiance and cosine power are finite and not negative.
Status validate_emitter(const Emitter& light);

} // namespace openltc::light
