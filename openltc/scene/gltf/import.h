// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A whole glTF file, and which of its lights came from where.

#pragma once

#include "openltc/base/quote.h"
#include "openltc/base/result.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/pose.h"
#include "openltc/scene/scene.h"
#include "openltc/scene/transform.h"

#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// A light that a node's extras describe.
struct NodeLight {
  int node = -1;
  light::Lights light; ///< one, without pictures
};

struct Imported {
  Scene scene;
  std::vector<NodeLight> extras_lights;
  std::vector<Transform> to_world;        ///< of each node, in the file's coordinates
  std::vector<light::Lights> mesh_lights; ///< of the emissive surfaces of each of scene.meshes
};

/// Reads the bytes of a .glb or .gltf. Relative references are looked up in `folder`. Throws
/// Failure.
Imported import_gltf(std::span<const std::uint8_t> bytes, const Folder& folder,
                     const EmissiveOptions& emissive, const PoseOptions& pose = {});

/// Runs `load` and turns whatever it throws into an Error of one line that begins with `name`.
template <class Load>
auto guarded(const std::string& name, const Load& load) -> Result<decltype(load())> {
  try {
    return load();
  } catch (const Failure& failure) {
    return Error{name + ": " + failure.message};
  } catch (const std::bad_alloc&) {
    return Error{name + ": not enough memory to load it"};
  } catch (const std::exception& e) {
    return Error{name + ": cannot be loaded: " + quote(e.what(), 200)};
  }
}

} // namespace openltc::scene::gltf
