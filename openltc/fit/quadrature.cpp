// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The rule works in slopes of the half vector, h ~ (r cos phi, r sin phi, 1), because there a
// reflection lobe is round however grazing the view, and because the horizon has a closed form:
// wi = reflect(wo, h) has
//   wi.z = 2 (cos + r sin cos phi)/(1 + r^2) - cos,      (cos, sin: of the view angle theta)
// which vanishes at r = t cos phi + sqrt(t^2 cos^2 phi + 1), t = tan theta, and nowhere else. With
//   t cos phi = sinh(k c),  k = asinh t,  c = cos chi,   that is   r_max = exp(k c),
// a rule uniform in chi resolves the step of r_max at phi = 90 degrees, is even and periodic in
// chi, and so converges like a trapezoidal rule on a smooth periodic function. Along r a
// Gauss-Legendre rule in v, r = s sinh v, gives the lobe's core, of scale s, and every decade from
// there to r_max their share of points. Both converge exponentially.
//
// Solid angle: d wi = 4 (wo.h) d h,  d h = r dr dphi / (1 + r^2)^(3/2)   (Walter et al. 2007,
// equation 14).

#include "openltc/fit/quadrature.h"

#include "openltc/base/parallel.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

namespace openltc::fit {

namespace {

struct GaussRule {
  std::vector<double> node, weight; // on [0, 1]
};

// Gauss-Legendre nodes by Newton's method on P_n from Tricomi's estimate.
GaussRule make_gauss(int n) {
  GaussRule rule;
  rule.node.resize(std::size_t(n));
  rule.weight.resize(std::size_t(n));
  for (int i = 0; i < n; ++i) {
    double x = std::cos(f64::k_pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 100; ++step) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= n; ++k)
        p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
      slope = n * (x * p1 - p0) / (x * x - 1);
      const double move = p1 / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    rule.node[std::size_t(i)] = 0.5 * (1 - x);
    rule.weight[std::size_t(i)] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

const GaussRule& gauss(int n) {
  static Mutex mutex;
  static std::map<int, GaussRule> rules;
  const std::lock_guard<Mutex> lock(mutex);
  const auto found = rules.find(n);
  return found != rules.end() ? found->second : rules.emplace(n, make_gauss(n)).first->second;
}

// One azimuth of the rule: direction, reach and d phi.
struct Azimuth {
  double cosine, sine, r_max, weight;
};

Azimuth azimuth(double chi, double t, double d_chi) {
  const double c = std::cos(chi), s = std::sin(chi);
  const double k = std::asinh(t);
  if (k < 1e-6) return {c, s, std::exp(k * c), d_chi};
  const double half_s = std::sin(0.5 * chi), half_c = std::cos(0.5 * chi);
  // sinh^2 k - sinh^2 kc = sinh(k (1 + c)) sinh(k (1 - c)): no cancellation at either end.
  const double sine =
      std::sqrt(std::sinh(2 * k * half_c * half_c) * std::sinh(2 * k * half_s * half_s)) / t;
  return {std::sinh(k * c) / t, sine, std::exp(k * c),
          d_chi * k * std::cosh(k * c) * s / (t * sine)};
}

std::string direction_text(Vec3d v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
}

// A tail is short when it ends before this many times the lobe's scale: GGX's never does, that of
// Beckmann, Phong or Blinn after about five.
constexpr double k_short_tail = 30;

} // namespace

namespace {

HalfVectors half_vectors_of(const brdf::Brdf& brdf, double roughness) {
  // At normal incidence the lobe is round: d wi = 4 (wo.h) d h leaves one integral over r in (0,
  // 1), here on a scale of log r.
  constexpr int n = 192;
  constexpr double k_smallest = 1e-6;
  // Of the greatest energy per step of log r: below it a tail is over.
  constexpr double k_nothing = 1e-7;
  const double step = -std::log(k_smallest) / n;
  const auto slope = [&](int i) { return k_smallest * std::exp((i + 0.5) * step); };
  std::vector<Vec3d> wi;
  for (int i = 0; i < n; ++i) {
    const double r = slope(i);
    const double inv = 1 / (1 + r * r);
    wi.push_back(Vec3d(2 * r * inv, 0, (1 - r * r) * inv));
  }
  std::vector<brdf::BrdfValue> values(wi.size());
  brdf::eval_all(brdf, Vec3d(0, 0, 1), wi, roughness, values);
  double energy[n], sum = 0, most = 0;
  for (int i = 0; i < n; ++i) {
    const double r = slope(i);
    const double inv = 1 / (1 + r * r);
    const double value = values[std::size_t(i)].scale;
    energy[i] = value > 0 && std::isfinite(value) ? value * r * r * inv * inv : 0;
    sum += energy[i];
    most = std::max(most, energy[i]);
  }
  HalfVectors found;
  if (!(sum > 0)) return found;
  double passed = 0;
  for (int i = 0; i < n && passed < 0.5 * sum; ++i) {
    passed += energy[i];
    found.scale = slope(i);
  }
  int last = n - 1;
  while (energy[last] < k_nothing * most)
    --last;
  found.reach = last < n - 2 ? slope(last) : 1.0;
  return found;
}

} // namespace

HalfVectors find_half_vectors(const brdf::Brdf& brdf, double roughness) try {
  return brdf.eval ? half_vectors_of(brdf, roughness) : HalfVectors();
} catch (...) {
  return {}; // make_quadrature meets the same and says what it is
}

namespace {

Result<Quadrature> make_rule(const brdf::Brdf& brdf, double roughness, double cos_theta,
                             HalfVectors half_vectors, QuadratureSize size) {
  Quadrature q;
  q.cos_theta = cos_theta;
  q.roughness = roughness;
  q.width = brdf.width == brdf::LobeWidth::alpha ? f64::alpha_from_roughness(roughness) : 1.0;
  const double sin_theta = std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta));
  const double t = sin_theta / cos_theta;
  const double s = half_vectors.scale;
  // A short tail ends before the horizon: most points go where it lives, the rest beyond, where
  // only the fitted lobe is left. At an angle a lobe around the mirror direction reaches farther in
  // slopes than at normal incidence, by 1/cos at most.
  const double reach = half_vectors.reach < std::min(0.95, k_short_tail * s)
                           ? 1.1 * half_vectors.reach / cos_theta
                           : std::numeric_limits<double>::infinity();
  const int inner = size.radial * 4 / 5;
  const Vec3d wo(sin_theta, 0, cos_theta);
  const GaussRule& whole_rule = gauss(size.radial);
  const GaussRule& inner_rule = gauss(inner);
  const GaussRule& outer_rule = gauss(size.radial - inner);

