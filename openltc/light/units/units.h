// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Photometric quantities of lights, and how one follows from another.
//
//   quantity             unit                    definition
//   flux                 lumen, lm               all light that a source gives
//   intensity            candela, cd = lm/sr     flux per solid angle, source seen from far away
//   illuminance          lux, lx = lm/m2         flux that meets a surface, per area
//   exitance             lm/m2                   flux that leaves a surface, per area
//   luminance, radiance  nit = cd/m2             flux per solid angle and projected area
//   radiant flux         watt, W                 power; lumens over the luminous efficacy
//
// A light's colour scales each of them alike, so the same factor holds for every channel: those
// functions take and give Vec3f. Every conversion has its inverse beside it. A value that is
// negative or not finite, or a result that leaves the number type's range, is an error that names
// the quantity.

#pragma once

#include "openltc/base/result.h"
#include "openltc/light/light.h"

namespace openltc::light {

// --- Power ---

/// Lumens per watt of light at 540 THz (a wavelength of 555 nm), where the eye sees best: by it the
/// SI defines the candela. Khronos' glTF exporter for Blender takes all light to be of this kind.
inline constexpr double k_efficacy_555nm = 683;

/// Lumens per watt of white light whose spectrum is even over what the eye sees: what the Radiance
/// renderer takes for its RGB (its WHTEFFICACY); and what it has for daylight, illuminant D65.
inline constexpr double k_efficacy_even_white = 179;
inline constexpr double k_efficacy_d65 = 203;

/// flux_lumens = power_watts * efficacy, in lumens per watt of light, not of electricity.
Result<double> lumens_from_watts(double power_watts, double efficacy = k_efficacy_555nm);
Result<double> watts_from_lumens(double flux_lumens, double efficacy = k_efficacy_555nm);

// --- Surfaces ---

/// Exitance of one side of a surface that emits luminance_nits cos(t)^cosine_power at the angle t
/// from its normal: 2 pi / (cosine_power + 2) times the luminance, pi times for Lambert's emitter.
Result<double> exitance_from_luminance(double luminance_nits, double cosine_power = 0);
Result<double> luminance_from_exitance(double exitance, double cosine_power = 0);

/// Illuminance in lux by a small light of that intensity towards the surface: I cos(t) / d^2.
/// Distance in metres, greater than zero; cos_incidence in (0, 1], at the surface.
Result<double> illuminance_from_intensity(double intensity_candela, double distance,
                                          double cos_incidence = 1);
Result<double> intensity_from_illuminance(double illuminance_lux, double distance,
                                          double cos_incidence = 1);

// --- Exposure values ---
//
// ISO 2720: a reflected-light meter of calibration constant K and an incident-light meter of
// constant C. EV100 is the exposure value at ISO 100: N^2 / t, in steps of a factor of two, of the
// exposure that such a meter asks for.

inline constexpr double k_meter_reflected = 12.5; ///< K, cd/m2, as most makers have it
inline constexpr double k_meter_incident = 250;   ///< C, lx, for a flat receptor

/// L = 2^EV100 K / 100 = 2^(EV100 - 3), nits. EV100 is any finite number; a luminance of 0 has
/// none.
Result<double> luminance_from_ev100(double ev100);
Result<double> ev100_from_luminance(double luminance_nits);

/// E = 2^EV100 C / 100 = 2.5 * 2^EV100, lux.
Result<double> illuminance_from_ev100(double ev100);
Result<double> ev100_from_illuminance(double illuminance_lux);

// --- Lights ---

/// Flux in lumens over the light's radiance in nits: area times exitance_per_radiance, in m2 sr.
/// 0 when the light's sizes or cosine power are no good; see validate.
double flux_per_radiance(const PolygonLight& light);
double flux_per_radiance(const EllipseLight& light);
double flux_per_radiance(const SphereLight& light);
double flux_per_radiance(const TubeLight& light);

/// Intensity in candela over the light's radiance in nits, in m2: the integral over the surface of
/// cos^p times the projected area, seen from far away:
///   polygon, ellipse   along the normal       A
///   sphere             from everywhere        2 pi r^2 / (p + 2)
///   tube               across its axis        r l sqrt(pi) G(p/2 + 1) / G(p/2 + 3/2), G the gamma
///                      function, which is 2 r l for p = 0; plus the sphere's for round caps; flat
///                      caps are seen edge-on and give nothing.
double intensity_per_radiance(const PolygonLight& light);
double intensity_per_radiance(const EllipseLight& light);
double intensity_per_radiance(const SphereLight& light);
double intensity_per_radiance(const TubeLight& light);

/// Flux in lumens over LineLight::intensity_per_metre: pi^2 l, in m sr.
double flux_per_intensity(const LineLight& light);

/// Flux in lumens over PunctualLight::intensity in candela, in sr: 4 pi for a point; for a spot the
/// integral of its cone, 2 pi (1 - c_i + (c_i - c_o) / 3) with the cosines of its inner and outer
/// angle (shade/punctual.glsl); with a profile the integral of profile times cone. 0 for a
/// directional light, which has no flux.
double flux_per_intensity(const PunctualLight& light);

/// Flux, luminance along the normal and intensity (in the direction of intensity_per_radiance) of a
/// light with a surface: one per linear channel. The light's own radiance is not read, so that an
/// importer may set it from what a file states. A light without area has no luminance: an error.
template <class Light> Result<Vec3f> flux_from_radiance(const Light& light, Vec3f radiance);
template <class Light> Result<Vec3f> radiance_from_flux(const Light& light, Vec3f flux_lumens);
template <class Light> Result<Vec3f> intensity_from_radiance(const Light& light, Vec3f radiance);
template <class Light> Result<Vec3f> radiance_from_intensity(const Light& light, Vec3f intensity);

/// The same for lights without a surface: LineLight (cd/m) and PunctualLight (cd). A directional
/// light has no flux: an error.
template <class Light> Result<Vec3f> flux_from_intensity(const Light& light, Vec3f intensity);
template <class Light> Result<Vec3f> intensity_from_flux(const Light& light, Vec3f flux_lumens);

// --- Helpers of the templates above ---

/// value * factor, or value / factor: an error that names `quantity` when the value is negative or
/// not finite, when the factor is not greater than zero, or when the result overflows.
Result<Vec3f> scale_quantity(const char* quantity, Vec3f value, double factor);
Result<Vec3f> divide_quantity(const char* quantity, Vec3f value, double factor);
Result<double> scale_quantity(const char* quantity, double value, double factor);
Result<double> divide_quantity(const char* quantity, double value, double factor);

template <class Light> Result<Vec3f> flux_from_radiance(const Light& light, Vec3f radiance) {
  return scale_quantity("the radiance", radiance, flux_per_radiance(light));
}
template <class Light> Result<Vec3f> radiance_from_flux(const Light& light, Vec3f flux_lumens) {
  return divide_quantity("the flux", flux_lumens, flux_per_radiance(light));
}
template <class Light> Result<Vec3f> intensity_from_radiance(const Light& light, Vec3f radiance) {
  return scale_quantity("the radiance", radiance, intensity_per_radiance(light));
}
template <class Light> Result<Vec3f> radiance_from_intensity(const Light& light, Vec3f intensity) {
  return divide_quantity("the intensity", intensity, intensity_per_radiance(light));
}
template <class Light> Result<Vec3f> flux_from_intensity(const Light& light, Vec3f intensity) {
  return scale_quantity("the intensity", intensity, flux_per_intensity(light));
}
template <class Light> Result<Vec3f> intensity_from_flux(const Light& light, Vec3f flux_lumens) {
  return divide_quantity("the flux", flux_lumens, flux_per_intensity(light));
}

} // namespace openltc::light
