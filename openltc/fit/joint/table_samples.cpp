// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/joint/table_samples.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/table_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace openltc::fit {

namespace {

// Cosine that stands in for 0 on the rim, and what its samples count.
constexpr double k_rim_cosine = 1e-4;
constexpr double k_rim_weight = 1e-3;

} // namespace

float round_to_six_digits(double x) {
  // Through text: the float is the one nearest to the decimal number, in every library alike.
  return std::strtof(fmt::format("{:.5e}", x).c_str(), nullptr);
}

Status first_failure(const std::vector<std::string>& failures) {
  for (const std::string& failure : failures)
    if (!failure.empty()) return Error{failure};
  return Success{};
}

Result<std::vector<JointSample>> make_table_samples(const brdf::Brdf& brdf, TableShape shape,
                                                    table::AngleAxis axis,
                                                    QuadratureSize quadrature) {
  const int per_cell = std::max(2, 40 / shape.rows);
  const int across = shape.columns > 1 ? (shape.columns - 1) * per_cell : 1;
  const int along = (shape.rows - 1) * per_cell;
  std::vector<HalfVectors> half_vectors, rim_half_vectors;
  for (int i = 0; i < across; ++i)
    half_vectors.push_back(
        find_half_vectors(brdf, shape.roughness(shape.columns > 1 ? (i + 0.5) / per_cell : 0)));
  for (int i = 0; i < shape.columns; ++i)
    rim_half_vectors.push_back(find_half_vectors(brdf, shape.roughness(i)));
  // Beyond the last sample the grazing row would be free: its own nodes are samples too, which
  // count little as places to fit and fully where the determinant must stay positive.
  const std::size_t between = std::size_t(across) * std::size_t(along);
  std::vector<JointSample> samples(between + std::size_t(shape.columns));
  std::vector<std::string> failures(samples.size());
  parallel_for(std::int64_t(samples.size()), 0, [&](std::int64_t index) {
    const std::size_t k = std::size_t(index);
    const bool rim = k >= between;
    const int i = rim ? int(k - between) : int(k) % across;
    const double x = rim ? i : shape.columns > 1 ? (i + 0.5) / per_cell : 0;
    const double y = rim ? shape.rows - 1 : (int(k) / across + 0.5) / per_cell;
    JointSample& sample = samples[k];
    Result<Quadrature> rule = make_quadrature(
        brdf, shape.roughness(x), rim ? k_rim_cosine : cosine_at(y / (shape.rows - 1), axis),
        rim ? rim_half_vectors[std::size_t(i)] : half_vectors[std::size_t(i)], quadrature);
    if (!rule) {
      failures[k] = rule.error().message;
      return;
    }
    sample.rule = std::move(*rule);
    sample.weight = rim ? k_rim_weight : 1.0;
    const int x0 = int(x), y0 = int(y);
    for (int corner = 0; corner < 4; ++corner) {
      const int right = corner % 2, down = corner / 2;
      const double share = (right ? x - x0 : 1 - (x - x0)) * (down ? y - y0 : 1 - (y - y0));
      if (share > 0) sample.terms.push_back({(y0 + down) * shape.columns + x0 + right, share});
    }
  });
  if (Status status = first_failure(failures); !status) return status.error();
  return samples;
}

} // namespace openltc::fit
