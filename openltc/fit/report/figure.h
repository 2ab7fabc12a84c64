// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figures of the report's page, each a piece of SVG. Private to this folder.

#pragma once

#include "openltc/fit/report/report.h"

#include <string>
#include <string_view>

namespace openltc::fit {

/// A number for people: four significant digits at most, a dash for what is not finite.
std::string html_number(double x);

/// One metric of a map: axes with units, colours from 0 to `top`, brighter is worse. `region` and
/// `candidate` are the indices that the page's script knows the map by.
std::string heat_map(const ErrorMap& map, const MeasureOptions& region, const LobeErrorField& field,
                     double top, std::size_t region_index, std::size_t candidate_index,
                     const std::string& label);

/// The colour bar that belongs to maps from 0 to `top`.
std::string color_bar(double top);

/// A lobe seen from above, logarithmic colours over three decades below the BRDF's peak.
std::string lobe_disc(const LobePicture& picture, const WorstCell& cell, const std::string& label);

/// The colour bar that belongs to discs.
std::string disc_color_bar();

/// BRDF and lobes along the plane of incidence, relative to the BRDF's peak.
std::string lobe_cuts(const WorstCell& cell);

} // namespace openltc::fit
