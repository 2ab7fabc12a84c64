// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A whole table: one fit per node, each started from its neighbour, then all of them together.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/lobe_fit.h"
#include "openltc/fit/measure/error.h"
#include "openltc/table/lobe_table.h"

#include <optional>

namespace openltc::fit {

/// Whether the nodes are fitted once more, jointly, through the bilinear look-up.
enum class Refine {
  automatic, ///< where it pays: up to k_refined_size nodes per axis, or one column
  on,
  off
};
inline constexpr int k_refined_size = 32;

/// How a table is fitted.
struct TableFitOptions {
  int size = 64; ///< nodes per axis, 2..512; a BRDF without a parameter gets one column
  table::AngleAxis angle_axis = table::AngleAxis::sqrt_one_minus_cos;
  Refine refine = Refine::automatic;
  std::optional<QuadratureSize> quadrature; ///< choose_quadrature's, if not given
  LobeFitOptions lobe;
};

/// Where the nodes of the grazing row, cos theta = 0, are fitted. At the limit itself the BRDF has
/// no lobe, and what is stored serves to be read between cos = 0 and the row before it; these
/// cosines were chosen for the least mean error there. See table_fit.cpp.
struct GrazingRow {
  double lobe_cosine;
  double amplitude_cosine;
};
GrazingRow grazing_row(int rows, table::AngleAxis axis);

/// The cosine of the view angle at a position 0..1 of an axis.
double cosine_at(double position, table::AngleAxis axis);

/// Fits a table. The result depends neither on the number of threads nor on the instruction set;
/// every coefficient is rounded to six decimal digits, so that it hardly depends on the last
/// bits of a maths library either. complete_metadata completes what it says about itself.
///
/// Fails with one line when the BRDF is not finite, negative or without energy, and when no lobe
/// between the nodes could be kept from turning inside out; or when `progress` asks it to stop,
/// which is noticed between rows and between the steps of a refinement.
Result<table::LobeTable> fit_table(const brdf::Brdf& brdf, const TableFitOptions& options,
                                   const Progress& progress = {});

/// Fills in what a table or polynomial says about itself: its errors rounded to four digits, the
/// version of the tool, and the command that makes the same again.
void complete_metadata(table::TableMetadata& metadata, const TableError& error,
                       const char* tool_version, const std::string& command);

} // namespace openltc::fit
