// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/error.h"

#include "openltc/fit/lobe_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace openltc::fit {

namespace {

constexpr std::array k_fields = {&LobeError::tv, &LobeError::l1,   &LobeError::l2,
                                 &LobeError::l3, &LobeError::peak, &LobeError::leak,
                                 &LobeError::n1, &LobeError::n5};

} // namespace

LobeError measure_lobe(const Quadrature& q, const f64::Lobe& lobe) {
  const Vec4d mirror = f64::mirror_from_lobe(lobe, q.width, q.cos_theta);
  double l1 = 0, l2 = 0, l3 = 0, norm2 = 0, norm3 = 0, peak = 0, peak_of_brdf = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double d =
        lobe_density(mirror, q.width, Vec3d(q.x_mirror[i], q.y[i], q.z_mirror[i])).value;
    const double r = std::abs(d - q.density[i]);
    const double w = q.weight[i];
    l1 += w * r;
    l2 += w * r * r;
    l3 += w * r * r * r;
    norm2 += w * q.density[i] * q.density[i];
    norm3 += w * q.density[i] * q.density[i] * q.density[i];
    peak = std::max(peak, d);
    peak_of_brdf = std::max(peak_of_brdf, q.density[i]);
  }
  LobeError e;
  e.leak = lobe_leak(mirror, q.width, q.cos_theta);
  e.l1 = l1;
  e.tv = 0.5 * (l1 + e.leak);
  e.l2 = std::sqrt(l2 / norm2);
  e.l3 = std::cbrt(l3 / norm3);
  e.peak = std::abs(peak / peak_of_brdf - 1);
  return e;
}

double mean_second_difference(const table::LobeTable& table) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < table.rows; ++y) {
    for (int x = 0; x < table.columns; ++x) {
      for (int k = 0; k < 4; ++k) {
        const double here = double(table.texel(x, y)[k]);
        if (x > 0 && x + 1 < table.columns) {
          sum += std::abs(double(table.texel(x - 1, y)[k]) - 2 * here +
                          double(table.texel(x + 1, y)[k]));
          ++count;
        }
        if (y > 0 && y + 1 < table.rows) {
          sum += std::abs(double(table.texel(x, y - 1)[k]) - 2 * here +
                          double(table.texel(x, y + 1)[k]));
          ++count;
        }
      }
    }
  }
  return count > 0 ? sum / count : 0;
}

LobeFunction lobes_of(const table::LobeTable& table) {
  return [&table](double roughness, double cos_theta) {
    const double alpha = f64::alpha_from_roughness(roughness);
    const double width = table.width == brdf::LobeWidth::alpha ? alpha : 1.0;
    return f64::fetch_lobe_of_width(table.view(), alpha, width, cos_theta);
  };
}

Result<TableError> measure_lobes(const brdf::Brdf& brdf, const LobeFunction& lobes,
                                 const MeasureOptions& options) {
  const int n = options.points;
  std::vector<LobeError> errors(std::size_t(n) * n);
  std::vector<std::string> failures(errors.size());
  tbb::parallel_for(0, n * n, [&](int k) {
    const double roughness = options.roughness_from +
                             (options.roughness_to - options.roughness_from) * (k % n + 0.5) / n;
    const double theta = options.theta_to_degrees * (k / n + 0.5) / n * f64::k_pi / 180;
    const double cos_theta = std::cos(theta);
    const Result<Quadrature> rule = make_quadrature(brdf, roughness, cos_theta, options.quadrature);
    if (!rule) {
      failures[std::size_t(k)] = rule.error().message;
      return;
    }
    const f64::FittedLobe fitted = lobes(roughness, cos_theta);
    LobeError& e = errors[std::size_t(k)];
    e = measure_lobe(*rule, fitted.lobe);
    e.n1 = std::abs(fitted.n1 - rule->n1);
    e.n5 = std::abs(fitted.n5 - rule->n5);
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) return Error{failure};

  TableError result;
  result.roughness_from = options.roughness_from;
  result.roughness_to = options.roughness_to;
  result.theta_to_degrees = options.theta_to_degrees;
  result.points = n;
  // Sums in a fixed order.
  for (const auto field : k_fields) {
    std::vector<double> values;
    double sum = 0;
    for (const LobeError& e : errors) {
      values.push_back(e.*field);
      sum += e.*field;
    }
    std::sort(values.begin(), values.end());
    result.mean.*field = sum / double(values.size());
    result.p95.*field = values[std::size_t(0.95 * double(values.size() - 1))];
    result.max.*field = values.back();
  }
  return result;
}

} // namespace openltc::fit
