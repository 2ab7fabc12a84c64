// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// EXT_lights_ies, and the photometric files of a scene.
//
// Source: KhronosGroup/glTF, extensions/2.0/Vendor/EXT_lights_ies. The file's direction (0, 0) is
// the node's -Z, the X/Z plane its vertical plane, so that the horizontal angle 0 of type C is +X.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/scene/transform.h"
#include "openltc/scene/warnings.h"

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

inline constexpr const char* k_lights_ies = "EXT_lights_ies";
inline constexpr const char* k_ies_mime_type = "application/x-ies-lm-63";

/// extensions.EXT_lights_ies.lights[i]: either a reference or a view.
struct IesSource {
  std::string name, uri;
  int view = -1;
};

/// extensions.EXT_lights_ies of a node.
struct IesNode {
  int light = -1;
  double multiplier = 1;
  double color[3] = {1, 1, 1}; ///< within 0 .. 1
};

struct IesLights {
  std::vector<IesSource> sources;
  std::map<int, IesNode> nodes;

  const IesNode* of_node(int index) const {
    const auto found = nodes.find(index);
    return found == nodes.end() ? nullptr : &found->second;
  }
};

/// What `root` says of it. A light whose members cannot be used is left out with a warning.
IesLights list_ies_lights(const nlohmann::json& root, Warnings& warnings);

/// Adds the light of a node, placed by `to_world`, to `lights`; or a warning, when its file cannot
/// be used.
void read_ies_light(Document& document, const IesNode& node, const Transform& to_world,
                    const std::string& node_name, light::Lights& lights);

/// Photometric files, each read once however many lights have it.
class ProfileFiles {
public:
  /// The file at `path`; what was put right in it becomes a warning. Throws Failure that names
  /// `field`.
  std::shared_ptr<const light::IesProfile> read(const std::string& path, const std::string& field,
                                                Warnings& warnings);
  /// The same from the text of a file inside the scene, which messages call `field`.
  std::shared_ptr<const light::IesProfile> parse(std::string_view text, const std::string& field,
                                                 Warnings& warnings);

private:
  struct Entry {
    std::shared_ptr<const light::IesProfile> profile; ///< null: `error` says why
    std::string error;
  };

  std::shared_ptr<const light::IesProfile> find(const std::string& key,
                                                const std::string& field) const;
  std::shared_ptr<const light::IesProfile> keep(const std::string& key, const std::string& field,
                                                Result<light::IesProfile> profile,
                                                Warnings& warnings);

  std::map<std::string, Entry> known_; ///< by path or field
};

} // namespace openltc::scene::gltf
