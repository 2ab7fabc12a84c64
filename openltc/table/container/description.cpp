// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/container/description.h"

#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace openltc::table {

namespace {

constexpr const char* k_format = "openltc-packed-table";
constexpr const char* k_version = "1";
constexpr const char* k_number_keys[] = {"version", "columns", "rows", "mean_tv", "max_tv"};

bool is_number_key(const std::string& key) {
  return std::any_of(std::begin(k_number_keys), std::end(k_number_keys),
                     [&](const char* known) { return key == known; });
}

// A finite number, or 0.
double number_of(const std::string* text) {
  const double value = text ? std::strtod(text->c_str(), nullptr) : 0;
  return std::isfinite(value) ? value : 0;
}

std::string text_of(const KeyValues& description, const char* key) {
  const std::string* found = find_value(description, key);
  return found ? *found : std::string();
}

// The members of the description, without braces.
std::string members(const KeyValues& description) {
  std::string out;
  for (const auto& [key, value] : description)
    out += fmt::format("{}{}: {}", out.empty() ? "" : ",\n", json_quoted(key),
                       is_number_key(key) ? value : json_quoted(value));
  return out;
}

KeyValues texts_of(const nlohmann::json& root) {
  KeyValues description;
  for (const auto& [key, value] : root.items()) {
    if (value.is_string()) description.emplace_back(key, value.get<std::string>());
    if (value.is_number()) description.emplace_back(key, value.dump());
  }
  return description;
}

Result<nlohmann::json> parse(const std::string& text, const std::string& name) {
  nlohmann::json root = nlohmann::json::parse(text, nullptr, false);
  if (root.is_discarded())
    return Error{fmt::format("{}: not a complete JSON file; was it cut off?", name)};
  if (!root.is_object() || !root.contains("format") || root["format"] != k_format)
    return Error{fmt::format("{}: format is not \"{}\"; openltc fit and convert write such files",
                             name, k_format)};
  return root;
}

} // namespace

std::string json_quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_number(float value) {
  // "-0" would read back as the integer 0.
  return value == 0 && std::signbit(value) ? std::string("-0.0") : fmt::format("{}", value);
}

KeyValues describe(const PackedTable& packed) {
  const LayoutFacts& facts = facts_of(packed.layout);
  const TableMetadata& m = packed.metadata;
  KeyValues d = {
      {"format", k_format},
      {"version", k_version},
      {"layout", name_of(packed.layout)},
      {"precision", name_of(packed.precision)},
      {"columns", fmt::format("{}", packed.columns())},
      {"rows", fmt::format("{}", packed.rows())},
      {"roughness_axis",
       fmt::format("x = {}, node i at i/(columns-1), texel centre (i + 1/2)/columns",
                   packed.layout == Layout::ltc_code_alpha ? "alpha = roughness^2"
                                                           : "roughness = sqrt(alpha)")},
      {"angle_axis", name_of(packed.angle_axis)},
      {"width", packed.width == brdf::LobeWidth::alpha ? "alpha" : "one"},
      {"normalisation", facts.normalisation},
  };
  for (std::size_t t = 0; t < facts.channels.size(); ++t) {
    std::string names;
    for (const char* channel : facts.channels[t])
      names += fmt::format("{}{}", names.empty() ? "" : ", ", channel);
    d.emplace_back(fmt::format("texture_{}", t + 1), names);
  }
  d.emplace_back("read_by", facts.readers);
  for (const MetadataField& field : k_metadata_fields)
    d.emplace_back(field.name, field.text ? m.*field.text : fmt::format("{}", m.*field.number));
  return d;
}

Status apply_description(const KeyValues& d, const std::string& name, PackedTable& packed) {
  if (text_of(d, "format") != k_format || text_of(d, "version") != k_version)
    return Error{
        fmt::format("{}: the description is not \"{}\" version {}", name, k_format, k_version)};
  const Layout* layout = find_layout(text_of(d, "layout"));
  if (!layout)
    return Error{fmt::format("{}: unknown layout \"{}\"", name, quote(text_of(d, "layout")))};
  const std::string axis = text_of(d, "angle_axis"), width = text_of(d, "width");
  if (axis != name_of(AngleAxis::theta) && axis != name_of(AngleAxis::sqrt_one_minus_cos))
    return Error{fmt::format("{}: unknown angle_axis \"{}\"", name, quote(axis))};
  if (width != "alpha" && width != "one")
    return Error{fmt::format("{}: unknown width \"{}\"", name, quote(width))};
  const std::string *columns = find_value(d, "columns"), *rows = find_value(d, "rows");
  if ((columns && number_of(columns) != packed.columns()) ||
      (rows && number_of(rows) != packed.rows()))
    return Error{fmt::format("{}: the description says {} x {} nodes, the textures have {} x {}",
                             name, columns ? number_of(columns) : 0, rows ? number_of(rows) : 0,
                             packed.columns(), packed.rows())};
  packed.layout = *layout;
  packed.angle_axis =
      axis == name_of(AngleAxis::theta) ? AngleAxis::theta : AngleAxis::sqrt_one_minus_cos;
  packed.width = width == "one" ? brdf::LobeWidth::one : brdf::LobeWidth::alpha;
  TableMetadata& m = packed.metadata;
  for (const MetadataField& field : k_metadata_fields) {
    if (field.text) m.*field.text = text_of(d, field.name);
    if (field.number) m.*field.number = number_of(find_value(d, field.name));
  }
  return Success{};
}

