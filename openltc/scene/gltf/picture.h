// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The pictures of a glTF file, each decoded once however many images, textures and samplers name
// it.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/image/texels.h"

#include <map>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

class Pictures {
public:
  /// What the pictures take, and the smaller copies that a renderer makes of them, is counted in
  /// `kept`.
  Pictures(const Document& document, MemoryShare& kept) : document_(document), kept_(kept) {}

  /// images[index]. Throws Failure that names the image and its file when it is missing, of a
  /// format that is not read, damaged or too large; the same one when asked again.
  image::Texels load(int index, bool is_color);

private:
  struct Loaded {
    image::Texels texels;
    std::string failure;                                    ///< empty = there is none
    std::string name;                                       ///< in messages
    bool has_color_copies = false, has_data_copies = false; ///< whether those are counted
  };
  std::string key_of(int index, const std::string& field) const;
  Loaded read(int index, const std::string& field) const;

  const Document& document_;
  MemoryShare& kept_;
  std::map<std::string, Loaded> loaded_; ///< by what is the same for the same bytes
};

} // namespace openltc::scene::gltf
