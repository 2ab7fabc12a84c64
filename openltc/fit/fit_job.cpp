// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/fit_job.h"

#include "openltc/fit/joint/look_up_fit.h"
#include "openltc/fit/measure/certificate.h"
#include "openltc/fit/measure/limit.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/two_lobe_fit.h"
#include "openltc/table/divided.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace openltc::fit {

namespace {

using table::Layout;
using table::PackedTable;

// In which the lobes are stored.
Layout stored_layout(const FitRequest& request) {
  return request.form == table::LobeForm::two_lobe ? Layout::native_two : request.layout;
}

bool is_builtin_source(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".cpp" || extension == ".inc";
}

// Whether the layout's look-up can interpolate these lobes: between nodes whose matrices differ
// much it may find one that turns its lobe inside out. Looked at on a grid four times as fine.
std::string interpolation_warning(const PackedTable& packed) {
  constexpr int k_finer = 4;
  constexpr double k_from = 0.01;
  const int columns = packed.columns() > 1 ? k_finer * (packed.columns() - 1) + 1 : 1;
  const int rows = k_finer * (packed.rows() - 1) + 1;
  int points = 0, broken = 0;
  double least = 1, most = 0;
  for (int column = 0; column < columns; ++column) {
    const double roughness = table::node_roughness(columns, column);
    if (roughness < k_from) continue;
    for (int row = 0; row < rows; ++row) {
      const double c = cosine_at(double(row) / (rows - 1), packed.angle_axis);
      ++points;
      if (table::fetch_packed(packed, roughness, c).lobe.det > 0) continue;
      ++broken;
      least = std::min(least, roughness);
      most = std::max(most, roughness);
    }
  }
  if (broken == 0) return "";
  return fmt::format("warning: {:.2g} % of the lobes that a look-up in layout {} reads turn inside "
                     "out between the nodes, at roughness {:.3g} to {:.3g}: this layout cannot "
                     "interpolate them there; more nodes (--size) or --layout native help",
                     100.0 * broken / points, name_of(packed.layout), least, most);
}

Result<FittedLobes> fit_polynomial_form(const brdf::Brdf& brdf, const FitRequest& request,
                                        const Objective& objective, const Progress& progress) {
  PolynomialFitOptions options;
  options.degree = request.degree;
  options.two_lobes = request.form == table::LobeForm::two_lobe_polynomial;
  options.objective = objective;
  Result<PolynomialFit> fitted = fit_polynomial(brdf, options, progress);
  if (!fitted) return fitted.error();
  FittedLobes result;
  result.stored = std::move(fitted->polynomial);
  result.note = fmt::format("certified: A D - w B C >= {:.2e}{} over the whole domain ({} boxes); "
                            "no lobe turns inside out",
                            fitted->certificate.lower_bound,
                            options.two_lobes ? " of both lobes" : "", fitted->certificate.boxes);
  return result;
}

Result<FittedLobes> fit_table_form(const brdf::Brdf& brdf, const FitRequest& request,
                                   const Objective& objective, const Progress& progress) {
  TableFitOptions options;
  options.size = request.size;
  options.refine = request.refine;
  const bool native = request.layout == Layout::native;
  const bool refine_later = !native && request.refine == Refine::on;
  if (!native) options.refine = Refine::off; // that of the native look-up, which they do not meet
  options.angle_axis = table::angle_axis_of(request.layout);
  options.lobe.objective = objective;
  const bool two = request.form == table::LobeForm::two_lobe;
  const Progress first = part_of(progress, 0, refine_later ? 0.1 : 1);
  Result<table::LobeTable> fitted =
      two ? fit_two_lobe_table(brdf, options, first) : fit_table(brdf, options, first);
  if (!fitted) return fitted.error();
  Result<PackedTable> packed =
      table::pack(*fitted, stored_layout(request), table::Precision::float32);
  if (!packed) return packed.error();
  if (refine_later) {
    const Progress rest = part_of(progress, 0.1, 1);
    if (Status status = refine_look_up(brdf, *packed, objective, rest); !status)
      return status.error();
  }
  if (!native && request.clip_aware) table::divide_amplitudes(*packed);
  packed = table::with_precision(*packed, request.precision);
  if (!packed) return packed.error();
  FittedLobes result;
  if (!native) result.warning = interpolation_warning(*packed);
  if (two)
    result.note = fmt::format("certified: A D - w B C >= {:.2e} of both lobes, between the nodes "
                              "too; no lobe turns inside out",
                              certify_determinants(*fitted).lower_bound);
  result.stored = std::move(*packed);
  result.nodes = std::move(*fitted);
  return result;
}

} // namespace

table::TableMetadata& FittedLobes::metadata() {
  return std::visit([](auto& form) -> table::TableMetadata& { return form.metadata; }, stored);
}

const table::TableMetadata& FittedLobes::metadata() const {
  return std::visit([](const auto& form) -> const table::TableMetadata& { return form.metadata; },
                    stored);
}

LobeFunction FittedLobes::lobes() const {
  if (const auto* packed = std::get_if<PackedTable>(&stored))
    return [packed](double roughness, double cos_theta) {
      return fetch_measured(*packed, roughness, cos_theta);
    };
  return lobes_of(std::get<table::LobePolynomial>(stored));
}

