// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Measured materials: files of the MERL BRDF database (.binary), isotropic, one per material.

#pragma once

#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"

#include <cstdint>
#include <span>
#include <string>

namespace openltc::brdf {

/// Reads a measured material. Its eval is the luminance (Rec.709) of the three channels times
/// cos_i, smooth (merl.cpp says how it interpolates), without parameter and without Fresnel part.
/// The name is the file's stem.
///
/// Refuses, with one line that begins with the path: a file that cannot be read, is shorter or
/// longer than its header says, has a dimension outside 1..4096 or more than 2^24 directions,
/// samples that are not finite or above 1e9, or no light in any of them.
Result<Brdf> read_merl(const std::string& path);

/// The same from the file's bytes; `name` stands in for the path in errors.
Result<Brdf> parse_merl(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace openltc::brdf
