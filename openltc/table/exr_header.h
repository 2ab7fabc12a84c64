// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A look at the header of an OpenEXR file before the library reads it. Private to this folder.

#pragma once

#include "openltc/table/texture.h"

namespace openltc::table {

/// Whether every attribute of the header, or of the headers of many parts, lies within the file and
/// has the size of its type. The library takes the memory that an attribute asks for, up to 2 GiB,
/// before it looks whether the file holds it.
bool exr_attributes_fit(ByteView bytes);

} // namespace openltc::table
