// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What lights and cameras are called.

#pragma once

#include <string>

namespace openltc::scene::gltf {

/// The first of these names that is not empty: the node's, the object's own, its place in the file.
inline const std::string& first_name_of(const std::string& node, const std::string& own,
                                        const std::string& field) {
  return !node.empty() ? node : !own.empty() ? own : field;
}

} // namespace openltc::scene::gltf
