// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What stands in an LM-63 file, before its symmetry is unfolded. Private to light/ies.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/photometry/ies.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::light {

struct IesText {
  std::string version;
  std::string label; ///< first line that is neither keyword nor version; files of 1986
  std::vector<std::pair<std::string, std::string>> keywords;
  PhotometricType type = PhotometricType::c;
  double lamp_lumens = 0; ///< of all lamps, 0 when photometry is absolute
  int lamp_count = 1;
  double input_watts = 0;
  double size_metres[3] = {0, 0, 0};
  /// Ascending; vertical within 0 .. 180, +-180, +-90 and horizontal within 0 .. 360, +-90, +-180
  /// degrees for types C, B, A.
  std::vector<double> vertical_degrees, horizontal_degrees;
  std::vector<double> candela;       ///< [horizontal][vertical], all factors applied, 0 .. 1e12
  std::vector<std::string> warnings; ///< see IesProfile
};

/// Checks every number by itself and that angles ascend; see parse_ies.
Result<IesText> parse_ies_text(std::string_view text, const std::string& name);

} // namespace openltc::light
