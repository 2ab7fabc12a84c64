// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source of the reweighting: Holland, Welsch 1977, "Robust Regression Using Iteratively Reweighted
// Least-Squares". The gradient of F = sum of w_i phi(r_i) is that of the weighted squares
// 1/2 sum of w_i omega_i r_i^2 with omega = phi'(r)/r at the current r; their matrix stands in for
// the second derivatives.
//
// The share above the horizon is exact: it is, in cosine space, the cosine's integral over a
// half-space with normal m = M^T z ~ (-m20, 0, m00), (1 + cos g)/2 = cos^2(g/2), cos g = m_z/|m|.

#include "openltc/fit/objective.h"

#include "openltc/fit/lobe_sums.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace openltc::fit {

Result<Objective> find_objective(std::string_view name) {
  Objective o;
  if (name == "balanced") return o;
  o.name = name;
  o.l2 = o.l3 = o.tv = 0;
  if (name == "tv") return o.tv = 1, o;
  if (name == "l2") return o.l2 = 1, o;
  if (name == "l3") return o.l3 = 1, o;
  // Three weights, e.g. 1,0.5,0.
  const std::string text(name);
  char* end = nullptr;
  double* const weights[] = {&o.tv, &o.l2, &o.l3};
  const char* at = text.c_str();
  for (int k = 0; k < 3; ++k) {
    *weights[k] = std::strtod(at, &end);
    const bool ends = *end == (k < 2 ? ',' : '\0');
    if (end == at || !ends || !(*weights[k] >= 0 && *weights[k] <= 1e6)) {
      end = nullptr;
      break;
    }
    at = end + 1;
  }
  if (end && o.tv + o.l2 + o.l3 > 0) return o;
  return Error{fmt::format("objective {}: choose balanced, tv, l2, l3, or three weights TV,L2,L3 "
                           "that are not negative, e.g. 1,0.5,0",
                           name)};
}

namespace {

// What the sums need of one lobe; false where its determinant is not positive.
struct LobeConstants {
  double m[4];
  double det;
  double log_slope[4];
};
bool lobe_constants(const Quadrature& q, Vec4d abcd, const Objective& o, LobeConstants& result) {
  const double width = q.width;
  const double det = width * (abcd.x * abcd.w - width * abcd.y * abcd.z);
  // The cosine's hemisphere must not be turned inside out. A and D by themselves may reach 0: at
  // grazing angles -B C carries the determinant.
  if (!(det > 0)) return false;

  // Half the angle g between the cosine's axis and the surface's normal in cosine space, and its
  // slopes by m[k] = A, wB, wC, wD: m00 = m0 cos - m1 sin, m20 = m2 cos - m3 sin.
  const double c = q.cos_theta, s = std::sqrt(std::max(0.0, 1 - c * c));
  const double m[4] = {abcd.x, width * abcd.y, width * abcd.z, width * abcd.w};
  const double m00 = m[0] * c - m[1] * s, m20 = m[2] * c - m[3] * s;
  const double length2 = m00 * m00 + m20 * m20;
  const double half = 0.5 * std::atan2(-m20, m00);
  const double by_m00 = 0.5 * m20 / length2, by_m20 = -0.5 * m00 / length2;
  const double slope[4] = {by_m00 * c, -by_m00 * s, by_m20 * c, -by_m20 * s};
  const double sine = std::sin(half), cosine = std::cos(half);
  // Shading divides by no less than k_min_share either.
  const double above = std::max(cosine * cosine, f64::k_min_share);
  const bool clipped = o.horizon == Horizon::clipped;
  const bool sloped = clipped && cosine * cosine > f64::k_min_share;
  const double scale = clipped ? 1 / above : 1.0;
  const double minor[4] = {m[3], -m[2], -m[1], m[0]};
  for (int k = 0; k < 4; ++k) {
    result.m[k] = m[k];
    // d log(1/cos^2) = 2 tan
    result.log_slope[k] = minor[k] / det + (sloped ? 2 * sine / cosine * slope[k] : 0.0);
  }
  result.det = det * scale * f64::k_inv_pi;
  return true;
}

void set_points(const Quadrature& q, const Objective& o, LobeSumsInput& in) {
  in.x = q.x_mirror.data();
  in.y = q.y.data();
  in.z = q.z_mirror.data();
  in.weight = q.weight.data();
  in.density = q.density.data();
  in.count = q.size();
  in.rounding = o.rounding;
  in.floor = o.rounding * 1e-3 * q.norm2;
}

// F of the sums, and the weights with which their derivatives make those of F.
double combine(const Quadrature& q, const Objective& o, const LobeDistances& distances,
               LobeSumsInput& in) {
  // A root has no slope at 0, where the fit is perfect.
  const double l2 = std::max(std::sqrt(distances.squares / q.norm2), 1e-6);
  const double l3 = std::max(std::cbrt(distances.cubes / q.norm3), 1e-6);
  // d sqrt(S) = dS / (2 sqrt(S)), d cbrt(S) = dS / (3 cbrt(S)^2)
  in.tv = o.tv;
  in.squares = o.l2 / (2 * l2 * q.norm2);
  in.cubes = o.l3 / (3 * l3 * l3 * q.norm3);
  return o.tv * distances.missing + o.l2 * l2 + o.l3 * l3;
}

} // namespace