  const std::size_t count = std::size_t(size.radial) * size.azimuths;
  const std::size_t padded =
      (count + Quadrature::k_block - 1) / Quadrature::k_block * Quadrature::k_block;
  // Padding: the mirror direction, where every lobe is finite and positive.
  q.x_mirror.assign(padded, 0.0);
  q.y.assign(padded, 0.0);
  q.z_mirror.assign(padded, 1.0);
  q.weight.assign(padded, 0.0);
  q.density.assign(padded, 0.0);

  std::size_t at = 0;
  std::vector<Vec3d> directions;         // above the horizon
  std::vector<std::size_t> direction_at; // where they belong
  directions.reserve(count);
  direction_at.reserve(count);
  for (int j = 0; j < size.azimuths; ++j) {
    const double d_chi = f64::k_pi / size.azimuths;
    const Azimuth a = azimuth((j + 0.5) * d_chi, t, d_chi);
    const double v_max = std::asinh(a.r_max / s);
    const double v_reach = std::asinh(std::min(reach, a.r_max) / s);
    const bool split = v_reach < 0.7 * v_max;
    for (int i = 0; i < size.radial; ++i, ++at) {
      const bool beyond = split && i >= inner;
      const GaussRule& rule = beyond ? outer_rule : split ? inner_rule : whole_rule;
      const std::size_t node = std::size_t(beyond ? i - inner : i);
      const double from = beyond ? v_reach : 0,
                   length = (beyond || !split ? v_max : v_reach) - from;
      const double growth = std::exp(from + length * rule.node[node]);
      const double r = 0.5 * s * (growth - 1 / growth);
      const double inv = 1 / (1 + r * r);
      // wi = 2 (wo.h) h - wo with h = (r cos phi, r sin phi, 1) sqrt(inv)
      const double o_dot = cos_theta + r * sin_theta * a.cosine; // wo.h / sqrt(inv)
      const double twice = 2 * o_dot * inv;
      const Vec3d wi(twice * r * a.cosine - sin_theta, twice * r * a.sine, twice - cos_theta);
      if (!(wi.z > 0)) continue; // the last bit of r_max
      const double dr = 0.5 * s * (growth + 1 / growth) * length * rule.weight[node];
      // Both halves of the domain: 2 * 4 (wo.h) r dr dphi / (1 + r^2)^(3/2).
      q.weight[at] = 8 * o_dot * r * dr * a.weight * inv * inv;
      q.x_mirror[at] = cos_theta * wi.x + sin_theta * wi.z;
      q.y[at] = wi.y;
      q.z_mirror[at] = cos_theta * wi.z - sin_theta * wi.x;
      directions.push_back(wi);
      direction_at.push_back(at);
    }
  }
  std::vector<brdf::BrdfValue> values(directions.size());
  brdf::eval_all(brdf, wo, directions, roughness, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const brdf::BrdfValue& value = values[k];
    if (!(value.scale >= 0 && std::isfinite(value.scale) && std::isfinite(value.bias)))
      return Error{fmt::format("brdf {}: its value is {} (Fresnel part {}) for wo {}, wi {}, "
                               "roughness {:.6g}; it must "
                               "be finite and not negative",
                               brdf.name, value.scale, value.bias, direction_text(wo),
                               direction_text(directions[k]), roughness)};
    const double weight = q.weight[direction_at[k]];
    q.density[direction_at[k]] = value.scale;
    q.n1 += weight * value.scale;
    q.n5 += weight * value.bias;
  }
  if (!(q.n1 > 1e-12 && std::isfinite(q.n1)))
    return Error{fmt::format("brdf {}: it reflects nothing for wo {}, roughness {:.6g} (albedo {})",
                             brdf.name, direction_text(wo), roughness, q.n1)};
  for (std::size_t i = 0; i < padded; ++i) {
    q.density[i] /= q.n1;
    const double square = q.weight[i] * q.density[i] * q.density[i];
    q.norm2 += square;
    q.norm3 += square * q.density[i];
  }
  return q;
}

// What a BRDF of the user's throws becomes an error.
template <class Body> auto guarded(const brdf::Brdf& brdf, Body body) -> decltype(body()) {
  if (!brdf.eval) return Error{fmt::format("brdf {}: it has no function to evaluate", brdf.name)};
  try {
    return body();
  } catch (const std::exception& e) {
    return Error{fmt::format("brdf {}: its function threw: {}", brdf.name, e.what())};
  } catch (...) {
    return Error{fmt::format("brdf {}: its function threw", brdf.name)};
  }
}

} // namespace

