// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A glTF file in memory: its structure as tinygltf gives it, and the bytes behind it.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/scene/gltf/file/container.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/light/extras.h"
#include "openltc/scene/gltf/light/ies_light.h"
#include "openltc/scene/warnings.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace openltc::scene::gltf {

/// How messages call a node: its place in the file, and its name if it has one.
std::string node_label(std::size_t index, const std::string& name);

/// The bytes of a buffer view, uncompressed.
struct View {
  std::span<const std::uint8_t> bytes;
  std::size_t stride = 0; ///< 0 = tightly packed
};

/// Where an image comes from: either a view or an URI.
struct ImageSource {
  std::string name;
  std::string uri;
  std::string mime_type;
  int view = -1;
};

/// Where the picture of a texture is.
struct TextureSource {
  std::vector<int> images; ///< the first that can be read counts
  std::string foreign;     ///< when there is none: the extension that has the picture
};

/// One of the file's animations.
struct FileAnimation {
  std::size_t index = 0; ///< in the file
  nlohmann::json json;
};

/// A checked document. All indices between its parts are in range; accessors are checked when they
/// are read.
struct Document {
  Document();
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  std::unique_ptr<tinygltf::Model> model; ///< without buffers, images, skins and animations
  Folder base_dir;                        ///< where references are looked up
  std::vector<View> views;                ///< as many as model->bufferViews
  std::vector<ImageSource> images;
  std::vector<TextureSource> texture_sources; ///< as many as model->textures
  std::set<int> lost_lights;                  ///< nodes whose light cannot be used
  std::vector<bool> strong_materials; ///< those with KHR_materials_emissive_strength that emit
  std::vector<NodeExtras> extras;     ///< of each node
  std::map<std::string, int> light_textures; ///< by canonical path: index into Lights::textures
  std::map<std::string, std::string> lost_light_textures; ///< and why others cannot be read
  std::vector<FileAnimation> animations;                  ///< those whose structure is right
  std::vector<nlohmann::json> skins;                      ///< null where the structure is wrong
  std::vector<int> node_skins;                            ///< of each node, -1 = none
  IesLights ies_lights;                                   ///< of EXT_lights_ies
  ProfileFiles profiles;
  Warnings warnings;

  std::deque<std::vector<std::uint8_t>> storage; ///< what the views point into
  MemoryShare memory;                            ///< what it takes while it is read
  /// What the scene keeps: meshes, textures, lights' pictures.
  std::shared_ptr<MemoryShare> scene_memory = std::make_shared<MemoryShare>();
};

/// Parses, checks and loads everything but the pictures. `container` must outlive `document`.
/// Throws Failure.
void read_document(const Container& container, const Folder& folder, Document& document);

} // namespace openltc::scene::gltf
