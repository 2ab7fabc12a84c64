// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Gauss-Newton with Marquardt's damping; the normal equations are solved by conjugate gradients and
// never formed:
//   with x_s = sum of f_si u_i the coefficients at sample s, g_s and H_s the objective's gradient
//   and matrix there, and weight w_s,
//   gradient_i = sum over s of w_s f_si g_s,   (H v)_i = sum over s of w_s f_si H_s sum_j f_sj v_j.
// A table's matrix is that of the bilinear hat functions, whose condition is good; its 4 x 4 blocks
// on the diagonal precondition it. A polynomial's few unknowns need as many steps at most.

#include "openltc/fit/joint/joint_fit.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/conjugate_gradients.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace openltc::fit {

namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;
using Unknowns = std::vector<Vector4, Eigen::aligned_allocator<Vector4>>;

struct Local {
  double value = 0;
  Vector4 gradient = Vector4::Zero();
  Matrix4 hessian = Matrix4::Zero();
};
using Locals = std::vector<Local, Eigen::aligned_allocator<Local>>;

Unknowns to_eigen(const std::vector<Vec4d>& v) {
  Unknowns result;
  for (const Vec4d& x : v)
    result.emplace_back(x.x, x.y, x.z, x.w);
  return result;
}

std::vector<Vec4d> from_eigen(const Unknowns& v) {
  std::vector<Vec4d> result;
  for (const Vector4& x : v)
    result.emplace_back(x[0], x[1], x[2], x[3]);
  return result;
}

Vector4 interpolate(const JointSample& sample, const Unknowns& unknowns) {
  Vector4 x = Vector4::Zero();
  for (const JointTerm& term : sample.terms)
    x += term.factor * unknowns[std::size_t(term.unknown)];
  return x;
}

// The coefficients A B C D of what is interpolated.
Vector4 read(const JointSample& sample, const Vector4& y) {
  if (!sample.read) return y;
  const Vec4d x = sample.read({y[0], y[1], y[2], y[3]});
  return {x.x, x.y, x.z, x.w};
}

// Adds weight * (what the determinant lacks of `least`, relative to it)^2; says whether it lacks.
bool add_penalty(const JointSample& sample, const Vector4& x, double least, double weight,
                 Local& local) {
  const double width = sample.rule.width;
  const double determinant = x[0] * x[3] - width * x[1] * x[2];
  if (!(least > 0 && determinant < least)) return false;
  const double missing = 1 - determinant / least;
  const Vector4 slope = Vector4(-x[3], width * x[2], width * x[1], -x[0]) / least;
  local.value += weight * missing * missing;
  local.gradient += 2 * weight * missing * slope;
  local.hessian += 2 * weight * slope * slope.transpose();
  return true;
}

// The slopes of sample.read at y, a column for each element of y, by central differences.
Matrix4 slopes_of_read(const JointSample& sample, const Vector4& y) {
  Matrix4 slopes;
  for (int k = 0; k < 4; ++k) {
    const double step = 1e-5 * std::abs(y[k]) + 1e-9;
    Vector4 more = y, less = y;
    more[k] += step;
    less[k] -= step;
    slopes.col(k) = (read(sample, more) - read(sample, less)) / (more[k] - less[k]);
  }
  return slopes;
}

// The objective at one sample, where `y` is interpolated, weighted, with the penalty that keeps the
// determinant away from 0.
Local evaluate_local(const JointSample& sample, const Vector4& y, const JointFitOptions& options) {
  Local local;
  const Vector4 x = read(sample, y);
  const ObjectiveValue at =
      evaluate_objective(sample.rule, Vec4d(x[0], x[1], x[2], x[3]), options.objective);
  local.value = sample.weight * at.value;
  int k = 0;
  for (int i = 0; i < 4; ++i) {
    local.gradient[i] = sample.weight * at.gradient[i];
    for (int j = i; j < 4; ++j, ++k)
      local.hessian(i, j) = local.hessian(j, i) = sample.weight * at.hessian[k];
  }
  add_penalty(sample, x, options.least_determinant, 1.0, local);
  if (sample.read && std::isfinite(local.value)) { // by the chain rule, as Gauss and Newton
    const Matrix4 slopes = slopes_of_read(sample, y);
    local.gradient = (slopes.transpose() * local.gradient).eval();
    local.hessian = (slopes.transpose() * local.hessian * slopes).eval();
  }
  return local;
}

