// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/surface_emission.h"

#include "openltc/scene/emissive/emissive_texture.h"
#include "openltc/scene/triangle_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace openltc::scene {

namespace {

// Up to so many texels a triangle has well-spread samples, above it all its texels are looked at.
// Beyond its share of the second number, for the whole mesh, or beyond the third by itself, it is
// every second one along each side, and so on.
constexpr double k_few_texels = 256, k_most_texels = 3e7, k_most_texels_each = 4e6;
// Texels along a side; what is longer repeats its texture so often that samples tell its mean.
constexpr double k_longest_side = 1e6, k_largest_coordinate = 1e12;

std::int64_t wrapped(std::int64_t i, std::int64_t size, Wrap mode) {
  if (mode == Wrap::clamp_to_edge) return std::clamp<std::int64_t>(i, 0, size - 1);
  const std::int64_t period = mode == Wrap::mirrored_repeat ? 2 * size : size;
  const std::int64_t m = ((i % period) + period) % period;
  return m < size ? m : period - 1 - m;
}

Vec4f texel_of(const Texture& texture, std::int64_t x, std::int64_t y) {
  return texture.image.rgba(int(wrapped(x, texture.image.width, texture.wrap_u)),
                            int(wrapped(y, texture.image.height, texture.wrap_v)));
}

// The texture where its sampler looks at it closely. Black and clear where there is no place.
Vec4f look_up(const Texture& texture, Vec2d uv) {
  const double x = uv.x * texture.image.width, y = uv.y * texture.image.height;
  if (!(std::abs(x) < 1e12) || !(std::abs(y) < 1e12)) return {0, 0, 0, 0};
  if (texture.nearest)
    return texel_of(texture, std::int64_t(std::floor(x)), std::int64_t(std::floor(y)));
  const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5);
  const float tx = float(x - 0.5 - fx), ty = float(y - 0.5 - fy);
  const std::int64_t i = std::int64_t(fx), j = std::int64_t(fy);
  const auto mix = [](Vec4f a, Vec4f b, float t) {
    return Vec4f{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
                 a.w + (b.w - a.w) * t};
  };
  return mix(mix(texel_of(texture, i, j), texel_of(texture, i + 1, j), tx),
             mix(texel_of(texture, i, j + 1), texel_of(texture, i + 1, j + 1), tx), ty);
}

double doubled(Vec2d a, Vec2d b, Vec2d c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct MeanSum {
  Vec3d sum{0, 0, 0};
  double weight = 0;
  Vec3f lowest{1e30f, 1e30f, 1e30f}, highest{0, 0, 0};

  void add(Vec3f value, double share) {
    sum += to_double(value) * share;
    lowest = Vec3f(std::min(lowest.x, value.x), std::min(lowest.y, value.y),
                   std::min(lowest.z, value.z));
    highest = Vec3f(std::max(highest.x, value.x), std::max(highest.y, value.y),
                    std::max(highest.z, value.z));
  }
};

} // namespace

SurfaceEmission::SurfaceEmission(const Mesh& mesh, const Material& material,
                                 const std::vector<Texture>& textures)
    : mesh_(mesh), material_(material) {
  const auto texture_of = [&](const TextureRef& ref) -> const Texture* {
    const auto& tex_coord = ref.tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
    if (ref.texture < 0 || tex_coord.empty()) return nullptr;
    const Texture& texture = textures[std::size_t(ref.texture)];
    return texture.image.empty() ? nullptr : &texture;
  };
  glow_ = texture_of(material.emission_texture);
  if (material.alpha_mode == AlphaMode::opaque) return;
  has_alpha_ = true;
  alpha_ = texture_of(material.base_color_texture);
  has_vertex_alpha_ =
      std::any_of(mesh.colors.begin(), mesh.colors.end(), [](Vec4f c) { return c.w != 1.0f; });
  is_cut_ = alpha_ || has_vertex_alpha_ ||
            (material.alpha_mode == AlphaMode::mask ? material.base_color.w < material.alpha_cutoff
                                                    : material.base_color.w < 1);
}

