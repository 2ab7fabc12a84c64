// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lobes and BRDFs seen from above, as densities over a disc.
//
// The projection is Lambert's azimuthal equal-area one (Lambert 1772): a direction (x, y, z) of the
// upper hemisphere lies at (x, y)/sqrt(1 + z), so that the hemisphere is the unit disc and equal
// areas of it are equal solid angles. Discs are drawn with the mirror direction to the right of the
// normal: the disc's x is -x of the shading frame, in which wo = (sin theta, 0, cos theta).

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/fit/horizon.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/quadrature.h"
#include "openltc/target/shade_f64.h"

#include <functional>
#include <span>
#include <vector>

namespace openltc::fit {

/// A lobe or BRDF as a density over directions of the shading frame, 1/steradian: values[i] is that
/// of wi[i]. Of many at once, since a BRDF may cost much by the call.
using Density = std::function<void(std::span<const Vec3d> wi, std::span<double> values)>;

/// rho/E of the BRDF that a quadrature is of, 0 below the horizon. `brdf` must outlive it.
Density density_of(const brdf::Brdf& brdf, const Quadrature& quadrature);

/// A lobe with its horizon read as stated, not negative. Directions below the horizon are the
/// caller's to leave out.
Density density_of(const f64::Lobe& lobe, Horizon horizon);

/// Of both lobes where there are two, weighted.
Density density_of(const MeasuredLobe& fitted, Horizon horizon);

/// A square window of the disc: its centre lies on the plane of incidence, at (center_x, 0).
struct DiscWindow {
  double center_x = 0;
  double half = 1.02; ///< the whole disc with a margin

  bool is_zoomed() const { return half < 1; }
};

/// The window that holds the BRDF's lobe: three deviations about its mean, or the whole disc when
/// that is not much more.
DiscWindow window_of_lobe(const Quadrature& quadrature);

/// Where the mirror direction of a view angle lies on the disc's x axis; the view direction lies at
/// minus that.
double mirror_in_disc(double cos_theta);

/// The density at the middles of side x side pixels of a window, top row first; -1 below the
/// horizon.
std::vector<double> sample_disc(const Density& density, const DiscWindow& window, int side);

} // namespace openltc::fit
