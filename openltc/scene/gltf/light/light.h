// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights that nodes carry.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

namespace openltc::scene::gltf {

struct Document;

/// extensions.KHR_lights_punctual.lights[index], placed by `to_world`.
light::PunctualLight read_punctual_light(Document& document, int index, const Transform& to_world,
                                         const std::string& node_name);

/// Adds extensions.EXT_lights_area.lights[index], placed by `to_world`, to `lights`: a rectangle or
/// a disk. One without a usable size is left out with a warning. `surface_deviation` in metres is
/// that of the light.
void read_area_light(Document& document, int index, const Transform& to_world,
                     const std::string& node_name, double surface_deviation, light::Lights& lights);

} // namespace openltc::scene::gltf
