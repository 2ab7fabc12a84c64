// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figure of a polygon in both spaces. After figure 3 of the project's source document and of
// Heitz, Dupuy, Hill, Neubelt 2016.

#pragma once

#include "openltc/base/result.h"
#include "openltc/draw/figure.h"
#include "openltc/plot/polygon_equivalence.h"

#include <optional>
#include <string>
#include <vector>

namespace openltc::plot {

/// A card that stands across the horizon, beside the mirror direction of a view from 60 degrees:
/// both horizons cut it.
std::vector<Vec3d> default_polygon();

struct PolygonOptions {
  f64::Lobe lobe = f64::cosine_lobe();
  std::string lobe_name;               ///< e.g. "ggx, θ = 60°, roughness 0.6"; for the title
  std::optional<double> theta_degrees; ///< of the view, where the lobe has one
  std::vector<Vec3d> corners = default_polygon(); ///< shading space, as compare_spaces wants them
  PolygonSampling sampling{500, 0};
  std::string command = "openltc plot polygon"; ///< for the caption
};

inline constexpr int k_most_samples = 5000; ///< more dots hide the picture

/// "x,y,z x,y,z ...". The error names the option.
Result<std::vector<Vec3d>> parse_points(const std::string& text);

/// Both spaces side by side, with both integrals and the samples that lie inside. Fails as
/// compare_spaces does, with messages about "--points", and when the integrals differ by more than
/// 1e-6 or the counts at all.
Result<draw::Figure> make_polygon_figure(const PolygonOptions& options);

} // namespace openltc::plot
