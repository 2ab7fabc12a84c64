// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#pragma once

#include "openltc/draw/figure.h"

namespace openltc::plot {

/// Six panels: what the source document's formulas give when they are taken literally, beside the
/// corrected ones. The numbers are those of literal_formulas.h and of the built-in table.
draw::Figure make_literal_figure();

} // namespace openltc::plot
