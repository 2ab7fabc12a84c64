// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What tinygltf is guarded against, each found in version 2.5 or 2.7 as the distributions ship it:
// - it refuses a Draco primitive whose index accessor has no buffer view, as most have, so those
//   indices are taken away before (the compressed data has its own);
// - it refuses buffers without URI, which EXT_meshopt_compression uses as placeholders, and its
//   messages do not name fields, so that buffers and images are read here;
// - 2.5 writes before its array of views when an attribute's accessor has no buffer view, as all of
//   a Draco primitive's have none, so that those accessors get a placeholder while it parses;
// - it silently ignores fields of the wrong type and truncates integers to 32 bits, and 2.5 reads
//   past its arrays for indices out of range: check_schema comes first;
// - it recurses over `extras` and extensions: split_container limits the nesting.

#include "openltc/scene/gltf/file/document.h"

#include "openltc/base/file_observer.h"
#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/scene/gltf/file/extensions.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/meshopt.h"
#include "openltc/scene/gltf/file/schema.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/light/broken_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

json parse_json(std::string_view text) {
  try {
    return json::parse(text.begin(), text.end());
  } catch (const json::exception& e) {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    const std::string what = e.what();
    const std::size_t bracket = what.find("] ");
    const std::string reason =
        quote(bracket == std::string::npos ? what : what.substr(bracket + 2), 200);
    fail("JSON", reason + "; the file is damaged, export it again");
  }
}

// Before the schema: what is wrong with an older file is its age, not that some member is no array.
void check_version(const json& root) {
  const json::json_pointer pointer("/asset/version");
  if (root.is_object() && root.contains(pointer)) {
    const json& version = root[pointer];
    const std::string text = version.is_string() ? version.get<std::string>() : version.dump();
    if (text.rfind("2.", 0) != 0)
      fail("asset.version",
           fmt::format("\"{}\" is not supported; export as glTF 2.0{}", quote(text, 20),
                       text.rfind("1.", 0) == 0 || text == "1" ? ", this is a glTF 1.0 file" : ""));
  } else if (root.is_object() && root.contains("scenes") && root["scenes"].is_object()) {
    fail("scenes", "is an object, as in glTF 1.0, which is not supported; export as glTF 2.0");
  }
}

// A member that is an array, or an empty one.
const json& array_of(const json& root, const char* name) {
  static const json empty = json::array();
  const auto found = root.find(name);
  return found == root.end() ? empty : *found;
}

std::size_t count_of(const json& object, const char* name) {
  return object.value(name, std::size_t(0));
}

const json* extension_of(const json& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() ? nullptr : &*found;
}

// The bytes behind the buffers' URIs, each file read once and as far as any of them asks.
class BufferFiles {
public:
  BufferFiles(const json& buffers, Document& document) : document_(document) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      if (!buffers[i].contains("uri")) continue;
      std::size_t& length = lengths_[key_of(uri_of(buffers[i]), field_of(i))];
      length = std::max(length, count_of(buffers[i], "byteLength"));
    }
  }

  std::span<const std::uint8_t> bytes(const json& buffer, std::size_t index) {
    const std::string key = key_of(uri_of(buffer), field_of(index));
    const auto [known, is_new] = known_.try_emplace(key);
    if (is_new) {
      document_.storage.push_back(read_uri(uri_of(buffer), document_.base_dir, field_of(index),
                                           document_.memory, lengths_[key]));
      known->second = document_.storage.back();
    }
    return known->second;
  }

private:
  static const std::string& uri_of(const json& buffer) {
    return buffer["uri"].get_ref<const std::string&>();
  }
  static std::string field_of(std::size_t index) { return fmt::format("buffers[{}].uri", index); }
  std::string key_of(const std::string& uri, const std::string& field) const {
    return is_data_uri(uri) ? field : canonical_path(resolve_uri(uri, document_.base_dir, field));
  }

  Document& document_;
  std::map<std::string, std::size_t> lengths_;
  std::map<std::string, std::span<const std::uint8_t>> known_;
};

// Bytes of each buffer; empty for the placeholders of EXT_meshopt_compression.
std::vector<std::span<const std::uint8_t>>
load_buffers(const json& root, const Container& container, Document& document) {
  std::vector<std::span<const std::uint8_t>> buffers;
  BufferFiles files(array_of(root, "buffers"), document);
  for (const json& buffer : array_of(root, "buffers")) {
    const std::size_t index = buffers.size();
    const std::string field = fmt::format("buffers[{}]", index);
    const std::size_t length = count_of(buffer, "byteLength");
    std::span<const std::uint8_t> bytes;
    if (buffer.contains("uri")) {
      bytes = files.bytes(buffer, index);
    } else if (index == 0 && container.has_binary) {
      bytes = container.binary;
    } else if (extension_of(buffer, "EXT_meshopt_compression")) {
      buffers.push_back({});
      continue;
    } else {
      fail(field + ".uri", "is missing, and the file has no binary chunk; export the file again");
    }
    if (bytes.size() < length)
      fail(field + ".byteLength",
           fmt::format("{} bytes are announced but there are {}; the data is cut short, export or "
                       "copy the file again",
                       length, bytes.size()));
    buffers.push_back(bytes.first(length));
  }
  return buffers;
}

