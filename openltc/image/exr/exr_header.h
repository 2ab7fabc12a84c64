// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A look at the header of an OpenEXR file before the library reads it. Every reader of such files
// asks here first.

#pragma once

#include <cstdint>
#include <span>

namespace openltc::image {

/// Whether every attribute of the header, or of the headers of at most 4096 parts, lies within
/// `bytes`, the beginning of a file of `file_bytes`, and has the size of its type, and whether the
/// tables of chunks fit into the file. The library takes the memory that these ask for, up to 2 GiB
/// for an attribute and 8 bytes for each tile of a single pixel, before it looks whether the file
/// holds them.
bool exr_header_fits(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

} // namespace openltc::image
