// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Each row of the table, one view angle, is swept from roughness 1 to 0: at roughness 1 the BRDF is
// close to the cosine lobe, from which the fit starts, and every further node starts from the
// previous one. In mirror packing the coefficients hardly change from node to node, down to the
// mirror. Rows know nothing of each other, so they run in parallel and threads cannot matter. A
// BRDF without a parameter has one column, which is swept from normal incidence to grazing.
//
// Refinement then moves all nodes together so that the lobes between them, as the bilinear look-up
// gives them, fit best (joint_fit.h). At 64 nodes hardly anything is left to win; at 16 the mean TV
// at low roughness falls by a third, at 8 by half.

#include "openltc/fit/table_fit.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/joint/joint_fit.h"
#include "openltc/fit/joint/table_samples.h"
#include "openltc/fit/lobe_start.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace openltc::fit {

namespace {

using table::LobeTable;

struct Node {
  Vec4d mirror{1, 0, 0, 1};
  double n1 = 0, n5 = 0;
};

// All that the steps below share.
struct Grid {
  const brdf::Brdf& brdf;
  const TableFitOptions& options;
  int columns, rows;
  QuadratureSize quadrature;
  std::vector<HalfVectors> half_vectors; // find_half_vectors of each column
  std::vector<Node> nodes;

