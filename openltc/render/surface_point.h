// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From a hit to what shading wants to know of the surface there.

#pragma once

#include "openltc/render/texture_sampler.h"
#include "openltc/scene/scene.h"

namespace openltc::render {

/// A surface point with its material evaluated.
struct SurfacePoint {
  Vec3f position;  ///< world space
  Vec3f normal;    ///< shading normal, unit, on the viewer's side
  Vec3f geometric; ///< of the triangle, unit, on the viewer's side
  Vec3f view;      ///< unit, to the viewer
  Vec3f albedo;    ///< (1 - metallic) base colour
  Vec3f f0;
  float f90 = 1;
  float roughness = 1; ///< perceptual
  float offset = 0;    ///< metres that shadow rays start off the surface
  Vec3f emission;      ///< nits towards the viewer, unlit colour included
  float alpha = 1;     ///< coverage; 0 on the culled back of a one-sided surface
  bool lit = true;     ///< false for unlit materials
};

/// Evaluates the material of mesh `mesh` where `direction` (unit, away from the camera) meets
/// triangle `triangle` at barycentric (u, v). `footprint` is the width of the pixel there in
/// metres, across the ray, for texture filtering.
SurfacePoint evaluate_surface(const scene::Scene& scene, const TextureSet& textures,
                              std::uint32_t mesh, std::uint32_t triangle, float u, float v,
                              Vec3f direction, float footprint);

/// Coverage alone, for shadow rays: base colour alpha, unfiltered.
float surface_alpha(const scene::Scene& scene, const TextureSet& textures, std::uint32_t mesh,
                    std::uint32_t triangle, float u, float v);

} // namespace openltc::render
