// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Every sample is first fitted by itself; the polynomials closest to those fits, in the metric of
// the objective, start the joint fit (joint_fit.h). The determinant is kept away from 0 by a
// penalty, also on the rim theta = 90 degrees, and proven to be positive afterwards; where the
// proof fails the penalty begins farther out and the joint fit goes on.

#include "openltc/fit/polynomial_fit.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/joint_fit.h"
#include "openltc/fit/lobe_start.h"
#include "openltc/fit/two_lobe_polynomial.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace openltc::fit {

namespace {

using table::LobePolynomial;

// Products T_i(u) T_j(v) in the order of LobePolynomial. A BRDF without a parameter depends on v
// alone: only terms with i = 0.
std::vector<JointTerm> terms_at(int degree, bool with_roughness, double roughness, double y) {
  const double u = 2 * std::max(roughness, 0.01) - 1, v = 2 * y - 1;
  std::vector<double> tu = {1, u}, tv = {1, v};
  for (std::size_t k = 2; k <= std::size_t(degree); ++k) {
    tu.push_back(2 * u * tu[k - 1] - tu[k - 2]);
    tv.push_back(2 * v * tv[k - 1] - tv[k - 2]);
  }
  std::vector<JointTerm> terms;
  int term = 0;
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i <= degree - j; ++i, ++term)
      if (with_roughness || i == 0)
        terms.push_back({term, tu[std::size_t(i)] * tv[std::size_t(j)]});
  return terms;
}

// Further rows towards the rim y = 1, where the determinant is smallest and polynomials swing most;
// at 1 itself there is no lobe.
constexpr std::array k_rim = {0.993, 0.998, 0.99995};
// The rim counts little as a place to fit, fully as one where the determinant must stay positive.
constexpr double k_rim_weight = 1e-3;

struct Samples {
  std::vector<JointSample> joint;
  std::vector<Vec4d> best; // fitted by themselves
};

Result<Samples> make_samples(const brdf::Brdf& brdf, const PolynomialFitOptions& options,
                             QuadratureSize quadrature, Progress progress) {
  const int n = options.samples;
  const int columns = brdf.has_parameter() ? n : 1, rows = n + int(k_rim.size());
  // Closer towards the mirror, where lobes are narrow and a small error of a coefficient is a large
  // one of the lobe. The rim's samples reach both ends.
  const auto roughness_of = [&](int column, bool rim) {
    if (columns == 1) return 1.0;
    const double t = rim ? double(column) / (n - 1) : (column + 0.5) / n;
    return t * (0.7 + 0.3 * t);
  };
  std::vector<HalfVectors> half_vectors;
  for (int i = 0; i < columns; ++i)
    half_vectors.push_back(find_half_vectors(brdf, roughness_of(i, false)));

  Samples samples;
  samples.joint.resize(std::size_t(columns) * std::size_t(rows));
  samples.best.resize(samples.joint.size());
  std::vector<std::string> failures{std::size_t(rows)};
  LobeFitOptions fit;
  fit.objective.horizon = options.objective.horizon; // otherwise balanced, the start of all
  ProgressCount done(rows, std::move(progress));
  parallel_for(rows, 0, [&](std::int64_t index) {
    const int row = int(index);
    if (done.is_cancelled()) return;
    const bool rim = row >= n;
    const double y = rim ? k_rim[std::size_t(row - n)] : (row + 0.5) / n;
    Vec4d start;
    for (int column = columns - 1; column >= 0; --column) {
      const std::size_t at = std::size_t(row) * std::size_t(columns) + std::size_t(column);
      Result<Quadrature> rule = make_quadrature(brdf, roughness_of(column, rim), 1 - y * y,
                                                half_vectors[std::size_t(column)], quadrature);
      if (!rule) {
        failures[std::size_t(row)] = rule.error().message;
        return;
      }
      if (column == columns - 1) start = fit_from_starts(*rule, {}, fit).mirror;
      samples.best[at] = fit_from_neighbour(*rule, start, fit).mirror;
      samples.joint[at].rule = std::move(*rule);
      samples.joint[at].weight = rim ? k_rim_weight : 1.0;
      samples.joint[at].terms =
          terms_at(options.degree, brdf.has_parameter(), roughness_of(column, rim), y);
    }
    done.add(1);
  });
  if (done.is_cancelled()) return cancelled();
  for (const std::string& failure : failures)
    if (!failure.empty()) return Error{failure};
  return samples;
}

