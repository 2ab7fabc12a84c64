// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/shading_lobes.h"

#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

namespace openltc::table {

namespace {

// "one, those of eon", or "one" where the BRDF is not known.
std::string width_of(const TableMetadata& metadata) {
  return metadata.brdf.empty() ? "one" : fmt::format("one, those of {}", metadata.brdf);
}

Status check_width(const std::string& path, brdf::LobeWidth width, const TableMetadata& metadata) {
  if (width == brdf::LobeWidth::alpha) return Success{};
  return Error{
      fmt::format("{}: holds lobes of width {}; surfaces are shaded with lobes that narrow "
                  "with roughness, of width alpha, such as those of ggx or beckmann",
                  path, width_of(metadata))};
}

void note_brdf(const std::string& path, const TableMetadata& metadata,
               std::vector<std::string>& notes) {
  if (metadata.brdf.empty() || metadata.brdf == "ggx") return;
  notes.push_back(fmt::format("{}: fitted to {}; the reference integrator and point lights by the "
                              "exact BRDF shade ggx",
                              path, metadata.brdf));
}

} // namespace

bool is_polynomial_file(const std::string& path) {
  std::error_code ec;
  if (std::filesystem::path(path).extension() != ".json" ||
      !std::filesystem::is_regular_file(path, ec))
    return false;
  // The format is the first field of what this tool writes, but JSON may be sorted anew.
  std::ifstream file(path, std::ios::binary);
  std::string text(std::size_t(1) << 16, '\0');
  file.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(file.gcount()));
  return text.find("\"openltc-lobe-polynomial\"") != std::string::npos;
}

Result<ShadingLobes> read_shading_lobes(const std::string& path, std::vector<std::string>& notes) {
  if (is_polynomial_file(path)) {
    Result<LobePolynomial> polynomial = read_polynomial(path);
    if (!polynomial) return polynomial.error();
    if (Status status = check_width(path, polynomial->width, polynomial->metadata); !status)
      return status.error();
    note_brdf(path, polynomial->metadata, notes);
    return ShadingLobes(std::move(*polynomial));
  }
  const Result<PackedTable> packed = read_packed(path);
  if (!packed) return packed.error();
  Result<LobeTable> table = shading_table(*packed, path);
  if (!table) return table.error();
  if (Status status = check_width(path, table->width, table->metadata); !status)
    return status.error();
  if (table->columns < 2)
    return Error{fmt::format("{}: has one column, a lobe for one roughness only; surfaces are "
                             "shaded with a table over all of them",
                             path)};
  note_brdf(path, table->metadata, notes);
  if (!facts_of(packed->layout).has_amplitudes)
    notes.push_back(fmt::format("{}: layout {} holds no amplitudes; n1 = 1 and n5 = 0 are used, as "
                                "if no light were lost: rough surfaces come out too bright",
                                path, name_of(packed->layout)));
  return ShadingLobes(std::move(*table));
}

} // namespace openltc::table
