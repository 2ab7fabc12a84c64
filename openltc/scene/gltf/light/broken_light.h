// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A light that its file does not describe well costs that light, not the file.

#pragma once

#include "openltc/scene/warnings.h"

#include <nlohmann/json_fwd.hpp>
#include <set>

namespace openltc::scene::gltf {

/// Takes lights of KHR_lights_punctual and EXT_lights_area that lack a member or have a wrong one
/// out of the nodes that refer to them, each with a warning; also references without an index.
/// Their places in the arrays stay, filled with a dark light, so that other indices hold. Returns
/// the nodes that lost a light. `root` may be any JSON; what is wrong elsewhere is left to
/// check_schema.
std::set<int> drop_broken_lights(nlohmann::json& root, Warnings& warnings);

} // namespace openltc::scene::gltf