std::span<const std::uint8_t> slice(std::span<const std::uint8_t> buffer, std::size_t offset,
                                    std::size_t length, const std::string& field) {
  if (offset > buffer.size() || length > buffer.size() - offset)
    fail(field + ".byteLength",
         fmt::format("bytes {} to {} are asked for but the buffer has {}; the file is damaged, "
                     "export it again",
                     offset, offset + length, buffer.size()));
  return buffer.subspan(offset, length);
}

View decode_meshopt_view(const json& extension,
                         std::span<const std::span<const std::uint8_t>> buffers,
                         const std::string& field, Document& document) {
  const auto source =
      slice(buffers[count_of(extension, "buffer")], count_of(extension, "byteOffset"),
            count_of(extension, "byteLength"), field);
  MeshoptStream stream;
  stream.bytes = source;
  stream.count = count_of(extension, "count");
  stream.stride = count_of(extension, "byteStride");
  stream.mode = extension["mode"].get<std::string>();
  stream.filter = extension.value("filter", std::string("NONE"));
  document.storage.push_back(decode_meshopt(stream, field, document.memory));
  return {document.storage.back(), stream.stride};
}

void load_views(const json& root, std::span<const std::span<const std::uint8_t>> buffers,
                Document& document) {
  for (const json& view : array_of(root, "bufferViews")) {
    const std::string field = fmt::format("bufferViews[{}]", document.views.size());
    const std::size_t stride = count_of(view, "byteStride");
    if (stride % 4 != 0 || stride > 252)
      fail(field + ".byteStride",
           fmt::format("{} is not a multiple of 4 up to 252; export the file again", stride));
    const json* meshopt = extension_of(view, "EXT_meshopt_compression");
    const std::size_t buffer = count_of(view, "buffer");
    // Without the decoder use what the file carries uncompressed, if it does.
    const bool has_fallback = !buffers[buffer].empty();
    if (meshopt && (has_meshopt_decoder() || !has_fallback)) {
      document.views.push_back(decode_meshopt_view(
          *meshopt, buffers, field + ".extensions.EXT_meshopt_compression", document));
    } else {
      document.views.push_back({slice(buffers[buffer], count_of(view, "byteOffset"),
                                      count_of(view, "byteLength"), field),
                                stride});
    }
  }
}

void list_images(const json& root, Document& document) {
  for (const json& image : array_of(root, "images"))
    document.images.push_back(
        {image.value("name", std::string()), image.value("uri", std::string()),
         image.value("mimeType", std::string()), image.value("bufferView", -1)});
}

// Of several forms of a texture's picture the first that can be read: an extension's goes before
// the plain one, which is there for those who cannot.
void list_textures(const json& root, Document& document) {
  for (const json& texture : array_of(root, "textures")) {
    TextureSource source;
    const json* const webp = extension_of(texture, "EXT_texture_webp");
    if (webp && webp->contains("source") && image::can_read_webp())
      source.images.push_back(webp->value("source", -1));
    if (texture.contains("source")) source.images.push_back(texture.value("source", -1));
    if (source.images.empty() && texture.contains("extensions"))
      for (const auto& [name, extension] : texture["extensions"].items())
        if (source.foreign.empty() && extension.is_object() && extension.contains("source"))
          source.foreign = name;
    document.texture_sources.push_back(std::move(source));
  }
}

void list_strong_materials(const json& root, Document& document) {
  for (const json& material : array_of(root, "materials")) {
    const json* const strength = extension_of(material, "KHR_materials_emissive_strength");
    bool emits = strength && strength->value("emissiveStrength", 1.0) > 0;
    const json factor = material.value("emissiveFactor", json::array({0, 0, 0}));
    emits = emits && std::any_of(factor.begin(), factor.end(),
                                 [](const json& c) { return c.get<double>() > 0; });
    document.strong_materials.push_back(emits);
  }
}

void read_extras(const json& root, Document& document) {
  for (const json& node : array_of(root, "nodes")) {
    const std::string label = node_label(document.extras.size(), node.value("name", ""));
    const auto extras = node.find("extras");
    document.extras.push_back(extras == node.end() ? NodeExtras{}
                                                   : read_node_extras(*extras, label, document));
  }
}

// Whether the part's structure is right; a warning says what is wrong and what follows.
bool is_usable(json& root, json& part, const std::string& path, const char* type,
               const char* consequence, Document& document) {
  try {
    check_member(root, part, path, type);
    return true;
  } catch (const Failure& failure) {
    document.warnings.add(fmt::format("{}; {}", failure.message, consequence));
    return false;
  }
}

