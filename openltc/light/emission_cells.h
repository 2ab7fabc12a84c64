// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A light's texture as a distribution over the cells of a grid, for sampling.

#pragma once

#include "openltc/target/resources.h"

#include <span>
#include <vector>

namespace openltc::light {

/// Owner of the arrays that sampling by cells needs; see EmissionTextureView.
struct EmissionCells {
  std::vector<float> row_cdf;  ///< running share of the rows, the last is 1
  std::vector<float> cell_cdf; ///< running share of each cell within its row, row by row
  float share = 0;             ///< of samples that are worth drawing by cells, 0 to 0.75
};

/// From the finest level of an emission stack: `texels` has 4 floats each, r g b times the light's
/// share of the texel, and that share. Cells beside the light have no share. Empty, with share 0,
/// where the texture is so even that nothing is gained.
EmissionCells make_emission_cells(std::span<const float> texels, int columns, int rows);

} // namespace openltc::light
