// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How bright a picture is about to be: what errors are measured against before there are pixels.

#pragma once

#include "openltc/render/camera_rays.h"
#include "openltc/render/kernel_types.h"
#include "openltc/render/ray_scene.h"
#include "openltc/scene/scene.h"

namespace openltc::render {

/// The light level of a view, in nits: the median, over at most 1024 rays spread evenly over the
/// picture, of the radiance (largest channel) that the surface first met reflects from all lights,
/// with their shadows where `context` traces them. Surfaces that reflect none do not count; 0 if
/// all do. With very many lights there are fewer rays, at least 64.
double light_level_nits(const scene::Scene& scene, const TextureSet& textures, const RayScene& rays,
                        const CameraRays& camera, int width, int height, const Kernel& kernel,
                        const KernelContext& context, int threads);

} // namespace openltc::render
