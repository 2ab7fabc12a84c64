// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights for scenes that come without.

#pragma once

#include "openltc/scene/scene.h"

namespace openltc::scene {

/// Three soft boxes around `bounds` as seen from `camera`: a large key from the upper left, a
/// weaker fill from the right, a rim light from behind and above. They stand outside the bounds'
/// sphere, are one-sided, face its centre, and grow with it, so that the light in the scene does
/// not depend on its size.
///
/// `white_nits` is the luminance that a white, matte card in the middle, facing the key, has by the
/// key's light. At 1 nit such a card is as bright as what emits glTF's plain emissive factor of 1,
/// and as unlit white.
light::Lights studio_lights(const Bounds& bounds, const Camera& camera, double white_nits = 1.0);

/// One soft box that shines down from `center`, with half its sides along X and Z: for a room that
/// the rig cannot shine into. `white_nits` is the luminance that it gives a white, matte card which
/// faces it `distance` below its centre. All lengths in metres, greater than 0.
light::Lights ceiling_light(Vec3d center, double half_x, double half_z, double distance,
                            double white_nits);

/// How bright the lights of a scene make a white, matte card in its middle that faces each of them:
/// the largest such luminance in nits. Shadows are ignored, area lights taken for points.
double white_level_nits(const light::Lights& lights, const Bounds& bounds);

/// Radiance in nits from which a pixel of a picture probably shows a light or its mirror image:
/// half the largest channel of the dimmest area light that gives a hundredth of their flux or more.
/// What diffusely reflects their light is darker. The largest float where there is no such light.
float least_nits_of_lights(const light::Lights& lights);

} // namespace openltc::scene
