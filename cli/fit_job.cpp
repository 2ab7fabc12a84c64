// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/fit_job.h"

#include "cli/output_place.h"
#include "openltc/fit/lobe_fit.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

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

// Amplitudes for a renderer that clips lights at the horizon but does not divide by the share of
// the lobe above it: the division is done here, at every node.
void divide_amplitudes(table::LobeTable& t) {
  for (int row = 0; row < t.rows; ++row) {
    for (int column = 0; column < t.columns; ++column) {
      const double y = double(row) / (t.rows - 1);
      const double roughness = t.columns > 1 ? double(column) / (t.columns - 1) : 1;
      const double c = std::max(fit::cosine_at(y, t.angle_axis), 0.0);
      const double above =
          std::max(fit::above_horizon(table::fetch_native(t, roughness, c).lobe), f64::k_min_share);
      float* texel = t.texel(column, row);
      texel[4] = float(double(texel[4]) / above);
      texel[5] = float(double(texel[5]) / above);
    }
  }
}

Result<FittedLobes> fit_polynomial_form(const brdf::Brdf& brdf, const FitChoices& choices,
                                        const fit::Objective& objective) {
  fit::PolynomialFitOptions options;
  options.degree = choices.degree;
  options.objective = objective;
  Result<fit::PolynomialFit> fitted = fit::fit_polynomial(brdf, options);
  if (!fitted) return fitted.error();
  FittedLobes result;
  result.stored = std::move(fitted->polynomial);
  result.note = fmt::format("certified: A D - w B C >= {:.2e} over the whole domain ({} boxes); no "
                            "lobe turns inside out",
                            fitted->certificate.lower_bound, fitted->certificate.boxes);
  return result;
}

Result<FittedLobes> fit_table_form(const brdf::Brdf& brdf, const FitChoices& choices,
                                   const fit::Objective& objective,
                                   const std::function<void(double)>& progress) {
  fit::TableFitOptions options;
  options.size = choices.size;
  options.refine = choices.refine;
  options.angle_axis = table::angle_axis_of(choices.layout);
  options.lobe.objective = objective;
  Result<table::LobeTable> fitted = fit::fit_table(brdf, options, progress);
  if (!fitted) return fitted.error();
  if (choices.layout != Layout::native && choices.clip_aware) divide_amplitudes(*fitted);
  Result<PackedTable> packed = table::pack(*fitted, choices.layout, choices.precision);
  if (!packed) return packed.error();
  FittedLobes result;
  result.stored = std::move(*packed);
  result.nodes = std::move(*fitted);
  return result;
}

} // namespace

table::TableMetadata& FittedLobes::metadata() {
  return std::visit([](auto& form) -> table::TableMetadata& { return form.metadata; }, stored);
}

fit::LobeFunction FittedLobes::lobes() const {
  return std::visit([](const auto& form) { return fit::lobes_of(form); }, stored);
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

Result<std::vector<std::string>> check_outputs(const brdf::Brdf& brdf, const FitChoices& choices,
                                               const std::vector<std::string>& paths) {
  std::vector<std::string> all;
  for (const std::string& path : paths) {
    std::vector<std::string> files = {path};
    if (choices.form == LobeForm::polynomial) {
      if (Status status = table::check_polynomial_extension(path); !status) return status.error();
    } else if (is_builtin_source(path)) {
      if (choices.layout != Layout::native || choices.precision != table::Precision::float32)
        return Error{path + ": C++ source of the built-in is for --layout native --precision "
                            "float32; .h holds any"};
    } else {
      if (Status status = table::check_packed_extension(path); !status) return status.error();
      files = table::packed_files(choices.layout, path);
    }
    if (is_builtin_source(path) && brdf.width != brdf::LobeWidth::alpha)
      return Error{fmt::format("{}: C++ source of the built-in is for lobes that narrow with "
                               "roughness, not for {}; .h holds any",
                               path, brdf.name)};
    for (const std::string& file : files)
      if (Status status = check_place(file); !status) return status.error();
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

Result<FittedLobes> fit_lobes(const brdf::Brdf& brdf, const FitChoices& choices,
                              const std::function<void(double)>& progress) {
  const Result<fit::Objective> found = fit::find_objective(choices.objective);
  if (!found) return found.error();
  fit::Objective objective = *found;
  if (choices.layout != Layout::native && !choices.clip_aware)
    objective.horizon = fit::Horizon::leaking;

  const auto begin = std::chrono::steady_clock::now();
  Result<FittedLobes> result = choices.form == LobeForm::polynomial
                                   ? fit_polynomial_form(brdf, choices, objective)
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
