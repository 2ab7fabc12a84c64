// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a node says to OpenLTC in its `extras`, which is where Blender writes custom properties.

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace openltc::scene::gltf {

struct Document;

/// Names of the properties, all of them members of a node's `extras`.
inline constexpr const char* k_extras_light = "openltc_light";
inline constexpr const char* k_extras_emits_light = "openltc_emits_light";
inline constexpr const char* k_extras_surface_deviation = "openltc_surface_deviation";

struct NodeExtras {
  /// openltc_light as an object with `type` and its properties, however it was written:
  /// - "openltc_light": {"type": "sphere", "radius": 0.2, ...};
  /// - the same object as a text, which is what a custom property holds;
  /// - "openltc_light": "sphere", "openltc_radius": 0.2, ..., one custom property for each.
  std::optional<nlohmann::json> light;
  bool describes_light = false; ///< there is an openltc_light, readable or not
  /// openltc_emits_light, true or false: whether emissive surfaces of the node's mesh make lights.
  bool emits_light = true;
  /// openltc_surface_deviation in metres: how far the surface that stands for the node's
  /// EXT_lights_area light may leave it; shadow rays stop before.
  double surface_deviation = 0;
};

/// Reads `extras`, any JSON value, of the node that messages call `node`. What cannot be understood
/// is left out with a warning that names node and property.
NodeExtras read_node_extras(const nlohmann::json& extras, const std::string& node,
                            Document& document);

/// Takes everything about the light out of `extras`.
template <class Json> void erase_light(Json& extras) {
  const bool is_flat = extras.contains(k_extras_light);
  extras.erase(k_extras_light);
  if (!is_flat) return;
  for (auto member = extras.begin(); member != extras.end();) {
    const bool is_property = member.key().rfind("openltc_", 0) == 0 &&
                             member.key() != k_extras_emits_light &&
                             member.key() != k_extras_surface_deviation;
    member = is_property ? extras.erase(member) : std::next(member);
  }
}

} // namespace openltc::scene::gltf
