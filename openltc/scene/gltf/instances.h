// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// EXT_mesh_gpu_instancing: one mesh many times.

#pragma once

#include "openltc/scene/transform.h"

#include <cstddef>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// From the mesh of nodes[node], once for each of its instances, to the node's own space; the
/// identity alone for a node without the extension. Throws Failure when the instances cannot be
/// read.
std::vector<Transform> read_instances(Document& document, std::size_t node);

} // namespace openltc::scene::gltf
