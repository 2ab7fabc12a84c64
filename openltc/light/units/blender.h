// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The strength of Blender's lights in photometric units.
//
// Blender states lights in watts and gives no luminous efficacy; these functions take one, by
// default the 683 lm/W of its glTF exporter. `strength` is Power times 2^Exposure, times colour if
// wanted. What Cycles makes of W watts, per light:
//
//   sphere of radius r     radiance W / (4 pi^2 r^2)   that a sphere of W watts has: 4 pi r^2 . pi
//   L point, spot, r = 0     intensity W / (4 pi)        the same sphere's; a spot is a point seen
//                                                      through its cone, which takes light away
//   area, any shape        radiance W / (4 A)          so it emits pi/4 W, not W; Eevee has 0.8/pi
//                                                      W / A, 2 % more, to look like it
//   sun                    irradiance W, per m2        on a surface that faces it
//
// These hold with Blender's `Normalize` on, the default, and an area light's `Spread` of 180
// degrees. The exporter multiplies W by the light's area where Normalize is off: so must the
// caller.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"
#include "openltc/light/units/units.h"

namespace openltc::light {

/// Luminance in nits of Blender's point or spot light of a radius in metres.
Result<double> luminance_from_blender_sphere(double strength_watts, double radius,
                                             double efficacy = k_efficacy_555nm);
Result<double> blender_sphere_from_luminance(double luminance_nits, double radius,
                                             double efficacy = k_efficacy_555nm);

/// Luminance in nits of Blender's area light of a world-space area in m2, one side.
Result<double> luminance_from_blender_area(double strength_watts, double area,
                                           double efficacy = k_efficacy_555nm);
Result<double> blender_area_from_luminance(double luminance_nits, double area,
                                           double efficacy = k_efficacy_555nm);

/// How Blender's glTF exporter writes KHR_lights_punctual's intensity ("Lighting Mode"): candela of
/// point and spot, lux of the sun.
enum class GltfLightMode {
  standard, ///< "SPEC": watts by 683 lm/W; point and spot over 4 pi. The exporter's default
  unitless, ///< "COMPAT": the same without 683: W/sr and W/m2, for viewers that expect small
            ///< numbers
  raw       ///< "RAW": the strength as it stands; for point and spot watts, not watts per steradian
};

/// What the exporter writes for a strength in watts (sun: W/m2), and what strength it came from. A
/// file does not say in which mode it was written. 683 lm/W belongs to the mode standard; to read
/// a file of another mode in true units, go back to the strength and forth by standard.
Result<double> gltf_intensity_from_blender(double strength, PunctualType type, GltfLightMode mode);
Result<double> blender_from_gltf_intensity(double intensity, PunctualType type, GltfLightMode mode);

} // namespace openltc::light
