// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/texture_sampler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace openltc::render {

namespace {

int wrap(int i, int size, scene::Wrap mode) {
  switch (mode) {
  case scene::Wrap::clamp_to_edge:
    return std::clamp(i, 0, size - 1);
  case scene::Wrap::mirrored_repeat: {
    const int period = 2 * size;
    const int m = ((i % period) + period) % period;
    return m < size ? m : period - 1 - m;
  }
  case scene::Wrap::repeat:
    break;
  }
  return ((i % size) + size) % size;
}

Vec4f mix(Vec4f a, Vec4f b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
          a.w + (b.w - a.w) * t};
}

} // namespace

MipTexture::MipTexture(const scene::Texture& texture,
                       std::shared_ptr<const image::MipLevels> smaller)
    : texture_(&texture), smaller_(std::move(smaller)) {
  if (!smaller_) smaller_ = std::make_shared<const image::MipLevels>(texture.image);
}

template <class Level> Vec4f MipTexture::bilinear(const Level& image, Vec2f uv) const {
  // Coordinates are wrapped into one period first, so that large ones keep their fraction.
  const float x = (uv.x - 2.0f * std::floor(0.5f * uv.x)) * float(image.width);
  const float y = (uv.y - 2.0f * std::floor(0.5f * uv.y)) * float(image.height);
  const auto clamped = [](scene::Wrap mode, float periodic, float plain, int size) {
    return mode == scene::Wrap::clamp_to_edge ? std::clamp(plain, 0.0f, 1.0f) * float(size)
                                              : periodic;
  };
  const float px = clamped(texture_->wrap_u, x, uv.x, image.width);
  const float py = clamped(texture_->wrap_v, y, uv.y, image.height);
  const auto at = [&](int i, int j) {
    return image.rgba(wrap(i, image.width, texture_->wrap_u),
                      wrap(j, image.height, texture_->wrap_v));
  };
  if (texture_->nearest) return at(int(std::floor(px)), int(std::floor(py)));
  const float fx = std::floor(px - 0.5f), fy = std::floor(py - 0.5f);
  const int i = int(fx), j = int(fy);
  const float tx = px - 0.5f - fx, ty = py - 0.5f - fy;
  return mix(mix(at(i, j), at(i + 1, j), tx), mix(at(i, j + 1), at(i + 1, j + 1), tx), ty);
}

Vec4f MipTexture::look_up(int level, Vec2f uv) const {
  if (level == 0) return bilinear(texture_->image, uv);
  return smaller_->look_at(level, [&](const auto& copy) { return bilinear(copy, uv); });
}

Vec4f MipTexture::sample(Vec2f uv, float width) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = {0, 0};
  const image::Texels& base = texture_->image;
  const int levels = smaller_->count();
  const float texels = width * float(std::max(base.width, base.height));
  if (!(texels > 1.0f) || levels == 0) return look_up(0, uv);
  const float lod = std::min(std::log2(texels), float(levels));
  const int lower = std::min(int(lod), levels);
  const int upper = std::min(lower + 1, levels);
  return mix(look_up(lower, uv), look_up(upper, uv), lod - float(lower));
}

TextureSet::TextureSet(const scene::Scene& scene) {
  textures_.reserve(scene.textures.size());
  // Samplers of the same picture share its smaller copies.
  std::map<std::pair<const void*, const void*>, std::shared_ptr<const image::MipLevels>> known;
  for (const scene::Texture& t : scene.textures) {
    std::shared_ptr<const image::MipLevels>& smaller = known[t.image.identity()];
    textures_.emplace_back(t, smaller);
    smaller = textures_.back().smaller();
  }
}

Vec4f TextureSet::sample(const scene::TextureRef& ref, const Vec2f tex_coord[2],
                         const float width[2]) const {
  if (ref.texture < 0) return {1, 1, 1, 1};
  const int set = ref.tex_coord == 1 ? 1 : 0;
  const Vec2f t = tex_coord[set];
  const auto& r0 = ref.uv_row0;
  const auto& r1 = ref.uv_row1;
  const Vec2f uv{r0[0] * t.x + r0[1] * t.y + r0[2], r1[0] * t.x + r1[1] * t.y + r1[2]};
  const float scale = std::sqrt(std::abs(r0[0] * r1[1] - r0[1] * r1[0]));
  return textures_[std::size_t(ref.texture)].sample(uv, width[set] * scale);
}

} // namespace openltc::render
