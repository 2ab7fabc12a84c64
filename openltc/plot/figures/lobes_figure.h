// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figure of lobes: what matrices make of a clamped cosine. After figure 1 of Heitz, Dupuy,
// Hill, Neubelt 2016 and of the project's source document.

#pragma once

#include "openltc/base/result.h"
#include "openltc/draw/figure.h"
#include "openltc/plot/lobe_rows.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct LobesOptions {
  /// Rows of one to k_most_swept lobes each; none = the four standard rows.
  std::vector<LobeRow> rows;
  std::string command = "openltc plot lobes"; ///< for the caption
};

inline constexpr std::size_t k_most_rows = 26;  ///< (a) to (z)
inline constexpr std::size_t k_most_lobes = 64; ///< in all rows together

/// Draws each lobe twice, as a sphere of directions and as a solid, relative to its own peak, with
/// det M, the peak and the integral of D, by quadrature, below. Fails for a row without lobes, for
/// too many of either, for a matrix that makes no lobe, and when an integral is not 1 to six
/// digits.
Result<draw::Figure> make_lobes_figure(const LobesOptions& options);

} // namespace openltc::plot
