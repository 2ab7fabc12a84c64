// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes files of the MERL format, since those of the database may not be given away.

#pragma once

#include "openltc/brdf/brdf.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace openltc::test {

/// The header and 3 n samples as bytes.
std::vector<std::uint8_t> merl_bytes(const std::array<std::int32_t, 3>& counts,
                                     const std::vector<double>& samples);

/// The samples of a grey material: each bin holds `brdf` (without the cosine) at its middle, and
/// -1, missing, where a direction lies below the horizon.
std::vector<double> merl_samples(const std::array<std::int32_t, 3>& counts, const brdf::Brdf& brdf,
                                 double roughness);

} // namespace openltc::test
