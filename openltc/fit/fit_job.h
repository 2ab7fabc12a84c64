// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One fit from what is asked for to lobes, metadata and files: a table in the layout and precision
// in which it is read, or a polynomial.

#pragma once

#include "openltc/base/atomic_file.h"
#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/report/report.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/layout.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/shading_lobes.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace openltc::fit {

/// Nodes per axis of the built-in table of two lobes: more hardly lower the error of lobes, and
/// with fewer that of the albedo shows in a furnace (docs/fitting.md, decision 107).
inline constexpr int k_two_lobe_size = 32;

/// What is asked for. The defaults give the built-in table.
struct FitRequest {
  int size = 64;                      ///< nodes per axis of a table, 2..512; see k_two_lobe_size
  std::string objective = "balanced"; ///< as find_objective reads it
  table::LobeForm form = table::LobeForm::table;
  int degree = 4;                               ///< of a polynomial
  table::Layout layout = table::Layout::native; ///< of two lobes stored as native_two
  table::Precision precision = table::Precision::float32;
  /// Joint refinement through the look-up of the layout; automatic for native alone.
  Refine refine = Refine::automatic;
  /// Fit for a renderer that clips lights at the horizon, for layouts other than native, which is
  /// so anyway.
  bool clip_aware = false;
  std::string tool_version; ///< what the files say made them; may be empty
  std::string command;      ///< the command line that makes the same again; may be empty
};

/// What was fitted: a table as it is written, or a polynomial.
struct FittedLobes {
  std::variant<table::PackedTable, table::LobePolynomial> stored;
  std::optional<table::LobeTable> nodes; ///< of a table: what was fitted, before it was packed
  Horizon horizon = Horizon::clipped;
  Objective objective;
  double seconds = 0; ///< wall time of the fit alone
  std::string note;   ///< what else there is to say: a polynomial's certificate
  /// Where the layout's look-up reads lobes that are none; empty: nowhere.
  std::string warning;

  table::TableMetadata& metadata();
  const table::TableMetadata& metadata() const;
  /// As shading or an engine reads them, amplitudes as albedo; refers to this object.
  LobeFunction lobes() const;
};

/// Whether the extension of every path is one that lobes of this form are written with.
Status check_extensions(const FitRequest& request, const std::vector<std::string>& paths);

/// Whether every file, of an extension that is known, can be written in this form and layout.
/// Before the work. Gives the files that would be written, whose places are not looked at.
Result<std::vector<std::string>> check_outputs(const brdf::Brdf& brdf, const FitRequest& request,
                                               const std::vector<std::string>& paths);

/// Fits. The metadata lacks the error, which state_error adds. Fails as fit_table and
/// fit_polynomial, and when the layout or precision cannot hold the lobes.
Result<FittedLobes> fit_lobes(const brdf::Brdf& brdf, const FitRequest& request,
                              const Progress& progress = {});

/// What the files say of the error over the first region of a report.
void state_error(FittedLobes& fitted, const TableError& error);

/// What was fitted, as the subject of a report. Refers to `fitted`.
Candidate candidate_of(const FittedLobes& fitted, const FitRequest& request);

/// The best single lobe at every point by itself, as a candidate: what no table can be better than.
/// Refers to `fitted`, from whose lobes the search starts.
Candidate limit_of(const brdf::Brdf& brdf, const FittedLobes& fitted);

/// One line where engines that read this layout expect another size; otherwise empty.
std::string size_note(const table::PackedTable& packed);

/// One file, or those of a layout of several textures, in memory.
Result<std::vector<FileBytes>> lobes_bytes(const FittedLobes& fitted, const std::string& path);

/// Writes the files of lobes_bytes, all or none; returns their paths.
Result<std::vector<std::string>> write_lobes(const FittedLobes& fitted, const std::string& path);

} // namespace openltc::fit
