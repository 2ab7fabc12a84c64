// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Filtered look-up of a material's textures.

#pragma once

#include "openltc/scene/scene.h"

#include <vector>

namespace openltc::render {

/// A texture and its smaller copies, each half as wide and high, down to one texel.
class MipTexture {
public:
  explicit MipTexture(const scene::Texture& texture);

  /// Trilinear look-up at uv with a footprint of `width` in units of uv (0 = sharpest).
  Vec4f sample(Vec2f uv, float width) const;

private:
  Vec4f bilinear(const image::Image& image, Vec2f uv) const;

  const scene::Texture* texture_;
  std::vector<image::Image> smaller_;
};

/// All textures of a scene; the scene outlives it.
class TextureSet {
public:
  explicit TextureSet(const scene::Scene& scene);

  /// Value of a texture use at the mesh's coordinates, (1,1,1,1) when there is none.
  /// `width` is the footprint of the sample, in units of either set of coordinates.
  Vec4f sample(const scene::TextureRef& ref, const Vec2f tex_coord[2], const float width[2]) const;

private:
  std::vector<MipTexture> textures_;
};

} // namespace openltc::render
