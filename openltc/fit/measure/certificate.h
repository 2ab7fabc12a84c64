// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Proof that a polynomial's lobes never turn inside out.

#pragma once

#include "openltc/table/lobe_polynomial.h"

namespace openltc::fit {

/// A proven bound of a polynomial from below.
struct Certificate {
  /// A D - w B C, w the lobe's width, is at least this over the whole domain, roughness 0.01..1
  /// (k_min_alpha) and theta 0..90 degrees. Positive: every lobe is proper.
  double lower_bound = 0;
  double smallest_seen = 0; ///< an upper bound of the minimum: the value at some corner of a box
  int boxes = 0;            ///< looked at
};

/// Bounds the determinant of the stored, rounded coefficients by Bernstein's form on a subdivided
/// domain. The bound allows for the rounding of double precision on the way and stops being
/// sharpened when it is positive and within a tenth of smallest_seen, or after max_boxes.
Certificate certify_determinant(const table::LobePolynomial& polynomial, int max_boxes = 20000);

} // namespace openltc::fit
