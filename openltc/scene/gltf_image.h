// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Decoding the pictures inside a glTF file.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"

#include <cstdint>
#include <span>
#include <string>

namespace openltc::scene::gltf {

/// Pictures larger than this in either direction are refused before they are decoded.
inline constexpr int k_max_image_side = 16384;

/// Pixels of all textures of a scene together: 4 GiB as float RGBA.
inline constexpr std::size_t k_max_total_pixels = std::size_t(1) << 28;

/// A PNG or JPEG as four float channels in [0, 1]; RGB decoded from sRGB if asked for, alpha never.
/// `name` stands for the picture in the error.
Result<image::Image> decode(std::span<const std::uint8_t> bytes, const std::string& name,
                            bool srgb_to_linear);

/// Pixels that decode() would make, 0 when the picture is not readable.
std::size_t pixel_count(std::span<const std::uint8_t> bytes);

} // namespace openltc::scene::gltf