Vec2d SurfaceEmission::coordinates(const TextureRef& ref, std::uint32_t triangle,
                                   Vec3d barycentric) const {
  const auto& tex_coord = ref.tex_coord == 0 ? mesh_.tex_coord_0 : mesh_.tex_coord_1;
  const auto& t = mesh_.triangles[triangle];
  const Vec2f a = tex_coord[t[0]], b = tex_coord[t[1]], c = tex_coord[t[2]];
  const double u =
      double(a.x) * barycentric.x + double(b.x) * barycentric.y + double(c.x) * barycentric.z;
  const double v =
      double(a.y) * barycentric.x + double(b.y) * barycentric.y + double(c.y) * barycentric.z;
  return {double(ref.uv_row0[0]) * u + double(ref.uv_row0[1]) * v + double(ref.uv_row0[2]),
          double(ref.uv_row1[0]) * u + double(ref.uv_row1[1]) * v + double(ref.uv_row1[2])};
}

Vec3f SurfaceEmission::at(std::uint32_t triangle, Vec3d barycentric) const {
  float share = 1;
  if (has_alpha_) {
    share = material_.base_color.w;
    if (has_vertex_alpha_) {
      const auto& t = mesh_.triangles[triangle];
      share *= float(double(mesh_.colors[t[0]].w) * barycentric.x +
                     double(mesh_.colors[t[1]].w) * barycentric.y +
                     double(mesh_.colors[t[2]].w) * barycentric.z);
    }
    if (alpha_)
      share *= look_up(*alpha_, coordinates(material_.base_color_texture, triangle, barycentric)).w;
    if (material_.alpha_mode == AlphaMode::mask)
      share = share >= material_.alpha_cutoff ? 1.0f : 0.0f;
    share = share > 0 ? std::min(share, 1.0f) : 0.0f;
  }
  if (!glow_ || share == 0) return Vec3f(share);
  const Vec4f glow =
      look_up(*glow_, coordinates(material_.emission_texture, triangle, barycentric));
  const auto sane = [&](float x) { return x > 0 && std::isfinite(x) ? x * share : 0.0f; };
  return {sane(glow.x), sane(glow.y), sane(glow.z)};
}

const Texture* SurfaceEmission::finest() const {
  if (!glow_ || !alpha_) return glow_ ? glow_ : alpha_;
  return alpha_->image.pixel_count() > glow_->image.pixel_count() ? alpha_ : glow_;
}

