// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// LM-63 files made by hand or from a formula, for tests and as a start for fuzzing.

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openltc::testing {

/// What a file says; the defaults are those of a luminaire of 1 m in absolute photometry.
struct IesFile {
  std::string version = "IESNA:LM-63-2002"; ///< "" leaves the line out, as in 1986
  std::string keywords = "[LUMINAIRE] made by a formula\n";
  std::string tilt = "TILT=NONE\n";
  std::string lamps = "1 -1 1";
  std::string kind = "1 2 1 1 1"; ///< type, units, width, length, height
  std::string ballast = "1 1 10";
  std::vector<double> vertical, horizontal;

  /// The text, with candela(vertical, horizontal) in degrees rounded to 1e-6.
  std::string text(const std::function<double(double, double)>& candela) const;
};

/// from, from + step, ... to.
std::vector<double> angles(double from, double to, double step);

/// Valid files of every version, range of angles and way of writing.
std::vector<std::string> ies_samples();

} // namespace openltc::testing