Status check_extensions(const FitRequest& request, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    Status status = Success{};
    if (is_polynomial(request.form))
      status = table::check_polynomial_extension(path);
    else if (!is_builtin_source(path))
      status = table::check_packed_extension(path);
    if (!status) return status;
  }
  return Success{};
}

Result<std::vector<std::string>> check_outputs(const brdf::Brdf& brdf, const FitRequest& request,
                                               const std::vector<std::string>& paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    std::vector<std::string> files = {path};
    const bool polynomial = is_polynomial(request.form);
    if (!polynomial && is_builtin_source(path)) {
      if (request.layout != Layout::native || request.precision != table::Precision::float32)
        return Error{path + ": C++ source of the built-in is for --layout native --precision "
                            "float32; .h holds any"};
    } else if (!polynomial) {
      files = table::packed_files(stored_layout(request), path);
    }
    if (is_builtin_source(path) && brdf.width != brdf::LobeWidth::alpha)
      return Error{fmt::format("{}: C++ source of the built-in is for lobes that narrow with "
                               "roughness, not for {}; .h holds any",
                               path, brdf.name)};
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

Result<FittedLobes> fit_lobes(const brdf::Brdf& brdf, const FitRequest& request,
                              const Progress& progress) {
  const Result<Objective> found = find_objective(request.objective);
  if (!found) return found.error();
  Objective objective = *found;
  if (request.layout != Layout::native && !request.clip_aware) objective.horizon = Horizon::leaking;

  const auto begin = std::chrono::steady_clock::now();
  Result<FittedLobes> result = is_polynomial(request.form)
                                   ? fit_polynomial_form(brdf, request, objective, progress)
                                   : fit_table_form(brdf, request, objective, progress);
  if (!result) return result;
  result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result->horizon = objective.horizon;
  result->objective = objective;
  complete_metadata(result->metadata(), {}, request.tool_version.c_str(), request.command);
  return result;
}

void state_error(FittedLobes& fitted, const TableError& error) {
  table::TableMetadata& metadata = fitted.metadata();
  const std::string version = metadata.tool_version, command = metadata.command;
  complete_metadata(metadata, error, version.c_str(), command);
  if (fitted.nodes) fitted.nodes->metadata = metadata;
}

Candidate candidate_of(const FittedLobes& fitted, const FitRequest& request) {
  Candidate c;
  const bool polynomial = is_polynomial(request.form);
  const bool two = request.form == table::LobeForm::two_lobe ||
                   request.form == table::LobeForm::two_lobe_polynomial;
  c.label = fmt::format("{}{}, {}{}", request.objective, two ? ", two lobes" : "",
                        polynomial ? "degree " : "", polynomial ? request.degree : request.size);
  c.lobes = fitted.lobes();
  c.horizon = fitted.horizon;
  const table::TableMetadata& m = fitted.metadata();
  for (const table::MetadataField& field : table::k_metadata_fields)
    if (field.text && !(m.*field.text).empty()) c.metadata.emplace_back(field.name, m.*field.text);
  if (!polynomial)
    c.metadata.emplace_back("layout", fmt::format("{}, {}", name_of(stored_layout(request)),
                                                  name_of(request.precision)));
  if (!fitted.note.empty()) c.metadata.emplace_back("proof", fitted.note);
  if (fitted.nodes) c.nodes = node_axes(*fitted.nodes, MeasureOptions{0, 1, 90});
  return c;
}

Candidate limit_of(const brdf::Brdf& brdf, const FittedLobes& fitted) {
  Candidate limit;
  limit.label = "limit";
  limit.horizon = fitted.horizon;
  limit.lobes = best_single_lobes(brdf, fitted.lobes(), fitted.objective);
  limit.metadata = {{"what", fmt::format("the best single lobe at every point by itself, {}",
                                         fitted.objective.name)}};
  limit.is_limit = true;
  return limit;
}

std::string size_note(const PackedTable& packed) {
  const table::LayoutFacts& facts = facts_of(packed.layout);
  const int usual = facts.usual_size;
  if (usual == 0 || (packed.columns() == usual && packed.rows() == usual)) return "";
  return fmt::format("note: {} expects {} x {} texels, this table has {} x {}; see --size",
                     facts.readers, usual, usual, packed.columns(), packed.rows());
}

Result<std::vector<FileBytes>> lobes_bytes(const FittedLobes& fitted, const std::string& path) {
  if (const auto* polynomial = std::get_if<table::LobePolynomial>(&fitted.stored)) {
    Result<FileBytes> file = table::polynomial_bytes(*polynomial, path);
    if (!file) return file.error();
    return std::vector<FileBytes>{std::move(*file)};
  }
  if (is_builtin_source(path))
    return std::vector<FileBytes>{file_of_text(path, table::to_builtin_source(*fitted.nodes))};
  return table::packed_bytes(std::get<PackedTable>(fitted.stored), path);
}

Result<std::vector<std::string>> write_lobes(const FittedLobes& fitted, const std::string& path) {
  const Result<std::vector<FileBytes>> files = lobes_bytes(fitted, path);
  if (!files) return files.error();
  return write_files(*files);
}

} // namespace openltc::fit
