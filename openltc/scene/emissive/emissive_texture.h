// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// An emission texture that lies on a flat light like a picture on a wall.

#pragma once

#include "openltc/scene/scene.h"

#include <cstdint>
#include <span>

namespace openltc::scene {

/// Places the emission texture of `ref` on the light that `triangles` (of `mesh`, all in one plane)
/// were made into, when their texture coordinates are one affine map of the plane: within a
/// thousandth of the picture or a quarter of a texel. Sets texture, to ref.texture, and
/// texture_corner, texture_u and texture_v; returns false, and leaves the light as it is, when the
/// map is another or repeats the picture within the light.
bool place_emission_texture(const Mesh& mesh, const TextureRef& ref, const Texture& texture,
                            std::span<const std::uint32_t> triangles, light::PolygonLight& light);

/// The same for a texture of that size and those samplers, whatever is in it; the map alone counts.
bool place_texture(const Mesh& mesh, const TextureRef& ref, int width, int height, Wrap wrap_u,
                   Wrap wrap_v, std::span<const std::uint32_t> triangles,
                   light::PolygonLight& light);

/// Index into scene.lights.textures of scene.textures[texture], which is put there, sharing its
/// samples, when it is not yet in `known`: for each of scene.textures its index there or -1.
int share_emission_texture(Scene& scene, int texture, std::vector<int>& known);

} // namespace openltc::scene
