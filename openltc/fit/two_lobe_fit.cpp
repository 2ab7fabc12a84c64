// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Two lobes at one point may change places, and where a fit of each node by itself lets them, their
// coefficients do not interpolate. So all nodes are fitted together, as joint_fit.cpp does, from
// lobes that hang together: the table of one lobe and beside it a wider lobe that is tilted more at
// grazing views. A prior on the second differences of the unknowns, lowered step by step, keeps
// them together on the way; the weight's unknown is its logit, so that it stays within 0 and 1.
//
// Gauss-Newton with Marquardt's damping, the normal equations by conjugate gradients. A table of
// many nodes starts from one of few.

#include "openltc/fit/two_lobe_fit.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/conjugate_gradients.h"
#include "openltc/fit/joint/table_samples.h"
#include "openltc/fit/measure/certificate.h"
#include "openltc/fit/two_lobe_problem.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace openltc::fit::two_lobe {

namespace {

using table::LobeTable;

struct Stage {
  bool balanced; ///< before the objective that is asked for
  double prior;
  int most_steps;
  double tolerance; ///< relative decrease of the objective in one step at which it ends
};

// The normal equations of a step at one place: the Gauss-Newton matrix H and minus the gradient.
class NormalEquations {
public:
  NormalEquations(const Problem& p, const Vectors& unknowns, const std::vector<Local>& l,
                  const Vector& prior)
      : problem(p), locals(l), prior_weight(2 * prior), slopes(unknowns.size(), Vector::Ones()),
        fixed(unknowns.size(), Vector::Ones()), residual(unknowns.size(), Vector::Zero()),
        blocks(unknowns.size(), Matrix::Zero()), at_samples(p.samples.size()) {
    // Chain rule from the weight to its logit.
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const double w = weight_of(unknowns[i][k_logit]);
      slopes[i][k_logit] = w * (1 - w);
    }
    in_pieces(unknowns.size(), [&](std::size_t i) {
      for (const auto& [s, factor] : problem.samples_of_node[i]) {
        residual[i] -= factor * locals[std::size_t(s)].gradient;
        blocks[i] += factor * factor * locals[std::size_t(s)].hessian;
      }
      residual[i] = residual[i].cwiseProduct(slopes[i]).eval();
      blocks[i] = (slopes[i].asDiagonal() * blocks[i] * slopes[i].asDiagonal()).eval();
    });
    for_neighbours(problem.shape, [&](std::size_t a, std::size_t b, std::size_t c) {
      const Vector pull = prior_weight.cwiseProduct(unknowns[a] - 2 * unknowns[b] + unknowns[c]);
      residual[a] -= pull;
      residual[b] += 2 * pull;
      residual[c] -= pull;
      blocks[a].diagonal() += prior_weight;
      blocks[b].diagonal() += 4 * prior_weight;
      blocks[c].diagonal() += prior_weight;
    });
    // What would leave its bound stays.
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      for (int k = 0; k < k_logit; ++k) {
        if (!p.bounded || !is_kept_above(k) || unknowns[i][k] > k_least_element ||
            residual[i][k] >= 0)
          continue;
        fixed[i][k] = 0;
        residual[i][k] = 0;
        blocks[i].row(k).setZero();
        blocks[i].col(k).setZero();
        blocks[i](k, k) = 1;
      }
  }

  // (H + damping diag) x = -gradient, to `accuracy` of the residual.
  Vectors solve(double damping, double accuracy) {
    const std::size_t count = residual.size();
    Vectors diagonal(count);
    std::vector<Eigen::LDLT<Matrix>> inverse(count);
    in_pieces(count, [&](std::size_t i) {
      diagonal[i] = damping * blocks[i].diagonal();
      for (int k = 0; k < k_unknowns; ++k)
        diagonal[i][k] += damping * k_flat * k_smoothness[k] * k_smoothness[k];
      Matrix damped = blocks[i];
      damped.diagonal() += diagonal[i];
      damped.diagonal().array() += 1e-12 * damped.trace() + 1e-300;
      inverse[i].compute(damped);
    });
    const auto precondition = [&](const Vectors& r, Vectors& z) {
      in_pieces(count, [&](std::size_t i) { z[i] = inverse[i].solve(r[i]); });
    };
    return conjugate_gradients(residual, accuracy * accuracy, 400, precondition,
                               [&](const Vectors& p, Vectors& hp) { multiply(p, diagonal, hp); });
  }

private:
  // hp = (H + diagonal) p. Samples first, then nodes: each writes its own.
  void multiply(const Vectors& p, const Vectors& diagonal, Vectors& hp) {
    Vectors& scaled = scaled_unknowns;
    scaled.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      scaled[i] = p[i].cwiseProduct(slopes[i]);
      hp[i] = diagonal[i].cwiseProduct(p[i]);
    }
    in_pieces(problem.samples.size(), [&](std::size_t s) {
      at_samples[s].noalias() = locals[s].hessian * interpolate(problem.samples[s], scaled);
    });
    for_neighbours(problem.shape, [&](std::size_t a, std::size_t b, std::size_t c) {
      const Vector pull = prior_weight.cwiseProduct(p[a] - 2 * p[b] + p[c]);
      hp[a] += pull;
      hp[b] -= 2 * pull;
      hp[c] += pull;
    });
    in_pieces(p.size(), [&](std::size_t i) {
      Vector sum = Vector::Zero();
      for (const auto& [s, factor] : problem.samples_of_node[i])
        sum += factor * at_samples[std::size_t(s)];
      hp[i] = (hp[i] + sum.cwiseProduct(slopes[i])).cwiseProduct(fixed[i]);
    });
  }

  const Problem& problem;
  const std::vector<Local>& locals;
  Vector prior_weight;
  Vectors slopes, fixed, residual; // fixed: 0 where an unknown stays, else 1
  std::vector<Matrix> blocks;
  Vectors at_samples, scaled_unknowns;
};

