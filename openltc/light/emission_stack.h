// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A texture as a light's emission, filtered once so that shading needs few looks at it.
//
// The stack covers the light's bounding rectangle, its sides along and across the texture's u axis.
// Each level holds what is left of the next finer one under a Gaussian of half a texel of its own,
// so widths double while texels halve. What is filtered is the texture times the light's outline,
// and the outline by itself; their quotient is the mean of the part of the light around a point,
// also for a point beside it. The last level is the mean of the whole light.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/base/result.h"
#include "openltc/image/texels.h"
#include "openltc/light/emission_cells.h"
#include "openltc/light/light.h"
#include "openltc/target/resources.h"

#include <cstdint>
#include <string>
#include <vector>

namespace openltc::light {

struct EmissionStackOptions {
  /// Columns and rows of the finest level, at most; a larger texture is reduced first, by the mean
  /// of what falls together. A power of two. 1024 makes 26 MB at most.
  int max_side = 1024;
};

/// Owner of the arrays behind an EmissionTextureView.
struct EmissionStack {
  std::vector<float> texels;
  std::vector<std::int32_t> levels;
  EmissionCells cells;
  EmissionTextureView view; ///< points into the vectors above and to the texture
  image::Texels texture;    ///< shares its samples, so that they outlive the view
  Vec3f mean{0, 0, 0};      ///< of the texture over the light
  MemoryShare memory;       ///< what the vectors take

  EmissionStack() = default;
  EmissionStack(EmissionStack&&) = default;
  EmissionStack& operator=(EmissionStack&&) = default;
};

/// Filters `texture`, one of Lights::textures, for a light that has it as its emission; the light's
/// radiance is not part of it. Values that are negative or not a number count as 0.
/// The error names the light: an empty texture, texture axes of no length or along its normal, an
/// outline of no extent, or no memory left in memory_budget().
Result<EmissionStack> build_emission_stack(const image::Texels& texture, const PolygonLight& light,
                                           const EmissionStackOptions& options = {});
Result<EmissionStack> build_emission_stack(const image::Texels& texture, const EllipseLight& light,
                                           const EmissionStackOptions& options = {});

/// Mean of a light's texture over the light, by which its flux is that of a white one: (1, 1, 1)
/// when it has none, or one that cannot be its texture.
Vec3f mean_of_texture(const PolygonLight& light, const std::vector<image::Texels>& textures);
Vec3f mean_of_texture(const EllipseLight& light, const std::vector<image::Texels>& textures);

/// Gives a light a texture: its corners are those of the light's bounding rectangle, its u axis
/// runs along `u_axis` (world space, made perpendicular to the normal), and it is upright for who
/// faces the light. `texture` is an index into Lights::textures.
void place_texture(PolygonLight& light, int texture, Vec3f u_axis);
void place_texture(EllipseLight& light, int texture, Vec3f u_axis);

} // namespace openltc::light
