// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/packed_file.h"

#include "openltc/base/regular_file.h"
#include "openltc/table/container/container.h"
#include "openltc/table/container/container_kind.h"
#include "openltc/table/container/description.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace openltc::table {

namespace {

namespace fs = std::filesystem;

Result<Texture> decode(ByteView bytes, Container container, const std::string& path) {
  switch (container) {
  case Container::dds:
    return decode_dds(bytes, path);
  case Container::ktx2:
    return decode_ktx2(bytes, path);
  case Container::exr:
    return decode_exr(bytes, path);
  default:
    return decode_npy(bytes, path);
  }
}

// No table comes near: 512 x 512 texels of four numbers as JSON.
constexpr std::uintmax_t k_max_file = std::uintmax_t(64) << 20;

Result<Bytes> read_file(const std::string& path) { return read_regular_file(path, k_max_file); }

// The path given to write_packed: "DIR/ggx.dds" of "DIR/ggx_1.dds" and so on.
std::string table_path(const std::string& path) {
  const fs::path p(path);
  const std::string stem = p.stem().string();
  const std::string end = stem.size() > 2 ? stem.substr(stem.size() - 2) : "";
  const bool numbered = end == "_1" || end == "_2" || end == "_3";
  if (!numbered) return path;
  return (p.parent_path() / (stem.substr(0, stem.size() - 2) + p.extension().string())).string();
}

std::vector<std::string> texture_files(const std::string& path) {
  const std::string whole = table_path(path);
  const std::string first = with_suffix(whole, "_1"), second = with_suffix(whole, "_2");
  const std::string third = with_suffix(whole, "_3");
  std::error_code ec;
  if ((path == whole && fs::exists(path, ec)) || !fs::exists(first, ec)) return {path};
  if (!fs::exists(second, ec)) return {first};
  if (!fs::exists(third, ec)) return {first, second};
  return {first, second, third};
}

} // namespace

Result<std::vector<std::string>> write_packed(const PackedTable& packed, const std::string& path) {
  const Result<std::vector<FileBytes>> files = packed_bytes(packed, path);
  if (!files) return files.error();
  return write_files(*files);
}

bool table_exists(const std::string& path) {
  std::error_code ec;
  return fs::exists(texture_files(path)[0], ec);
}

Result<TextureFiles> read_textures(const std::string& path) {
  const ContainerFacts* container = container_of(path);
  if (!container || !container->one_texture)
    return Error{
        fmt::format("{}: cannot be read as textures; known are .dds .ktx2 .exr .npy", path)};
  TextureFiles files;
  files.paths = texture_files(path);
  const auto read = [&](const std::string& file) -> Status {
    const Result<Bytes> bytes = read_file(file);
    if (!bytes) return bytes.error();
    Result<Texture> texture = decode(*bytes, container->container, file);
    if (!texture) return texture.error();
    files.textures.push_back(std::move(*texture));
    return Success{};
  };
  for (std::size_t t = 0; t < std::min(files.paths.size(), std::size_t(2)); ++t)
    if (Status status = read(files.paths[t]); !status) return status.error();
  files.description = files.textures[0].metadata;
  const std::string beside = table_path(path) + ".json";
  std::error_code ec;
  if (!container->describes && fs::exists(beside, ec)) {
    const Result<Bytes> bytes = read_file(beside);
    if (!bytes) return bytes.error();
    Result<KeyValues> description =
        description_from_json(std::string(bytes->begin(), bytes->end()), beside);
    if (!description) return description.error();
    files.description = std::move(*description);
  }
  // A third texture beside a table of two is of another, older table.
  const std::string* layout = find_value(files.description, "layout");
  if (!layout || *layout != name_of(Layout::native_two))
    files.paths.resize(files.textures.size());
  else if (files.paths.size() > 2)
    if (Status status = read(files.paths[2]); !status) return status.error();
  return files;
}

Result<PackedTable> read_packed(const std::string& path, std::optional<Layout> layout) {
  const ContainerFacts* container = container_of(path);
  if (!container || (!container->one_texture && container->container != Container::json))
    return Error{
        fmt::format("{}: cannot be read as a table; known are .dds .ktx2 .exr .npy .json", path)};
  PackedTable packed;
  bool described = true;
  if (container->container == Container::json) {
    const Result<Bytes> bytes = read_file(path);
    if (!bytes) return bytes.error();
    const std::string text(bytes->begin(), bytes->end());
    if (text.find("\"openltc-packed-table\"") != std::string::npos) {
      Result<PackedTable> read = packed_from_json(text, path);
      if (!read) return read.error();
      packed = std::move(*read);
    } else {
      const Result<LobeTable> table = from_json(text, path);
      if (!table) return table.error();
      Result<PackedTable> native = pack(
          *table, table->two_lobes() ? Layout::native_two : Layout::native, Precision::float32);
      if (!native) return Error{fmt::format("{}: {}", path, native.error().message)};
      packed = std::move(*native);
    }
  } else {
    Result<TextureFiles> files = read_textures(path);
    if (!files) return files.error();
    packed.textures = std::move(files->textures);
    described = !files->description.empty();
    if (described) {
      if (Status status = apply_description(files->description, path, packed); !status)
        return status.error();
    } else if (layout) {
      packed.layout = *layout;
      packed.angle_axis = angle_axis_of(*layout);
    } else {
      return Error{fmt::format("{}: says nothing about its layout; openltc inspect finds out what "
                               "it most probably is; openltc convert --from-layout then makes a "
                               "file of it that says so",
                               path)};
    }
    const std::size_t count = facts_of(packed.layout).channels.size();
    if (packed.textures.size() > count && !described) packed.textures.resize(count);
    if (Status status = check_textures(path, packed.layout, packed.textures); !status)
      return status.error();
    packed.precision = packed.textures[0].precision;
    for (Texture& texture : packed.textures)
      texture.metadata.clear();
  }
  if (described && layout && *layout != packed.layout)
    return Error{fmt::format("{}: says itself that its layout is {}, not {}", path,
                             name_of(packed.layout), name_of(*layout))};
  return packed;
}

} // namespace openltc::table
