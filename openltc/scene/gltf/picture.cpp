// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/picture.h"

#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/image/mip_levels.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/uri.h"

#include <fmt/format.h>

#include <utility>

namespace openltc::scene::gltf {

namespace {

// As for any picture (image::read): 4 channels of 16 bits, uncompressed.
constexpr std::uint64_t k_largest_file = image::k_max_pixels * 8;

} // namespace

std::string Pictures::key_of(int index, const std::string& field) const {
  const ImageSource& source = document_.images[std::size_t(index)];
  if (is_data_uri(source.uri)) return field;
  if (!source.uri.empty())
    return "file " + canonical_path(resolve_uri(source.uri, document_.base_dir, field + ".uri"));
  if (source.view < 0) fail(field, "has neither uri nor bufferView; export the file again");
  const auto bytes = document_.views[std::size_t(source.view)].bytes;
  return fmt::format("{} bytes at {}", bytes.size(), static_cast<const void*>(bytes.data()));
}

Pictures::Loaded Pictures::read(int index, const std::string& field) const {
  const ImageSource& source = document_.images[std::size_t(index)];
  Loaded loaded;
  try {
    MemoryShare transient(kept_.budget());
    std::vector<std::uint8_t> file;
    std::span<const std::uint8_t> bytes;
    std::string name = field;
    if (!source.uri.empty()) {
      file =
          read_uri(source.uri, document_.base_dir, field + ".uri", transient, k_largest_file + 1);
      if (file.size() > k_largest_file)
        fail(field + ".uri", fmt::format("{} has more than {}, too much for a picture",
                                         quote(source.uri, 160), memory_size_text(k_largest_file)));
      bytes = file;
      if (!is_data_uri(source.uri)) name += fmt::format(".uri: {}", quote(source.uri, 160));
    } else {
      bytes = document_.views[std::size_t(source.view)].bytes;
    }
    Result<image::Texels> decoded = image::decode_texels(bytes, name, true);
    if (!decoded) throw Failure{decoded.error().message};
    loaded.name =
        fmt::format("{}: a picture of {}x{} pixels", name, decoded->width, decoded->height);
    take_memory(kept_, decoded->byte_count(), loaded.name);
    loaded.texels = std::move(*decoded);
  } catch (const Failure& failure) {
    loaded.failure = failure.message;
  }
  return loaded;
}

image::Texels Pictures::load(int index, bool is_color) {
  const std::string field = fmt::format("images[{}]", index);
  const std::string key = key_of(index, field);
  auto known = loaded_.find(key);
  if (known == loaded_.end()) known = loaded_.emplace(key, read(index, field)).first;
  Loaded& loaded = known->second;
  if (!loaded.failure.empty()) throw Failure{loaded.failure};
  // Colours and data have smaller copies of their own.
  bool& has_copies = is_color ? loaded.has_color_copies : loaded.has_data_copies;
  if (!has_copies) take_memory(kept_, image::MipLevels::byte_count(loaded.texels), loaded.name);
  has_copies = true;
  return loaded.texels.taken_as(is_color);
}

} // namespace openltc::scene::gltf
