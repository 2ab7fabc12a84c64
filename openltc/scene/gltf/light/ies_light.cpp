// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/light/ies_light.h"

#include "openltc/light/photometry/photometry.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/name.h"
#include "openltc/scene/gltf/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

constexpr double k_largest_candela = 1e30;

// The extension's object in `object`, null where there is none.
const json* ies_extension_of(const json& object) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(k_lights_ies);
  return found == extensions->end() ? nullptr : &*found;
}

// A whole number from 0 to below `count`; -1 for anything else.
int ies_index_in(const json& value, std::size_t count) {
  if (!value.is_number()) return -1;
  const double number = value.get<double>();
  const bool is_index = number >= 0 && number < double(count) && number == std::floor(number);
  return is_index ? int(number) : -1;
}

std::string ies_text_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

IesSource read_ies_source(const json& light, const json& root, const std::string& field,
                          Warnings& warnings) {
  if (!light.is_object()) fail(field, "must be an object");
  IesSource source;
  source.name = ies_text_of(light, "name");
  source.uri = ies_text_of(light, "uri");
  if (!source.uri.empty()) return source;
  if (!light.contains("bufferView"))
    fail(field, "has neither uri nor bufferView; export the file again");
  const auto views = root.find("bufferViews");
  source.view = ies_index_in(light["bufferView"], views == root.end() ? 0 : views->size());
  if (source.view < 0) fail(field + ".bufferView", "points at no buffer view");
  if (ies_text_of(light, "mimeType") != k_ies_mime_type)
    warnings.add(fmt::format("{}.mimeType: is not {}; the buffer view is read as if it were", field,
                             k_ies_mime_type));
  return source;
}

IesNode read_ies_node(const json& object, const std::string& field, std::size_t light_count,
                      Warnings& warnings) {
  if (!object.is_object()) fail(field, "must be an object");
  IesNode node;
  if (!object.contains("light")) fail(field + ".light", "is missing");
  node.light = ies_index_in(object["light"], light_count);
  if (node.light < 0)
    fail(field + ".light", fmt::format("points at no light; there are {}", light_count));
  if (object.contains("multiplier")) {
    const json& value = object["multiplier"];
    node.multiplier = value.is_number() ? value.get<double>() : -1;
    if (!(node.multiplier >= 0 && node.multiplier <= k_largest_candela))
      fail(field + ".multiplier", "must be a number, 0 or more");
  }
  if (object.contains("color")) {
    const json& value = object["color"];
    const bool is_color = value.is_array() && value.size() == 3 && value[0].is_number() &&
                          value[1].is_number() && value[2].is_number();
    if (!is_color) fail(field + ".color", "must be three numbers from 0 to 1");
    for (std::size_t c = 0; c < 3; ++c) {
      const double channel = value[c].get<double>();
      node.color[c] = channel > 0 ? std::min(channel, 1.0) : 0.0;
      if (node.color[c] != channel)
        warnings.add(fmt::format("{}.color: {} is not within 0 .. 1; {} is used", field, channel,
                                 node.color[c]));
    }
  }
  return node;
}

std::string_view text_of_bytes(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::shared_ptr<const light::IesProfile> profile_of(Document& document, int index) {
  const IesSource& source = document.ies_lights.sources[std::size_t(index)];
  const std::string field = fmt::format("extensions.{}.lights[{}]", k_lights_ies, index);
  if (source.view >= 0)
    return document.profiles.parse(text_of_bytes(document.views[std::size_t(source.view)].bytes),
                                   field, document.warnings);
  const bool is_embedded = source.uri.rfind("data:", 0) == 0;
  if (!is_embedded)
    return document.profiles.read(resolve_uri(source.uri, document.base_dir, field + ".uri"),
                                  field + ".uri", document.warnings);
  const std::vector<std::uint8_t> bytes =
      read_uri(source.uri, document.base_dir, field + ".uri", document.memory);
  return document.profiles.parse(text_of_bytes(bytes), field, document.warnings);
}

} // namespace

