// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// References from a glTF file to its buffers and images.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// The path of a file that `uri` refers to, relative to `base_dir`. Throws Failure that names
/// `field` when it is absolute or a network address, or when `base_dir` is empty.
std::string resolve_uri(const std::string& uri, const std::string& base_dir,
                        const std::string& field);

/// The bytes behind `uri`: a base64 data URI or a file relative to `base_dir`. Throws Failure that
/// names `field` when it is absolute, a network address, missing, or broken, or when `base_dir` is
/// empty and a file is asked for.
std::vector<std::uint8_t> read_uri(const std::string& uri, const std::string& base_dir,
                                   const std::string& field);

/// A whole file. Throws Failure that names `field` when it cannot be read.
std::vector<std::uint8_t> read_file(const std::string& path, const std::string& field);

} // namespace openltc::scene::gltf
