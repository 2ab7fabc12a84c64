// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The fields follow the JSON schemas of the glTF 2.0 specification and of the extensions that are
// read. Fields that are not listed are not read and may hold anything.

#include "openltc/scene/gltf/file/schema.h"

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

enum class Kind {
  text,
  flag,
  number,
  numbers,    // `size` of them, 0 = any
  count,      // a whole number >= 0
  index,      // into the array at JSON pointer `detail`
  indices,    // an array of those
  index_map,  // an object whose values are those
  index_maps, // an array of index_map
  object,     // of the type `detail`
  objects,    // an array of those
  texts,
  choice,      // a text, one of `detail`, separated by |
  count_choice // a whole number, one of `detail`
};

struct Field {
  const char* name;
  Kind kind;
  const char* detail = "";
  bool required = false;
  std::size_t size = 0;
};

using Type = std::vector<Field>;

constexpr bool k_required = true;
// Largest whole number that a double holds exactly; more than any file has bytes.
constexpr double k_max_count = 9007199254740992.0;
// tinygltf keeps indices and the offsets of sparse accessors in an int.
constexpr double k_max_index = 2147483647.0;

const Type& type_named(std::string_view name) {
  static const std::map<std::string_view, Type> types = {
      {"root",
       {{"asset", Kind::object, "asset", k_required},
        {"extensionsUsed", Kind::texts},
        {"extensionsRequired", Kind::texts},
        {"scenes", Kind::objects, "scene"},
        {"nodes", Kind::objects, "node"},
        {"meshes", Kind::objects, "mesh"},
        {"accessors", Kind::objects, "accessor"},
        {"bufferViews", Kind::objects, "buffer_view"},
        {"buffers", Kind::objects, "buffer"},
        {"materials", Kind::objects, "material"},
        {"textures", Kind::objects, "texture"},
        {"images", Kind::objects, "image"},
        {"samplers", Kind::objects, "sampler"},
        {"cameras", Kind::objects, "camera"},
        {"skins", Kind::objects, "nothing"}, // check_member
        {"animations", Kind::objects, "nothing"},
        {"extensions", Kind::object, "root_extensions"},
        {"scene", Kind::index, "/scenes"}}},
      {"asset", {{"version", Kind::text, "", k_required}, {"minVersion", Kind::text}}},
      {"scene", {{"name", Kind::text}, {"nodes", Kind::indices, "/nodes"}}},
      {"node",
       {{"name", Kind::text},
        {"children", Kind::indices, "/nodes"},
        {"mesh", Kind::index, "/meshes"},
        {"camera", Kind::index, "/cameras"},
        {"skin", Kind::index, "/skins"},
        {"matrix", Kind::numbers, "", false, 16},
        {"translation", Kind::numbers, "", false, 3},
        {"rotation", Kind::numbers, "", false, 4},
        {"scale", Kind::numbers, "", false, 3},
        {"weights", Kind::numbers},
        {"extensions", Kind::object, "node_extensions"}}},
      {"node_extensions",
       {{"KHR_lights_punctual", Kind::object, "node_light_punctual"},
        {"EXT_lights_area", Kind::object, "node_light_area"},
        {"EXT_mesh_gpu_instancing", Kind::object, "node_instancing"}}},
      {"node_instancing", {{"attributes", Kind::index_map, "/accessors", k_required}}},
      {"node_light_punctual",
       {{"light", Kind::index, "/extensions/KHR_lights_punctual/lights", k_required}}},
      {"node_light_area",
       {{"light", Kind::index, "/extensions/EXT_lights_area/lights", k_required}}},
      {"mesh",
       {{"name", Kind::text},
        {"primitives", Kind::objects, "primitive", k_required},
        {"weights", Kind::numbers}}},
      {"primitive",
       {{"attributes", Kind::index_map, "/accessors", k_required},
        {"indices", Kind::index, "/accessors"},
        {"material", Kind::index, "/materials"},
        {"mode", Kind::count_choice, "0|1|2|3|4|5|6"},
        {"targets", Kind::index_maps, "/accessors"},
        {"extensions", Kind::object, "primitive_extensions"}}},
      {"primitive_extensions", {{"KHR_draco_mesh_compression", Kind::object, "draco"}}},
      {"draco",
       {{"bufferView", Kind::index, "/bufferViews", k_required},
        {"attributes", Kind::index_map, "", k_required}}},
      {"accessor",
       {{"name", Kind::text},
        {"bufferView", Kind::index, "/bufferViews"},
        {"byteOffset", Kind::count},
        {"componentType", Kind::count_choice, "5120|5121|5122|5123|5125|5126", k_required},
        {"normalized", Kind::flag},
        {"count", Kind::count, "", k_required},
        {"type", Kind::choice, "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4", k_required},
        {"sparse", Kind::object, "sparse"}}},
      {"sparse",
       {{"count", Kind::count, "int", k_required},
        {"indices", Kind::object, "sparse_indices", k_required},
        {"values", Kind::object, "sparse_values", k_required}}},
      {"sparse_indices",
       {{"bufferView", Kind::index, "/bufferViews", k_required},
        {"byteOffset", Kind::count, "int"},
        {"componentType", Kind::count_choice, "5121|5123|5125", k_required}}},
      {"sparse_values",
       {{"bufferView", Kind::index, "/bufferViews", k_required},
        {"byteOffset", Kind::count, "int"}}},
      {"buffer_view",
       {{"name", Kind::text},
        {"buffer", Kind::index, "/buffers", k_required},
        {"byteOffset", Kind::count},
        {"byteLength", Kind::count, "", k_required},
        {"byteStride", Kind::count},
        {"extensions", Kind::object, "buffer_view_extensions"}}},
      {"buffer_view_extensions", {{"EXT_meshopt_compression", Kind::object, "meshopt"}}},
      {"meshopt",
       {{"buffer", Kind::index, "/buffers", k_required},
        {"byteOffset", Kind::count},
        {"byteLength", Kind::count, "", k_required},
        {"byteStride", Kind::count, "int", k_required},
        {"count", Kind::count, "int", k_required},
        {"mode", Kind::choice, "ATTRIBUTES|TRIANGLES|INDICES", k_required},
        {"filter", Kind::choice, "NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL"}}},
      {"buffer",
       {{"name", Kind::text},
        {"uri", Kind::text},
        {"byteLength", Kind::count, "", k_required},
        {"extensions", Kind::object, "buffer_extensions"}}},
      {"buffer_extensions", {{"EXT_meshopt_compression", Kind::object, "buffer_meshopt"}}},
      {"buffer_meshopt", {{"fallback", Kind::flag}}},
      {"material",
       {{"name", Kind::text},
        {"pbrMetallicRoughness", Kind::object, "pbr"},
        {"normalTexture", Kind::object, "normal_texture"},
        {"occlusionTexture", Kind::object, "occlusion_texture"},
        {"emissiveTexture", Kind::object, "texture_info"},
        {"emissiveFactor", Kind::numbers, "", false, 3},
        {"alphaMode", Kind::choice, "OPAQUE|MASK|BLEND"},
        {"alphaCutoff", Kind::number},
        {"doubleSided", Kind::flag},
        {"extensions", Kind::object, "material_extensions"}}},
      {"pbr",
       {{"baseColorFactor", Kind::numbers, "", false, 4},
        {"baseColorTexture", Kind::object, "texture_info"},
        {"metallicFactor", Kind::number},
        {"roughnessFactor", Kind::number},
        {"metallicRoughnessTexture", Kind::object, "texture_info"}}},
      {"material_extensions",
       {{"KHR_materials_emissive_strength", Kind::object, "emissive_strength"},
        {"KHR_materials_ior", Kind::object, "ior"},
        {"KHR_materials_specular", Kind::object, "specular"},
        {"KHR_materials_unlit", Kind::object, "nothing"}}},
      {"emissive_strength", {{"emissiveStrength", Kind::number}}},
      {"ior", {{"ior", Kind::number}}},
      {"nothing", {}},
      {"specular",
       {{"specularFactor", Kind::number},
        {"specularTexture", Kind::object, "texture_info"},
        {"specularColorFactor", Kind::numbers, "", false, 3},
        {"specularColorTexture", Kind::object, "texture_info"}}},
      {"texture_info",
       {{"index", Kind::index, "/textures", k_required},
        {"texCoord", Kind::count, "int"},
        {"extensions", Kind::object, "texture_info_extensions"}}},
      {"normal_texture",
       {{"index", Kind::index, "/textures", k_required},
        {"texCoord", Kind::count, "int"},
        {"scale", Kind::number},
        {"extensions", Kind::object, "texture_info_extensions"}}},
      {"occlusion_texture",
       {{"index", Kind::index, "/textures", k_required},
        {"texCoord", Kind::count, "int"},
        {"strength", Kind::number},
        {"extensions", Kind::object, "texture_info_extensions"}}},
      {"texture_info_extensions", {{"KHR_texture_transform", Kind::object, "texture_transform"}}},
      {"texture_transform",
       {{"offset", Kind::numbers, "", false, 2},
        {"rotation", Kind::number},
        {"scale", Kind::numbers, "", false, 2},
        {"texCoord", Kind::count, "int"}}},
      {"texture",
       {{"name", Kind::text},
        {"sampler", Kind::index, "/samplers"},
        {"source", Kind::index, "/images"},
        {"extensions", Kind::object, "texture_extensions"}}},
      {"texture_extensions", {{"EXT_texture_webp", Kind::object, "texture_webp"}}},
      {"texture_webp", {{"source", Kind::index, "/images"}}},
      {"image",
       {{"name", Kind::text},
        {"uri", Kind::text},
        {"mimeType", Kind::text},
        {"bufferView", Kind::index, "/bufferViews"}}},
      {"sampler",
       {{"magFilter", Kind::count, "int"},
        {"minFilter", Kind::count, "int"},
        {"wrapS", Kind::count_choice, "10497|33071|33648"},
        {"wrapT", Kind::count_choice, "10497|33071|33648"}}},
      {"camera",
       {{"name", Kind::text},
        {"type", Kind::choice, "perspective|orthographic", k_required},
        {"perspective", Kind::object, "perspective"},
        {"orthographic", Kind::object, "orthographic"}}},
      {"perspective",
       {{"aspectRatio", Kind::number},
        {"yfov", Kind::number, "", k_required},
        {"zfar", Kind::number},
        {"znear", Kind::number, "", k_required}}},
      {"orthographic",
       {{"xmag", Kind::number, "", k_required},
        {"ymag", Kind::number, "", k_required},
        {"zfar", Kind::number, "", k_required},
        {"znear", Kind::number, "", k_required}}},
      {"skin",
       {{"inverseBindMatrices", Kind::index, "/accessors"},
        {"joints", Kind::indices, "/nodes", k_required}}},
      {"animation",
       {{"name", Kind::text},
        {"channels", Kind::objects, "animation_channel", k_required},
        {"samplers", Kind::objects, "animation_sampler", k_required}}},
      {"animation_channel",
       {{"sampler", Kind::count, "int", k_required},
        {"target", Kind::object, "animation_target", k_required}}},
      {"animation_target", {{"node", Kind::index, "/nodes"}, {"path", Kind::text, "", k_required}}},
      {"animation_sampler",
       {{"input", Kind::index, "/accessors", k_required},
        {"output", Kind::index, "/accessors", k_required},
        {"interpolation", Kind::choice, "LINEAR|STEP|CUBICSPLINE"}}},
      {"root_extensions",
       {{"KHR_lights_punctual", Kind::object, "lights_punctual"},
        {"EXT_lights_area", Kind::object, "lights_area"}}},
      {"lights_punctual", {{"lights", Kind::objects, "light_punctual", k_required}}},
      {"light_punctual",
       {{"name", Kind::text},
        {"type", Kind::choice, "point|spot|directional", k_required},
        {"color", Kind::numbers, "", false, 3},
        {"intensity", Kind::number},
        {"range", Kind::number},
        {"spot", Kind::object, "spot"}}},
      {"spot", {{"innerConeAngle", Kind::number}, {"outerConeAngle", Kind::number}}},
      {"lights_area", {{"lights", Kind::objects, "light_area", k_required}}},
      {"light_area",
       {{"name", Kind::text},
        {"type", Kind::choice, "rect|disk", k_required},
        {"color", Kind::numbers, "", false, 3},
        {"intensity", Kind::number},
        {"size", Kind::number},
        {"rect", Kind::object, "rect"}}},
      {"rect", {{"aspect", Kind::number}}},
  };
  return types.at(name);
}

