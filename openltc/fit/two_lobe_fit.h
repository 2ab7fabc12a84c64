// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A table of two lobes at every node: one lobe cannot have GGX's sharp peak and its wide tail at
// once.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/lobe_table.h"

namespace openltc::fit {

/// Fits a table of two lobes, (1 - w) D1 + w D2, all nodes together through the bilinear look-up,
/// of which A B C D of both lobes and w are read. The first lobe comes from fit_table with the same
/// options, which gives n1 and n5 too. `options.refine` and `options.lobe.max_iterations` are those
/// of that table.
///
/// The result depends neither on the number of threads nor on the instruction set; coefficients are
/// rounded to six decimal digits. Both lobes keep a positive determinant, proven between the nodes
/// too (certify_determinants), and w lies in 0..1.
///
/// Fails with one line as fit_table does, when no lobes with positive determinants are found, and
/// when `progress` asks it to stop.
Result<table::LobeTable> fit_two_lobe_table(const brdf::Brdf& brdf, const TableFitOptions& options,
                                            const Progress& progress = {});

} // namespace openltc::fit
