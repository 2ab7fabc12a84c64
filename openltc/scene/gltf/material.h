// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Materials and the textures that they use.

#pragma once

#include "openltc/scene/gltf/primitive.h"
#include "openltc/scene/scene.h"

namespace openltc::scene::gltf {

struct Document;

/// Fills scene.materials, one for each of the file, and scene.textures, each used texture once per
/// colour space and sampler. A picture that cannot be read costs its texture and a warning. Throws
/// Failure.
void read_materials(Document& document, Scene& scene);

/// Which texture coordinates and tangents `material` makes a mesh need.
VertexNeeds vertex_needs(const Material& material);

} // namespace openltc::scene::gltf
