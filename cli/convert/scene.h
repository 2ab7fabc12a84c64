// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc convert of a scene.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/read_options.h"

#include <string>

namespace openltc::cli {

/// Whether `path` has the extension of a scene, .gltf or .glb.
bool is_scene_file(const std::string& path);

/// Writes the scene `input` to `output`, a .glb, with its lights as EXT_lights_area and
/// EXT_lights_ies, and says on stderr, unless `quiet`, what became of them.
Status convert_scene(const std::string& input, const std::string& output,
                     const scene::EmissiveOptions& emissive, const scene::ReadOptions& reading,
                     bool quiet);

} // namespace openltc::cli
