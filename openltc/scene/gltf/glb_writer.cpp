// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The GLB container: glTF 2.0 specification, section 4.4.

#include "openltc/scene/gltf/glb_writer.h"

#include "openltc/base/atomic_file.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/light/ies_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace openltc::scene::gltf {

namespace {

using Json = nlohmann::ordered_json;

// Views of matrices of doubles do not exist; four bytes align all accessors, and meshopt streams.
constexpr std::size_t k_alignment = 4;

std::size_t append(Binary& binary, std::span<const std::uint8_t> bytes) {
  binary.bytes.resize((binary.bytes.size() + k_alignment - 1) / k_alignment * k_alignment);
  const std::size_t offset = binary.bytes.size();
  binary.bytes.insert(binary.bytes.end(), bytes.begin(), bytes.end());
  binary.exists = true;
  return offset;
}

// Where the bytes of a buffer of the file are now.
struct Place {
  std::size_t buffer = 0, offset = 0;
};

void move_reference(Json& object, const std::vector<Place>& places) {
  const Place& place = places[object["buffer"].get<std::size_t>()];
  object["buffer"] = place.buffer;
  const std::size_t offset = object.value("byteOffset", std::size_t(0)) + place.offset;
  if (offset != 0) object["byteOffset"] = offset;
}

std::string_view mime_type_of(std::span<const std::uint8_t> bytes) {
  const auto begins = [&](std::string_view head, std::size_t at = 0) {
    return bytes.size() >= at + head.size() &&
           std::memcmp(bytes.data() + at, head.data(), head.size()) == 0;
  };
  if (begins("\x89PNG")) return "image/png";
  if (begins("\xFF\xD8\xFF")) return "image/jpeg";
  if (begins("RIFF") && begins("WEBP", 8)) return "image/webp";
  if (begins("\xABKTX 20\xBB")) return "image/ktx2";
  if (begins("ftypavif", 4)) return "image/avif";
  if (begins("DDS ")) return "image/vnd-ms.dds";
  return "";
}

// One text for all references to the same bytes.
std::string key_of(const std::string& uri, const Folder& folder, const std::string& field) {
  return is_data_uri(uri) ? field : canonical_path(resolve_uri(uri, folder, field));
}

void embed_buffers(Json& root, Binary& binary, const Folder& folder, MemoryShare& memory) {
  if (!root.contains("buffers")) return;
  Json& buffers = root["buffers"];
  std::vector<Place> places;
  Json kept = Json::array();
  const bool first_is_binary = binary.exists && !buffers.empty() && !buffers[0].contains("uri");
  if (first_is_binary) { // the chunk may be longer by padding, but never shorter: import checked
    binary.bytes.resize(buffers[0].value("byteLength", std::size_t(0)));
    kept.push_back(buffers[0]);
  } else {
    binary = {};
    kept.push_back({{"byteLength", 0}});
  }
  // Of each file as much as the buffer that asks for most of it.
  const auto field_of = [](std::size_t i) { return fmt::format("buffers[{}].uri", i); };
  std::map<std::string, std::size_t> lengths;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    if (!buffers[i].contains("uri")) continue;
    std::size_t& length =
        lengths[key_of(buffers[i]["uri"].get<std::string>(), folder, field_of(i))];
    length = std::max(length, buffers[i].value("byteLength", std::size_t(0)));
  }
  std::map<std::string, Place> embedded;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const Json& buffer = buffers[i];
    if (i == 0 && first_is_binary) {
      places.push_back({0, 0});
    } else if (buffer.contains("uri")) {
      const std::string uri = buffer["uri"].get<std::string>();
      const std::string key = key_of(uri, folder, field_of(i));
      const auto [place, is_new] = embedded.try_emplace(key);
      if (is_new) {
        const std::vector<std::uint8_t> bytes =
            read_uri(uri, folder, field_of(i), memory, lengths[key]);
        place->second = {0, append(binary, bytes)};
      }
      places.push_back(place->second);
    } else { // without bytes, a placeholder of EXT_meshopt_compression
      places.push_back({kept.size(), 0});
      kept.push_back(buffer);
    }
  }
  if (!root.contains("bufferViews")) root["bufferViews"] = Json::array();
  for (Json& view : root["bufferViews"]) {
    move_reference(view, places);
    const Json::json_pointer meshopt("/extensions/EXT_meshopt_compression");
    if (view.contains(meshopt)) move_reference(view[meshopt], places);
  }
  buffers = std::move(kept);
}

void embed_images(Json& root, Binary& binary, const Folder& folder, MemoryShare& memory) {
  if (!root.contains("images")) return;
  std::map<std::string, std::pair<std::size_t, std::string>> embedded; // view and type by key
  for (std::size_t i = 0; i < root["images"].size(); ++i) {
    Json& image = root["images"][i];
    if (!image.contains("uri")) continue;
    const std::string uri = image["uri"].get<std::string>();
    std::vector<std::uint8_t> bytes;
    std::string key;
    try {
      key = key_of(uri, folder, fmt::format("images[{}]", i));
      if (!embedded.contains(key)) bytes = read_uri(uri, folder, "", memory);
    } catch (const Failure&) {
      continue; // import warned if something uses it
    }
    if (const auto known = embedded.find(key); known != embedded.end()) {
      image.erase("uri");
      image["bufferView"] = known->second.first;
      image["mimeType"] = known->second.second;
      continue;
    }
    const std::string mime_type(mime_type_of(bytes));
    if (mime_type.empty()) continue;
    if (!root.contains("buffers") || root["buffers"].empty()) {
      root["buffers"] = Json::array({{{"byteLength", 0}}});
      root["bufferViews"] = Json::array();
      binary = {};
    }
    const std::size_t offset = append(binary, bytes);
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    image.erase("uri");
    image["mimeType"] = mime_type;
    image["bufferView"] = root["bufferViews"].size() - 1;
    embedded[key] = {root["bufferViews"].size() - 1, mime_type};
  }
}

