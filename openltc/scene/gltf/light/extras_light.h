// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights of every shape, as a node's extras describe them (docs/lights_in_gltf.md lists the
// properties).
//
// Planar shapes emit along the node's -Z, tubes and lines lie along its X axis, spots and
// directional lights shine along -Z. All lengths are multiplied by the largest component of the
// node's world scale, without its sign, as EXT_lights_area does it.

#pragma once

#include "openltc/light/light.h"
#include "openltc/scene/transform.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace openltc::scene::gltf {

struct Document;

/// Adds the light that `properties` describe to `lights`, pictures included. `node` stands for the
/// node in messages, `node_name` becomes the light's name. Throws Failure, whose message names node
/// and property, for whatever cannot be understood or shaded.
void read_extras_light(const nlohmann::json& properties, const std::string& node,
                       const std::string& node_name, const Transform& to_world, Document& document,
                       light::Lights& lights);

} // namespace openltc::scene::gltf
