// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the reader of glTF files wants of a file system, a machine and of libraries that are not
// headers alone, none of which there is here. Each says so; see index.d.ts, readLights.

#include "openltc/base/memory_budget.h"
#include "openltc/base/regular_file.h"
#include "openltc/image/file.h"
#include "openltc/scene/gltf/file/draco.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/uri.h"

#include <fmt/format.h>

namespace openltc {

// Half of what 32 bits address.
std::uint64_t default_memory_limit() { return std::uint64_t(1) << 31; }

Result<std::string> read_regular_text(const std::string& path, std::uint64_t) {
  return Error{path + ": there are no files here; embed it"};
}

namespace image {

bool can_read_webp() { return true; } // as far as the file's structure goes

Result<Texels> decode_texels(std::span<const std::uint8_t>, const std::string& name, bool) {
  return Error{name + ": pictures are not decoded here"};
}

Result<Texels> read_texels(const std::string& path) {
  return Error{path + ": there are no files here"};
}

} // namespace image

namespace scene::gltf {

std::string canonical_path(const std::string& path) { return path; }

// Without a folder resolve_uri has refused already.
std::string find_in_folder(const std::string& name, const std::string&, const Folder&,
                           const std::string&) {
  return name;
}

std::vector<std::uint8_t> read_file(const std::string&, const std::string& field, MemoryShare&,
                                    std::uint64_t) {
  fail(field, "there are no files here; embed it");
}

DracoMesh decode_draco(std::span<const std::uint8_t>, const std::map<std::string, int>&,
                       const std::string& field) {
  fail(field, "Draco data is not decoded here; export the file without "
              "KHR_draco_mesh_compression");
}

} // namespace scene::gltf

} // namespace openltc