ObjectiveValue evaluate_objective(const Quadrature& q, Vec4d abcd, const Objective& o,
                                  bool with_derivatives) {
  ObjectiveValue result;
  LobeConstants constants;
  if (!lobe_constants(q, abcd, o, constants)) {
    result.value = std::numeric_limits<double>::infinity();
    return result;
  }
  LobeSumsInput in;
  set_points(q, o, in);
  for (int k = 0; k < 4; ++k) {
    in.m[k] = constants.m[k];
    in.log_slope[k] = constants.log_slope[k];
  }
  in.det = constants.det;
  const LobeSums sums = lobe_sums();
  LobeDistances distances;
  sums.distances(in, distances);
  result.value = combine(q, o, distances, in);
  if (!with_derivatives) return result;

  LobeDerivatives derivatives;
  sums.derivatives(in, derivatives);

  // From m[k] to A B C D.
  const double width = q.width;
  const double factor[4] = {1, width, width, width};
  int at = 0;
  for (int i = 0; i < 4; ++i) {
    result.gradient[i] = factor[i] * derivatives.gradient[i];
    for (int j = i; j < 4; ++j, ++at)
      result.hessian[at] = factor[i] * factor[j] * derivatives.hessian[at];
  }
  return result;
}

TwoLobeObjectiveValue evaluate_objective(const Quadrature& q, const TwoLobes& lobes,
                                         const Objective& o, bool with_derivatives) {
  TwoLobeObjectiveValue result;
  const double weight = lobes[8];
  TwoLobeSumsInput in;
  bool proper = weight >= 0 && weight <= 1;
  for (std::size_t part = 0; part < 2 && proper; ++part) {
    const double* abcd = lobes.data() + 4 * part;
    LobeConstants constants;
    proper = lobe_constants(q, Vec4d(abcd[0], abcd[1], abcd[2], abcd[3]), o, constants);
    if (!proper) break;
    for (int k = 0; k < 4; ++k) {
      in.parts[part].m[k] = constants.m[k];
      in.parts[part].log_slope[k] = constants.log_slope[k];
    }
    in.parts[part].det = constants.det;
    in.parts[part].weight = part == 0 ? 1 - weight : weight;
  }
  if (!proper) {
    result.value = std::numeric_limits<double>::infinity();
    return result;
  }
  set_points(q, o, in.points);
  const LobeSums sums = lobe_sums();
  LobeDistances distances;
  sums.two_distances(in, distances);
  result.value = combine(q, o, distances, in.points);
  if (!with_derivatives) return result;

  TwoLobeDerivatives derivatives;
  sums.two_derivatives(in, derivatives);
  const double w = q.width;
  const double factor[k_two_lobe_unknowns] = {1, w, w, w, 1, w, w, w, 1};
  std::size_t at = 0;
  for (std::size_t i = 0; i < k_two_lobe_unknowns; ++i) {
    result.gradient[i] = factor[i] * derivatives.gradient[i];
    for (std::size_t j = i; j < k_two_lobe_unknowns; ++j, ++at)
      result.hessian[at] = factor[i] * factor[j] * derivatives.hessian[at];
  }
  return result;
}

} // namespace openltc::fit
