// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The containers that hold one texture, in memory: each with its writer and its reader.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/texture.h"

#include <span>
#include <string>

namespace openltc::table {

// A writer takes 1, 2 or 4 channels, as tables have them, and a size that check_texture_size
// accepts. A reader takes any bytes: it gives a texture of finite values or an error that begins
// with `name`.

/// DirectDraw surface with a DX10 header: R, RG or RGBA, 16 or 32 bits. Holds no metadata. The
/// reader also takes the older header with FourCC 111 to 116; of mip levels it reads the first.
Bytes encode_dds(const Texture& texture);
Result<Texture> decode_dds(ByteView bytes, const std::string& name);

/// Khronos texture 2.0 of the same formats, uncompressed, one level; metadata as key/values.
/// The reader does not take arrays, of layers of one size, channels and precision.
Bytes encode_ktx2(const Texture& texture);
Bytes encode_ktx2_array(std::span<const Texture> layers);
Result<Texture> decode_ktx2(ByteView bytes, const std::string& name);

/// OpenEXR, not compressed: channels R G B A, R G or R; metadata as string attributes
/// "openltc.KEY".
Bytes encode_exr(const Texture& texture);
Result<Texture> decode_exr(ByteView bytes, const std::string& name);

/// NumPy array, format 1.0: shape (rows, columns, channels), '<f4' or '<f2'. Holds no metadata.
/// The reader also takes shape (rows, columns).
Bytes encode_npy(const Texture& texture);
Result<Texture> decode_npy(ByteView bytes, const std::string& name);

} // namespace openltc::table
