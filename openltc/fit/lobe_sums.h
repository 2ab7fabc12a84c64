// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The inner loop of every fit: sums over the points of a quadrature. Internal to fit.
//
// Compiled once per instruction set from lobe_sums_variant.cpp. Eight points at a time, whatever
// the width of the machine's registers, without fused operations: every addition happens in the
// same order and rounds the same way, so the bits of a fit do not depend on the machine.

#pragma once

#include <cstddef>
#include <vector>

namespace openltc::fit {

/// The points, eight at a time, and the constants of one evaluation.
struct LobeSumsInput {
  const double* x = nullptr; ///< Quadrature::x_mirror, and so on
  const double* y = nullptr;
  const double* z = nullptr;
  const double* weight = nullptr;
  const double* density = nullptr;
  std::size_t count = 0; ///< a multiple of 8

  double m[4];         ///< o.x = m0 x + m1 z, o.z = m2 x + m3 z: (A, wB, wC, wD), w the width
  double det = 0;      ///< det M^-1 times the scale s, over pi
  double log_slope[4]; ///< derivative of log(det s) by m[k]
  double rounding = 0; ///< of |r| at 0: e = rounding p + floor
  double floor = 0;
  // Weights of the squares' sums, for the derivatives: of (|r| - r)/2, r^2 and |r|^3.
  double tv = 0;
  double squares = 0;
  double cubes = 0;
};

/// Sums over the points, weights included, of (|r| - r)/2, |r| rounded, of r^2 and of |r|^3.
struct LobeDistances {
  double missing;
  double squares;
  double cubes;
};

/// Gradient by m[k] of the weighted sum, and the reweighted squares' matrix, upper triangle by
/// rows.
struct LobeDerivatives {
  double gradient[4];
  double hessian[10];
};

/// The points and the constants of two lobes, whose weighted sum is the density.
struct TwoLobeSumsInput {
  LobeSumsInput points; ///< its lobe apart: points, rounding, floor and the weights of the sums
  struct Part {
    double m[4];         ///< as in LobeSumsInput
    double det = 0;      ///< without the weight
    double log_slope[4]; ///< derivative of log(det) by m[k]
    double weight = 0;   ///< of this lobe, 0..1
  } parts[2];
};

/// The unknowns of two lobes: m of the first, m of the second, the weight of the second, that of
/// the first being the rest.
inline constexpr int k_two_lobe_unknowns = 9;

/// Gradient by them of the weighted sum, and the reweighted squares' matrix, upper triangle by
/// rows.
struct TwoLobeDerivatives {
  double gradient[k_two_lobe_unknowns];
  double hessian[k_two_lobe_unknowns * (k_two_lobe_unknowns + 1) / 2];
};

/// The sums, for one instruction set.
struct LobeSums {
  void (*distances)(const LobeSumsInput& input, LobeDistances& output);
  void (*derivatives)(const LobeSumsInput& input, LobeDerivatives& output);
  void (*two_distances)(const TwoLobeSumsInput& input, LobeDistances& output);
  void (*two_derivatives)(const TwoLobeSumsInput& input, TwoLobeDerivatives& output);
};

/// The variant for this machine.
LobeSums lobe_sums();

/// All that this machine can run.
std::vector<LobeSums> all_lobe_sums();

} // namespace openltc::fit
