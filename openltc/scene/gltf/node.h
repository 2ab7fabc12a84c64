// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Places what the nodes carry in the world: meshes, cameras and lights.

#pragma once

#include "openltc/scene/gltf/hierarchy.h"
#include "openltc/scene/gltf/import.h"

namespace openltc::scene::gltf {

struct Document;

/// Goes through the file's default scene (else its first one, else all root nodes), its nodes in
/// `pose` (hierarchy.h), and fills the scene's origin, meshes, cameras and the lights that
/// nodes carry, extras_lights and to_world. Throws Failure, also for cycles, for nodes with several
/// parents and for what lies beyond light::k_max_metres.
void read_nodes(Document& document, std::span<const NodePose> pose, Imported& imported);

} // namespace openltc::scene::gltf
