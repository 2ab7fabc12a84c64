// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From a glTF primitive to triangles in the mesh's own space, bent by morph targets and skins.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// Which optional arrays a primitive's material asks for.
struct VertexNeeds {
  bool tex_coord[2] = {false, false};
  int tangent_tex_coord = -1; ///< set of the normal map, -1 = no tangents needed
};

/// What bends a mesh.
struct Deformation {
  std::vector<double> weights;       ///< of the morph targets; missing ones are 0
  std::span<const Transform> joints; ///< from the mesh to where it is wanted; none: no skin
};

struct Primitive {
  Mesh mesh;
  bool is_skinned = false; ///< the joints have placed it
};

/// The triangles of meshes[mesh].primitives[primitive], with normals and whatever else the file has
/// or `needs` asks for. No triangles when the primitive is made of points or lines or has no area.
/// Throws Failure.
Primitive read_primitive(Document& document, std::size_t mesh, std::size_t primitive,
                         const VertexNeeds& needs, const Deformation& deformation);

} // namespace openltc::scene::gltf