  double roughness(double column) const { return columns > 1 ? column / (columns - 1) : 1.0; }
  Node& node(int column, int row) {
    return nodes[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
  }
};

// Rule at a node, and its amplitudes, which the grazing row takes elsewhere than its lobe.
Result<Quadrature> node_rule(const Grid& grid, int column, int row, Node& node) {
  const GrazingRow grazing = grazing_row(grid.rows, grid.options.angle_axis);
  const double c =
      row == 0 ? 1.0 : cosine_at(double(row) / (grid.rows - 1), grid.options.angle_axis);
  const auto rule_at = [&](double cos_theta) {
    return make_quadrature(grid.brdf, grid.roughness(column), cos_theta,
                           grid.half_vectors[std::size_t(column)], grid.quadrature);
  };
  const bool last = row == grid.rows - 1;
  Result<Quadrature> rule = rule_at(last ? grazing.lobe_cosine : c);
  if (!rule) return rule;
  node.n1 = rule->n1;
  node.n5 = rule->n5;
  if (!last) return rule;
  const Result<Quadrature> amplitude = rule_at(grazing.amplitude_cosine);
  if (!amplitude) return amplitude;
  node.n1 = amplitude->n1;
  node.n5 = amplitude->n5;
  return rule;
}

Status fit_row(Grid& grid, int row) {
  Vec4d start;
  for (int column = grid.columns - 1; column >= 0; --column) {
    Node& node = grid.node(column, row);
    const Result<Quadrature> rule = node_rule(grid, column, row, node);
    if (!rule) return rule.error();
    if (column == grid.columns - 1) {
      const LobeFit first = fit_from_starts(*rule, {}, grid.options.lobe);
      start = node.mirror = first.mirror;
    } else {
      node.mirror = fit_from_neighbour(*rule, start, grid.options.lobe).mirror;
    }
  }
  return Success{};
}

Status fit_single_column(Grid& grid) {
  Vec4d previous = cosine_start(1, 1);
  for (int row = 0; row < grid.rows; ++row) {
    Node& node = grid.node(0, row);
    const Result<Quadrature> rule = node_rule(grid, 0, row, node);
    if (!rule) return rule.error();
    previous = node.mirror =
        fit_from_starts(*rule, std::span<const Vec4d>(&previous, 1), grid.options.lobe).mirror;
  }
  return Success{};
}

Status refine(Grid& grid, Progress progress) {
  Result<std::vector<JointSample>> samples = make_table_samples(
      grid.brdf, {grid.columns, grid.rows}, grid.options.angle_axis, grid.quadrature);
  if (!samples) return samples.error();
  std::vector<Vec4d> mirror;
  std::vector<double> n1, n5, wanted1, wanted5;
  for (const Node& node : grid.nodes) {
    mirror.push_back(node.mirror);
    n1.push_back(node.n1);
    n5.push_back(node.n5);
  }
  for (const JointSample& sample : *samples) {
    wanted1.push_back(sample.rule.n1);
    wanted5.push_back(sample.rule.n5);
  }
  JointFitOptions joint;
  joint.objective = grid.options.lobe.objective;
  joint.least_determinant = k_least_determinant;
  joint.progress = std::move(progress);
  JointFit fitted = fit_jointly(*samples, mirror, joint);
  if (fitted.cancelled) return cancelled();
  mirror = std::move(fitted.unknowns);
  n1 = interpolate_jointly(*samples, wanted1, {}, n1);
  n5 = interpolate_jointly(*samples, wanted5, {}, n5);
  // Least squares may overshoot where the albedo bends; more than the BRDF ever reflects must not
  // be.
  const double most = std::max(
      *std::max_element(wanted1.begin(), wanted1.end()),
      std::max_element(grid.nodes.begin(), grid.nodes.end(), [](const Node& a, const Node& b) {
        return a.n1 < b.n1;
      })->n1);
  for (std::size_t i = 0; i < grid.nodes.size(); ++i) {
    const double albedo = std::clamp(n1[i], 0.0, most);
    grid.nodes[i] = {mirror[i], albedo, std::clamp(n5[i], 0.0, albedo)};
  }
  return Success{};
}

LobeTable pack(const Grid& grid) {
  LobeTable result;
  result.columns = grid.columns;
  result.rows = grid.rows;
  result.angle_axis = grid.options.angle_axis;
  result.width = grid.brdf.width;
  result.texels.reserve(grid.nodes.size() * LobeTable::k_channels);
  for (const Node& node : grid.nodes)
    for (const double value :
         {node.mirror.x, node.mirror.y, node.mirror.z, node.mirror.w, node.n1, node.n5, 0.0, 0.0})
      result.texels.push_back(round_to_six_digits(value));
  return result;
}

// Between the nodes the determinant must stay positive too: looked at on a fine grid.
Status check_lobes(const brdf::Brdf& brdf, const LobeTable& t) {
  for (const float value : t.texels)
    if (!std::isfinite(value))
      return Error{fmt::format("brdf {}: the fit of a {}-node table gave a value that is not "
                               "finite; please report this with the command line",
                               brdf.name, t.rows)};
  constexpr int k_per_cell = 4;
  const int across = std::max(1, (t.columns - 1) * k_per_cell);
  for (int j = 0; j <= (t.rows - 1) * k_per_cell; ++j) {
    for (int i = 0; i <= across; ++i) {
      const double x = t.columns > 1 ? double(i) / across : 1;
      const double y = double(j) / ((t.rows - 1) * k_per_cell);
      const double alpha = f64::alpha_from_roughness(x);
      const double width = t.width == brdf::LobeWidth::alpha ? alpha : 1.0;
      const Vec4d m = f64::lobe_table_texel(t.view(), {x, y}).coefficients;
      if (!(m.x * m.w - width * m.y * m.z > 0))
        return Error{fmt::format(
            "brdf {}: the lobes of neighbouring nodes do not interpolate near roughness {:.3f}, "
            "theta {:.1f} degrees; openltc fit --size, --objective "
            "balanced and --refine change them",
            brdf.name, x, std::acos(cosine_at(y, t.angle_axis)) * 180 / f64::k_pi)};
    }
  }
  return Success{};
}

} // namespace

double cosine_at(double position, table::AngleAxis axis) {
  if (axis == table::AngleAxis::sqrt_one_minus_cos) return 1 - position * position;
  return std::cos(position * 0.5 * f64::k_pi);
}

// With 64 nodes the last cell reaches from 88.2 to 90 degrees. Mean errors over it, by the share of
// the cell's cosines at which the last row is fitted (roughness .01-.06 / .06-1, 20 x 17 points):
//   share   TV            n1
//   .02     .056 / .182   .026 / .007
//   .05     .073 / .183   .023 / .006
//   .10     .101 / .184   .018 / .005
//   .30     .185 / .190   .011 / .010
GrazingRow grazing_row(int rows, table::AngleAxis axis) {
  const double cell = cosine_at(double(rows - 2) / (rows - 1), axis);
  return {0.03 * cell, 0.1 * cell};
}

Result<LobeTable> fit_table(const brdf::Brdf& brdf, const TableFitOptions& options,
                            const Progress& progress) {
  if (options.size < 2 || options.size > 512)
    return Error{fmt::format("table size {}: choose 2 to 512 nodes per axis", options.size)};

  Result<QuadratureSize> quadrature =
      options.quadrature ? Result<QuadratureSize>(*options.quadrature) : choose_quadrature(brdf);
  if (!quadrature) return quadrature.error();

  Grid grid{brdf, options, brdf.has_parameter() ? options.size : 1, options.size, *quadrature,
            {},   {}};
  grid.nodes.resize(std::size_t(grid.columns) * std::size_t(grid.rows));
  for (int i = 0; i < grid.columns; ++i)
    grid.half_vectors.push_back(find_half_vectors(brdf, grid.roughness(i)));

  const bool refined =
      options.refine == Refine::on || (options.refine == Refine::automatic &&
                                       (options.size <= k_refined_size || grid.columns == 1));
  if (grid.columns == 1) {
    if (Status status = fit_single_column(grid); !status) return status.error();
  } else {
    ProgressCount done(grid.rows, part_of(progress, 0.0, refined ? 0.3 : 1.0));
    std::vector<std::string> failures(std::size_t(grid.rows));
    parallel_for(grid.rows, 0, [&](std::int64_t index) {
      const int row = int(index);
      if (done.is_cancelled()) return;
      if (const Status status = fit_row(grid, row); !status)
        failures[std::size_t(row)] = status.error().message;
      done.add(1);
    });
    if (done.is_cancelled()) return cancelled();
    if (Status status = first_failure(failures); !status) return status.error();
  }
  const std::vector<Node> unrefined = grid.nodes;
  if (refined)
    if (Status status = refine(grid, part_of(progress, 0.3, 0.9)); !status) return status.error();
  if (progress && (refined || grid.columns == 1) && !progress(1.0)) return cancelled();

  LobeTable result = pack(grid);
  Status status = check_lobes(brdf, result);
  if (!status && refined && options.refine == Refine::automatic) {
    grid.nodes = unrefined;
    result = pack(grid);
    status = check_lobes(brdf, result);
  }
  if (!status) return status.error();
  result.metadata.brdf = brdf.name;
  result.metadata.variant = brdf.variant;
  result.metadata.objective = options.lobe.objective.name;
  result.metadata.horizon = name_of(options.lobe.objective.horizon);
  return result;
}

void complete_metadata(table::TableMetadata& metadata, const TableError& error,
                       const char* tool_version, const std::string& command) {
  const auto four_digits = [](double x) {
    return std::strtod(fmt::format("{:.3e}", x).c_str(), nullptr);
  };
  metadata.mean_tv = four_digits(error.mean.tv);
  metadata.max_tv = four_digits(error.max.tv);
  metadata.tool_version = tool_version;
  metadata.command = command;
}

} // namespace openltc::fit
