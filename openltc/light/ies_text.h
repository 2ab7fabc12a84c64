// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What stands in an LM-63 file, before its symmetry is unfolded. Private to light/ies.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::light {

struct IesText {
  std::string version;
  std::string label; ///< first line that is neither keyword nor version; files of 1986
  std::vector<std::pair<std::string, std::string>> keywords;
  double lamp_lumens = 0; ///< of all lamps, 0 when photometry is absolute
  double input_watts = 0;
  double size_metres[3] = {0, 0, 0};
  std::vector<double> vertical_degrees;   ///< ascending, within 0 .. 180
  std::vector<double> horizontal_degrees; ///< ascending, within 0 .. 360
  std::vector<double> candela; ///< [horizontal][vertical], all factors applied, 0 .. 1e12
};

/// Checks every number by itself and that angles ascend; see read_ies.
Result<IesText> parse_ies_text(std::string_view text, const std::string& name);

} // namespace openltc::light