double evaluate_all(const std::vector<JointSample>& samples, const Unknowns& unknowns,
                    const JointFitOptions& options, Locals& locals) {
  parallel_for(std::int64_t(samples.size()), 0, [&](std::int64_t index) {
    const std::size_t s = std::size_t(index);
    locals[s] = evaluate_local(samples[s], interpolate(samples[s], unknowns), options);
  });
  double sum = 0;
  for (const Local& local : locals)
    sum += local.value;
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

// Solves (H + damping diag blocks) x = -gradient, x being 0 for the first `held` unknowns.
Unknowns solve(const std::vector<JointSample>& samples, const Locals& locals, double damping,
               std::size_t count, std::size_t held = 0) {
  Unknowns residual(count, Vector4::Zero());
  std::vector<Matrix4, Eigen::aligned_allocator<Matrix4>> block(count, Matrix4::Zero());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    for (const JointTerm& term : samples[s].terms) {
      residual[std::size_t(term.unknown)] -= term.factor * locals[s].gradient;
      block[std::size_t(term.unknown)] += term.factor * term.factor * locals[s].hessian;
    }
  }
  const auto hold = [&](Unknowns& v) { std::fill_n(v.begin(), held, Vector4(Vector4::Zero())); };
  hold(residual);
  std::vector<Vector4, Eigen::aligned_allocator<Vector4>> diagonal(count);
  std::vector<Eigen::LDLT<Matrix4>> inverse(count);
  for (std::size_t i = 0; i < count; ++i) {
    diagonal[i] = damping * block[i].diagonal();
    for (int k = 0; k < 4; ++k)
      block[i](k, k) += diagonal[i][k] + 1e-12 * block[i].trace() + 1e-300;
    inverse[i].compute(block[i]);
  }

  const auto precondition = [&](const Unknowns& r, Unknowns& z) {
    for (std::size_t i = 0; i < count; ++i)
      z[i] = inverse[i].solve(r[i]);
  };
  const auto multiply = [&](const Unknowns& p, Unknowns& hp) {
    for (std::size_t i = 0; i < count; ++i)
      hp[i] = diagonal[i].cwiseProduct(p[i]);
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const Vector4 h = locals[s].hessian * interpolate(samples[s], p);
      for (const JointTerm& term : samples[s].terms)
        hp[std::size_t(term.unknown)] += term.factor * h;
    }
    hold(hp);
  };
  const int most = int(std::min<std::size_t>(4 * count, 300));
  return conjugate_gradients(std::move(residual), 1e-8, most, precondition, multiply);
}

} // namespace

JointFit fit_jointly(const std::vector<JointSample>& samples, std::vector<Vec4d> start,
                     const JointFitOptions& options) {
  JointFit fit;
  Unknowns at = to_eigen(start);
  Locals locals(samples.size()), trial_locals(samples.size());
  double total_weight = 0;
  for (const JointSample& sample : samples)
    total_weight += sample.weight;
  double value = evaluate_all(samples, at, options, locals);
  double damping = 1e-3;
  while (fit.iterations < options.max_iterations && damping < 1e8) {
    const Unknowns step = solve(samples, locals, damping, at.size(), std::size_t(options.held));
    Unknowns trial = at;
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial[i] += step[i];
    const double there = evaluate_all(samples, trial, options, trial_locals);
    ++fit.iterations;
    if (options.progress && !options.progress(double(fit.iterations) / options.max_iterations)) {
      fit.cancelled = true;
      break;
    }
    if (there < value) {
      const bool done = value - there < options.tolerance * value;
      at.swap(trial);
      locals.swap(trial_locals);
      value = there;
      damping = std::max(0.2 * damping, 1e-6);
      if (done) break;
    } else {
      damping *= 10;
    }
  }
  fit.unknowns = from_eigen(at);
  fit.objective = value / total_weight;
  return fit;
}

