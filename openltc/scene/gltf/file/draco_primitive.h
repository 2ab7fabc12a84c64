// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The part of a primitive that KHR_draco_mesh_compression compresses.

#pragma once

#include "openltc/scene/gltf/file/draco.h"

#include <optional>
#include <string>

namespace tinygltf {
struct Primitive;
}

namespace openltc::scene::gltf {

struct Document;

/// Decodes it, its normalised integers scaled as accessors' are; nothing if the primitive has none.
/// `field` is the primitive's path in messages. Throws Failure as decode_draco does.
std::optional<DracoMesh> decode_draco_part(const Document& document,
                                           const tinygltf::Primitive& primitive,
                                           const std::string& field);

} // namespace openltc::scene::gltf
