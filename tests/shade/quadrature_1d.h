// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Adaptive quadrature in one dimension: the Gauss-Kronrod pair of 7 and 15 points (Kronrod 1965;
// points as in QUADPACK, Piessens et al. 1983), halving intervals until the two rules agree.

#pragma once

#include "openltc/target/vec.h"

#include <cmath>

namespace openltc::testing {

inline double size_of(double x) { return std::abs(x); }
inline double size_of(Vec3d v) { return length(v); }

/// Integral of f, a double or a Vec3d, over [from, to]; `tolerance` is absolute.
template <class F>
auto integrate_adaptive(const F& f, double from, double to, double tolerance, int depth = 24)
    -> decltype(f(from)) {
  constexpr double point[8] = {0,
                               0.207784955007898467600689403773245,
                               0.405845151377397166906606412076961,
                               0.586087235467691130294144691693013,
                               0.741531185599394439863864773280788,
                               0.864864423359769072789712788640926,
                               0.949107912342758524526189684047851,
                               0.991455371120812639206854697526329};
  constexpr double kronrod[8] = {
      0.209482141084727828012999174891714, 0.204432940075298892414161999234649,
      0.190350578064785409913256402421014, 0.169004726639267902826583426598550,
      0.140653259715525918745189590510238, 0.104790010322250183839876322541518,
      0.063092092629978553290700663189204, 0.022935322010529224963732008058970};
  constexpr double gauss[4] = {
      0.417959183673469387755102040816327, 0.381830050505118944950369775488975,
      0.279705391489276667901467771423780, 0.129484966168869693270611432679082};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  auto sum = f(middle) * kronrod[0];
  auto coarse = f(middle) * gauss[0];
  for (int i = 1; i < 8; ++i) {
    const auto pair = f(middle - half * point[i]) + f(middle + half * point[i]);
    sum = sum + pair * kronrod[i];
    if (i % 2 == 0) coarse = coarse + pair * gauss[i / 2];
  }
  sum = sum * half;
  coarse = coarse * half;
  if (depth == 0 || !(size_of(sum - coarse) > tolerance)) return sum;
  return integrate_adaptive(f, from, middle, tolerance * 0.6, depth - 1) +
         integrate_adaptive(f, middle, to, tolerance * 0.6, depth - 1);
}

} // namespace openltc::testing
