// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/fit_job.h"

#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/divided.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace openltc::cli {

namespace {

using table::Layout;
using table::PackedTable;

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
      const double c = fit::cosine_at(double(row) / (rows - 1), packed.angle_axis);
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

Result<FittedLobes> fit_polynomial_form(const brdf::Brdf& brdf, const FitChoices& choices,
                                        const fit::Objective& objective, const Progress& progress) {
  fit::PolynomialFitOptions options;
  options.degree = choices.degree;
  options.objective = objective;
  Result<fit::PolynomialFit> fitted = fit::fit_polynomial(brdf, options, progress);
  if (!fitted) return fitted.error();
  FittedLobes result;
  result.stored = std::move(fitted->polynomial);
  result.note = fmt::format("certified: A D - w B C >= {:.2e} over the whole domain ({} boxes); no "
                            "lobe turns inside out",
                            fitted->certificate.lower_bound, fitted->certificate.boxes);
  return result;
}

Result<FittedLobes> fit_table_form(const brdf::Brdf& brdf, const FitChoices& choices,
                                   const fit::Objective& objective, const Progress& progress) {
  fit::TableFitOptions options;
  options.size = choices.size;
  options.refine = choices.refine;
  // Refinement goes through the native look-up, which is not the one that these tables meet.
  if (choices.layout != Layout::native && choices.refine == fit::Refine::automatic)
    options.refine = fit::Refine::off;
  options.angle_axis = table::angle_axis_of(choices.layout);
  options.lobe.objective = objective;
  Result<table::LobeTable> fitted = fit::fit_table(brdf, options, progress);
  if (!fitted) return fitted.error();
  Result<PackedTable> packed = table::pack(*fitted, choices.layout, table::Precision::float32);
  if (!packed) return packed.error();
  if (choices.layout != Layout::native && choices.clip_aware) table::divide_amplitudes(*packed);
  packed = table::with_precision(*packed, choices.precision);
  if (!packed) return packed.error();
  FittedLobes result;
  if (choices.layout != Layout::native) result.warning = interpolation_warning(*packed);
  result.stored = std::move(*packed);
  result.nodes = std::move(*fitted);
  return result;
}

} // namespace

table::TableMetadata& FittedLobes::metadata() {
  return std::visit([](auto& form) -> table::TableMetadata& { return form.metadata; }, stored);
}

fit::LobeFunction FittedLobes::lobes() const {
  if (const auto* packed = std::get_if<PackedTable>(&stored))
    return [packed](double roughness, double cos_theta) {
      return table::fetch_albedo(*packed, roughness, cos_theta);
    };
  return fit::lobes_of(std::get<table::LobePolynomial>(stored));
}

std::string shell_word(const std::string& path) {
  constexpr const char* k_plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "_-./,:=@%+";
  if (!path.empty() && path.find_first_not_of(k_plain) == std::string::npos) return path;
  std::string quoted = "'";
  for (const char c : path)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string command_of(const FitChoices& c) {
  const FitChoices standard;
  std::string command = fmt::format("openltc fit --brdf {}", shell_word(c.brdf));
  if (c.form == LobeForm::polynomial)
    command += fmt::format(" --form polynomial --degree {}", c.degree);
  else
    command += fmt::format(" --size {}", c.size);
  if (c.objective != standard.objective) command += fmt::format(" --objective {}", c.objective);
  if (c.layout != standard.layout) command += fmt::format(" --layout {}", name_of(c.layout));
  if (c.precision != standard.precision)
    command += fmt::format(" --precision {}", name_of(c.precision));
  if (c.refine != standard.refine)
    command += fmt::format(" --refine {}", c.refine == fit::Refine::on ? "on" : "off");
  return c.clip_aware ? command + " --clip-aware" : command;
}

Status check_extensions(const FitChoices& choices, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    Status status = Success{};
    if (choices.form == LobeForm::polynomial)
      status = table::check_polynomial_extension(path);
    else if (!is_builtin_source(path))
      status = table::check_packed_extension(path);
    if (!status) return status;
  }
  return Success{};
}

Result<std::vector<std::string>> check_outputs(const brdf::Brdf& brdf, const FitChoices& choices,
                                               const std::vector<std::string>& paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    std::vector<std::string> files = {path};
    if (choices.form == LobeForm::table && is_builtin_source(path)) {
      if (choices.layout != Layout::native || choices.precision != table::Precision::float32)
        return Error{path + ": C++ source of the built-in is for --layout native --precision "
                            "float32; .h holds any"};
    } else if (choices.form == LobeForm::table) {
      files = table::packed_files(choices.layout, path);
    }
    if (is_builtin_source(path) && brdf.width != brdf::LobeWidth::alpha)
      return Error{fmt::format("{}: C++ source of the built-in is for lobes that narrow with "
                               "roughness, not for {}; .h holds any",
                               path, brdf.name)};
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

Result<FittedLobes> fit_lobes(const brdf::Brdf& brdf, const FitChoices& choices,
                              const Progress& progress) {
  const Result<fit::Objective> found = fit::find_objective(choices.objective);
  if (!found) return found.error();
  fit::Objective objective = *found;
  if (choices.layout != Layout::native && !choices.clip_aware)
    objective.horizon = fit::Horizon::leaking;

  const auto begin = std::chrono::steady_clock::now();
  Result<FittedLobes> result = choices.form == LobeForm::polynomial
                                   ? fit_polynomial_form(brdf, choices, objective, progress)
                                   : fit_table_form(brdf, choices, objective, progress);
  if (!result) return result;
  result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result->horizon = objective.horizon;
  result->objective = objective;
  fit::complete_metadata(result->metadata(), {}, OPENLTC_VERSION, command_of(choices));
  return result;
}

void state_error(FittedLobes& fitted, const fit::TableError& error) {
  table::TableMetadata& metadata = fitted.metadata();
  const std::string command = metadata.command;
  fit::complete_metadata(metadata, error, OPENLTC_VERSION, command);
  if (fitted.nodes) fitted.nodes->metadata = metadata;
}

std::string size_note(const PackedTable& packed) {
  const table::LayoutFacts& facts = facts_of(packed.layout);
  const int usual = facts.usual_size;
  if (usual == 0 || (packed.columns() == usual && packed.rows() == usual)) return "";
  return fmt::format("note: {} expects {} x {} texels, this table has {} x {}; see --size",
                     facts.readers, usual, usual, packed.columns(), packed.rows());
}

Result<std::vector<std::string>> write_lobes(const FittedLobes& fitted, const std::string& path) {
  if (const auto* polynomial = std::get_if<table::LobePolynomial>(&fitted.stored)) {
    if (Status status = table::write_polynomial(*polynomial, path); !status) return status.error();
    return std::vector<std::string>{path};
  }
  if (is_builtin_source(path)) {
    if (Status status = table::write_table(*fitted.nodes, path); !status) return status.error();
    return std::vector<std::string>{path};
  }
  return table::write_packed(std::get<PackedTable>(fitted.stored), path);
}

} // namespace openltc::cli
