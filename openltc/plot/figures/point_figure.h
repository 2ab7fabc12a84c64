// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One point light over a floor (source section 0.1.3): the exact BRDF, the lobe's density in its
// place, and their difference, as pictures and along the plane of incidence.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/plot/point_scene.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct PointFigureOptions {
  PointSetup setup;
  std::vector<double> roughness = {0.2, 0.5}; ///< 0.05..1, a row each, at most 4
  Scan scan = Scan::along;
  fit::LobeFunction lobes; ///< empty: of the built-in table, as is `source`
  render::LobeSource source = table::builtin_ggx_table(); ///< the same for the renderer
  std::string label = "built-in table";
  std::string command; ///< stands in the caption
};

/// For each roughness three pictures and, below them, the scan. Fails for options out of range and
/// as render_point does.
Result<draw::Figure> make_point_figure(const PointFigureOptions& options);

} // namespace openltc::plot
