// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Which lobes the figure of lobes shows: rows of matrices, by name, by numbers, by a sweep of one
// number, or fitted to a BRDF.

#pragma once

#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/plot/matrix_lobe.h"

#include <span>
#include <string>
#include <vector>

namespace openltc::plot {

/// One lobe and what is printed below it.
struct LobeCell {
  LobeMatrix matrix;
  std::string caption; ///< the parameters that tell it from its neighbours
  std::string note;    ///< a second line; may be empty
};

struct LobeRow {
  std::string title; ///< e.g. "roughness"
  std::string note;  ///< what its lobes have in common
  std::vector<LobeCell> cells;
};

/// The rows of figure 1 of the source document (docs/source_document.md).
enum class StandardRow { cosine, roughness, anisotropy, skew };

LobeRow standard_row(StandardRow row);

/// "a,b,c,d". The error names the option.
Result<LobeMatrix> parse_matrix(const std::string& text);

/// One of a b c d, from one value to another in equal steps.
struct LobeSweep {
  char name = 'a';
  double from = 1, to = 0.1;
  int count = 4;
};
inline constexpr int k_most_swept = 16;

/// "NAME=FROM:TO:COUNT", e.g. "c=0.6:0.1:4", of 2 to k_most_swept lobes. The error names the
/// option.
Result<LobeSweep> parse_sweep(const std::string& text);

/// The matrices given, each checked.
Result<LobeRow> matrix_row(std::span<const LobeMatrix> matrices);

/// `base` with one number swept. The error names the option and the value at which there is no
/// lobe.
Result<LobeRow> sweep_row(const LobeMatrix& base, const LobeSweep& sweep);

/// The lobes that shading uses for a BRDF, of the built-in table for GGX, of one fitted on the spot
/// for others: a row for each roughness 0..1, one for a BRDF without, and in it every view angle in
/// degrees, 0..90. At roughness and angles where the lobe is too narrow for a picture, or for a
/// BRDF that cannot be fitted, an error.
Result<std::vector<LobeRow>> fitted_rows(const brdf::Brdf& brdf,
                                         std::span<const double> theta_degrees,
                                         std::span<const double> roughness);

/// The same for a single lobe.
Result<f64::Lobe> fitted_lobe(const brdf::Brdf& brdf, double theta_degrees, double roughness);

/// "θ = 60°, roughness 0.5", without roughness for a BRDF that has none.
std::string view_text(const brdf::Brdf& brdf, double theta_degrees, double roughness);

/// "a = 1, b = 0, c = 1, d = 0".
std::string entries_text(const LobeMatrix& matrix);

/// "a,b,c,d" as short as can be read back.
std::string text_of(const LobeMatrix& matrix);

/// A number for people: four digits at most, a true minus sign.
std::string number_text(double x);

} // namespace openltc::plot
