// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A look at the header of an OpenEXR file before the library reads it. Every reader of such files
// asks here first.

#pragma once

#include <cstdint>
#include <span>

namespace openltc::image {

/// Whether every attribute of the header, or of the headers of many parts, lies within the file and
/// has the size of its type. The library takes the memory that an attribute asks for, up to 2 GiB,
/// before it looks whether the file holds it.
bool exr_attributes_fit(std::span<const std::uint8_t> bytes);

} // namespace openltc::image
