// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/texture_sampler.h"

#include <algorithm>
#include <cmath>

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

Vec4f load4(const float* p) { return {p[0], p[1], p[2], p[3]}; }

Vec4f mix(Vec4f a, Vec4f b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
          a.w + (b.w - a.w) * t};
}

// Box filter of 2 x 2 texels; the last row or column of an odd size is used twice.
image::Image half(const image::Image& in) {
  image::Image out(std::max(in.width / 2, 1), std::max(in.height / 2, 1), 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int x0 = std::min(2 * x, in.width - 1), x1 = std::min(2 * x + 1, in.width - 1);
      const int y0 = std::min(2 * y, in.height - 1), y1 = std::min(2 * y + 1, in.height - 1);
      for (int c = 0; c < 4; ++c)
        out.pixel(x, y)[c] = 0.25f * (in.pixel(x0, y0)[c] + in.pixel(x1, y0)[c] +
                                      in.pixel(x0, y1)[c] + in.pixel(x1, y1)[c]);
    }
  return out;
}

} // namespace

MipTexture::MipTexture(const scene::Texture& texture) : texture_(&texture) {
  const image::Image* level = &texture.image;
  smaller_.reserve(32); // pointers into it must stay
  while (level->width > 1 || level->height > 1) {
    smaller_.push_back(half(*level));
    level = &smaller_.back();
  }
}

Vec4f MipTexture::bilinear(const image::Image& image, Vec2f uv) const {
  // Coordinates are wrapped into one period first, so that large ones keep their fraction.
  const float x = (uv.x - 2.0f * std::floor(0.5f * uv.x)) * float(image.width);
  const float y = (uv.y - 2.0f * std::floor(0.5f * uv.y)) * float(image.height);
  const auto clamped = [](scene::Wrap mode, float periodic, float plain, int size) {
    return mode == scene::Wrap::clamp_to_edge ? std::clamp(plain, 0.0f, 1.0f) * float(size)
                                              : periodic;
  };
  const float px = clamped(texture_->wrap_u, x, uv.x, image.width);
  const float py = clamped(texture_->wrap_v, y, uv.y, image.height);
  const auto texel = [&](int i, int j) {
    return load4(image.pixel(wrap(i, image.width, texture_->wrap_u),
                             wrap(j, image.height, texture_->wrap_v)));
  };
  if (texture_->nearest) return texel(int(std::floor(px)), int(std::floor(py)));
  const float fx = std::floor(px - 0.5f), fy = std::floor(py - 0.5f);
  const int i = int(fx), j = int(fy);
  const float tx = px - 0.5f - fx, ty = py - 0.5f - fy;
  return mix(mix(texel(i, j), texel(i + 1, j), tx), mix(texel(i, j + 1), texel(i + 1, j + 1), tx),
             ty);
}

Vec4f MipTexture::sample(Vec2f uv, float width) const {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = {0, 0};
  const image::Image& base = texture_->image;
  const float texels = width * float(std::max(base.width, base.height));
  if (!(texels > 1.0f) || smaller_.empty()) return bilinear(base, uv);
  const float lod = std::min(std::log2(texels), float(smaller_.size()));
  const int lower = std::min(int(lod), int(smaller_.size()));
  const int upper = std::min(lower + 1, int(smaller_.size()));
  const auto level = [&](int i) -> const image::Image& {
    return i == 0 ? base : smaller_[std::size_t(i - 1)];
  };
  return mix(bilinear(level(lower), uv), bilinear(level(upper), uv), lod - float(lower));
}

TextureSet::TextureSet(const scene::Scene& scene) {
  textures_.reserve(scene.textures.size());
  for (const scene::Texture& t : scene.textures)
    textures_.emplace_back(t);
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
