// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Packed tables as files in memory; packed_file.cpp has what needs a disk.

#include "openltc/table/container/container.h"
#include "openltc/table/container/container_kind.h"
#include "openltc/table/container/description.h"
#include "openltc/table/container/source_code.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace openltc::table {

namespace {

namespace fs = std::filesystem;

constexpr ContainerFacts k_containers[] = {
    {".dds", Container::dds, true, false},   {".ktx2", Container::ktx2, true, true},
    {".exr", Container::exr, true, true},    {".npy", Container::npy, true, false},
    {".json", Container::json, false, true}, {".h", Container::c, false, true},
    {".glsl", Container::glsl, false, true}, {".hlsl", Container::hlsl, false, true},
    {".wgsl", Container::wgsl, false, true}, {".js", Container::js, false, true},
};

Bytes encode(const Texture& texture, Container container) {
  switch (container) {
  case Container::dds:
    return encode_dds(texture);
  case Container::ktx2:
    return encode_ktx2(texture);
  case Container::exr:
    return encode_exr(texture);
  default:
    return encode_npy(texture);
  }
}

Result<std::string> source_text(const PackedTable& packed, Container container,
                                const std::string& path) {
  const std::string name = fs::path(path).stem().string();
  switch (container) {
  case Container::c:
    return to_source(packed, SourceLanguage::c, name);
  case Container::glsl:
    return to_source(packed, SourceLanguage::glsl, name);
  case Container::hlsl:
    return to_source(packed, SourceLanguage::hlsl, name);
  case Container::wgsl:
    return to_source(packed, SourceLanguage::wgsl, name);
  case Container::js:
    return to_source(packed, SourceLanguage::javascript, name);
  default:
    break;
  }
  if (!is_native(packed.layout) || packed.precision != Precision::float32)
    return packed_to_json(packed);
  const Result<LobeTable> table = unpack(packed);
  if (!table) return table.error();
  return to_json(*table);
}

} // namespace

const ContainerFacts* container_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const ContainerFacts& facts : k_containers)
    if (extension == facts.extension) return &facts;
  return nullptr;
}

std::string with_suffix(const std::string& path, const std::string& suffix) {
  const fs::path p(path);
  return (p.parent_path() / (p.stem().string() + suffix + p.extension().string())).string();
}

Status check_packed_extension(const std::string& path) {
  if (container_of(path)) return Success{};
  return Error{
      fmt::format("{}: unknown extension; a table is written as .dds .ktx2 .exr .npy .json "
                  ".h .glsl .hlsl .wgsl or .js",
                  path)};
}

std::vector<std::string> packed_files(Layout layout, const std::string& path) {
  const ContainerFacts* container = container_of(path);
  if (!container) return {};
  if (!container->one_texture) return {path};
  std::vector<std::string> files;
  if (facts_of(layout).channels.size() == 1)
    files = {path};
  else
    for (std::size_t t = 1; t <= facts_of(layout).channels.size(); ++t)
      files.push_back(with_suffix(path, fmt::format("_{}", t)));
  if (!container->describes) files.push_back(path + ".json");
  return files;
}

Result<std::vector<FileBytes>> packed_bytes(const PackedTable& packed, const std::string& path) {
  if (Status status = check_packed_extension(path); !status) return status.error();
  if (Status status = check_textures(path, packed.layout, packed.textures); !status)
    return status.error();
  const ContainerFacts& container = *container_of(path);
  const std::vector<std::string> paths = packed_files(packed.layout, path);
  std::vector<FileBytes> files;
  if (container.one_texture) {
    for (std::size_t t = 0; t < packed.textures.size(); ++t) {
      Texture texture = packed.textures[t];
      texture.metadata = describe(packed);
      texture.metadata.emplace_back("texture",
                                    fmt::format("{} of {}", t + 1, packed.textures.size()));
      files.push_back({paths[t], encode(texture, container.container)});
    }
    if (!container.describes)
      files.push_back(file_of_text(paths.back(), description_to_json(describe(packed))));
  } else {
    const Result<std::string> text = source_text(packed, container.container, path);
    if (!text) return text.error();
    files.push_back(file_of_text(path, *text));
  }
  return files;
}

} // namespace openltc::table
