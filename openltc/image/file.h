// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading and writing picture files, format chosen by the extension.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace openltc::image {

enum class ExrPrecision { half_float, full_float };

/// Reads .exr, .hdr (scene-linear) or .png/.jpg/.jpeg (sRGB, decoded to linear). 3 or 4 channels.
/// An EXR's further layers are ignored here; see read_layer.
Result<Image> read(const std::string& path);

/// Reads one named layer of an EXR file ("" = the picture itself, e.g. "stderr").
Result<Image> read_layer(const std::string& path, const std::string& layer);

/// Writes an EXR file, channels R G B (A) for the first layer and NAME.R NAME.G NAME.B for others.
/// All writers write to a temporary name beside `path` and rename, so that no half file is left and
/// an older file survives a failure.
Status write_exr(const std::string& path, std::span<const Layer> layers,
                 ExrPrecision precision = ExrPrecision::full_float);

/// Writes a Radiance RGBE file.
Status write_hdr(const std::string& path, const Image& image);

/// Writes an 8-bit PNG from values that are already display-encoded (sRGB) in [0, 1]; 1, 3 or 4
/// channels. Values outside are clamped, NaN becomes 0.
Status write_png(const std::string& path, const Image& display);

/// sRGB transfer function, IEC 61966-2-1, and its inverse.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

/// Whether a file with this extension can be written: ".exr", ".hdr", ".png" (any case).
bool is_writable_extension(const std::string& path);

} // namespace openltc::image