SurfaceEmission::Mean SurfaceEmission::mean_over(std::span<const Patch> patches) const {
  if (patches.empty()) return {};
  const Texture* const texture = finest();
  if (!texture && !has_vertex_alpha_)
    return {material_.emission * at(patches[0].triangle, Vec3d(1, 0, 0)), true};
  const TextureRef& ref =
      texture == alpha_ && texture ? material_.base_color_texture : material_.emission_texture;
  const double most_texels = std::clamp(k_most_texels / double(mesh_.triangles.size()),
                                        4 * k_few_texels, k_most_texels_each);
  MeanSum mean;
  for (const Patch& patch : patches) {
    double texels = 0, along = 0, area = 0; // within the triangle, along its sides
    Vec2d uv[3] = {};
    const double width = texture ? texture->image.width : 1;
    const double height = texture ? texture->image.height : 1;
    if (texture) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec2d at_corner = coordinates(ref, patch.triangle, patch.corners[c]);
        uv[c] = {at_corner.x * width, at_corner.y * height};
      }
      // Coordinates beyond all sense, or none at all, are met by a few samples.
      const bool is_sane = std::all_of(std::begin(uv), std::end(uv), [](Vec2d p) {
        return std::abs(p.x) < k_largest_coordinate && std::abs(p.y) < k_largest_coordinate;
      });
      if (!is_sane) std::fill(std::begin(uv), std::end(uv), Vec2d(0, 0));
      area = doubled(uv[0], uv[1], uv[2]);
      texels = 0.5 * std::abs(area);
      for (std::size_t c = 0; c < 3; ++c)
        along =
            std::max(along, std::hypot(uv[(c + 1) % 3].x - uv[c].x, uv[(c + 1) % 3].y - uv[c].y));
    }
    const auto place = [&](double b, double c) {
      return patch.corners[0] * (1 - b - c) + patch.corners[1] * b + patch.corners[2] * c;
    };
    std::size_t count = 0;
    MeanSum own = mean;
    own.sum = Vec3d(0, 0, 0);
    if (texels > k_few_texels && along < k_longest_side) {
      // Centres of texels within the triangle.
      const double stride = std::max(std::ceil(std::sqrt(texels / most_texels)), 1.0);
      const auto [low_y, high_y] = std::minmax({uv[0].y, uv[1].y, uv[2].y});
      for (double y = std::floor(low_y) + 0.5; y < high_y; y += stride) {
        const RowRange range = row_range(uv, y, y);
        for (double x = std::floor(range.low) + 0.5; x < range.high; x += stride) {
          const double b = doubled(uv[0], {x, y}, uv[2]) / area;
          const double c = doubled(uv[0], uv[1], {x, y}) / area;
          if (b < 0 || c < 0 || b + c > 1) continue;
          own.add(at(patch.triangle, place(b, c)), 1);
          ++count;
        }
      }
    }
    if (count == 0) {
      count = std::size_t(std::clamp(4 * std::max(texels, along), 16.0, 1024.0));
      for (std::size_t i = 0; i < count; ++i) {
        // Additive recurrence with the plastic number (M. Roberts, 2018), folded into the triangle.
        double a = std::fmod(0.5 + 0.7548776662466927 * double(i + 1), 1.0);
        double b = std::fmod(0.5 + 0.5698402909980532 * double(i + 1), 1.0);
        if (a + b > 1) {
          a = 1 - a;
          b = 1 - b;
        }
        own.add(at(patch.triangle, place(a, b)), 1);
      }
    }
    own.sum = mean.sum + own.sum * (patch.area / double(count));
    own.weight = mean.weight + patch.area;
    mean = own;
  }
  if (!(mean.weight > 0)) return {};
  const auto is_even = [](float low, float high) { return high - low <= 0.01f * high; };
  return {material_.emission * to_float(mean.sum / mean.weight),
          is_even(mean.lowest.x, mean.highest.x) && is_even(mean.lowest.y, mean.highest.y) &&
              is_even(mean.lowest.z, mean.highest.z)};
}

bool SurfaceEmission::place_texture_on(light::PolygonLight& light, const FlatPart& part) const {
  return glow_ && !is_cut_ &&
         place_emission_texture(mesh_, material_.emission_texture, *glow_, part.source, light);
}

std::vector<Patch> patches_of(const WeldedMesh& welded, std::span<const std::uint32_t> triangles) {
  std::vector<Patch> patches;
  for (const std::uint32_t i : triangles) {
    Patch patch;
    patch.triangle = welded.source[i];
    patch.area = welded.areas[i];
    patches.push_back(patch);
  }
  return patches;
}

std::vector<Patch> patches_of(const FlatPart& part, const Mesh& mesh, const Extent& extent) {
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    Patch patch;
    patch.triangle = part.source[i];
    const auto& t = mesh.triangles[patch.triangle];
    const Vec3d a = to_double(mesh.positions[t[0]]) - extent.center;
    const Vec3d ab = to_double(mesh.positions[t[1]]) - extent.center - a;
    const Vec3d ac = to_double(mesh.positions[t[2]]) - extent.center - a;
    const Vec3d normal = cross(ab, ac);
    const double scale = dot(normal, normal);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d p = part.points[part.triangles[i][c]] - a;
      double b1 = scale > 0 ? dot(cross(p, ac), normal) / scale : 0;
      double b2 = scale > 0 ? dot(cross(ab, p), normal) / scale : 0;
      // Corners were moved by a little.
      b1 = std::clamp(b1, 0.0, 1.0);
      b2 = std::clamp(b2, 0.0, 1.0 - b1);
      patch.corners[c] = Vec3d(1 - b1 - b2, b1, b2);
    }
    const Vec3d q = part.points[part.triangles[i][0]];
    patch.area = 0.5 * length(cross(part.points[part.triangles[i][1]] - q,
                                    part.points[part.triangles[i][2]] - q));
    patches.push_back(patch);
  }
  return patches;
}

} // namespace openltc::scene
