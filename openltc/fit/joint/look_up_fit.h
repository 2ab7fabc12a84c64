// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Refinement of a table as its engine reads it.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/objective.h"
#include "openltc/table/layout.h"

namespace openltc::fit {

/// Moves the texels of the first texture together so that the lobes that the layout's look-up reads
/// between them, in single precision, fit best. Amplitudes stay, and so does the row of normal
/// incidence, whose lobes have no direction to turn to. Not for two lobes. Fails as
/// make_quadrature, and when progress asks to stop.
Status refine_look_up(const brdf::Brdf& brdf, table::PackedTable& packed,
                      const Objective& objective, const Progress& progress = {});

} // namespace openltc::fit
