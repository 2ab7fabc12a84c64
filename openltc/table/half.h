// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Half precision, IEEE 754 binary16: 1 sign bit, 5 of exponent, 10 of mantissa.

#pragma once

#include <cstdint>

namespace openltc::table {

/// Largest finite value of half precision.
inline constexpr float k_half_max = 65504.0f;

/// The half nearest to `value`, ties to even; below 2^-14 in steps of 2^-24, the subnormals.
/// Finite values from 65520 on and infinities become infinite; NaN stays NaN.
std::uint16_t half_from_float(float value);

/// The value of a half, exactly.
float float_from_half(std::uint16_t half);

/// `value` as it comes back from a file in half precision.
inline float rounded_to_half(float value) { return float_from_half(half_from_float(value)); }

} // namespace openltc::table
