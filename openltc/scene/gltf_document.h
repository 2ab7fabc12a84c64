// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A glTF file in memory: its structure as tinygltf gives it, and the bytes behind it.

#pragma once

#include "openltc/scene/gltf_container.h"
#include "openltc/scene/gltf_extras.h"
#include "openltc/scene/gltf_ies_light.h"
#include "openltc/scene/warnings.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
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
  std::string base_dir;
  std::vector<View> views; ///< as many as model->bufferViews
  std::vector<ImageSource> images;
  std::vector<NodeExtras> extras;            ///< of each node
  std::map<std::string, int> light_textures; ///< by reference: index into Lights::textures
  std::vector<FileAnimation> animations;     ///< those whose structure is right
  std::vector<nlohmann::json> skins;         ///< null where the structure is wrong
  std::vector<int> node_skins;               ///< of each node, -1 = none
  IesLights ies_lights;                      ///< of EXT_lights_ies
  ProfileFiles profiles;
  Warnings warnings;

  std::vector<std::vector<std::uint8_t>> storage; ///< what the views point into
};

/// Parses, checks and loads everything but the pictures. `container` must outlive `document`.
/// Throws Failure.
void read_document(const Container& container, const std::string& base_dir, Document& document);

} // namespace openltc::scene::gltf
