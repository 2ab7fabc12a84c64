// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Morph targets: glTF 2.0 specification, section 3.7.2.2.

#pragma once

#include "openltc/scene/scene.h"

#include <map>
#include <span>
#include <string>

namespace openltc::scene::gltf {

struct Document;

/// Adds to the vertices of `mesh` what `targets`, accessors by attribute, make of them; missing
/// weights are 0. They hold differences to the attributes of the same name, three numbers for a
/// tangent; those that the mesh lacks are left out. `primitive` stands for it in messages. Normals
/// keep no unit length. Throws Failure for accessors that do not fit the mesh.
void add_targets(const Document& document, std::span<const std::map<std::string, int>> targets,
                 const std::string& primitive, std::span<const double> weights, Mesh& mesh);

} // namespace openltc::scene::gltf
