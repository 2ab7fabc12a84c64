// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From scene-linear radiance to what a display shows: exposure, tone curve, sRGB encoding.

#pragma once

#include "openltc/image/image.h"

#include <limits>

namespace openltc::image {

/// Factor from luminance in nits to display-linear values: 1 / (1.2 * 2^EV100). A surface whose
/// luminance saturates a camera set to EV100 becomes 1.
/// Lagarde, de Rousiers, "Moving Frostbite to Physically Based Rendering 3.0", 2014, section 5.1.2.
float exposure_from_ev100(float ev100);
float ev100_from_exposure(float exposure);

/// Luminance of linear Rec.709: 0.2126 R + 0.7152 G + 0.0722 B.
float luminance(Vec3f rgb);

struct AutoExposureOptions {
  /// Display-linear value that the middle of the picture gets: the grey card's 18 %.
  float middle_grey = 0.18f;
  /// Display-linear value that the highlights are kept below: a sensor's white. The tone maps that
  /// roll off have room above it, for what is brighter still.
  float white = 1.0f;
  /// What may become brighter: this fraction of the picture's area, sparks and small lights.
  float highlight_fraction = 0.01f;
  /// Pixels with a channel from here on are lights, or mirror images of lights, and no surfaces
  /// that lights fall on; infinity = not known, any pixel may be one.
  float light = std::numeric_limits<float>::infinity();
  /// Known lights are kept below this, where the tone maps still tell their colours.
  float light_white = 3.0f;
  /// Lights take at most this many stops off, so that one in view does not leave the scene that it
  /// lights in the dark.
  float light_stops = 2.0f;
  /// The same for surfaces, where they can be told from lights.
  float surface_stops = 8.0f;
  /// Pixels darker than this fraction of the bright ones are background and do not count.
  float black = 1e-4f;
};

/// An exposure factor for this picture, always positive and finite. It brings the geometric mean
/// luminance, without the darkest and brightest twentieth of the lit pixels, to middle grey, or
/// less where the highlights ask for it: then 99 % of the picture's pixels are below white in every
/// channel, as far as highlight_stops allows. Black, negative, NaN and infinite pixels do not
/// count; a picture without any other gets 1. Scaling the picture by k scales the result by 1/k.
float auto_exposure(const Image& image, const AutoExposureOptions& options = {});

/// `exposure`, or what less keeps all of the picture but highlight_fraction at most white in every
/// channel, as far as light_stops and surface_stops allow. For where the level of the light is
/// known beforehand.
float exposure_below_white(const Image& image, float exposure,
                           const AutoExposureOptions& options = {});

enum class Tonemap { neutral, aces, none };

/// Display-linear RGB in [0, 1] from exposed scene-linear RGB; negative input counts as 0.
Vec3f apply_tonemap(Vec3f rgb, Tonemap tonemap);

/// Khronos PBR Neutral: leaves colours of lit base colours as they are, up to the 4 % that a
/// dielectric reflects, and rolls off highlights towards white without shifting hue.
Vec3f pbr_neutral(Vec3f rgb);

/// One channel of the ACES fit by Krzysztof Narkowicz, "ACES Filmic Tone Mapping Curve", 2015, with
/// the 0.6 that he gives as the factor to the original's exposure. Increasing, in [0, 1].
float aces(float x);
/// The x >= 0 for which aces(x) = y, for y in [0, 1).
float inverse_aces(float y);

/// Exposed, tone-mapped and sRGB-encoded in [0, 1]; ready for write_png. Alpha is kept, clamped.
/// NaN becomes black, +infinity as bright as the tone map gets. Grey pictures become RGB.
Image to_display(const Image& image, float exposure, Tonemap tonemap);

} // namespace openltc::image