void take_animations_and_skins(json& root, Document& document) {
  if (root.contains("animations"))
    for (std::size_t i = 0; i < root["animations"].size(); ++i) {
      json& animation = root["animations"][i];
      if (is_usable(root, animation, fmt::format("animations[{}]", i), "animation",
                    "this animation cannot be played", document))
        document.animations.push_back({i, std::move(animation)});
    }
  if (root.contains("skins"))
    for (std::size_t i = 0; i < root["skins"].size(); ++i) {
      json& skin = root["skins"][i];
      const bool is_right = is_usable(root, skin, fmt::format("skins[{}]", i), "skin",
                                      "its meshes are not bent", document);
      document.skins.push_back(is_right ? std::move(skin) : json());
    }
  for (const json& node : array_of(root, "nodes"))
    document.node_skins.push_back(node.value("skin", -1));
}

// Takes away what tinygltf must not see or need not read.
void reduce_for_tinygltf(json& root) {
  for (const char* name : {"buffers", "images", "animations", "skins", "extras"})
    root.erase(name);
  for (const char* name : {"scenes", "nodes", "meshes", "accessors", "bufferViews", "materials",
                           "textures", "samplers", "cameras"}) {
    if (!root.contains(name)) continue;
    for (json& object : root[name]) {
      for (const char* member : {"extras", "min", "max", "skin"})
        object.erase(member);
      if (!object.contains("primitives")) continue;
      for (json& primitive : object["primitives"]) {
        primitive.erase("extras");
        if (extension_of(primitive, "KHR_draco_mesh_compression")) primitive.erase("indices");
      }
    }
  }
}

// Gives every accessor a view: those without one get a placeholder behind the views of the file.
// Returns its index.
int add_placeholder_view(json& root) {
  json& views = root["bufferViews"];
  const int placeholder = int(views.size());
  views.push_back({{"buffer", 0}, {"byteLength", 1}});
  if (root.contains("accessors"))
    for (json& accessor : root["accessors"])
      if (!accessor.contains("bufferView")) accessor["bufferView"] = placeholder;
  return placeholder;
}

void remove_placeholder_view(int placeholder, tinygltf::Model& model) {
  for (tinygltf::Accessor& accessor : model.accessors)
    if (accessor.bufferView == placeholder) accessor.bufferView = -1;
  model.bufferViews.pop_back();
}

void parse_with_tinygltf(const json& root, tinygltf::Model& model) {
  const std::string text = root.dump();
  if (text.size() > std::numeric_limits<unsigned int>::max())
    fail("JSON", "larger than 4 GiB; split the file");
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  const bool ok = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                             static_cast<unsigned int>(text.size()), "");
  if (ok) return;
  fail("JSON", quote(error, 200) + "; export the file again");
}

// What the file refers to is the user's, also what nothing here reads: no output may replace it.
void note_references(const json& root, const Folder& folder) {
  std::vector<const json*> left = {&root};
  while (!left.empty()) {
    const json& object = *left.back();
    left.pop_back();
    for (const auto& member : object.items()) {
      const json& value = member.value();
      if (value.is_structured()) left.push_back(&value);
      if (member.key() != "uri" || !value.is_string()) continue;
      const std::string& uri = value.get_ref<const std::string&>();
      if (uri.rfind("data:", 0) == 0) continue;
      try {
        file_observer().reads(resolve_uri(uri, folder, ""));
      } catch (const Failure&) { // whoever needs it says so
      }
    }
  }
}

} // namespace

std::string node_label(std::size_t index, const std::string& name) {
  return name.empty() ? fmt::format("nodes[{}]", index)
                      : fmt::format("nodes[{}] \"{}\"", index, quote(name));
}

Document::Document() : model(std::make_unique<tinygltf::Model>()) {}
Document::~Document() = default;

void read_document(const Container& container, const Folder& folder, Document& document) {
  MemoryShare parsing;
  take_memory(parsing, memory_to_parse(container.json), "JSON");
  json root = parse_json(container.json);
  check_version(root);
  document.lost_lights = drop_broken_lights(root, document.warnings);
  check_schema(root);
  document.base_dir = folder;
  note_references(root, {folder.path, true}); // whether they may be read or not

  check_extensions(root.value("extensionsUsed", std::vector<std::string>()),
                   root.value("extensionsRequired", std::vector<std::string>()), document);
  const auto buffers = load_buffers(root, container, document);
  load_views(root, buffers, document);
  list_images(root, document);
  list_textures(root, document);
  list_strong_materials(root, document);
  read_extras(root, document);
  take_animations_and_skins(root, document);
  document.ies_lights = list_ies_lights(root, document.warnings);
  reduce_for_tinygltf(root);
  const int placeholder = add_placeholder_view(root);
  parse_with_tinygltf(root, *document.model);
  remove_placeholder_view(placeholder, *document.model);
}

} // namespace openltc::scene::gltf
