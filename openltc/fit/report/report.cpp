// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace openltc::fit {

namespace {

constexpr QuadratureSize k_quadrature = {40, 32};
constexpr int k_cut_points = 241;

// Cells with the largest TV, the worst first, no two of them neighbours.
std::vector<std::size_t> worst_cells(const ErrorMap& map, int count) {
  std::vector<std::size_t> order(map.cells.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return map.cells[a].tv > map.cells[b].tv; });
  const int columns = int(map.columns());
  const int apart = std::max(2, columns / 6);
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    if (int(chosen.size()) >= count) break;
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t k) {
      return std::abs(int(i) % columns - int(k) % columns) < apart &&
             std::abs(int(i) / columns - int(k) / columns) < apart;
    });
    if (!near) chosen.push_back(i);
  }
  return chosen;
}

// Along the plane of incidence, 0 at its ends.
std::vector<double> cut_values(const Density& density, const std::vector<double>& degrees) {
  std::vector<Vec3d> directions;
  for (const double d : degrees)
    directions.emplace_back(-std::sin(d * f64::k_pi / 180), 0, std::cos(d * f64::k_pi / 180));
  std::vector<double> values(degrees.size());
  density(directions, values);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(directions[i].z > 0)) values[i] = 0;
  return values;
}

// The part of the plane of incidence where the BRDF or a lobe exceeds a hundredth of the peak.
void choose_cut(const std::vector<Density>& densities, WorstCell& cell) {
  double low = 90, high = -90;
  constexpr int n = 4000;
  std::vector<double> degrees;
  for (int i = 0; i < n; ++i)
    degrees.push_back(-90 + 180 * (i + 0.5) / n);
  for (const Density& density : densities) {
    const std::vector<double> values = cut_values(density, degrees);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] < 0.01 * cell.peak) continue;
      low = std::min(low, degrees[i]);
      high = std::max(high, degrees[i]);
    }
  }
  if (!(high > low)) low = -90, high = 90;
  const double margin = 0.08 * (high - low);
  low = std::max(low - margin, -90.0);
  high = std::min(high + margin, 90.0);
  for (int i = 0; i < k_cut_points; ++i)
    cell.cut_degrees.push_back(low + (high - low) * i / (k_cut_points - 1));
}

LobePicture picture(const Density& density, const WorstCell& cell) {
  return {sample_disc(density, cell.window, WorstCell::k_side),
          cut_values(density, cell.cut_degrees)};
}

Result<WorstCell> describe_cell(const brdf::Brdf& brdf, const std::vector<Candidate>& candidates,
                                const RegionReport& region, std::size_t of, std::size_t at) {
  WorstCell cell;
  const ErrorMap& map = region.maps[of];
  cell.of = of;
  cell.roughness = map.axes.roughness[at % map.columns()];
  cell.theta_degrees = map.axes.theta_degrees[at / map.columns()];
  cell.albedo = map.albedo[at];
  for (const ErrorMap& m : region.maps)
    cell.errors.push_back(m.cells[at]);

  const double cos_theta = std::cos(cell.theta_degrees * f64::k_pi / 180);
  const Result<Quadrature> rule = make_quadrature(brdf, cell.roughness, cos_theta, k_quadrature);
  if (!rule) return rule.error();
  cell.peak = *std::max_element(rule->density.begin(), rule->density.end());
  cell.window = window_of_lobe(*rule);

  std::vector<Density> densities = {density_of(brdf, *rule)};
  for (const Candidate& candidate : candidates)
    densities.push_back(density_of(candidate.lobes(cell.roughness, cos_theta), candidate.horizon));
  choose_cut(densities, cell);
  cell.brdf = picture(densities[0], cell);
  for (std::size_t i = 1; i < densities.size(); ++i)
    cell.lobes.push_back(picture(densities[i], cell));
  return cell;
}

