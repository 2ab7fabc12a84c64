// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Which glTF extensions are understood, and what is missing in the picture without the others.

#pragma once

#include <string>
#include <vector>

namespace openltc::scene::gltf {

struct Document;

/// Throws Failure for a required extension that is not supported, unless it only concerns textures;
/// warns, once each, of those and of optional ones that change the picture.
void check_extensions(const std::vector<std::string>& used,
                      const std::vector<std::string>& required, Document& document);

} // namespace openltc::scene::gltf
