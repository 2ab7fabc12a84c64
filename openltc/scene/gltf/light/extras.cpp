// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/light/extras.h"

#include "openltc/base/quote.h"
#include "openltc/light/light.h"
#include "openltc/scene/gltf/file/container.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <string_view>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::string_view k_prefix = "openltc_";

// A light in a text, e.g. of a custom property.
json parse_light(const std::string& text, const std::string& field) {
  check_json_depth(text, field);
  json parsed = json::parse(text, nullptr, false);
  if (parsed.is_discarded()) fail(field, "the text is not valid JSON");
  return parsed;
}

json light_of(const json& extras, const std::string& node) {
  const std::string field = fmt::format("{}.extras.{}", node, k_extras_light);
  json light = extras[k_extras_light];
  const bool is_text = light.is_string();
  if (is_text) {
    const std::string text = light.get<std::string>();
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] == '{')
      light = parse_light(text, field);
    else
      light = {{"type", text}};
  }
  if (!light.is_object())
    fail(field, "must be an object such as {\"type\": \"sphere\", \"radius\": 0.2}, or its text");
  for (const auto& [key, value] : extras.items()) {
    if (key.rfind(k_prefix, 0) != 0 || key == k_extras_light || key == k_extras_emits_light ||
        key == k_extras_surface_deviation)
      continue;
    const std::string name = key.substr(k_prefix.size());
    if (light.contains(name))
      fail(field, fmt::format("{} is given twice, also as {}", quote(name), quote(key)));
    light[name] = value;
  }
  return light;
}

// Blender before 3.0 had no truth values for custom properties, only 0 and 1.
bool flag_of(const json& value, const std::string& field) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number() && (value == 0 || value == 1)) return value == 1;
  fail(field, "must be true or false");
}

} // namespace

NodeExtras read_node_extras(const json& extras, const std::string& node, Document& document) {
  NodeExtras read;
  if (!extras.is_object()) return read;
  const auto guarded = [&](const char* consequence, const auto& action) {
    try {
      action();
    } catch (const Failure& failure) {
      document.warnings.add(fmt::format("{}; {}", failure.message, consequence));
    }
  };
  if (extras.contains(k_extras_light)) {
    read.describes_light = true;
    guarded("the light is left out", [&] { read.light = light_of(extras, node); });
  } else {
    for (const auto& [key, value] : extras.items())
      if (key.rfind(k_prefix, 0) == 0 && key != k_extras_emits_light &&
          key != k_extras_surface_deviation)
        document.warnings.add(fmt::format(
            "{}.extras.{}: there is no {} beside it, so that it means nothing; it is ignored", node,
            quote(key), k_extras_light));
  }
  if (extras.contains(k_extras_emits_light))
    guarded("it is ignored", [&] {
      read.emits_light = flag_of(extras[k_extras_emits_light],
                                 fmt::format("{}.extras.{}", node, k_extras_emits_light));
    });
  if (extras.contains(k_extras_surface_deviation))
    guarded("it is ignored", [&] {
      const json& value = extras[k_extras_surface_deviation];
      if (!value.is_number() || !(value.get<double>() >= 0) ||
          !(value.get<double>() <= light::k_max_metres))
        fail(fmt::format("{}.extras.{}", node, k_extras_surface_deviation),
             "must be a length in metres, 0 or more");
      read.surface_deviation = value.get<double>();
    });
  return read;
}

} // namespace openltc::scene::gltf
