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

Vec4f texel(const image::Texels& image, int x, int y) { return image.rgba(x, y); }
Vec4f texel(const image::Image& image, int x, int y) {
  const float* p = image.pixel(x, y);
  return {p[0], p[1], p[2], p[3]};
}

Vec4f mix(Vec4f a, Vec4f b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
          a.w + (b.w - a.w) * t};
}

// Box filter of 2 x 2 texels; the last row or column of an odd size is used twice.
template <class Level> image::Image half(const Level& in) {
  image::Image out(std::max(in.width / 2, 1), std::max(in.height / 2, 1), 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int x0 = std::min(2 * x, in.width - 1), x1 = std::min(2 * x + 1, in.width - 1);
      const int y0 = std::min(2 * y, in.height - 1), y1 = std::min(2 * y + 1, in.height - 1);
      const Vec4f a = texel(in, x0, y0), b = texel(in, x1, y0), c = texel(in, x0, y1),
                  d = texel(in, x1, y1);
      float* const to = out.pixel(x, y);
      to[0] = 0.25f * (a.x + b.x + c.x + d.x);
      to[1] = 0.25f * (a.y + b.y + c.y + d.y);
      to[2] = 0.25f * (a.z + b.z + c.z + d.z);
      to[3] = 0.25f * (a.w + b.w + c.w + d.w);
    }
  return out;
}

MipLevels smaller_of(const image::Texels& image) {
  MipLevels levels;
  if (image.width > 1 || image.height > 1) levels.push_back(half(image));
  while (!levels.empty() && (levels.back().width > 1 || levels.back().height > 1))
    levels.push_back(half(levels.back()));
  return levels;
}

} // namespace

MipTexture::MipTexture(const scene::Texture& texture, std::shared_ptr<const MipLevels> smaller)
    : texture_(&texture), smaller_(std::move(smaller)) {
  if (!smaller_) smaller_ = std::make_shared<const MipLevels>(smaller_of(texture.image));
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
    return texel(image, wrap(i, image.width, texture_->wrap_u),
                 wrap(j, image.height, texture_->wrap_v));
  };
  if (texture_->nearest) return at(int(std::floor(px)), int(std::floor(py)));
  const float fx = std::floor(px - 0.5f), fy = std::floor(py - 0.5f);
  const int i = int(fx), j = int(fy);
  const float tx = px - 0.5f - fx, ty = py - 0.5f - fy;
  return mix(mix(at(i, j), at(i + 1, j), tx), mix(at(i, j + 1), at(i + 1, j + 1), tx), ty);
}

Vec4f MipTexture::look_up(int level, Vec2f uv) const {
  return level == 0 ? bilinear(texture_->image, uv)
                    : bilinear((*smaller_)[std::size_t(level - 1)], uv);
}

Vec4f MipTexture::sample(Vec2f uv, float width) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = {0, 0};
  const image::Texels& base = texture_->image;
  const int levels = int(smaller_->size());
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
  std::map<std::pair<const void*, const void*>, std::shared_ptr<const MipLevels>> known;
  for (const scene::Texture& t : scene.textures) {
    std::shared_ptr<const MipLevels>& smaller = known[t.image.identity()];
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
