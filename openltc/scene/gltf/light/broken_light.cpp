// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/light/broken_light.h"

#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/schema.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

struct Kind {
  const char* extension;
  const char* type; // of the schema
  const char* dark; // a light that is valid
};
constexpr Kind k_kinds[] = {
    {"KHR_lights_punctual", "light_punctual", R"({"type": "point", "intensity": 0})"},
    {"EXT_lights_area", "light_area", R"({"type": "disk", "intensity": 0})"}};

json* member(json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

// Members by name, one in the other; none when one is not there.
template <class... Names> json* member(json& object, const char* name, Names... names) {
  json* const next = member(object, name);
  return next ? member(*next, names...) : nullptr;
}

// Which lights of the extension are broken; they are made dark.
std::set<std::uint64_t> darken_broken(json& root, const Kind& kind, Warnings& warnings) {
  std::set<std::uint64_t> broken;
  json* const lights = member(root, "extensions", kind.extension, "lights");
  if (!lights || !lights->is_array()) return broken;
  for (std::size_t i = 0; i < lights->size(); ++i) {
    try {
      check_member(root, (*lights)[i], fmt::format("extensions.{}.lights[{}]", kind.extension, i),
                   kind.type);
    } catch (const Failure& failure) {
      warnings.add(failure.message + "; the light is left out");
      (*lights)[i] = json::parse(kind.dark);
      broken.insert(i);
    }
  }
  return broken;
}

} // namespace

std::set<int> drop_broken_lights(json& root, Warnings& warnings) {
  std::set<int> lost;
  json* const nodes = member(root, "nodes");
  if (!nodes || !nodes->is_array()) return lost;
  for (const Kind& kind : k_kinds) {
    const std::set<std::uint64_t> broken = darken_broken(root, kind, warnings);
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      json* const reference = member((*nodes)[i], "extensions", kind.extension);
      if (!reference || !reference->is_object()) continue;
      const json* const light = member(*reference, "light");
      if (!light)
        warnings.add(fmt::format("nodes[{}].extensions.{}.light: is missing; the light is left out",
                                 i, kind.extension));
      else if (!light->is_number_unsigned() || !broken.contains(light->get<std::uint64_t>()))
        continue;
      (*nodes)[i]["extensions"].erase(kind.extension);
      lost.insert(int(i));
    }
  }
  return lost;
}

} // namespace openltc::scene::gltf