// One stage from where the unknowns are; false when the progress asks to stop.
bool run_stage(const Problem& problem, const Objective& objective, const Stage& stage,
               const Progress& progress, Vectors& unknowns) {
  const Vector prior = prior_weights(problem, stage.prior);
  std::vector<Local> locals(problem.samples.size()), trial_locals(problem.samples.size());
  double value = evaluate_all(problem, unknowns, objective, prior, true, locals);
  double damping = 1e-2;
  for (int step = 0; step < stage.most_steps && damping < 1e6; ++step) {
    if (progress && !progress(double(step) / stage.most_steps)) return false;
    NormalEquations equations(problem, unknowns, locals, prior);
    bool moved = false, done = false;
    while (!moved && damping < 1e6) {
      Vectors trial = equations.solve(damping, 0.01);
      for (std::size_t i = 0; i < trial.size(); ++i)
        trial[i] = within_bounds(unknowns[i] + trial[i], problem.bounded);
      const double there = evaluate_all(problem, trial, objective, prior, true, trial_locals);
      if (there < value) {
        done = value - there < stage.tolerance * value;
        unknowns.swap(trial);
        locals.swap(trial_locals);
        value = there;
        damping = std::max(damping * 0.3, 1e-6);
        moved = true;
      } else {
        damping *= 6;
      }
    }
    if (done) break;
  }
  return true;
}

Result<Problem> make_problem(const brdf::Brdf& brdf, TableShape shape, table::AngleAxis axis,
                             QuadratureSize quadrature) {
  Result<std::vector<JointSample>> samples = make_table_samples(brdf, shape, axis, quadrature);
  if (!samples) return samples.error();
  Problem problem;
  problem.shape = shape;
  problem.samples = std::move(*samples);
  problem.bounded = brdf.width == brdf::LobeWidth::alpha;
  problem.samples_of_node.resize(problem.count());
  for (std::size_t s = 0; s < problem.samples.size(); ++s) {
    problem.total_weight += problem.samples[s].weight;
    for (const JointTerm& term : problem.samples[s].terms)
      problem.samples_of_node[std::size_t(term.unknown)].emplace_back(int(s), term.factor);
  }
  return problem;
}

// The first lobe of a table narrower, and beside it one that is wider and tilted more.
Vectors start_from(const LobeTable& one) {
  Vectors unknowns;
  for (int row = 0; row < one.rows; ++row) {
    const double v = std::sqrt(1 - cosine_at(double(row) / (one.rows - 1), one.angle_axis));
    for (int column = 0; column < one.columns; ++column) {
      const float* t = one.texel(column, row);
      const double a = double(t[0]), b = double(t[1]), c = double(t[2]), d = double(t[3]);
      Vector x;
      x << 0.95 * a, 0.5 * b, 0.7 * c, 0.95 * d, 1.2 * a + 0.05, b - 0.6 * v, c + 1.5 * v, 1.3 * d,
          -1;
      unknowns.push_back(within_bounds(x, one.width == brdf::LobeWidth::alpha));
    }
  }
  return unknowns;
}

