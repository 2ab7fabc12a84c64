// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What readers of photometric files share. Private to light.

#pragma once

#include "openltc/light/photometry/ies.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace openltc::light {

// Bounds of what is taken from a file.
inline constexpr double k_max_angle_count = 4096, k_max_directions = 1 << 20;
inline constexpr double k_max_photometric_value = 1e12;

/// Angles of a file or beyond, each with the row of intensities that belongs to it.
struct AngleRows {
  std::vector<double> degrees;
  std::vector<std::size_t> row;
  void add(double angle, std::size_t r) {
    degrees.push_back(angle);
    row.push_back(r);
  }
  /// Appends the mirror image about the last angle.
  void unfold();
};

/// Puts polar and azimuth angles and intensities, rows[azimuth.row * polar.size() + polar], into
/// `profile`. Azimuths that run on beyond 360 degrees, a whole circle from where they begin, are
/// turned so that they begin at 0, with an angle made there if there is none.
void take_rows(const std::vector<double>& polar, const AngleRows& azimuth,
               const std::vector<double>& rows, IesProfile& profile);

/// Finds maximum, flux and grid of a profile whose angles and intensities are there. Refuses one
/// without light and angles that rounding has put out of order; `name` begins the line.
Status finish_profile(IesProfile& profile, const std::string& name);

/// Intensity at angles of the profile's own sphere, degrees, any azimuth: see eval_candela.
double eval_own(const IesProfile& profile, double polar_degrees, double azimuth_degrees);

/// Takes noise of the measurement away: values below 0 by no more than a hundredth of the largest
/// become 0, with a warning. The index of one that is further below, or values.size().
std::size_t clamp_noise(std::vector<double>& values, const std::string& name,
                        std::vector<std::string>& warnings);

/// At most `length` characters, none of them control characters: fit for names and messages.
std::string printable(std::string_view text, std::size_t length);

/// Without blanks, and zeros, at both ends.
std::string_view trimmed(std::string_view text);

} // namespace openltc::light
