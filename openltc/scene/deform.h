// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Vertices bent by the joints of a skeleton: glTF 2.0 specification, section 3.7.3.3.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

#include <cstdint>
#include <span>
#include <vector>

namespace openltc::scene {

/// Which joints move each vertex, and how much: `per_vertex` of both, vertex after vertex.
struct Influences {
  std::size_t per_vertex = 0;
  std::vector<std::uint32_t> joints; ///< in range of the transforms
  std::vector<float> weights;        ///< 0 or more; those of a vertex are taken as shares
};

/// Moves every vertex of `mesh` by the weighted mean of the transforms of its joints, normals and
/// tangents along. Where that turns a triangle inside out, its corners change places. A vertex
/// without weights follows its first joint.
void bend(Mesh& mesh, const Influences& influences, std::span<const Transform> joints);

} // namespace openltc::scene
