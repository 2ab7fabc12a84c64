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
  /// (k_min_alpha) and theta 0..90 degrees, of both lobes where there are two. Positive: every lobe
  /// is proper.
  double lower_bound = 0;
  double smallest_seen = 0; ///< an upper bound of the minimum: the value at some corner of a box
  int boxes = 0;            ///< looked at
};

/// Bounds the determinant of the stored, rounded coefficients by Bernstein's form on a subdivided
/// domain. The bound allows for the rounding of double precision on the way and stops being
/// sharpened when it is positive and within a tenth of smallest_seen, or after max_boxes.
Certificate certify_determinant(const table::LobePolynomial& polynomial, int max_boxes = 20000);

/// A proven bound of a table's determinants from below.
struct TableCertificate {
  /// A D - w B C of every lobe is at least this wherever the look-up reads it: roughness 0..1,
  /// theta 0..90 degrees. Positive: every lobe is proper.
  double lower_bound = 0;
  double roughness = 0; ///< where it is least
};

/// Bounds the determinants of what the bilinear look-up gives, of both lobes where there are two,
/// cell by cell: a polynomial of degree 4 in roughness and 2 in the angle's axis, in Bernstein's
/// form, halved until it is positive, at most `max_halvings` times. The bound allows for the
/// rounding of single precision in the look-up.
TableCertificate certify_determinants(const table::LobeTable& table, int max_halvings = 12);

} // namespace openltc::fit
