// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// EULUMDAT, the photometric files of Europe.

#pragma once

#include "openltc/light/photometry/ies.h"

#include <string>
#include <string_view>

namespace openltc::light {

/// Reads the text of an EULUMDAT file, .ldt; `name` stands in for its path in messages. The profile
/// is of type C: C-planes are horizontal angles, gamma is the vertical angle.
///
/// All symmetries (Isym 0 to 4) are unfolded. Intensities, cd per 1000 lm, are multiplied by the
/// conversion factor and by a thousandth of the lumens of the first set of lamps; a negative number
/// of lamps says that these are the luminaire's own. Downward share and light output ratio are kept
/// as stated; the tilt of the measurement and the direct ratios are not used. Along C90 lies the
/// luminaire's length, which is a width in LM-63, so that lengths and widths change places.
///
/// With a warning: sets of lamps with other lumens than the first, text behind the last value,
/// and noise just below 0, as in parse_ies. Refuses, with one line "name:line: what is wrong", what
/// parse_ies refuses, and counts of planes that their symmetry does not divide.
Result<IesProfile> parse_ldt(std::string_view text, const std::string& name);

} // namespace openltc::light
