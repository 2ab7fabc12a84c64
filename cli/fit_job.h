// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One fit, from the choices on the command line to lobes, metadata and files.

#pragma once

#include "cli/lobe_file.h"
#include "openltc/base/progress.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/report.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/layout.h"
#include "openltc/table/lobe_polynomial.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace openltc::cli {

/// What is asked for. The defaults give the built-in table.
struct FitChoices {
  std::string brdf = "ggx"; ///< name, or path of a MERL file
  int size = 64;
  std::string objective = "balanced";
  LobeForm form = LobeForm::table;
  int degree = 4;
  table::Layout layout = table::Layout::native;
  table::Precision precision = table::Precision::float32;
  fit::Refine refine = fit::Refine::automatic;
  bool clip_aware = false; ///< for layouts other than native, which is so anyway
};

/// The command line that makes the same again: all choices that are not defaults.
std::string command_of(const FitChoices& choices);

/// What was fitted: a table as it is written, or a polynomial.
struct FittedLobes {
  std::variant<table::PackedTable, table::LobePolynomial> stored;
  std::optional<table::LobeTable> nodes; ///< of a table: what was fitted, before it was packed
  fit::Horizon horizon = fit::Horizon::clipped;
  fit::Objective objective;
  double seconds = 0; ///< wall time of the fit alone
  std::string note;   ///< what else there is to say: a polynomial's certificate
  /// Where the layout's look-up reads lobes that are none; empty: nowhere.
  std::string warning;

  table::TableMetadata& metadata();
  /// As shading or an engine reads them, amplitudes as albedo; refers to this object.
  fit::LobeFunction lobes() const;
};

/// A path as one word of a shell's command line, in quotes where it needs them.
std::string shell_word(const std::string& path);

/// Whether the extension of every path is one that lobes of this form are written with.
Status check_extensions(const FitChoices& choices, const std::vector<std::string>& paths);

/// Whether every file, of an extension that is known, can be written in this form and layout.
/// Before the work. Gives the files that would be written, whose places are not looked at.
Result<std::vector<std::string>> check_outputs(const brdf::Brdf& brdf, const FitChoices& choices,
                                               const std::vector<std::string>& paths);

/// Fits. The metadata lacks the error, which state_error adds.
Result<FittedLobes> fit_lobes(const brdf::Brdf& brdf, const FitChoices& choices,
                              const Progress& progress);

/// What the files say of the error over the first region of a report.
void state_error(FittedLobes& fitted, const fit::TableError& error);

/// One line where engines that read this layout expect another size; otherwise empty.
std::string size_note(const table::PackedTable& packed);

/// Writes one file, or the two of a layout with two textures; returns their paths.
Result<std::vector<std::string>> write_lobes(const FittedLobes& fitted, const std::string& path);

} // namespace openltc::cli