class Checker {
public:
  explicit Checker(json& root) : root_(root) {}

  void check_object(json& value, const std::string& path, std::string_view type) {
    if (!value.is_object()) fail(path, "must be an object; export the file again");
    for (const Field& field : type_named(type)) {
      const std::string field_path = path.empty() ? field.name : path + "." + field.name;
      const auto found = value.find(field.name);
      if (found == value.end()) {
        if (field.required) fail(field_path, "is missing; export the file again");
        continue;
      }
      check_field(*found, field_path, field);
    }
  }

private:
  void check_field(json& value, const std::string& path, const Field& field) {
    switch (field.kind) {
    case Kind::text:
      if (!value.is_string()) fail(path, "must be a text");
      break;
    case Kind::flag:
      if (!value.is_boolean()) fail(path, "must be true or false");
      break;
    case Kind::number:
      check_number(value, path);
      break;
    case Kind::numbers:
      for_each(value, path, [&](json& v, const std::string& p) { check_number(v, p); });
      if (field.size != 0 && value.size() != field.size)
        fail(path, fmt::format("must hold {} numbers, not {}", field.size, value.size()));
      break;
    case Kind::count:
      check_whole(value, path, *field.detail ? k_max_index : k_max_count);
      break;
    case Kind::index:
      check_index(value, path, field.detail);
      break;
    case Kind::indices:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_index(v, p, field.detail); });
      break;
    case Kind::index_map:
      check_index_map(value, path, field.detail);
      break;
    case Kind::index_maps:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_index_map(v, p, field.detail); });
      break;
    case Kind::object:
      check_object(value, path, field.detail);
      break;
    case Kind::objects:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_object(v, p, field.detail); });
      break;
    case Kind::texts:
      for_each(value, path, [&](json& v, const std::string& p) {
        if (!v.is_string()) fail(p, "must be a text");
      });
      break;
    case Kind::choice:
      if (!value.is_string()) fail(path, "must be a text");
      check_choice(value.get_ref<const std::string&>(), path, field.detail);
      break;
    case Kind::count_choice:
      check_whole(value, path, k_max_index);
      check_choice(std::to_string(value.get<std::int64_t>()), path, field.detail);
      break;
    }
  }

  template <class Check>
  static void for_each(json& value, const std::string& path, const Check& check) {
    if (!value.is_array()) fail(path, "must be an array");
    for (std::size_t i = 0; i < value.size(); ++i)
      check(value[i], path + "[" + std::to_string(i) + "]");
  }

  static void check_number(json& value, const std::string& path) {
    if (!value.is_number()) fail(path, "must be a number");
    // Everything is used in single precision sooner or later.
    if (!(std::abs(value.get<double>()) <= 1e37)) // false for NaN
      fail(path,
           fmt::format("{} is beyond the range of numbers that can be used", quote(value.dump())));
    value = value.get<double>(); // tinygltf keeps whole numbers in 32 bits
  }

  static void check_whole(json& value, const std::string& path, double limit) {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= 0) || !(number <= limit) || number != std::floor(number))
      fail(path, fmt::format("{} is not a usable whole number; export the file again",
                             value.is_number() ? quote(value.dump()) : "this"));
    if (value.is_number_float()) value = std::int64_t(number);
  }

  void check_index(json& value, const std::string& path, const char* target) const {
    check_whole(value, path, k_max_index);
    if (!*target) return;
    const json::json_pointer pointer(target);
    const bool exists = root_.contains(pointer) && root_[pointer].is_array();
    const std::size_t size = exists ? root_[pointer].size() : 0;
    if (value.get<std::uint64_t>() < size) return;
    std::string array = target + 1;
    for (char& c : array)
      if (c == '/') c = '.';
    fail(path, fmt::format("points at {}[{}], but there {}; the file is damaged, export it again",
                           array, value.get<std::uint64_t>(),
                           size == 0 ? std::string("are none") : fmt::format("are only {}", size)));
  }

  void check_index_map(json& value, const std::string& path, const char* target) const {
    if (!value.is_object()) fail(path, "must be an object");
    for (auto& [key, index] : value.items())
      check_index(index, path + "." + quote(key), target);
  }

  static void check_choice(std::string_view value, const std::string& path,
                           std::string_view choices) {
    std::string_view rest = choices;
    while (!rest.empty()) {
      const std::size_t bar = rest.find('|');
      if (rest.substr(0, bar) == value) return;
      rest = bar == std::string_view::npos ? std::string_view() : rest.substr(bar + 1);
    }
    std::string listed(choices);
    for (char& c : listed)
      if (c == '|') c = ' ';
    fail(path, fmt::format("\"{}\" is not one of: {}", quote(value), listed));
  }

  json& root_;
};

} // namespace

void check_schema(json& root) { Checker(root).check_object(root, "", "root"); }

void check_member(json& root, json& value, const std::string& path, const char* type) {
  Checker(root).check_object(value, path, type);
}

} // namespace openltc::scene::gltf
