// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The containers of tables by the extension of a path.

#pragma once

#include <string>

namespace openltc::table {

/// How a table is written.
enum class Container { dds, ktx2, exr, npy, json, c, glsl, hlsl, wgsl, js };

/// What is fixed for a container.
struct ContainerFacts {
  const char* extension; ///< with its dot, lower case
  Container container;
  bool one_texture; ///< a file each
  bool describes;   ///< has room for the description
};

/// The container of a path's extension, of any case; nullptr when there is none.
const ContainerFacts* container_of(const std::string& path);

/// "DIR/ggx" + "_1" + ".dds", of "DIR/ggx.dds" and "_1".
std::string with_suffix(const std::string& path, const std::string& suffix);

} // namespace openltc::table
