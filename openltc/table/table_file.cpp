// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/table_file.h"

#include "openltc/base/atomic_file.h"
#include "openltc/table/container/description.h"
#include "openltc/table/container/lobe_json.h"
#include "openltc/table/lobe_check.h"
#include "openltc/table/packed_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>

namespace openltc::table {

namespace {

constexpr const char* k_format = "openltc-lobe-table";
constexpr int k_version = 2;     // 1: square, sqrt(1 - cos theta), width alpha
constexpr int k_two_version = 3; // of two lobes
// Of a texel of two lobes: A B C D n1 n5 weight A2 B2 C2 D2.
constexpr int k_two_channels = 11;
constexpr int k_max_size = 512;

bool ends_with(const std::string& text, const char* ending) {
  const std::size_t n = std::strlen(ending);
  return text.size() >= n && text.compare(text.size() - n, n, ending) == 0;
}

// The texels of two lobes, k_two_channels numbers each.
std::vector<float> both_lobes(const LobeTable& table) {
  std::vector<float> values;
  for (int row = 0; row < table.rows; ++row)
    for (int column = 0; column < table.columns; ++column) {
      const float* texel = table.texel(column, row);
      const float* second = table.second_texel(column, row);
      values.insert(values.end(), texel, texel + 7);
      values.insert(values.end(), second, second + LobeTable::k_second_channels);
    }
  return values;
}

} // namespace

std::string to_json(const LobeTable& table) {
  std::string out = "{\n";
  out += fmt::format("\"format\": \"{}\",\n\"version\": {},\n", k_format,
                     table.two_lobes() ? k_two_version : k_version);
  out += metadata_json(table.metadata);
  out += fmt::format("\"columns\": {},\n\"rows\": {},\n", table.columns, table.rows);
  out += fmt::format("\"angle_axis\": \"{}\",\n", name_of(table.angle_axis));
  out +=
      fmt::format("\"width\": \"{}\",\n", table.width == brdf::LobeWidth::alpha ? "alpha" : "one");
  out += "\"axes\": [\"x, fast: sqrt(alpha) = roughness, node i at i/(columns-1)\", "
         "\"y: angle_axis (theta over pi/2), node j at j/(rows-1)\"],\n";
  out += "\"packing\": \"mirror frame: M^-1 = [A 0 wB; 0 1 0; wC 0 wD], w = width, acting on "
         "(x', y, z'), x' = (cos, 0, sin), z' = (-sin, 0, cos)\",\n";
  out += "\"channels\": [\"A\", \"B\", \"C\", \"D\", \"n1\", \"n5\"";
  if (table.two_lobes()) out += ", \"weight\", \"A2\", \"B2\", \"C2\", \"D2\"";
  out += "],\n\"texels\": [\n";
  out += table.two_lobes() ? number_rows(both_lobes(table), k_two_channels, k_two_channels)
                           : number_rows(table.texels, LobeTable::k_channels);
  return out + "]\n}\n";
}

Result<LobeTable> from_json(const std::string& text, const std::string& name) {
  const nlohmann::json root = nlohmann::json::parse(text, nullptr, false);
  if (root.is_discarded()) return Error{name + ": not a complete JSON file; was it cut off?"};
  if (!root.is_object() || text_of(root, "format") != k_format)
    return Error{
        fmt::format("{}: format is not \"{}\"; openltc fit writes such tables", name, k_format)};
  const double version = number_of(root, "version");
  if (version != 1 && version != k_version && version != k_two_version)
    return Error{
        fmt::format("{}: version is not 1 to {}, those this build reads", name, k_two_version)};

  LobeTable table;
  const bool square = version == 1;
  const double columns = number_of(root, square ? "size" : "columns");
  const double rows = number_of(root, square ? "size" : "rows");
  const auto is_size = [](double size, double least) {
    return size >= least && size <= k_max_size && size == std::floor(size);
  };
  if (!is_size(columns, square ? 2 : 1) || !is_size(rows, 2))
    return Error{fmt::format("{}: {} must be whole numbers to {}", name,
                             square ? "size" : "columns and rows", k_max_size)};
  table.columns = int(columns);
  table.rows = int(rows);
  if (!square) {
    const std::string axis = text_of(root, "angle_axis"), width = text_of(root, "width");
    if (axis == name_of(AngleAxis::theta))
      table.angle_axis = AngleAxis::theta;
    else if (axis != name_of(AngleAxis::sqrt_one_minus_cos))
      return Error{fmt::format("{}: unknown angle_axis {}", name, json_quoted(axis))};
    if (width == "one")
      table.width = brdf::LobeWidth::one;
    else if (width != "alpha")
      return Error{fmt::format("{}: unknown width {}", name, json_quoted(width))};
  }
  const auto texels = root.find("texels");
  if (texels == root.end() || !texels->is_array()) return Error{name + ": texels is missing"};
  const std::size_t count = std::size_t(table.columns) * std::size_t(table.rows);
  const bool two = version == k_two_version;
  const std::size_t channels = std::size_t(two ? k_two_channels : k_stored_channels);
  if (texels->size() != count * channels)
    return Error{fmt::format("{}: texels holds {} numbers, but {} x {} needs {}", name,
                             texels->size(), table.columns, table.rows, count * channels)};

  table.texels.assign(count * LobeTable::k_channels, 0.0f);
  if (two) table.second.assign(count * LobeTable::k_second_channels, 0.0f);
  for (std::size_t i = 0; i < count; ++i) {
    float* texel = table.texels.data() + i * LobeTable::k_channels;
    for (std::size_t k = 0; k < channels; ++k) {
      const nlohmann::json& value = (*texels)[i * channels + k];
      float& number = k < 7 ? texel[k] : table.second[i * LobeTable::k_second_channels + (k - 7)];
      if (value.is_number()) number = float(value.get<double>());
      if (!value.is_number() || !std::isfinite(number))
        return Error{fmt::format("{}: texels[{}] is not a finite number", name, i * channels + k)};
    }
    if (!(texel[6] >= 0 && texel[6] <= 1))
      return Error{
          fmt::format("{}: texels[{}], a weight, is not within 0 to 1", name, i * channels + 6)};
  }
  if (Status status = check_determinants(table, name); !status) return status.error();

  if (Status status = read_metadata(root, name, table.metadata); !status) return status.error();
  return table;
}

Result<LobeTable> shading_table(const PackedTable& packed, const std::string& name) {
  Result<LobeTable> table = unpack(packed);
  if (table && table->angle_axis != AngleAxis::sqrt_one_minus_cos)
    table = resample(*table, table->columns, table->rows, AngleAxis::sqrt_one_minus_cos);
  if (!table) return Error{fmt::format("{}: {}", name, table.error().message)};
  return table;
}

Result<LobeTable> read_table(const std::string& path) {
  const Result<PackedTable> packed = read_packed(path);
  if (!packed) return packed.error();
  return shading_table(*packed, path);
}

std::string to_builtin_source(const LobeTable& table) {
  if (table.two_lobes()) {
    std::string out =
        builtin_head(table.metadata,
                     "One texel a line: A B C D n1 n5 weight 0, then A B C D of the second lobe; "
                     "see LobeTableView (openltc/target/resources.h).");
    out += builtin_metadata("k_ggx_two_lobes_metadata", table.metadata);
    out += fmt::format("inline constexpr int k_ggx_two_lobes_columns = {}, k_ggx_two_lobes_rows = "
                       "{};\n\n",
                       table.columns, table.rows);
    out += builtin_array("k_ggx_two_lobes", table.texels, LobeTable::k_channels) + "\n";
    return out +
           builtin_array("k_ggx_two_lobes_second", table.second, LobeTable::k_second_channels) +
           builtin_end();
  }
  std::string out =
      builtin_head(table.metadata, "One texel a line: A B C D n1 n5 0 0; see LobeTableView "
                                   "(openltc/target/resources.h).");
  out += builtin_metadata("k_ggx_table_metadata", table.metadata);
  out += fmt::format("inline constexpr int k_ggx_table_columns = {}, k_ggx_table_rows = {};\n\n",
                     table.columns, table.rows);
  return out + builtin_numbers("k_ggx_table", table.texels);
}

Status check_writable_extension(const std::string& path) {
  if (ends_with(path, ".json") || ends_with(path, ".cpp") || ends_with(path, ".inc"))
    return Success{};
  return Error{path + ": a table is written as .json, or as .cpp or .inc for C++ source"};
}

Status write_table(const LobeTable& table, const std::string& path) {
  if (Status status = check_writable_extension(path); !status) return status;
  const std::string text = ends_with(path, ".json") ? to_json(table) : to_builtin_source(table);
  const FileBytes file = file_of_text(path, text);
  const auto written = write_files({&file, 1});
  if (!written) return written.error();
  return Success{};
}

} // namespace openltc::table
