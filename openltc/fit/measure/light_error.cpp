// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The bound: rho/E and D are probability densities on the sphere, so for any set of directions P
//   |integral over P of (rho/E - D)| <= 1/2 integral of |rho/E - D| = TV.
// Shading multiplies D with the table's n1, not with E, and so errs over P, where F = 1, by
//   |integral over P of (rho - n1 D)| <= E TV + |n1 - E|,
// and a light of radiance 0 <= L <= L_max, a mixture of such sets, by at most L_max times that.
//
// Rotations: Shoemake 1992, "Uniform Random Rotations", Graphics Gems III: a unit quaternion from
// three uniform numbers.

#include "openltc/fit/measure/light_error.h"

#include "openltc/base/parallel.h"
#include "openltc/base/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::fit {

namespace {

constexpr QuadratureSize k_quadrature = {40, 32};

double mix(double from, double to, double t) { return from + (to - from) * t; }

// The columns of a rotation matrix from a unit quaternion (x, y, z, w): the images of the x and y
// axes.
struct Pose {
  Vec3d u, v;
};
Pose random_pose(double a, double b, double c) {
  const double r1 = std::sqrt(1 - a), r2 = std::sqrt(a);
  const double x = r1 * std::sin(2 * f64::k_pi * b), y = r1 * std::cos(2 * f64::k_pi * b);
  const double z = r2 * std::sin(2 * f64::k_pi * c), w = r2 * std::cos(2 * f64::k_pi * c);
  return {Vec3d(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)),
          Vec3d(2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w))};
}

struct CaseError {
  double error = 0; // lobe minus BRDF, both of albedo 1
  double tv = 0;
  double light = 0; // the lobe times the table's n1 minus the BRDF's integral
  double bound = 0;
};

LightError summarise(const std::vector<CaseError>& cases) {
  LightError result;
  result.count = int(cases.size());
  std::vector<double> sizes;
  double squares = 0, sum = 0, signed_sum = 0;
  for (const CaseError& c : cases) {
    const double e = std::abs(c.error);
    sizes.push_back(e);
    squares += e * e;
    sum += e;
    signed_sum += c.error;
    const double light = std::abs(c.light);
    if (e > c.tv + k_light_tolerance || light > c.bound + k_light_tolerance) ++result.violations;
    if (c.bound > 1e-3) result.of_bound = std::max(result.of_bound, light / c.bound);
  }
  std::sort(sizes.begin(), sizes.end());
  const double n = double(cases.size());
  result.rmse = std::sqrt(squares / n);
  result.mean = sum / n;
  result.bias = signed_sum / n;
  result.p95 = sizes[std::size_t(0.95 * (n - 1))];
  result.max = sizes.back();
  return result;
}

} // namespace

LightCase light_case(const LightFamily& family, int index) {
  const auto pair = [&](std::uint32_t k) {
    return owen_sobol(std::uint32_t(index), hash_combine(family.seed, k));
  };
  const Sample2 a = pair(0), b = pair(1), c = pair(2), d = pair(3), e = pair(4);
  LightCase light;
  light.roughness = mix(family.roughness_from, family.roughness_to, double(a.u));
  light.cos_theta =
      std::cos(theta_at(double(a.v), family.theta_to_degrees, family.angle_axis) * f64::k_pi / 180);
  const double z = double(b.u), r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = 2 * f64::k_pi * double(b.v);
  const Vec3d center = Vec3d(r * std::cos(phi), r * std::sin(phi), z) *
                       mix(family.distance_from, family.distance_to, double(c.u));
  const Pose pose = random_pose(double(c.v), double(d.u), double(d.v));
  const Vec3d u = pose.u * (0.5 * mix(family.side_from, family.side_to, double(e.u)));
  const Vec3d v = pose.v * (0.5 * mix(family.side_from, family.side_to, double(e.v)));
  light.corners = {center - u - v, center + u - v, center + u + v, center - u + v};
  return light;
}

Result<std::vector<LightError>> measure_lights(const brdf::Brdf& brdf,
                                               std::span<const MeasuredLobes> candidates,
                                               const LightFamily& family) {
  if (family.count < 1) return Error{"a family of lights needs at least one member"};
  const auto count = std::size_t(family.count);
  std::vector<std::vector<CaseError>> errors(candidates.size(), std::vector<CaseError>(count));
  std::vector<double> light(count);
  std::vector<std::string> failures(count);
  parallel_for(std::int64_t(count), 0, [&](std::int64_t index) {
    const std::size_t i = std::size_t(index);
    const LightCase at = light_case(family, int(i));
    const HalfVectors half_vectors = find_half_vectors(brdf, at.roughness);
    const Result<Quadrature> rule =
        make_quadrature(brdf, at.roughness, at.cos_theta, half_vectors, k_quadrature);
    if (!rule) {
      failures[i] = rule.error().message;
      return;
    }
    light[i] = integrate_brdf_over_polygon(brdf, at.roughness, at.cos_theta, half_vectors.scale,
                                           at.corners) /
               rule->n1;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const MeasuredLobe fitted = candidates[c].lobes(at.roughness, at.cos_theta);
      const LobeError bounds = measure_lobe(*rule, fitted, candidates[c].horizon);
      // As shade_polygon does it.
      const auto filled = [&](const f64::Lobe& lobe) {
        return horizon_scale(lobe, candidates[c].horizon) *
               integrate_lobe_over_polygon(lobe, at.corners);
      };
      const double w = fitted.second.weight;
      const double share = std::min(
          (1 - w) * filled(fitted.lobe) + (fitted.two() ? w * filled(fitted.second.lobe) : 0), 1.0);
      errors[c][i] = {share - light[i], bounds.tv, fitted.n1 * share - rule->n1 * light[i],
                      bounds.bound};
      if (!is_finite(fitted) || !std::isfinite(share))
        failures[i] = fmt::format("{}: the lobe at roughness {:.6g}, cos theta {:.6g} is not "
                                  "finite; the table is broken or read in a wrong layout",
                                  candidates[c].label, at.roughness, at.cos_theta);
    }
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) return Error{failure};
  double mean_light = 0;
  for (const double x : light)
    mean_light += x / double(count);
  std::vector<LightError> result;
  for (const std::vector<CaseError>& cases : errors) {
    result.push_back(summarise(cases));
    result.back().mean_light = mean_light;
  }
  return result;
}

} // namespace openltc::fit