constexpr const char* k_buffers = "/buffers";
constexpr const char* k_images = "/images";
constexpr const char* k_profiles = "/extensions/EXT_lights_ies/lights";

bool has_uri(const Json& root, const char* array) {
  const Json::json_pointer pointer(array);
  if (!root.contains(pointer) || !root[pointer].is_array()) return false;
  for (const Json& object : root[pointer])
    if (object.is_object() && object.contains("uri")) return true;
  return false;
}

// A file that is not there, or of another format than the extension's, keeps its reference.
void embed_profiles(Json& root, Binary& binary, const Folder& folder, MemoryShare& memory) {
  const Json::json_pointer pointer(k_profiles);
  for (std::size_t i = 0; i < root[pointer].size(); ++i) {
    if (!root[pointer][i].is_object() || !root[pointer][i].contains("uri") ||
        !root[pointer][i]["uri"].is_string())
      continue;
    std::vector<std::uint8_t> bytes;
    try {
      bytes = read_uri(root[pointer][i]["uri"].get<std::string>(), folder, "", memory);
    } catch (const Failure&) {
      continue;
    }
    constexpr std::string_view tilt = "TILT";
    if (std::search(bytes.begin(), bytes.end(), tilt.begin(), tilt.end()) == bytes.end()) continue;
    const std::size_t view = add_view(root, binary, bytes);
    Json& light = root[pointer][i];
    light.erase("uri");
    light["bufferView"] = view;
    light["mimeType"] = k_ies_mime_type;
  }
}

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    out.push_back(std::uint8_t(value >> shift));
}

} // namespace

std::size_t add_view(Json& root, Binary& binary, std::span<const std::uint8_t> bytes) {
  if (!binary.exists) {
    MemoryShare none;
    embed_buffers(root, binary, {}, none); // placeholders of EXT_meshopt_compression make room
    if (!root.contains("buffers")) root["buffers"] = Json::array({{{"byteLength", 0}}});
  }
  const std::size_t offset = append(binary, bytes);
  root["buffers"][0]["byteLength"] = binary.bytes.size();
  root["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
  return root["bufferViews"].size() - 1;
}

void embed_references(Json& root, Binary& binary, const Folder& folder, MemoryShare& memory) {
  const bool has_buffers = has_uri(root, k_buffers), has_images = has_uri(root, k_images);
  if (has_buffers || has_images) {
    embed_buffers(root, binary, folder, memory);
    embed_images(root, binary, folder, memory);
  }
  const bool has_profiles = has_uri(root, k_profiles);
  if (has_profiles) embed_profiles(root, binary, folder, memory);
  if (!has_buffers && !has_images && !has_profiles) return;
  if (binary.exists)
    root["buffers"][0]["byteLength"] = binary.bytes.size();
  else if (root.contains("buffers") && root["buffers"].size() == 1)
    root.erase("buffers");
}

Status write_glb(const std::string& path, const Json& root, const Binary& binary) {
  std::string text = root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t padded = (binary.bytes.size() + 3) / 4 * 4;
  const std::size_t length = 12 + 8 + text.size() + (binary.exists ? 8 + padded : 0);
  if (length > std::numeric_limits<std::uint32_t>::max())
    return Error{path + ": larger than 4 GiB, which a .glb cannot be; split the scene"};
  std::vector<std::uint8_t> head = {'g', 'l', 'T', 'F'}, between;
  put_u32(head, 2);
  put_u32(head, std::uint32_t(length));
  put_u32(head, std::uint32_t(text.size()));
  put_u32(head, 0x4E4F534A); // "JSON"
  if (binary.exists) {
    put_u32(between, std::uint32_t(padded));
    put_u32(between, 0x004E4942); // "BIN"
  }
  const std::vector<std::uint8_t> padding(padded - binary.bytes.size(), 0);
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    const auto failed = [&] {
      return Error{fmt::format("{}: cannot be written: {}", path, std::strerror(errno))};
    };
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(temporary.c_str(), "wb"),
                                                         &std::fclose);
    if (!file) return failed();
    const auto put = [&](const void* data, std::size_t size) {
      return size == 0 || std::fwrite(data, 1, size, file.get()) == size;
    };
    const bool is_written = put(head.data(), head.size()) && put(text.data(), text.size()) &&
                            put(between.data(), between.size()) &&
                            (!binary.exists || (put(binary.bytes.data(), binary.bytes.size()) &&
                                                put(padding.data(), padding.size())));
    if (!is_written || std::fclose(file.release()) != 0) return failed();
    return Success{};
  });
}

} // namespace openltc::scene::gltf