// The axes' points within a region.
MeasureAxes within(const MeasureAxes& axes, const MeasureOptions& region) {
  MeasureAxes kept;
  for (const double r : axes.roughness)
    if (r >= region.roughness_from && r <= region.roughness_to) kept.roughness.push_back(r);
  for (const double t : axes.theta_degrees)
    if (t <= region.theta_to_degrees) kept.theta_degrees.push_back(t);
  return kept;
}

Result<RegionReport> measure_region(const brdf::Brdf& brdf,
                                    const std::vector<Candidate>& candidates,
                                    const std::vector<MeasuredLobes>& measured,
                                    const MeasureOptions& options) {
  RegionReport region;
  region.name = fmt::format("roughness {}–{}", options.roughness_from, options.roughness_to);
  region.region = options;
  Result<std::vector<ErrorMap>> maps =
      measure_maps(brdf, measured, midpoint_axes(options), options.quadrature);
  if (!maps) return maps.error();
  region.maps = std::move(*maps);
  for (const ErrorMap& map : region.maps) {
    TableError error = summarise(map);
    error.roughness_from = options.roughness_from;
    error.roughness_to = options.roughness_to;
    error.theta_to_degrees = options.theta_to_degrees;
    region.errors.push_back(error);
  }
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    region.nodes.emplace_back();
    const MeasureAxes nodes = within(candidates[c].nodes, options);
    if (nodes.roughness.empty() || nodes.theta_degrees.empty()) continue;
    const Result<std::vector<ErrorMap>> on_nodes =
        measure_maps(brdf, {&measured[c], 1}, nodes, options.quadrature);
    if (!on_nodes) return on_nodes.error();
    region.nodes.back() = summarise(on_nodes->front());
  }
  return region;
}

} // namespace

std::vector<MeasureOptions> ReportOptions::default_regions() {
  MeasureOptions rough, sharp;
  sharp.roughness_from = 0.01;
  sharp.roughness_to = 0.06;
  return {rough, sharp};
}

Result<Report> make_report(const brdf::Brdf& brdf, const std::vector<Candidate>& candidates,
                           const ReportOptions& options) {
  if (candidates.empty()) return Error{"a report needs at least one table to report on"};
  if (options.regions.empty()) return Error{"a report needs at least one region to measure"};
  Report report;
  report.title = options.title;
  report.command = options.command;
  report.tool_version = options.tool_version;
  report.brdf = brdf.name;
  report.variant = brdf.variant;
  report.source = brdf.source;
  report.parameter = brdf.parameter;
  report.lights = options.lights;

  std::vector<MeasuredLobes> measured;
  for (const Candidate& c : candidates)
    measured.push_back({c.label, c.lobes, c.horizon});
  for (const MeasureOptions& region : options.regions) {
    Result<RegionReport> done = measure_region(brdf, candidates, measured, region);
    if (!done) return done.error();
    report.regions.push_back(std::move(*done));
  }
  Result<std::vector<LightError>> lights = std::vector<LightError>(candidates.size());
  if (options.lights.count > 0) lights = measure_lights(brdf, measured, options.lights);
  if (!lights) return lights.error();
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const Candidate& from = candidates[c];
    CandidateReport to{from.label, from.horizon, from.metadata, from.is_limit, {}, (*lights)[c]};
    if (!from.is_limit)
      to.second_difference = mean_second_difference(from.lobes, options.smoothness_points);
    report.candidates.push_back(std::move(to));
  }

  const RegionReport& first = report.regions.front();
  std::vector<std::size_t> shown;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (candidates[c].is_limit) continue;
    const int count = c == 0 ? options.worst_cells : options.worst_cells / 2;
    for (const std::size_t at : worst_cells(first.maps[c], count)) {
      if (std::find(shown.begin(), shown.end(), at) != shown.end()) continue;
      shown.push_back(at);
      Result<WorstCell> cell = describe_cell(brdf, candidates, first, c, at);
      if (!cell) return cell.error();
      report.worst.push_back(std::move(*cell));
    }
  }
  return report;
}

} // namespace openltc::fit
