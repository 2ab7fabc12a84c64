// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/container/lobe_json.h"

#include "openltc/table/container/description.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

namespace openltc::table {

namespace {

// A string literal of JSON is one of C++ too.
std::string literal(const TableMetadata& metadata, const MetadataField& field) {
  return field.text ? json_quoted(metadata.*field.text) : fmt::format("{}", metadata.*field.number);
}

} // namespace

std::string text_of(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double number_of(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string metadata_json(const TableMetadata& metadata) {
  std::string out = "\"metadata\": {\n";
  for (const MetadataField& field : k_metadata_fields)
    out += fmt::format("  \"{}\": {}{}\n", field.name, literal(metadata, field),
                       &field == std::end(k_metadata_fields) - 1 ? "" : ",");
  return out + "},\n";
}

Status read_metadata(const nlohmann::json& root, const std::string& name, TableMetadata& metadata) {
  const auto found = root.find("metadata");
  if (found == root.end() || !found->is_object()) return Error{name + ": metadata is missing"};
  for (const MetadataField& field : k_metadata_fields) {
    if (field.text) metadata.*field.text = text_of(*found, field.name);
    if (field.number) metadata.*field.number = number_of(*found, field.name);
  }
  return Success{};
}

std::string metadata_assignments(const TableMetadata& metadata, const std::string& variable) {
  std::string out;
  for (const MetadataField& field : k_metadata_fields)
    out += fmt::format("  {}.metadata.{} = {};\n", variable, field.name, literal(metadata, field));
  return out;
}

std::string number_rows(const std::vector<float>& values, int stride) {
  std::string rows;
  const std::size_t step = std::size_t(stride);
  for (std::size_t i = 0; i + step <= values.size(); i += step) {
    for (int k = 0; k < k_stored_channels; ++k) {
      if (k > 0) rows += ",";
      rows += json_number(values[i + std::size_t(k)]);
    }
    rows += i + 2 * step <= values.size() ? ",\n" : "\n";
  }
  return rows;
}

} // namespace openltc::table
