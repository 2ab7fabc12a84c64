// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Packed tables as files.
//
// Container by extension: .dds .ktx2 .exr .npy hold one texture a file, .json .h .glsl .hlsl .wgsl
// .js all of a table. A table of two textures written as DIR/ggx.dds becomes DIR/ggx_1.dds and
// DIR/ggx_2.dds, one of three DIR/ggx_3.dds too, one of a single texture DIR/ggx.dds. What the
// table says about itself lies inside the file; .dds and .npy have no room for it, so
// DIR/ggx.dds.json stands beside them.

#pragma once

#include "openltc/base/atomic_file.h"
#include "openltc/base/result.h"
#include "openltc/table/layout.h"

#include <optional>
#include <string>
#include <vector>

namespace openltc::table {

/// Whether write_packed knows the extension of `path`; the error lists those it knows.
Status check_packed_extension(const std::string& path);

/// The files that write_packed makes of a layout for `path`, in the order in which they are
/// written.
std::vector<std::string> packed_files(Layout layout, const std::string& path);

/// The files of the table, those of packed_files in their order, in memory. A native table in
/// single precision as .json is the file of table_file.h.
Result<std::vector<FileBytes>> packed_bytes(const PackedTable& packed, const std::string& path);

/// Writes all files of packed_bytes or none, as write_files does. Returns their paths.
Result<std::vector<std::string>> write_packed(const PackedTable& packed, const std::string& path);

/// Whether there is a table of textures by this name: the file itself, or NAME_1 of it.
bool table_exists(const std::string& path);

/// Textures as files hold them, and the description where there is one.
struct TextureFiles {
  std::vector<std::string> paths;
  std::vector<Texture> textures;
  KeyValues description; ///< empty: a bare texture
};

/// Reads .dds .ktx2 .exr .npy. `path` may name any texture of a table, or what write_packed was
/// given; the others are looked for beside it.
Result<TextureFiles> read_textures(const std::string& path);

/// Reads a table from .dds .ktx2 .exr .npy or .json. Bare textures need `layout`; where the file
/// says itself what it is, `layout` must agree.
Result<PackedTable> read_packed(const std::string& path, std::optional<Layout> layout = {});

} // namespace openltc::table
