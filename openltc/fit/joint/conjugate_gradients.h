// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Conjugate gradients (Hestenes, Stiefel 1952), preconditioned, for normal equations of many small
// vectors that are never formed. Internal to fit.

#pragma once

#include <cstddef>

namespace openltc::fit {

/// Sum of the products of two lists of vectors, in order.
template <class Vectors> double dot(const Vectors& a, const Vectors& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].dot(b[i]);
  return sum;
}

/// x with A x = residual, nearly: ends after `most` steps or where the residual's square in the
/// preconditioner's norm falls below `stop` of what it was. `precondition(r, z)` writes M^-1 r to
/// z, `multiply(p, hp)` A p to hp.
template <class Vectors, class Precondition, class Multiply>
Vectors conjugate_gradients(Vectors residual, double stop, int most,
                            const Precondition& precondition, const Multiply& multiply) {
  const std::size_t count = residual.size();
  Vectors z = residual, hp = residual, x = residual;
  for (auto& value : x)
    value.setZero();
  precondition(residual, z);
  Vectors p = z;
  double rz = dot(residual, z);
  stop *= rz;
  for (int k = 0; k < most && rz > stop; ++k) {
    multiply(p, hp);
    const double curvature = dot(p, hp);
    if (!(curvature > 0)) break;
    const double step = rz / curvature;
    for (std::size_t i = 0; i < count; ++i) {
      x[i] += step * p[i];
      residual[i] -= step * hp[i];
    }
    precondition(residual, z);
    const double next = dot(residual, z);
    for (std::size_t i = 0; i < count; ++i)
      p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  return x;
}

} // namespace openltc::fit
