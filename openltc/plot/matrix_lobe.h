// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A lobe from the four numbers of its matrix M, and what a figure says about it.

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/shade_f64.h"

#include <span>
#include <string>

namespace openltc::plot {

/// M = [[a, 0, b], [0, c, 0], [d, 0, 1]], from cosine space to shading space.
struct LobeMatrix {
  double a = 1, b = 0, c = 1, d = 0;
};

/// c (a - b d).
double determinant(const LobeMatrix& m);

/// Columns of M: where it takes the axes x, y, z of cosine space. `axis` 0..2.
Vec3d column(const LobeMatrix& m, int axis);

/// Whether M makes a lobe: finite, c > 0, a > b d, and not so close to singular that double
/// precision loses it. The error begins with `name`, e.g. "--matrix 1,0,1,0", and says what is
/// needed.
Status check_matrix(const LobeMatrix& m, const std::string& name);

/// The lobe of a matrix that check_matrix accepts.
f64::Lobe lobe_of_matrix(const LobeMatrix& m);

/// Its inverse: M scaled so that its last element is 1. Fails for a lobe whose M has a last element
/// of 0 or less, which cannot be scaled so.
Result<LobeMatrix> matrix_of_lobe(const f64::Lobe& lobe);

/// What a figure prints of a lobe.
struct LobeFacts {
  double peak = 0;               ///< largest density, 1/steradian
  Vec3d peak_direction{0, 0, 1}; ///< shading space, unit; one of two where the lobe has two
  double integral = 0;           ///< of D over the sphere, by quadrature in shading space: 1
  Vec3d mean_direction{0, 0, 1}; ///< integral of w D, normalised, by the same quadrature
  double above = 1;              ///< share above the surface's horizon, closed form
};

/// The quadrature's error: below 1e-8 for matrices of entries 0.01..10 (tests/plot).
LobeFacts lobe_facts(const f64::Lobe& lobe);

} // namespace openltc::plot
