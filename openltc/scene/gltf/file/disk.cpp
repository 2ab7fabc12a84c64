// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What uri.h wants of the file system.

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace openltc::scene::gltf {

namespace {

// Whether `path` lies in `folder`; both canonical.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto [at, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return at == folder.end() || (std::next(at) == folder.end() && at->empty());
}

constexpr std::uint64_t k_largest_scene = std::uint64_t(1)
                                          << 32; // the length of a .glb has 32 bits

} // namespace

Folder folder_of(const std::string& path, bool allow_outside) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return {folder.empty() ? "." : folder.string(), allow_outside};
}

std::string canonical_path(const std::string& path) {
  std::error_code ec;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ec);
  return ec ? path : canonical.string();
}

std::vector<std::uint8_t> read_file(const std::string& path, const std::string& field,
                                    MemoryShare& memory, std::uint64_t most) {
  std::error_code ec;
  if (path.find('\0') != std::string::npos || !std::filesystem::exists(path, ec))
    fail(field, field.empty() ? "the file does not exist; check the path"
                              : fmt::format("the file {} is missing; put it back or export again",
                                            quote(path, k_longest_path)));
  const Result<RegularFile> file = open_regular_file(path);
  if (!file) fail(field, quote(file.error().message, k_longest_path));
  const std::uint64_t size = std::min(file->size(), most);
  take_memory(memory, size,
              field.empty() ? "the file"
                            : fmt::format("{}: {}", field, quote(path, k_longest_path)));
  std::vector<std::uint8_t> bytes(size);
  const Result<std::size_t> got = file->read_at(0, bytes);
  if (!got) fail(field, quote(got.error().message, k_longest_path));
  bytes.resize(*got);
  return bytes;
}

std::vector<std::uint8_t> read_scene_file(const std::string& path, MemoryShare& memory) {
  std::error_code ec;
  const std::uintmax_t size = std::filesystem::file_size(path, ec);
  if (!ec && size > k_largest_scene)
    fail("", fmt::format("{} are more than a glTF file can have, 4 GiB; give a .gltf or .glb file",
                         memory_size_text(size)));
  return read_file(path, "", memory, k_largest_scene);
}

std::string find_in_folder(const std::string& given, const std::string& uri, const Folder& folder,
                           const std::string& field) {
  std::error_code ec;
  std::string name = given;
  const std::filesystem::path base(folder.path);
  if (name.find('\\') != std::string::npos && !std::filesystem::exists(base / name, ec))
    std::replace(name.begin(), name.end(), '\\', '/');
  const std::filesystem::path path = base / name; // an absolute name stands for itself
  if (folder.allow_outside) return path.string();

  // Before a look at whether it exists, which a stranger need not learn either.
  const std::filesystem::path canonical_base = std::filesystem::canonical(base, ec);
  const bool is_base_known = !ec;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ec);
  if (!is_base_known || ec || !lies_in(canonical, canonical_base))
    fail(field,
         fmt::format("{} lies outside the scene's folder, where nothing is read; put it beside the "
                     "scene, or say --allow-outside if you trust the file",
                     quote(uri, k_longest_path)));
  return path.string();
}

} // namespace openltc::scene::gltf
