// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Luminous intensity by direction, from files of the IES LM-63 format.

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/resources.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::light {

/// Type C photometry: the vertical angle is 0 at the nadir, straight down from the luminaire, and
/// 180 degrees at the zenith; the horizontal angle runs counter-clockwise seen from above.
struct IesProfile {
  std::string name;    ///< [LUMINAIRE], else [LUMCAT], else the file's
  std::string version; ///< first line, "" for files of 1986, which have none
  std::vector<std::pair<std::string, std::string>> keywords; ///< without brackets, [MORE] joined

  /// As measured, unfolded by the file's symmetry to the whole circle. Ascending, degrees.
  std::vector<double> vertical_degrees;
  /// From 0 to 360, both of which are there; or 0 alone when the light is symmetric about its axis.
  std::vector<double> horizontal_degrees;
  /// candela[h * vertical_degrees.size() + v], multiplied by the file's factors.
  std::vector<double> candela;

  double flux_lumens = 0; ///< integral of the interpolated intensities over all directions
  double max_candela = 0; ///< greater than zero
  /// Lumens of all lamps, as the file states them; 0 when it has absolute photometry (-1).
  double lamp_lumens = 0;
  double input_watts = 0;            ///< electric
  double size_metres[3] = {0, 0, 0}; ///< width, length, height; negative values mean round shapes

  /// The intensities over max_candela, for shading: see ProfileView.
  std::vector<float> grid;
  int grid_columns = 0, grid_rows = 0;

  ProfileView view() const { return {grid.data(), grid_columns, grid_rows}; }
};

/// Intensity in candela in a direction, angles in radians: bilinear in the measured angles, 0
/// outside their vertical range. Any horizontal angle.
double eval_candela(const IesProfile& profile, double vertical_rad, double horizontal_rad);

/// The mean of that over the horizontal angle.
double mean_candela(const IesProfile& profile, double vertical_rad);

/// Reads a file: LM-63-1986, 1991, 1995, 2002 or 2019, TILT=NONE or INCLUDE, type C photometry.
///
/// Vertical angles anywhere within 0 .. 180 degrees; horizontal angles 0 alone, 0 to 90 (quadrants
/// alike), 0 to 180 or 90 to 270 (halves alike), or 0 to 360; a full circle may lack its last
/// angle. Intensities are multiplied by the candela multiplier, the ballast factor and, up to 1995,
/// the ballast-lamp photometric factor, in whose place later standards have another field. Tilt
/// factors are read and not applied: they are for luminaires mounted at an angle.
///
/// Refuses, with one line "name:line: what is wrong": a file that cannot be read or exceeds 16 MiB,
/// no TILT line, TILT in a file of its own, types A and B, broken, missing and surplus numbers,
/// counts below 1 or above 4096 or of more than 2^20 directions, angles that do not ascend or are
/// out of range, values that are negative, not finite or above 1e12, and no light at all.
Result<IesProfile> read_ies(const std::string& path);

/// The same from the file's text; `name` stands in for the path in errors.
Result<IesProfile> parse_ies(std::string_view text, const std::string& name);

} // namespace openltc::light
