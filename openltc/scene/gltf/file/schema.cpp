// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Walks the fields of a file beside those of its type (schema_types.h).

#include "openltc/scene/gltf/file/schema.h"

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/schema_types.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;
// Largest whole number that a double holds exactly; more than any file has bytes.
constexpr double k_max_count = 9007199254740992.0;
// tinygltf keeps indices and the offsets of sparse accessors in an int.
constexpr double k_max_index = 2147483647.0;

class Checker {
public:
  explicit Checker(json& root) : root_(root) {}

  void check_object(json& value, const std::string& path, std::string_view type) {
    if (!value.is_object()) fail(path, "must be an object; export the file again");
    for (const SchemaField& field : schema_type(type)) {
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
  void check_field(json& value, const std::string& path, const SchemaField& field) {
    switch (field.kind) {
    case FieldKind::text:
      if (!value.is_string()) fail(path, "must be a text");
      break;
    case FieldKind::flag:
      if (!value.is_boolean()) fail(path, "must be true or false");
      break;
    case FieldKind::number:
      check_number(value, path);
      break;
    case FieldKind::numbers:
      for_each(value, path, [&](json& v, const std::string& p) { check_number(v, p); });
      if (field.size != 0 && value.size() != field.size)
        fail(path, fmt::format("must hold {} numbers, not {}", field.size, value.size()));
      break;
    case FieldKind::count:
      check_whole(value, path, *field.detail ? k_max_index : k_max_count);
      break;
    case FieldKind::index:
      check_index(value, path, field.detail);
      break;
    case FieldKind::indices:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_index(v, p, field.detail); });
      break;
    case FieldKind::index_map:
      check_index_map(value, path, field.detail);
      break;
    case FieldKind::index_maps:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_index_map(v, p, field.detail); });
      break;
    case FieldKind::object:
      check_object(value, path, field.detail);
      break;
    case FieldKind::objects:
      for_each(value, path,
               [&](json& v, const std::string& p) { check_object(v, p, field.detail); });
      break;
    case FieldKind::texts:
      for_each(value, path, [&](json& v, const std::string& p) {
        if (!v.is_string()) fail(p, "must be a text");
      });
      break;
    case FieldKind::choice:
      if (!value.is_string()) fail(path, "must be a text");
      check_choice(value.get_ref<const std::string&>(), path, field.detail);
      break;
    case FieldKind::count_choice:
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
