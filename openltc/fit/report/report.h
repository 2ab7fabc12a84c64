// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The report of a fit: every figure that says how far lobes are from their BRDF, for several
// candidates side by side, as text, as JSON and as a page.

#pragma once

#include "openltc/fit/measure/error.h"
#include "openltc/fit/measure/light_error.h"
#include "openltc/fit/report/lobe_view.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace openltc::fit {

/// One set of lobes to report on. The first of a report is its subject; the others are compared
/// with it.
struct Candidate {
  std::string label; ///< short: a column's heading
  LobeFunction lobes;
  Horizon horizon = Horizon::leaking;
  std::vector<std::pair<std::string, std::string>> metadata; ///< name and value, as to be shown
  /// The table whose nodes are measured besides the points between them; empty axes for none.
  MeasureAxes nodes;
  /// The best single lobe at each point, no table: it has no smoothness and is not among the worst.
  bool is_limit = false;
};

struct ReportOptions {
  std::string title = "Error of a lobe table";
  std::string command;      ///< the command line that made the report
  std::string tool_version; ///< of OpenLTC
  /// What is measured between the nodes. The worst cells are those of the first.
  std::vector<MeasureOptions> regions = default_regions();
  LightFamily lights;         ///< of no members: the lights are not measured
  int smoothness_points = 64; ///< see mean_second_difference
  int worst_cells = 4;        ///< of the subject; half as many of each other candidate

  /// Roughness .06-1, what scenes use, and .01-.06, the nearly specular end.
  static std::vector<MeasureOptions> default_regions();
};

/// One region, one entry per candidate in each vector.
struct RegionReport {
  std::string name; ///< "roughness 0.06–1"
  MeasureOptions region;
  std::vector<ErrorMap> maps;
  std::vector<TableError> errors;               ///< of the maps
  std::vector<std::optional<TableError>> nodes; ///< on the nodes that lie in the region
};

/// Density per solid angle over a window of the hemisphere seen from above (lobe_view.h), and along
/// the plane of incidence.
struct LobePicture {
  std::vector<double> disc; ///< k_side * k_side, as sample_disc gives it
  std::vector<double> cut;  ///< at the angles of WorstCell::cut_degrees
};

/// A cell of the first region with its BRDF and lobes.
struct WorstCell {
  static constexpr int k_side = 120;
  std::size_t of = 0; ///< the candidate that is worst there
  double roughness = 0, theta_degrees = 0, albedo = 0;
  std::vector<LobeError> errors;   ///< one per candidate
  double peak = 0;                 ///< of the BRDF's lobe, 1/steradian
  DiscWindow window;               ///< of the discs
  std::vector<double> cut_degrees; ///< from the normal, positive on the mirror's side
  LobePicture brdf;
  std::vector<LobePicture> lobes; ///< one per candidate
};

/// What is known of a candidate besides its errors over the regions.
struct CandidateReport {
  std::string label;
  Horizon horizon = Horizon::leaking;
  std::vector<std::pair<std::string, std::string>> metadata;
  bool is_limit = false;
  std::optional<double> second_difference;
  LightError lights;
};

/// All figures. Plain data: the writers below compute nothing.
struct Report {
  std::string title, command, tool_version;
  std::string brdf, variant, source, parameter;
  std::vector<CandidateReport> candidates;
  std::vector<RegionReport> regions;
  LightFamily lights;
  std::vector<WorstCell> worst;
};

/// Measures everything. Neither the number of threads nor the clock changes a byte of the outputs.
/// Fails as measure_maps does, and
/// without a candidate or a region.
Result<Report> make_report(const brdf::Brdf& brdf, const std::vector<Candidate>& candidates,
                           const ReportOptions& options);

/// The short table for a terminal, UTF-8.
std::string to_text(const Report& report);

/// All figures and maps. Numbers have six significant digits; what is not finite is null.
std::string to_json(const Report& report);

/// One page that needs nothing but itself: HTML 5, UTF-8, style, figures and script inline.
std::string to_html(const Report& report);

} // namespace openltc::fit
