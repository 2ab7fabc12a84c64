// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Each row of the table, one view angle, is swept from roughness 1 to 0: at roughness 1 the BRDF is
// close to the cosine lobe, from which the fit starts, and every further node starts from the
// previous one. In mirror packing the coefficients hardly change from node to node, down to the
// mirror. Rows know nothing of each other, so they run in parallel and threads cannot matter.

#include "openltc/fit/table_fit.h"

#include "openltc/target/shade_f64.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>

namespace openltc::fit {

namespace {

float round_to_six_digits(double x) {
  // Through text: the float is the one nearest to the decimal number, in every library alike.
  return std::strtof(fmt::format("{:.5e}", x).c_str(), nullptr);
}

void fit_row(const brdf::Brdf& brdf, const TableFitOptions& options, int row,
             table::LobeTable& result) {
  const int last = options.size - 1;
  const double y = double(row) / last;
  const GrazingRow grazing = grazing_row(options.size);
  const double cos_theta = std::max(1 - y * y, grazing.lobe_cosine);
  const double amplitude_cosine = std::max(1 - y * y, grazing.amplitude_cosine);
  Vec4d start = cosine_start(1.0, cos_theta);
  for (int column = last; column >= 0; --column) {
    const double roughness = double(column) / last;
    const Quadrature rule = make_quadrature(brdf, roughness, cos_theta, options.quadrature).value();
    const Quadrature fine =
        make_quadrature(brdf, roughness, amplitude_cosine, options.quadrature).value();
    const LobeFit fit = fit_lobe(rule, start, options.lobe);
    start = fit.mirror;
    const double channels[table::LobeTable::k_channels] = {
        fit.mirror.x, fit.mirror.y, fit.mirror.z, fit.mirror.w, fine.n1, fine.n5, 0, 0};
    for (int k = 0; k < table::LobeTable::k_channels; ++k)
      result.texel(column, row)[k] = round_to_six_digits(channels[k]);
  }
}

} // namespace

// With 64 nodes the last cell reaches from 88.2 to 90 degrees. Mean errors over it, by the share of
// the cell's cosines at which the last row is fitted (roughness .01-.06 / .06-1, 20 x 17 points):
//   share   TV            n1
//   .02     .056 / .182   .026 / .007
//   .05     .073 / .183   .023 / .006
//   .10     .101 / .184   .018 / .005
//   .30     .185 / .190   .011 / .010
GrazingRow grazing_row(int size) {
  const double y = double(size - 2) / (size - 1);
  const double cell = 1 - y * y;
  return {0.03 * cell, 0.1 * cell};
}

Result<table::LobeTable> fit_table(const brdf::Brdf& brdf, const TableFitOptions& options,
                                   const std::function<void(double)>& progress) {
  if (options.size < 2 || options.size > 512)
    return Error{fmt::format("table size {}: choose 2 to 512 nodes per axis", options.size)};

  table::LobeTable result;
  result.columns = result.rows = options.size;
  result.width = brdf.width;
  result.texels.assign(std::size_t(options.size) * options.size * table::LobeTable::k_channels, 0);

  std::mutex mutex;
  int done = 0;
  tbb::parallel_for(
      tbb::blocked_range<int>(0, options.size, 1),
      [&](const tbb::blocked_range<int>& rows) {
        for (int row = rows.begin(); row != rows.end(); ++row) {
          fit_row(brdf, options, row, result);
          const std::lock_guard<std::mutex> lock(mutex);
          ++done;
          if (progress) progress(double(done) / options.size);
        }
      },
      tbb::simple_partitioner());

  for (const float value : result.texels)
    if (!std::isfinite(value))
      return Error{fmt::format("brdf {}: the fit of a {}-node table gave a value that is not "
                               "finite; please report this with the command line",
                               brdf.name, options.size)};

  result.metadata.brdf = brdf.name;
  result.metadata.variant = brdf.variant;
  result.metadata.objective =
      fmt::format("total variation (rounding {}) + {} * relative squared L2", options.lobe.rounding,
                  options.lobe.l2_weight);
  return result;
}

void describe_table(table::LobeTable& table, const TableError& error, const char* tool_version) {
  const auto four_digits = [](double x) {
    return std::strtod(fmt::format("{:.3e}", x).c_str(), nullptr);
  };
  table.metadata.mean_tv = four_digits(error.mean.tv);
  table.metadata.max_tv = four_digits(error.max.tv);
  table.metadata.tool_version = tool_version;
  table.metadata.command =
      fmt::format("openltc fit --brdf {} --size {}", table.metadata.brdf, table.rows);
}

} // namespace openltc::fit