Result<Quadrature> make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   HalfVectors half_vectors, QuadratureSize size) {
  return guarded(brdf, [&] { return make_rule(brdf, roughness, cos_theta, half_vectors, size); });
}

Result<Quadrature> make_quadrature(const brdf::Brdf& brdf, double roughness, double cos_theta,
                                   QuadratureSize size) {
  return guarded(brdf, [&] {
    return make_rule(brdf, roughness, cos_theta, find_half_vectors(brdf, roughness), size);
  });
}

Result<QuadratureSize> choose_quadrature(const brdf::Brdf& brdf) {
  constexpr double k_agreement = 0.01;
  constexpr QuadratureSize k_sizes[] = {{20, 32}, {40, 64}, {80, 128}};
  const std::vector<double> probes =
      brdf.has_parameter() ? std::vector<double>{0.02, 0.1, 0.4, 0.8} : std::vector<double>{1.0};
  double apart = 0, roughness_there = 0, degrees_there = 0;
  for (const QuadratureSize size : k_sizes) {
    apart = 0;
    for (const double roughness : probes) {
      for (const double degrees : {0.0, 25.0, 50.0, 75.0}) {
        const double c = std::cos(degrees * f64::k_pi / 180);
        const Result<Quadrature> coarse = make_quadrature(brdf, roughness, c, size);
        const Result<Quadrature> fine =
            make_quadrature(brdf, roughness, c, {2 * size.radial, 2 * size.azimuths});
        if (!coarse) return coarse.error();
        if (!fine) return fine.error();
        const double here = std::abs(coarse->n1 - fine->n1) / fine->n1;
        if (here > apart) {
          apart = here;
          roughness_there = roughness;
          degrees_there = degrees;
        }
      }
    }
    if (apart < k_agreement) return size;
  }
  return Error{fmt::format("brdf {}: its albedo at roughness {:g}, theta {:g} degrees does not "
                           "settle with more points (still {:.0f} % apart): a lobe that narrow "
                           "away from the mirror direction is not found",
                           brdf.name, roughness_there, degrees_there, apart * 100)};
}

} // namespace openltc::fit