float round_to_seven_digits(double x) {
  return std::strtof(fmt::format("{:.6e}", x).c_str(), nullptr);
}

LobePolynomial pack(const brdf::Brdf& brdf, int degree, const std::vector<Vec4d>& mirror,
                    const std::vector<double>& n1, const std::vector<double>& s) {
  LobePolynomial p;
  p.degree = degree;
  p.width = brdf.width;
  for (std::size_t term = 0; term < mirror.size(); ++term)
    for (const double c : {mirror[term].x, mirror[term].y, mirror[term].z, mirror[term].w, n1[term],
                           s[term], 0.0, 0.0})
      p.coefficients.push_back(round_to_seven_digits(c));
  return p;
}

// Places on all of the domain where lobes must not turn inside out, closest at its edges, where
// polynomials swing most: the extremes of a Chebyshev polynomial.
std::vector<JointSample> fences(const brdf::Brdf& brdf, int degree) {
  constexpr int k_per_axis = 48;
  const auto place = [](int i) { return 0.5 - 0.5 * std::cos(f64::k_pi * i / (k_per_axis - 1)); };
  std::vector<JointSample> result;
  for (int column = 0; column < (brdf.has_parameter() ? k_per_axis : 1); ++column)
    for (int row = 0; row < k_per_axis; ++row) {
      const double roughness = brdf.has_parameter() ? 0.01 + 0.99 * place(column) : 1;
      JointSample& fence = result.emplace_back();
      fence.weight = 0;
      fence.rule.width =
          brdf.width == brdf::LobeWidth::alpha ? f64::alpha_from_roughness(roughness) : 1;
      fence.terms = terms_at(degree, brdf.has_parameter(), roughness, place(row));
    }
  return result;
}

// Fits two lobes from the one of `mirror`; n1 and s stay.
Status add_second_lobe(const brdf::Brdf& brdf, const PolynomialFitOptions& options,
                       std::vector<JointSample> samples, const std::vector<Vec4d>& mirror,
                       const Progress& progress, PolynomialFit& result) {
  for (JointSample& fence : fences(brdf, options.degree))
    samples.push_back(std::move(fence));
  LobePolynomial& p = result.polynomial;
  double barrier = k_barrier;
  for (int attempt = 0; attempt < 3; ++attempt, barrier *= 10) {
    const auto terms = fit_two_lobe_terms(samples, mirror, options.degree, options.objective,
                                          barrier, attempt == 0 ? progress : Progress());
    if (!terms) return cancelled();
    p.second.clear();
    for (std::size_t i = 0; i < terms->size(); ++i) {
      const TwoLobeTerm& term = (*terms)[i];
      for (std::size_t k = 0; k < 4; ++k) {
        p.term(int(i))[k] = round_to_seven_digits(term[k]);
        p.second.push_back(round_to_seven_digits(term[4 + k]));
      }
      p.term(int(i))[6] = round_to_seven_digits(term[8]);
    }
    result.certificate = certify_determinant(p);
    if (result.certificate.lower_bound > 0) return Success{};
  }
  return Error{fmt::format("brdf {}: polynomials of degree {} of two lobes could not be certified, "
                           "A D - w B C reaches {:.2e}; openltc fit --degree asks for another, and "
                           "a table needs none",
                           brdf.name, options.degree, result.certificate.smallest_seen)};
}

} // namespace