// Values at other nodes, bilinear.
Vectors between_nodes(const Vectors& from, TableShape coarse, TableShape fine) {
  Vectors result;
  for (int row = 0; row < fine.rows; ++row)
    for (int column = 0; column < fine.columns; ++column) {
      const double x = fine.columns > 1 && coarse.columns > 1
                           ? double(column) * (coarse.columns - 1) / (fine.columns - 1)
                           : 0;
      const double y = double(row) * (coarse.rows - 1) / (fine.rows - 1);
      const int x0 = std::min(int(x), std::max(coarse.columns - 2, 0));
      const int y0 = std::min(int(y), coarse.rows - 2);
      const int x1 = std::min(x0 + 1, coarse.columns - 1);
      const auto at = [&](int i, int j) {
        return from[std::size_t(j) * std::size_t(coarse.columns) + std::size_t(i)];
      };
      const double fx = x - x0, fy = y - y0;
      result.push_back((1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) +
                       fy * ((1 - fx) * at(x0, y0 + 1) + fx * at(x1, y0 + 1)));
    }
  return result;
}

void store(const Vectors& unknowns, LobeTable& table) {
  table.second.clear();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    float* texel = table.texels.data() + i * LobeTable::k_channels;
    for (int k = 0; k < 4; ++k) {
      texel[k] = round_to_six_digits(unknowns[i][k]);
      table.second.push_back(round_to_six_digits(unknowns[i][4 + k]));
    }
    texel[6] = round_to_six_digits(weight_of(unknowns[i][k_logit]));
  }
}

/// Nodes per axis with which larger tables begin.
constexpr int k_coarse_size = 16;

} // namespace

} // namespace openltc::fit::two_lobe

namespace openltc::fit {

Result<table::LobeTable> fit_two_lobe_table(const brdf::Brdf& brdf, const TableFitOptions& options,
                                            const Progress& progress) {
  using namespace two_lobe;
  Result<LobeTable> one = fit_table(brdf, options, part_of(progress, 0.0, 0.1));
  if (!one) return one.error();
  Result<QuadratureSize> quadrature =
      options.quadrature ? Result<QuadratureSize>(*options.quadrature) : choose_quadrature(brdf);
  if (!quadrature) return quadrature.error();

  const Objective& objective = options.lobe.objective;
  Objective balanced;
  balanced.horizon = objective.horizon;

  const TableShape shape{one->columns, one->rows};
  TableShape coarse = shape;
  LobeTable coarse_one;
  const LobeTable* first = &*one;
  if (options.size > k_coarse_size + 8) {
    coarse = {shape.columns > 1 ? k_coarse_size : 1, k_coarse_size};
    TableFitOptions few = options;
    few.size = k_coarse_size;
    Result<LobeTable> fitted = fit_table(brdf, few);
    if (!fitted) return fitted.error();
    coarse_one = std::move(*fitted);
    first = &coarse_one;
  }
  Vectors unknowns = start_from(*first);
  Result<Problem> problem = make_problem(brdf, coarse, options.angle_axis, *quadrature);
  if (!problem) return problem.error();
  const std::vector<Stage> stages = {{true, 3e-3, 12, 2e-3},
                                     {true, 3e-4, 15, 1e-3},
                                     {true, 3e-5, 20, 5e-4},
                                     {true, 3e-6, 20, 2e-4},
                                     {false, 1e-6, 25, 2e-4}};
  double done = 0.1;
  for (const Stage& stage : stages) {
    const Progress part = part_of(progress, done, done + 0.1);
    if (!run_stage(*problem, stage.balanced ? balanced : objective, stage, part, unknowns))
      return cancelled();
    done += 0.1;
  }
  if (coarse.rows != shape.rows) {
    unknowns = between_nodes(unknowns, coarse, shape);
    problem = make_problem(brdf, shape, options.angle_axis, *quadrature);
    if (!problem) return problem.error();
    const Stage last{false, 1e-6, 12, 5e-4};
    if (!run_stage(*problem, objective, last, part_of(progress, done, 0.95), unknowns))
      return cancelled();
  }

  store(unknowns, *one);
  TableCertificate certificate = certify_determinants(*one);
  // A determinant that is too small between samples: once more, further away from it.
  for (int attempt = 0; attempt < 3 && !(certificate.lower_bound > 0); ++attempt) {
    problem->least *= 30;
    if (!run_stage(*problem, objective, {false, 1e-6, 25, 2e-4}, {}, unknowns)) return cancelled();
    store(unknowns, *one);
    certificate = certify_determinants(*one);
  }
  if (!(certificate.lower_bound > 0))
    return Error{fmt::format("brdf {}: the lobes of neighbouring nodes do not interpolate near "
                             "roughness {:.3f}; openltc fit --size and --objective balanced change "
                             "them",
                             brdf.name, certificate.roughness)};
  if (progress && !progress(1.0)) return cancelled();
  return one;
}

} // namespace openltc::fit
