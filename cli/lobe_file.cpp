// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/lobe_file.h"

#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

namespace openltc::cli {

namespace {

// "one, those of eon", or "one" where the BRDF is not known.
std::string width_of(const table::TableMetadata& metadata) {
  return metadata.brdf.empty() ? "one" : fmt::format("one, those of {}", metadata.brdf);
}

Status check_width(const std::string& path, brdf::LobeWidth width,
                   const table::TableMetadata& metadata) {
  if (width == brdf::LobeWidth::alpha) return Success{};
  return Error{
      fmt::format("{}: holds lobes of width {}; surfaces are shaded with lobes that narrow "
                  "with roughness, of width alpha, such as those of ggx or beckmann",
                  path, width_of(metadata))};
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

Result<ShadingLobes> read_shading_lobes(const std::string& path) {
  if (is_polynomial_file(path)) {
    Result<table::LobePolynomial> polynomial = table::read_polynomial(path);
    if (!polynomial) return polynomial.error();
    if (Status status = check_width(path, polynomial->width, polynomial->metadata); !status)
      return status.error();
    return ShadingLobes(std::move(*polynomial));
  }
  Result<table::LobeTable> table = table::read_table(path);
  if (!table) return table.error();
  if (Status status = check_width(path, table->width, table->metadata); !status)
    return status.error();
  if (table->columns < 2)
    return Error{fmt::format("{}: has one column, a lobe for one roughness only; surfaces are "
                             "shaded with a table over all of them",
                             path)};
  return ShadingLobes(std::move(*table));
}

} // namespace openltc::cli
