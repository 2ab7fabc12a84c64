// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading and writing picture files, format chosen by the extension.
//
// What a file holds is what a reader gives: NaN, infinities and negative values of an EXR file are
// kept; the metrics (metrics.h) say how they treat them. A PNG or Radiance file cannot hold them,
// so their writers replace them, as said below. Pictures of more than k_max_side pixels a side or
// k_max_pixels in all are refused, by readers before any memory is taken for them.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/image/layer.h"
#include "openltc/image/texels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace openltc::image {

/// Largest picture that is read or written: 65,535 pixels a side, 2^27 (134 million) in all.
inline constexpr int k_max_side = 65535;
inline constexpr std::size_t k_max_pixels = std::size_t(1) << 27;

enum class ExrPrecision { half_float, full_float };

/// Reads .exr, .hdr (scene-linear) or .png, .jpg, .jpeg, .webp (sRGB, decoded to linear).
/// The result has 3 channels, or 4 where the file has alpha; grey is repeated in all three.
/// Of an EXR file it is the picture of the file (choose_layer) in its display window, black where
/// the file has no data. Luminance with chroma, CIE XYZ and other primaries become linear Rec.709.
/// A Radiance file's values are divided by its EXPOSURE and COLORCORR lines, as its format defines.
Result<Image> read(const std::string& path);

/// A picture and which layer of its file it is. Files without layers have one, "".
struct Picture {
  LayerInfo layer;
  Image image;
};

/// Reads one layer of a file that read() reads ("" = the picture itself; e.g. "stderr"); only EXR
/// files have others. The image has 1 channel (grey, one channel), 3 (colours, a vector) or 4
/// (with alpha). The error of a layer that is not there names those that are.
Result<Picture> read_picture(const std::string& path, const std::string& layer);

/// The image of read_picture.
Result<Image> read_layer(const std::string& path, const std::string& layer);

/// The layers of an EXR file (layer.h), and their names.
Result<std::vector<LayerInfo>> list_layers(const std::string& path);
Result<std::vector<std::string>> layer_names(const std::string& path);

/// The same picture with a grey one's values in three channels.
Image grey_as_rgb(Image image);

/// FILE or FILE:LAYER, as a user writes it.
struct PictureName {
  std::string path, layer;
};

/// Cuts FILE.exr:LAYER behind .exr (any case). A file of the whole name goes before that.
PictureName split_picture_name(const std::string& name);

/// Decodes the bytes of a PNG, JPEG or WebP file, told apart by their first bytes, to 4 channels in
/// [0, 1]; alpha is 1 where the file has none. Colours are decoded from sRGB to linear if
/// `srgb_to_linear` is set (base colour, emission), else only scaled (normals, roughness); alpha is
/// only scaled. An error begins with `name`.
Result<Image> decode(std::span<const std::uint8_t> bytes, const std::string& name,
                     bool srgb_to_linear);

/// The same in the file's own precision: the same values, a quarter of the memory or half.
Result<Texels> decode_texels(std::span<const std::uint8_t> bytes, const std::string& name,
                             bool srgb_to_linear);

/// What `read` reads, in the file's own precision where that is 8 or 16 bits; colours of those are
/// taken as sRGB.
Result<Texels> read_texels(const std::string& path);

/// Whether this build reads WebP.
bool can_read_webp();

/// Writes an EXR file: channels R G B (A), or Y, of the first layer, whose name is empty, and
/// NAME.R NAME.G NAME.B (NAME.A), or NAME.Y, of the others. All layers have the same size.
/// Lossless ZIP compression. In half precision finite values beyond +-65504 become +-65504.
/// All writers write to a temporary name beside `path` and rename, so that no half file is left and
/// an older file survives a failure.
Status write_exr(const std::string& path, std::span<const Layer> layers,
                 ExrPrecision precision = ExrPrecision::full_float);

/// A layer whose picture another owns.
struct LayerView {
  std::string name;
  const Image* image = nullptr;
};
Status write_exr_views(const std::string& path, std::span<const LayerView> layers,
                       ExrPrecision precision = ExrPrecision::full_float);

/// Writes a Radiance RGBE file, run-length encoded: 8 bits of mantissa, the exponent shared by the
/// three channels, so the error is at most 1/256 of the pixel's largest channel. Alpha is dropped;
/// negative values and NaN become 0, values beyond 1.7e38 (infinity too) become 1.7e38.
Status write_hdr(const std::string& path, const Image& image);

/// Writes an 8-bit PNG from values that are already display-encoded (sRGB) in [0, 1]; 1, 3 or 4
/// channels. Values outside are clamped, NaN becomes 0.
Status write_png(const std::string& path, const Image& display);

/// The bytes of such a file. `display` has 1, 3 or 4 channels and at least one pixel.
Result<std::vector<std::uint8_t>> encode_png(const Image& display);

/// sRGB transfer function, IEC 61966-2-1, and its inverse. Odd-symmetric for negative values.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

/// Whether read() knows this extension: ".exr", ".hdr", ".png", ".jpg", ".jpeg" (any case).
bool is_readable_extension(const std::string& path);

/// Whether a file with this extension can be written: ".exr", ".hdr", ".png" (any case).
bool is_writable_extension(const std::string& path);

/// Whether a file with this extension holds scene-linear radiance: ".exr", ".hdr" (any case).
bool is_scene_linear_extension(const std::string& path);

} // namespace openltc::image
