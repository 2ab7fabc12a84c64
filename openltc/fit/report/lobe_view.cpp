// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/lobe_view.h"

#include "openltc/fit/measure/error.h"

#include <algorithm>
#include <cmath>

namespace openltc::fit {

Density density_of(const brdf::Brdf& brdf, const Quadrature& q) {
  const Vec3d wo(std::sqrt(1 - q.cos_theta * q.cos_theta), 0, q.cos_theta);
  return [&brdf, wo, roughness = q.roughness, n1 = q.n1](std::span<const Vec3d> wi,
                                                         std::span<double> values) {
    std::vector<Vec3d> above;
    for (const Vec3d& w : wi)
      if (w.z > 0) above.push_back(w);
    std::vector<brdf::BrdfValue> found(above.size());
    brdf::eval_all(brdf, wo, above, roughness, found);
    for (std::size_t i = 0, k = 0; i < wi.size(); ++i)
      values[i] = wi[i].z > 0 ? found[k++].scale / n1 : 0;
  };
}

Density density_of(const f64::Lobe& lobe, Horizon horizon) {
  const double scale = horizon_scale(lobe, horizon);
  return [lobe, scale](std::span<const Vec3d> wi, std::span<double> values) {
    for (std::size_t i = 0; i < wi.size(); ++i) // one inside out would be negative
      values[i] = std::max(scale * f64::eval_lobe(lobe, wi[i]), 0.0);
  };
}

Density density_of(const MeasuredLobe& fitted, Horizon horizon) {
  const Density first = density_of(fitted.lobe, horizon);
  if (!fitted.two()) return first;
  const double w = fitted.second.weight;
  return [first, second = density_of(fitted.second.lobe, horizon), w](std::span<const Vec3d> wi,
                                                                      std::span<double> values) {
    std::vector<double> beside(wi.size());
    first(wi, values);
    second(wi, beside);
    for (std::size_t i = 0; i < wi.size(); ++i)
      values[i] = (1 - w) * values[i] + w * beside[i];
  };
}

DiscWindow window_of_lobe(const Quadrature& q) {
  const double c = q.cos_theta, s = std::sqrt(std::max(0.0, 1 - c * c));
  double mean = 0, square = 0, across = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double x = s * q.z_mirror[i] - c * q.x_mirror[i]; // towards the mirror direction
    const double z = s * q.x_mirror[i] + c * q.z_mirror[i];
    const double inv2 = 1 / (1 + std::max(z, 0.0));
    const double energy = q.weight[i] * q.density[i];
    mean += energy * x * std::sqrt(inv2);
    square += energy * x * x * inv2;
    across += energy * q.y[i] * q.y[i] * inv2;
  }
  const double deviation = std::sqrt(std::max({square - mean * mean, across, 0.0}));
  DiscWindow window;
  if (3 * deviation < 0.55) {
    window.center_x = mean;
    window.half = std::max(3 * deviation, 1e-4);
  }
  return window;
}

double mirror_in_disc(double cos_theta) {
  return std::sqrt(std::max(0.0, 1 - cos_theta * cos_theta)) / std::sqrt(1 + cos_theta);
}

std::vector<double> sample_disc(const Density& density, const DiscWindow& window, int side) {
  std::vector<double> disc(std::size_t(side) * std::size_t(side), -1);
  std::vector<Vec3d> directions;
  std::vector<std::size_t> places;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = window.center_x + window.half * (2 * (column + 0.5) / side - 1);
      const double y = window.half * (1 - 2 * (row + 0.5) / side);
      const double r2 = x * x + y * y, stretch = std::sqrt(std::max(0.0, 2 - r2));
      if (!(r2 < 1)) continue;
      directions.emplace_back(-x * stretch, y * stretch, 1 - r2);
      places.push_back(std::size_t(row) * std::size_t(side) + std::size_t(column));
    }
  }
  std::vector<double> values(directions.size());
  density(directions, values);
  for (std::size_t i = 0; i < places.size(); ++i)
    disc[places[i]] = values[i];
  return disc;
}

} // namespace openltc::fit
