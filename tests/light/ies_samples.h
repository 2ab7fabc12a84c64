// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// LM-63 and EULUMDAT files made by hand or from a formula, for tests and as a start for fuzzing.

#pragma once

#include <functional>
#include <string>
#include <utility>
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

/// What a EULUMDAT file says.
struct LdtFile {
  int symmetry = 0;
  int planes = 24;           ///< of the whole circle
  std::vector<double> gamma; ///< degrees
  double conversion = 1;
  /// Sets of lamps: count, lumens of all.
  std::vector<std::pair<int, double>> lamps = {{1, 1000}};
  bool set_by_set = true; ///< else item by item
  std::string line_end = "\n";

  /// The text, with intensity(gamma, c) in cd per 1000 lm, degrees, of the planes that the symmetry
  /// has.
  std::string text(const std::function<double(double, double)>& intensity) const;
};

/// Valid files of every symmetry and way of writing.
std::vector<std::string> ldt_samples();

/// from, from + step, ... to.
std::vector<double> angles(double from, double to, double step);

/// Valid LM-63 files of every version, type, range of angles and way of writing.
std::vector<std::string> ies_samples();

} // namespace openltc::testing
