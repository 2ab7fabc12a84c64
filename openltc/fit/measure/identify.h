// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What an unknown table texture most probably is.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/layout.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace openltc::fit {

/// One way to read the textures, and how well the lobes read that way fit one BRDF.
struct Identification {
  std::string reading;                 ///< in words: packing and axes
  std::optional<table::Layout> layout; ///< the named layout of this reading, if it has one
  std::string brdf;
  double mean_tv = 1; ///< total variation over the grid, 1 where the texels hold no lobe
  bool has_amplitudes = false;
  double mean_n1 = 0; ///< mean |n1 - E|, of the second texture
  double mean_n5 = 0;
};

/// Reads the textures in every way known (the layouts of table/layout.h, the first ltc_code, the
/// transposed and the inverted matrix; angle axis sqrt(1 - cos), theta or cos; roughness or alpha;
/// axes swapped) and compares the lobes with every BRDF of brdf::all_brdfs() at `points` x `points`
/// view angles to 89.7 degrees and roughnesses .06 to 1. The best first; a named layout comes
/// before a nameless reading that is as good. Fails when no texture has four channels.
Result<std::vector<Identification>> identify(std::span<const table::Texture> textures,
                                             int points = 8);

} // namespace openltc::fit