std::string description_to_json(const KeyValues& description) {
  return "{\n" + members(description) + "\n}\n";
}

Result<KeyValues> description_from_json(const std::string& text, const std::string& name) {
  const Result<nlohmann::json> root = parse(text, name);
  if (!root) return root.error();
  return texts_of(*root);
}

std::string packed_to_json(const PackedTable& packed) {
  std::string out = "{\n" + members(describe(packed)) + ",\n\"textures\": [";
  for (std::size_t t = 0; t < packed.textures.size(); ++t) {
    const Texture& texture = packed.textures[t];
    out +=
        fmt::format("{}\n{{\"channels\": {}, \"values\": [\n", t > 0 ? "," : "", texture.channels);
    const std::size_t channels = std::size_t(texture.channels);
    for (std::size_t i = 0; i < texture.values.size(); ++i) {
      out += json_number(texture.values[i]);
      if (i + 1 < texture.values.size()) out += (i + 1) % channels == 0 ? ",\n" : ",";
    }
    out += "\n]}";
  }
  return out + "\n]\n}\n";
}

Result<PackedTable> packed_from_json(const std::string& text, const std::string& name) {
  const Result<nlohmann::json> parsed = parse(text, name);
  if (!parsed) return parsed.error();
  const nlohmann::json& root = *parsed;
  const KeyValues description = texts_of(root);
  const double columns = number_of(find_value(description, "columns"));
  const double rows = number_of(find_value(description, "rows"));
  const double limit = Texture::k_max_side;
  if (!(columns >= 1 && columns <= limit && rows >= 2 && rows <= limit) ||
      columns != std::floor(columns) || rows != std::floor(rows))
    return Error{fmt::format("{}: columns and rows must be whole numbers to {}", name, limit)};
  const auto textures = root.find("textures");
  if (textures == root.end() || !textures->is_array() || textures->empty() || textures->size() > 3)
    return Error{fmt::format("{}: textures must be an array of one to three", name)};

  PackedTable packed;
  packed.precision = text_of(description, "precision") == name_of(Precision::float16)
                         ? Precision::float16
                         : Precision::float32;
  for (const nlohmann::json& entry : *textures) {
    const std::size_t number = packed.textures.size() + 1;
    if (!entry.is_object() || !entry.contains("channels") || !entry.contains("values") ||
        !entry["channels"].is_number_integer() || !entry["values"].is_array())
      return Error{fmt::format("{}: texture {} lacks channels or values", name, number)};
    const std::int64_t channels = entry["channels"].get<std::int64_t>();
    if (Status status = check_texture_size(name, std::uint64_t(columns), std::uint64_t(rows),
                                           channels < 0 ? 0 : std::uint64_t(channels));
        !status)
      return status.error();
    Texture texture;
    texture.width = int(columns);
    texture.height = int(rows);
    texture.channels = int(channels);
    texture.precision = packed.precision;
    const nlohmann::json& values = entry["values"];
    if (values.size() != texture.count())
      return Error{fmt::format("{}: texture {} holds {} numbers, but {} x {} x {} needs {}", name,
                               number, values.size(), columns, rows, channels, texture.count())};
    texture.values.reserve(texture.count());
    for (const nlohmann::json& value : values) {
      if (!value.is_number())
        return Error{fmt::format("{}: texture {}, values[{}] is not a number", name, number,
                                 texture.values.size())};
      texture.values.push_back(float(value.get<double>()));
    }
    if (Status status = check_finite(name, texture); !status) return status.error();
    packed.textures.push_back(std::move(texture));
  }
  if (Status status = apply_description(description, name, packed); !status) return status.error();
  if (Status status = check_textures(name, packed.layout, packed.textures); !status)
    return status.error();
  return packed;
}

} // namespace openltc::table
