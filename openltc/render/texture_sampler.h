// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Filtered look-up of a material's textures.

#pragma once

#include "openltc/image/mip_levels.h"
#include "openltc/scene/scene.h"

#include <memory>
#include <vector>

namespace openltc::render {

/// A texture and its smaller copies.
class MipTexture {
public:
  /// `smaller` are those of another texture of the same picture; without them they are made.
  explicit MipTexture(const scene::Texture& texture,
                      std::shared_ptr<const image::MipLevels> smaller = {});

  /// Trilinear look-up at uv with a footprint of `width` in units of uv (0 = sharpest).
  Vec4f sample(Vec2f uv, float width) const;

  const std::shared_ptr<const image::MipLevels>& smaller() const { return smaller_; }

private:
  template <class Level> Vec4f bilinear(const Level& level, Vec2f uv) const;
  Vec4f look_up(int level, Vec2f uv) const;

  const scene::Texture* texture_;
  std::shared_ptr<const image::MipLevels> smaller_;
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
