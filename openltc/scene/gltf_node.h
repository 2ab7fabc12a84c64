// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The node hierarchy: places meshes, cameras and lights in the world.

#pragma once

#include "openltc/scene/gltf_import.h"

namespace openltc::scene::gltf {

struct Document;

/// Walks the file's default scene (else its first one, else all root nodes) and fills the scene's
/// meshes, cameras and the lights that nodes carry, extras_lights and to_world. Throws Failure,
/// also for cycles and for nodes with several parents.
void read_nodes(Document& document, Imported& imported);

} // namespace openltc::scene::gltf