IesLights list_ies_lights(const json& root, Warnings& warnings) {
  IesLights found;
  const auto guarded = [&](const auto& action) {
    try {
      action();
    } catch (const Failure& failure) {
      warnings.add(failure.message + "; the light is left out");
    }
  };
  const std::string root_field = fmt::format("extensions.{}", k_lights_ies);
  if (const json* extension = ies_extension_of(root)) {
    const auto lights = extension->is_object() ? extension->find("lights") : extension->end();
    if (extension->is_object() && lights != extension->end() && lights->is_array())
      for (std::size_t i = 0; i < lights->size(); ++i) {
        found.sources.emplace_back();
        guarded([&] {
          found.sources[i] = read_ies_source((*lights)[i], root,
                                             fmt::format("{}.lights[{}]", root_field, i), warnings);
        });
      }
    else
      warnings.add(root_field + ".lights: is no array; its lights are left out");
  }
  const auto nodes = root.find("nodes");
  if (nodes == root.end()) return found;
  for (std::size_t i = 0; i < nodes->size(); ++i)
    if (const json* extension = ies_extension_of((*nodes)[i]))
      guarded([&] {
        const IesNode node =
            read_ies_node(*extension, fmt::format("nodes[{}].extensions.{}", i, k_lights_ies),
                          found.sources.size(), warnings);
        const IesSource& source = found.sources[std::size_t(node.light)];
        if (!source.uri.empty() || source.view >= 0) found.nodes[int(i)] = node;
      });
  return found;
}

void read_ies_light(Document& document, const IesNode& node, const Transform& to_world,
                    const std::string& node_name, light::Lights& lights) {
  const std::string field = fmt::format("extensions.{}.lights[{}]", k_lights_ies, node.light);
  light::PunctualLight light;
  try {
    light.profile = profile_of(document, node.light);
    const Placement placement = placement_of(to_world, field, document);
    light.position = to_float(placement.position);
    light.direction = to_float(-placement.back);
    light.right = to_float(placement.right);
  } catch (const Failure& failure) {
    document.warnings.add(failure.message + "; the light is left out");
    return;
  }
  const double candela = node.multiplier * light.profile->max_candela;
  const auto channel = [&](int c) {
    return float(std::min(node.color[c] * candela, k_largest_candela));
  };
  light.intensity = Vec3f(channel(0), channel(1), channel(2));
  const IesSource& source = document.ies_lights.sources[std::size_t(node.light)];
  light.name = first_name_of(node_name, source.name, light.profile->name);
  lights.punctual.push_back(std::move(light));
}

std::shared_ptr<const light::IesProfile> ProfileFiles::keep(const std::string& key,
                                                            const std::string& field,
                                                            Result<light::IesProfile> profile,
                                                            Warnings& warnings) {
  Entry& entry = known_[key];
  if (!profile) {
    entry.error = profile.error().message;
    fail(field, entry.error);
  }
  for (const std::string& warning : profile->warnings)
    warnings.add(warning);
  return entry.profile = std::make_shared<const light::IesProfile>(std::move(*profile));
}

std::shared_ptr<const light::IesProfile> ProfileFiles::find(const std::string& key,
                                                            const std::string& field) const {
  const auto known = known_.find(key);
  if (known == known_.end()) return nullptr;
  if (!known->second.profile) fail(field, known->second.error);
  return known->second.profile;
}

std::shared_ptr<const light::IesProfile>
ProfileFiles::read(const std::string& path, const std::string& field, Warnings& warnings) {
  const std::string key = canonical_path(path);
  if (auto known = find(key, field)) return known;
  return keep(key, field, light::read_photometry(path), warnings);
}

std::shared_ptr<const light::IesProfile>
ProfileFiles::parse(std::string_view text, const std::string& field, Warnings& warnings) {
  if (auto known = find(field, "")) return known;
  return keep(field, "", light::parse_photometry(text, field), warnings);
}

} // namespace openltc::scene::gltf
