// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The brightness of UsdLux lights in nits and lux.
//
// By the schema of OpenUSD's LightAPI a light's luminance is
//   L = intensity * 2^exposure * color / size_factor, nits,
// with size_factor 1, or, when `normalize` is on, the world-space area of the light's surface:
// rect w h, disk pi r^2, sphere 4 pi r^2, cylinder 2 pi r l (it does not emit from its ends, so it
// is a TubeLight of TubeCaps::none); each is area() of the light's shape in light/polygon.h,
// light/ellipse.h and light/curved.h, after all transforms. The intensity of a normalized light is
// in nits m2: its flux over pi, for Lambert's emitter.
//
// A distant light of angular diameter a has t = a/2 and the size factor pi sin(t)^2 up to t = pi/2,
// pi (2 - sin(t)^2) beyond, and 1 for t = 0. That is the illuminance on a facing surface over the
// luminance, so the intensity of a normalized one is in lux.
//
// inputs:shaping:focus is Emitter::cosine_power when inputs:shaping:focusTint is black.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

/// The attributes inputs:intensity, exposure, color and normalize, with their fallback values.
struct UsdLuxEmission {
  double intensity = 1;
  double exposure = 0;  ///< stops, any finite number
  Vec3f color{1, 1, 1}; ///< linear Rec.709, already multiplied by the colour temperature's
  bool normalize = false;
};

/// Luminance in nits of an area light; `area` is its world-space area in m2, which only a
/// normalized light needs. Error: intensity or colour negative or not finite, no area, out of
/// range.
Result<Vec3f> luminance_from_usdlux(const UsdLuxEmission& emission, double area);

/// The emission that has that luminance: colour of largest component 1, the exposure given, and the
/// intensity that remains. Black has intensity 0 and the colour white.
Result<UsdLuxEmission> usdlux_from_luminance(Vec3f luminance_nits, double exposure, bool normalize,
                                             double area);

/// The size factor of a distant light of that angular diameter, clamped to 0 .. 360 degrees.
Result<double> usdlux_distant_size_factor(double angle_degrees);

/// Illuminance in lux of a distant light on a surface that faces it: a PunctualLight's intensity
/// when directional. For an angle of 0, where the luminance is infinite, it is the intensity, with
/// or without `normalize`: our reading, the limit of the normalized light.
Result<Vec3f> illuminance_from_usdlux_distant(const UsdLuxEmission& emission, double angle_degrees);
Result<UsdLuxEmission> usdlux_distant_from_illuminance(Vec3f illuminance_lux, double exposure,
                                                       bool normalize, double angle_degrees);

} // namespace openltc::light