std::vector<Vec4d> project_jointly(const std::vector<JointSample>& samples,
                                   const std::vector<Vec4d>& best, int unknown_count,
                                   const JointFitOptions& options) {
  // Times the objective: a norm's second derivatives grow where it is small, its square's do not.
  Locals model(samples.size());
  JointFitOptions plain = options;
  plain.least_determinant = 0;
  const Unknowns wanted = to_eigen(best);
  parallel_for(std::int64_t(samples.size()), 0, [&](std::int64_t index) {
    const std::size_t s = std::size_t(index);
    model[s] = evaluate_local(samples[s], wanted[s], plain);
    model[s].hessian *= model[s].value;
  });

  // The quadratic model's minimum; while a determinant is too small there, damped steps on the
  // model and a penalty, whose margin is wide, for the determinant of a narrow one jumps.
  const std::size_t count = std::size_t(unknown_count);
  const double margin = 50 * options.least_determinant;
  Locals locals = model;
  const auto evaluate = [&](const Unknowns& at, double weight, bool& lacking) {
    double sum = 0;
    lacking = false;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const Vector4 x = interpolate(samples[s], at), away = x - wanted[s];
      locals[s].hessian = model[s].hessian;
      locals[s].gradient = model[s].hessian * away;
      locals[s].value = 0.5 * away.dot(locals[s].gradient);
      add_penalty(samples[s], x, margin, weight, locals[s]);
      sum += locals[s].value;
      const double determinant = x[0] * x[3] - samples[s].rule.width * x[1] * x[2];
      lacking = lacking || !(determinant >= options.least_determinant);
    }
    return sum;
  };
  const auto moved = [](Unknowns from, const Unknowns& by) {
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] += by[i];
    return from;
  };
  bool lacking = false;
  Unknowns at(count, Vector4::Zero());
  evaluate(at, 0, lacking);
  at = moved(at, solve(samples, locals, 1e-9, count));
  double weight = 1e-4, damping = 1e-3;
  double value = evaluate(at, weight, lacking);
  for (int step = 0; step < 60 && lacking; ++step) {
    const Unknowns trial = moved(at, solve(samples, locals, damping, count));
    bool still = false;
    const double there = evaluate(trial, weight, still);
    if (there < value) {
      at = trial;
      lacking = still;
      damping = std::max(0.2 * damping, 1e-6);
    } else {
      damping *= 10;
    }
    if (damping > 1e3) { // a minimum of this weight: ask for more
      damping = 1e-3;
      weight *= 10;
    }
    bool unused = false;
    value = evaluate(at, weight, unused);
  }
  return from_eigen(at);
}

std::vector<double> interpolate_jointly(const std::vector<JointSample>& samples,
                                        const std::vector<double>& values,
                                        const std::vector<double>& importance,
                                        std::vector<double> start) {
  // One of the four channels carries the values; the others are 0.
  Unknowns at(start.size(), Vector4::Zero());
  for (std::size_t i = 0; i < start.size(); ++i)
    at[i][0] = start[i];
  Locals locals(samples.size());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const double w = samples[s].weight * (importance.empty() ? 1.0 : importance[s]);
    locals[s].gradient[0] = w * (interpolate(samples[s], at)[0] - values[s]);
    locals[s].hessian = Matrix4::Identity() * w;
  }
  const Unknowns step = solve(samples, locals, 0, start.size());
  for (std::size_t i = 0; i < start.size(); ++i)
    start[i] += step[i][0];
  return start;
}

} // namespace openltc::fit
