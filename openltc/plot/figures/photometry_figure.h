// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polar diagram of a luminaire, as data sheets have it: intensity over the angle from its axis
// in the planes C0-C180 and C90-C270, the aim downwards.

#pragma once

#include "openltc/base/result.h"
#include "openltc/draw/figure.h"
#include "openltc/light/photometry/ies.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct PhotometryOptions {
  light::IesProfile profile;
  bool per_kilolumen = false; ///< cd per 1000 lm of the luminaire instead of cd
  std::string command;        ///< for the caption
};

/// Circles of the diagram: where they lie, ascending, the last one no less than the peak.
std::vector<double> rings_of(double peak);

/// The diagram, and the luminaire's numbers beside it. Fails when the profile has no flux and
/// per_kilolumen asks for a share of it.
Result<draw::Figure> make_photometry_figure(const PhotometryOptions& options);

} // namespace openltc::plot
