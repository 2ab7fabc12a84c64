// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the trade asks of a photometric file.

#pragma once

#include "openltc/light/photometry/ies.h"

#include <vector>

namespace openltc::light {

/// In which planes the intensities are their own mirror image. The planes hold the light's axis.
enum class PhotometricSymmetry {
  none,
  plane_c0,  ///< C0-C180; of types A and B the plane H = 0
  plane_c90, ///< C90-C270; of types A and B the plane V = 0
  both,      ///< four quarters alike
  axis       ///< the same all around
};

/// The symmetry of the intensities, to `tolerance` of the maximum.
PhotometricSymmetry symmetry_of(const IesProfile& profile, double tolerance = 1e-6);

/// A direction in a plane through the light's axis: degrees from the axis, -180 .. 180, positive
/// towards the plane's first half, C0 or C90.
struct PlanePoint {
  double degrees = 0, candela = 0;
};

/// Intensity around the whole plane C0-C180 (azimuth_degrees = 0) or C90-C270 (90), or any other,
/// in steps of `step_degrees`, which divide 180; ascending from -180 to 180, which are one
/// direction.
std::vector<PlanePoint> plane_curve(const IesProfile& profile, double azimuth_degrees,
                                    double step_degrees = 0.25);

/// Where intensity is at least `share` of the plane's maximum: the width in degrees of the part
/// around the maximum, 360 when that is all and 0 in a dark plane. 0.5 gives the beam angle, 0.1
/// the field angle.
double angle_within(const std::vector<PlanePoint>& curve, double share);

struct PhotometricSummary {
  double flux_lumens = 0;
  double downward_share = 0; ///< of the lumens, towards the aim's side of the plane across it
  double peak_candela = 0;
  PhotometricAngles peak;   ///< in the file's own angles; of equal ones that nearest to the aim
  PhotometricAngles peak_c; ///< the same direction in those of type C
  double beam_degrees[2] = {0, 0};  ///< in planes C0-C180 and C90-C270, see angle_within
  double field_degrees[2] = {0, 0}; ///< alike
  PhotometricSymmetry symmetry = PhotometricSymmetry::none;
};

PhotometricSummary summarise(const IesProfile& profile);

} // namespace openltc::light