Result<PolynomialFit> fit_polynomial(const brdf::Brdf& brdf, const PolynomialFitOptions& options,
                                     const Progress& progress) {
  if (options.degree < LobePolynomial::k_min_degree ||
      options.degree > LobePolynomial::k_max_degree)
    return Error{fmt::format("polynomial degree {}: choose {} to {}", options.degree,
                             LobePolynomial::k_min_degree, LobePolynomial::k_max_degree)};
  const Result<QuadratureSize> quadrature =
      options.quadrature ? Result<QuadratureSize>(*options.quadrature) : choose_quadrature(brdf);
  if (!quadrature) return quadrature.error();
  Result<Samples> samples = make_samples(brdf, options, *quadrature, part_of(progress, 0.0, 0.3));
  if (!samples) return samples.error();

  const std::size_t count = std::size_t(table::polynomial_terms(options.degree));
  JointFitOptions joint;
  joint.objective = Objective{};
  joint.objective.horizon = options.objective.horizon;
  joint.max_iterations = 60;
  joint.least_determinant = 2e-5;
  std::vector<Vec4d> mirror = project_jointly(samples->joint, samples->best, int(count), joint);

  // n5 = n1 s^5 is what a dielectric's albedo hangs on, E = F0 n1 + (1 - F0) n5 with F0 = .04: its
  // relative error is what counts, (1 - F0) 5 n1 s^4 ds / E, and a little of ds everywhere.
  std::vector<double> wanted1, wanted_s, importance_s;
  for (const JointSample& sample : samples->joint) {
    const double albedo = sample.rule.n1, weighted = std::max(sample.rule.n5, 0.0);
    const double s = std::pow(weighted / albedo, 0.2);
    const double slope = 0.96 * 5 * albedo * s * s * s * s / (0.04 * albedo + 0.96 * weighted);
    wanted_s.push_back(s);
    importance_s.push_back(slope * slope + 1e-2);
    wanted1.push_back(sample.rule.n1);
  }
  const std::vector<double> zero(count, 0.0);
  const std::vector<double> n1 = interpolate_jointly(samples->joint, wanted1, {}, zero);
  const std::vector<double> s = interpolate_jointly(samples->joint, wanted_s, importance_s, zero);

  PolynomialFit result;
  // Most fits need one attempt; each takes half of what is left of the bar, or of its first part.
  const double end = options.two_lobes ? 0.6 : 1.0;
  double share = 0.3;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const double step = 0.25 * (end - share);
    joint.progress = part_of(progress, share, share + step);
    const JointFit balanced = fit_jointly(samples->joint, mirror, joint);
    if (balanced.cancelled) return cancelled();
    if (!std::isfinite(balanced.objective))
      return Error{fmt::format("brdf {}: no polynomial of degree {} keeps its lobes from turning "
                               "inside out; openltc fit --degree asks for a higher one, and a "
                               "table has none",
                               brdf.name, options.degree)};
    mirror = balanced.unknowns;
    JointFitOptions own = joint;
    own.objective = options.objective;
    own.progress = part_of(progress, share + step, share + 2 * step);
    share += 2 * step;
    const JointFit fitted = fit_jointly(samples->joint, mirror, own);
    if (fitted.cancelled) return cancelled();
    result.polynomial = pack(brdf, options.degree, fitted.unknowns, n1, s);
    result.certificate = certify_determinant(result.polynomial);
    if (result.certificate.lower_bound > 0) break;
    joint.least_determinant *= 3;
  }
  if (!(result.certificate.lower_bound > 0))
    return Error{
        fmt::format("brdf {}: polynomials of degree {} could not be certified, A D - w B C "
                    "reaches {:.2e}; openltc fit --degree asks for another, and a table needs none",
                    brdf.name, options.degree, result.certificate.smallest_seen)};
  if (options.two_lobes)
    if (Status status = add_second_lobe(brdf, options, std::move(samples->joint), mirror,
                                        part_of(progress, 0.6, 1.0), result);
        !status)
      return status.error();
  if (progress && !progress(1.0)) return cancelled();
  result.polynomial.metadata.brdf = brdf.name;
  result.polynomial.metadata.variant = brdf.variant;
  result.polynomial.metadata.objective = options.objective.name;
  result.polynomial.metadata.horizon = name_of(options.objective.horizon);
  return result;
}

LobeFunction lobes_of(const LobePolynomial& polynomial) {
  return [&polynomial](double roughness, double cos_theta) {
    const double alpha = f64::alpha_from_roughness(roughness);
    const double width = polynomial.width == brdf::LobeWidth::alpha ? alpha : 1.0;
    const f64::FittedLobe first =
        f64::eval_lobe_polynomial_of_width(polynomial.view(), alpha, width, cos_theta);
    if (!polynomial.two_lobes()) return MeasuredLobe(first);
    return MeasuredLobe(first, f64::eval_second_lobe_polynomial_of_width(polynomial.view(), alpha,
                                                                         width, cos_theta));
  };
}

} // namespace openltc::fit
