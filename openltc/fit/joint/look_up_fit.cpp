// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The unknowns are the texels as they are stored; at every sample the layout's own look-up makes a
// lobe of what is interpolated there, whose coefficients in the mirror frame the objective knows.
// A lobe below roughness .06 is narrower than what its direction is off by between nodes that are
// right by themselves. Nodes that are fitted together share that error, to both sides.

#include "openltc/fit/joint/look_up_fit.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/joint_fit.h"
#include "openltc/fit/joint/table_samples.h"
#include "openltc/fit/table_fit.h"
#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace openltc::fit {

namespace {

using table::PackedTable;

constexpr int k_per_cell = 2; ///< samples along each axis of a cell
/// What samples at the nodes and at the rim count: little as places to fit, fully where the
/// determinant must stay positive.
constexpr double k_guard_weight = 1e-3;
constexpr double k_rim_cosine = 1e-4; ///< stands in for 0

// What a sample's look-up makes of the interpolated first texture, `second` being what it reads of
// the other one.
std::function<Vec4d(Vec4d)> reader(const PackedTable& packed, const Quadrature& rule, Vec2d at) {
  std::array<double, 4> second = {};
  if (packed.textures.size() > 1)
    second =
        table::sample_texture(packed.textures[1], f64::table_coordinate(at.x, packed.columns()),
                              f64::table_coordinate(at.y, packed.rows()));
  return [=, layout = packed.layout, width = rule.width, c = rule.cos_theta](Vec4d texel) {
    const double first[4] = {texel.x, texel.y, texel.z, texel.w};
    return f64::mirror_from_lobe(table::lobe_of_texel(layout, first, second, width, c).lobe, width,
                                 c);
  };
}

// The shares of the four nodes around a position.
std::vector<JointTerm> terms_at(const PackedTable& packed, Vec2d at) {
  const int columns = packed.columns(), rows = packed.rows();
  const double x = at.x * (columns - 1), y = at.y * (rows - 1);
  const int x0 = std::min(int(x), std::max(columns - 2, 0)), y0 = std::min(int(y), rows - 2);
  std::vector<JointTerm> terms;
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner % 2, down = corner / 2;
    const double share = (right ? x - x0 : 1 - (x - x0)) * (down ? y - y0 : 1 - (y - y0));
    if (share > 0) terms.push_back({(y0 + down) * columns + x0 + right, share});
  }
  return terms;
}

Result<std::vector<JointSample>> make_samples(const brdf::Brdf& brdf, const PackedTable& packed) {
  const Result<QuadratureSize> size = choose_quadrature(brdf);
  if (!size) return size.error();
  const int columns = packed.columns(), rows = packed.rows();
  const int across = columns > 1 ? (columns - 1) * k_per_cell : 1;
  const int along = (rows - 1) * k_per_cell;
  std::vector<std::vector<JointSample>> by_roughness(std::size_t(across + columns));
  std::vector<std::string> failures(by_roughness.size());
  parallel_for(std::int64_t(by_roughness.size()), 0, [&](std::int64_t index) {
    const int node = int(index) - across; // from 0 on: samples at the nodes of this column
    const double roughness = node >= 0     ? table::column_roughness(packed.layout, columns, node)
                             : columns > 1 ? (double(index) + 0.5) / across
                                           : 1;
    const HalfVectors half_vectors = find_half_vectors(brdf, roughness);
    const auto add = [&](double cos_theta, double weight, const Vec2d* at_node) {
      Result<Quadrature> rule = make_quadrature(brdf, roughness, cos_theta, half_vectors, *size);
      if (!rule) {
        failures[std::size_t(index)] = rule.error().message;
        return;
      }
      const Vec2d at = at_node ? *at_node : table::look_up_position(packed, roughness, cos_theta);
      JointSample& sample = by_roughness[std::size_t(index)].emplace_back();
      sample.weight = weight;
      sample.terms = terms_at(packed, at);
      sample.read = reader(packed, *rule, at);
      sample.rule = std::move(*rule);
    };
    if (node < 0) {
      for (int row = 0; row < along; ++row)
        add(cosine_at((row + 0.5) / along, packed.angle_axis), 1, nullptr);
      add(k_rim_cosine, k_guard_weight, nullptr);
      return;
    }
    for (int row = 0; row < rows; ++row) {
      const Vec2d at{double(node) / std::max(columns - 1, 1), double(row) / (rows - 1)};
      add(table::row_cosine(packed.layout, packed.angle_axis, rows, row), k_guard_weight, &at);
    }
  });
  if (Status status = first_failure(failures); !status) return status.error();
  std::vector<JointSample> samples;
  for (std::vector<JointSample>& some : by_roughness)
    std::move(some.begin(), some.end(), std::back_inserter(samples));
  return samples;
}

} // namespace

Status refine_look_up(const brdf::Brdf& brdf, PackedTable& packed, const Objective& objective,
                      const Progress& progress) {
  const Result<std::vector<JointSample>> samples = make_samples(brdf, packed);
  if (!samples) return samples.error();
  std::vector<float>& values = packed.textures[0].values;
  std::vector<Vec4d> texels;
  for (std::size_t i = 0; i < values.size(); i += 4)
    texels.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
  JointFitOptions options;
  options.objective = objective;
  options.least_determinant = k_least_determinant;
  options.held = packed.columns();
  options.progress = progress;
  const JointFit fitted = fit_jointly(*samples, std::move(texels), options);
  if (fitted.cancelled) return cancelled();
  for (std::size_t i = 0; i < fitted.unknowns.size(); ++i) {
    const Vec4d& t = fitted.unknowns[i];
    const double channels[4] = {t.x, t.y, t.z, t.w};
    std::transform(channels, channels + 4, values.begin() + std::ptrdiff_t(4 * i),
                   round_to_six_digits);
  }
  return Success{};
}

} // namespace openltc::fit
