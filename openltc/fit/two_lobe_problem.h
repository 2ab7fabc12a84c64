// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the joint fit of two lobes minimises: the objective at all samples of a table, as the
// look-up interpolates it, with penalties for lobes that turn inside out and a prior on second
// differences; the objective at a sample serves polynomials too. Private to two_lobe_fit.cpp and
// two_lobe_polynomial.cpp.

#pragma once

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/table_samples.h"
#include "openltc/fit/two_lobe_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace openltc::fit::two_lobe {

inline constexpr int k_unknowns = 9;
inline constexpr int k_logit = 8;
using Vector = Eigen::Matrix<double, k_unknowns, 1>;
using Matrix = Eigen::Matrix<double, k_unknowns, k_unknowns>;
using Vectors = std::vector<Vector>;

/// How much the second differences of A B C D, A2 B2 C2 D2 and the logit count: about as one over
/// their sizes.
inline constexpr double k_smoothness[k_unknowns] = {1, 1, 0.3, 1, 1, 0.5, 0.3, 1, 0.15};

/// Least second derivative that damping takes: where a lobe hardly depends on an unknown, as on B
/// and C near the mirror, steps would have no end.
inline constexpr double k_flat = 0.1;

/// What A and D of both lobes are kept above: on the rim of the table, theta = 90 degrees, they
/// tend to 0 with the roughness, and a penalty of their product alone is a wall at which steps end.
/// Lobes of width one have nothing of the kind, and D may be negative.
inline constexpr double k_least_element = 3e-3;
constexpr bool is_kept_above(int k) { return k < k_logit && (k % 4 == 0 || k % 4 == 3); }
/// And A D - w B C.
inline constexpr double k_least_product = 0.5 * k_least_element * k_least_element;

inline Vector within_bounds(Vector x, bool bounded) {
  for (int k = 0; k < k_logit; ++k)
    if (bounded && is_kept_above(k)) x[k] = std::max(x[k], k_least_element);
  return x;
}

inline double weight_of(double logit) { return 1 / (1 + std::exp(-logit)); }

// The nodes of one table and where it is compared.
struct Problem {
  TableShape shape;
  std::vector<JointSample> samples;
  std::vector<std::vector<std::pair<int, double>>> samples_of_node; // sample, factor
  double total_weight = 0;
  double least = k_least_product; ///< of determinants, by a penalty
  bool bounded = true;            ///< whether A and D are kept above k_least_element

  std::size_t count() const { return std::size_t(shape.columns) * std::size_t(shape.rows); }
};

struct Local {
  double value = 0;
  Vector gradient;
  Matrix hessian;
};

// Runs body over [0, count) in pieces.
template <class Body> void in_pieces(std::size_t count, const Body& body) {
  constexpr std::size_t k_piece = 64;
  parallel_for(std::int64_t((count + k_piece - 1) / k_piece), 0, [&](std::int64_t piece) {
    const std::size_t from = std::size_t(piece) * k_piece, to = std::min(from + k_piece, count);
    for (std::size_t i = from; i < to; ++i)
      body(i);
  });
}

// What the look-up interpolates: the unknowns with the weight in place of its logit.
inline Vectors stored(const Vectors& unknowns) {
  Vectors result = unknowns;
  for (Vector& x : result)
    x[k_logit] = weight_of(x[k_logit]);
  return result;
}

inline Vector interpolate(const JointSample& sample, const Vectors& nodes) {
  Vector x = Vector::Zero();
  for (const JointTerm& term : sample.terms)
    x += term.factor * nodes[std::size_t(term.unknown)];
  return x;
}

// A quadratic penalty where the determinant of one of the lobes lacks `least`, relative to it.
inline void add_penalty(const JointSample& sample, const Vector& x, int first, double least,
                        Local& local) {
  const double width = sample.rule.width;
  const double determinant = x[first] * x[first + 3] - width * x[first + 1] * x[first + 2];
  if (!(determinant < least)) return;
  const double missing = 1 - determinant / least;
  const Eigen::Vector4d slope =
      Eigen::Vector4d(-x[first + 3], width * x[first + 2], width * x[first + 1], -x[first]) / least;
  local.value += missing * missing;
  local.gradient.segment<4>(first) += 2 * missing * slope;
  local.hessian.block<4, 4>(first, first) += 2 * slope * slope.transpose();
}

// Of the penalties `least` is what determinants are kept above.
inline void evaluate_local(const JointSample& sample, const Vector& x, const Objective& objective,
                           double least, bool with_derivatives, Local& local) {
  TwoLobes lobes;
  for (std::size_t k = 0; k < k_unknowns; ++k)
    lobes[k] = x[Eigen::Index(k)];
  const TwoLobeObjectiveValue at =
      evaluate_objective(sample.rule, lobes, objective, with_derivatives);
  local.value = sample.weight * at.value;
  std::size_t entry = 0;
  for (int i = 0; i < k_unknowns; ++i) {
    local.gradient[i] = sample.weight * at.gradient[std::size_t(i)];
    for (int j = i; j < k_unknowns; ++j, ++entry)
      local.hessian(i, j) = local.hessian(j, i) = sample.weight * at.hessian[entry];
  }
  add_penalty(sample, x, 0, least, local);
  add_penalty(sample, x, 4, least, local);
}

// Calls body(before, at, after) for every three neighbours in a row or column.
template <class Body> void for_neighbours(const TableShape& shape, const Body& body) {
  const int columns = shape.columns, rows = shape.rows;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const std::size_t at = std::size_t(row) * std::size_t(columns) + std::size_t(column);
      if (column > 0 && column + 1 < columns) body(at - 1, at, at + 1);
      if (row > 0 && row + 1 < rows) body(at - std::size_t(columns), at, at + std::size_t(columns));
    }
}

// The prior's weight per second difference: those of a smooth function fall with the square of the
// distance between nodes, and their sum of squares with that distance.
inline Vector prior_weights(const Problem& problem, double prior) {
  const TableShape& shape = problem.shape;
  const double scale = prior * problem.total_weight * (shape.rows - 1) * (shape.rows - 1) /
                       (double(shape.columns) * shape.rows);
  Vector weights;
  for (int k = 0; k < k_unknowns; ++k)
    weights[k] = scale * k_smoothness[k] * k_smoothness[k];
  return weights;
}

inline double evaluate_all(const Problem& problem, const Vectors& unknowns,
                           const Objective& objective, const Vector& prior, bool with_derivatives,
                           std::vector<Local>& locals) {
  const Vectors nodes = stored(unknowns);
  in_pieces(problem.samples.size(), [&](std::size_t s) {
    const JointSample& sample = problem.samples[s];
    evaluate_local(sample, interpolate(sample, nodes), objective, problem.least, with_derivatives,
                   locals[s]);
  });
  double sum = 0;
  for (const Local& local : locals)
    sum += local.value;
  for_neighbours(problem.shape, [&](std::size_t a, std::size_t b, std::size_t c) {
    const Vector bend = unknowns[a] - 2 * unknowns[b] + unknowns[c];
    sum += bend.cwiseProduct(prior).dot(bend);
  });
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

} // namespace openltc::fit::two_lobe
