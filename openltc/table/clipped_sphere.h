// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Form factor of a sphere cut by the horizon: the fourth channel of ltc_code's second texture.

#pragma once

namespace openltc::table {

/// How much of a spherical light's irradiance arrives, relative to the same sphere with its centre
/// at the zenith: (1/pi) times the integral of the cosine over the part above the horizon of a cap,
/// divided by sin^2 sigma. `z` in [-1, 1] is the cosine between the normal and the cap's centre,
/// `form_factor` in [0, 1] is sin^2 sigma, sigma the cap's angular radius. In the limit of a small
/// cap it is max(z, 0), for a hemisphere (1 + z)/2.
double clipped_sphere_form_factor(double z, double form_factor);

} // namespace openltc::table
