// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From a glTF primitive to triangles in the mesh's own space.

#pragma once

#include "openltc/scene/scene.h"

#include <cstddef>
#include <string>

namespace openltc::scene::gltf {

struct Document;

/// Which optional arrays a primitive's material asks for.
struct VertexNeeds {
  bool tex_coord[2] = {false, false};
  int tangent_tex_coord = -1; ///< set of the normal map, -1 = no tangents needed
};

/// The triangles of meshes[mesh].primitives[primitive], with normals and whatever else the file has
/// or `needs` asks for. No triangles when the primitive is made of points or lines or has no area.
/// Throws Failure.
Mesh read_primitive(Document& document, std::size_t mesh, std::size_t primitive,
                    const VertexNeeds& needs);

} // namespace openltc::scene::gltf
