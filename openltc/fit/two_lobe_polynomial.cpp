// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The start is that of tables of two lobes (two_lobe_fit.cpp): one lobe narrower and beside it one
// that is wider and tilted more, as far as no lobe turns inside out. Polynomials hang together by
// themselves and need no prior. They are smooth, too: near the rim theta = 90 degrees, where A D
// vanishes with the roughness, a coefficient moves all determinants at once. A penalty below a
// least determinant is a wall there, at which steps end (mean TV 0.0219 at degree 4); a barrier,
//   b log(1 + m / det),   det = A D - w B C,
// bends them before they meet it (0.0192), and far from 0 it is nothing.
//
// Gauss-Newton with Marquardt's damping. The unknowns are few, and each takes part in every sample:
// the normal equations are dense.

#include "openltc/fit/two_lobe_polynomial.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/two_lobe_problem.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace openltc::fit {

namespace {

using two_lobe::Local;
using two_lobe::Vector;
using Terms = std::vector<TwoLobeTerm>;
using Locals = std::vector<Local>;

constexpr int k_tangent = two_lobe::k_logit; // in the place of tables' logit: t
constexpr double k_margin = 1e-3;            // m: determinants below feel the barrier

struct Aim {
  Objective objective;
  double barrier;
};

void add_barrier(const JointSample& sample, const Vector& x, int first, double barrier,
                 Local& local) {
  const double width = sample.rule.width;
  const double det = x[first] * x[first + 3] - width * x[first + 1] * x[first + 2];
  if (!(det > 0)) {
    local.value = std::numeric_limits<double>::infinity();
    return;
  }
  const Eigen::Vector4d slope(x[first + 3], -width * x[first + 2], -width * x[first + 1], x[first]);
  const double pull = barrier * k_margin / (det * (det + k_margin));
  local.value += barrier * std::log1p(k_margin / det);
  local.gradient.segment<4>(first) -= pull * slope;
  local.hessian.block<4, 4>(first, first) +=
      pull * (1 / det + 1 / (det + k_margin)) * slope * slope.transpose();
}

// Objective and barrier at every sample, with derivatives by t in place of the weight.
double evaluate(const std::vector<JointSample>& samples, const Terms& terms, const Aim& aim,
                Locals& locals) {
  two_lobe::in_pieces(samples.size(), [&](std::size_t s) {
    const JointSample& sample = samples[s];
    Local& local = locals[s];
    Vector x = Vector::Zero();
    for (const JointTerm& term : sample.terms)
      x += term.factor * Eigen::Map<const Vector>(terms[std::size_t(term.unknown)].data());
    const double t = x[k_tangent], cosine = 1 / std::sqrt(1 + t * t);
    x[k_tangent] = 0.5 + 0.5 * t * cosine;
    if (sample.weight > 0)
      two_lobe::evaluate_local(sample, x, aim.objective, 0, true, local);
    else
      local = {0, Vector::Zero(), two_lobe::Matrix::Zero()};
    const double slope = 0.5 * cosine * cosine * cosine;
    local.gradient[k_tangent] *= slope;
    local.hessian.row(k_tangent) *= slope;
    local.hessian.col(k_tangent) *= slope;
    add_barrier(sample, x, 0, aim.barrier, local);
    add_barrier(sample, x, 4, aim.barrier, local);
  });
  double sum = 0;
  for (const Local& local : locals)
    sum += local.value;
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;

  NormalEquations(const std::vector<JointSample>& samples, const Locals& locals,
                  std::size_t count) {
    constexpr int n = two_lobe::k_unknowns;
    matrix.setZero(Eigen::Index(count) * n, Eigen::Index(count) * n);
    gradient.setZero(Eigen::Index(count) * n);
    // A row of blocks by itself, its samples in order.
    parallel_for(std::int64_t(count), 0, [&](std::int64_t row) {
      const Eigen::Index at = Eigen::Index(row) * n;
      for (std::size_t s = 0; s < samples.size(); ++s)
        for (const JointTerm& left : samples[s].terms) {
          if (left.unknown != row) continue;
          gradient.segment<n>(at) += left.factor * locals[s].gradient;
          for (const JointTerm& right : samples[s].terms)
            matrix.block<n, n>(at, Eigen::Index(right.unknown) * n) +=
                left.factor * right.factor * locals[s].hessian;
        }
    });
  }

  // Where the terms go by a step that is damped so.
  Terms moved(Terms terms, double damping) const {
    Eigen::MatrixXd damped = matrix;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += 1e-12 * matrix.trace();
    const Eigen::VectorXd step = damped.ldlt().solve(gradient);
    Eigen::Index at = 0;
    for (TwoLobeTerm& term : terms)
      for (double& c : term)
        c -= step[at++];
    return terms;
  }
};

// From where the terms are; false when the progress asks to stop.
bool minimise(const std::vector<JointSample>& samples, const Aim& aim, const Progress& progress,
              Terms& terms) {
  constexpr int k_most_steps = 60;
  Locals locals(samples.size()), trial_locals(samples.size());
  double value = evaluate(samples, terms, aim, locals), damping = 1e-2;
  for (int step = 0; step < k_most_steps; ++step) {
    if (progress && !progress(double(step) / k_most_steps)) return false;
    const NormalEquations equations(samples, locals, terms.size());
    bool done = true;
    for (; damping < 1e6; damping *= 6) {
      Terms trial = equations.moved(terms, damping);
      const double there = evaluate(samples, trial, aim, trial_locals);
      if (!(there < value)) continue;
      done = value - there < 1e-4 * value;
      terms.swap(trial);
      locals.swap(trial_locals);
      value = there;
      damping = std::max(damping * 0.3, 1e-6);
      break;
    }
    if (done) break;
  }
  return true;
}

// One lobe beside itself at 0, at 1 what was found to lead to GGX's peak and tail.
Terms start_of(const std::vector<Vec4d>& one, int degree, double share) {
  Terms terms;
  for (const Vec4d& c : one)
    terms.push_back({(1 - 0.05 * share) * c.x, (1 - 0.5 * share) * c.y, (1 - 0.3 * share) * c.z,
                     (1 - 0.05 * share) * c.w, (1 + 0.2 * share) * c.x, c.y, c.z,
                     (1 + 0.3 * share) * c.w, 0});
  terms[0][4] += 0.05 * share;
  terms[0][k_tangent] = -0.5; // a weight of 0.28
  // sqrt(1 - cos theta) = (T_0 + T_1) / 2 of the second variable, whose T_1 is the first term
  // after degree + 1 of T_0.
  for (const std::size_t term : {std::size_t(0), std::size_t(degree) + 1}) {
    terms[term][5] -= 0.3 * share;
    terms[term][6] += 0.75 * share;
  }
  return terms;
}

} // namespace

std::optional<Terms> fit_two_lobe_terms(const std::vector<JointSample>& samples,
                                        const std::vector<Vec4d>& one, int degree,
                                        const Objective& objective, double barrier,
                                        const Progress& progress) {
  Aim balanced{{}, barrier};
  balanced.objective.horizon = objective.horizon;
  Locals locals(samples.size());
  Terms terms = start_of(one, degree, 1);
  for (double share = 1; share > 1e-3 && std::isinf(evaluate(samples, terms, balanced, locals));)
    terms = start_of(one, degree, share *= 0.5);
  if (!minimise(samples, balanced, part_of(progress, 0, 0.5), terms)) return {};
  if (!minimise(samples, {objective, barrier}, part_of(progress, 0.5, 1), terms)) return {};
  return terms;
}

} // namespace openltc::fit
