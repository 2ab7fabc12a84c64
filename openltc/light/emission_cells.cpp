// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points are drawn from a mixture: with the share w by the cells of the texture, otherwise by the
// light's solid angle. With c^2 the texture's relative variance over the light, E[L^2]/E[L]^2 - 1,
// all of it stems from a share 1 / (1 + c^2) of the light's area if it is black or white; of an
// even one nothing is gained by cells. So w = 0.75 c^2 / (1 + c^2): never more than four times the
// variance of the solid angle by itself, whatever the texture.
//
// A texel of a texture that is interpolated reaches beyond its cell: of the light of one texel 3/4
// lie within it along each axis, 1/8 in either neighbour. Cells have those shares.

#include "openltc/light/emission_cells.h"

#include <algorithm>
#include <cstddef>

namespace openltc::light {

namespace {

constexpr double k_most_share = 0.75, k_least_share = 0.05;

// 1 6 1 along rows or columns, what is beyond the border being like the border.
std::vector<double> spread(const std::vector<double>& from, int columns, int rows, bool along_x) {
  std::vector<double> to(from.size());
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, columns - 1);
    y = std::clamp(y, 0, rows - 1);
    return from[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
  };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const int dx = along_x ? 1 : 0, dy = along_x ? 0 : 1;
      to[std::size_t(y) * std::size_t(columns) + std::size_t(x)] =
          (at(x - dx, y - dy) + 6 * at(x, y) + at(x + dx, y + dy)) / 8;
    }
  return to;
}

} // namespace

EmissionCells make_emission_cells(std::span<const float> texels, int columns, int rows) {
  EmissionCells cells;
  std::vector<double> weight(std::size_t(columns) * std::size_t(rows));
  for (std::size_t i = 0; i < weight.size(); ++i)
    weight[i] = double(texels[4 * i]) + double(texels[4 * i + 1]) + double(texels[4 * i + 2]);
  weight = spread(spread(weight, columns, rows, true), columns, rows, false);
  double sum = 0, squares = 0, covered = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const double cover = double(texels[4 * i + 3]);
    if (!(cover > 0)) weight[i] = 0;
    sum += weight[i];
    squares += cover > 0 ? weight[i] * weight[i] / cover : 0;
    covered += cover;
  }
  if (!(sum > 0)) return cells;
  const double lit = std::min(sum / squares * (sum / covered), 1.0); // 1 / (1 + c^2)
  const double share = k_most_share * (1 - lit);
  if (!(share >= k_least_share)) return cells;

  cells.share = float(share);
  double before = 0;
  for (int y = 0; y < rows; ++y) {
    const double* const row = weight.data() + std::size_t(y) * std::size_t(columns);
    double row_sum = 0;
    for (int x = 0; x < columns; ++x)
      row_sum += row[x];
    double running = 0;
    for (int x = 0; x < columns; ++x) {
      running += row[x];
      cells.cell_cdf.push_back(row_sum > 0 ? float(std::min(running / row_sum, 1.0)) : 0.0f);
    }
    // Rounding leaves no gap behind the last cell that has a share.
    for (int x = columns - 1; x >= 0 && row_sum > 0; --x) {
      cells.cell_cdf[cells.cell_cdf.size() - std::size_t(columns - x)] = 1.0f;
      if (row[x] > 0) break;
    }
    before += row_sum;
    cells.row_cdf.push_back(float(std::min(before / sum, 1.0)));
  }
  for (std::size_t y = cells.row_cdf.size(); y-- > 0;) {
    cells.row_cdf[y] = 1.0f;
    if (cells.cell_cdf[(y + 1) * std::size_t(columns) - 1] > 0) break;
  }
  return cells;
}

} // namespace openltc::light
