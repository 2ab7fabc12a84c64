// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// In the plane, with origin m, the middle of the corners, and axes e, f, an affine map is
//   uv(p) = c + g_e (p - m).e + g_f (p - m).f.
// c is the mean of the corners' uv, g the least squares solution over all corners, two unknowns for
// u and two for v with the same 2 x 2 normal matrix. A light knows the map by where it is (0, 0)
// and by texture_u = g_u / |g_u|^2, because u = (p - corner) . texture_u / |texture_u|^2.

#include "openltc/scene/emissive/emissive_texture.h"

#include <algorithm>
#include <cmath>

namespace openltc::scene {

namespace {

constexpr double k_tolerance = 1e-3; // of the picture
constexpr double k_texel_tolerance = 0.25;

struct Corner {
  Vec3d p;
  Vec2d uv;
};

Vec2d transformed(const TextureRef& ref, Vec2f uv) {
  const double u = double(uv.x), v = double(uv.y);
  return {double(ref.uv_row0[0]) * u + double(ref.uv_row0[1]) * v + double(ref.uv_row0[2]),
          double(ref.uv_row1[0]) * u + double(ref.uv_row1[1]) * v + double(ref.uv_row1[2])};
}

// What to add to a coordinate so that the light shows the picture once; false when none does.
bool unwrap(double lowest, double highest, double tolerance, Wrap wrap, double& shift) {
  shift = 0;
  if (wrap == Wrap::clamp_to_edge) return true;
  if (wrap == Wrap::repeat) shift = -std::floor(lowest + tolerance);
  return lowest + shift >= -tolerance && highest + shift <= 1 + tolerance;
}

} // namespace

bool place_emission_texture(const Mesh& mesh, const TextureRef& ref, const Texture& texture,
                            std::span<const std::uint32_t> triangles, light::PolygonLight& light) {
  return !texture.image.empty() &&
         place_texture(mesh, ref, texture.image.width, texture.image.height, texture.wrap_u,
                       texture.wrap_v, triangles, light);
}

bool place_texture(const Mesh& mesh, const TextureRef& ref, int width, int height, Wrap wrap_u,
                   Wrap wrap_v, std::span<const std::uint32_t> triangles,
                   light::PolygonLight& light) {
  const auto& tex_coord = ref.tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
  if (tex_coord.empty() || triangles.empty()) return false;
  std::vector<Corner> corners;
  Vec3d middle{0, 0, 0};
  Vec2d mean{0, 0};
  for (const std::uint32_t triangle : triangles)
    for (const std::uint32_t corner : mesh.triangles[triangle]) {
      corners.push_back({to_double(mesh.positions[corner]), transformed(ref, tex_coord[corner])});
      middle += corners.back().p;
      mean = mean + corners.back().uv;
    }
  middle = middle / double(corners.size());
  mean = mean * (1.0 / double(corners.size()));

  // Least squares in the plane.
  const Vec3d normal = to_double(light.normal);
  const Vec3d any = std::abs(normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d e = normalize(cross(normal, any)), f = cross(normal, e);
  double ee = 0, ef = 0, ff = 0;
  Vec2d e_uv{0, 0}, f_uv{0, 0};
  for (const Corner& corner : corners) {
    const double x = dot(corner.p - middle, e), y = dot(corner.p - middle, f);
    const Vec2d uv = corner.uv - mean;
    ee += x * x;
    ef += x * y;
    ff += y * y;
    e_uv = e_uv + uv * x;
    f_uv = f_uv + uv * y;
  }
  const double determinant = ee * ff - ef * ef;
  if (!(determinant > 0)) return false;
  const Vec2d g_e = (e_uv * ff - f_uv * ef) * (1 / determinant);
  const Vec2d g_f = (f_uv * ee - e_uv * ef) * (1 / determinant);

  // Every corner's own coordinates follow from the map.
  const Vec2d tolerance(std::max(k_tolerance, k_texel_tolerance / width),
                        std::max(k_tolerance, k_texel_tolerance / height));
  Vec2d lowest = corners[0].uv, highest = lowest;
  for (const Corner& corner : corners) {
    const Vec2d mapped = mean + g_e * dot(corner.p - middle, e) + g_f * dot(corner.p - middle, f);
    if (!(std::abs(mapped.x - corner.uv.x) <= tolerance.x) ||
        !(std::abs(mapped.y - corner.uv.y) <= tolerance.y))
      return false;
    lowest = {std::min(lowest.x, corner.uv.x), std::min(lowest.y, corner.uv.y)};
    highest = {std::max(highest.x, corner.uv.x), std::max(highest.y, corner.uv.y)};
  }
  double shift_u = 0, shift_v = 0;
  if (!unwrap(lowest.x, highest.x, tolerance.x, wrap_u, shift_u) ||
      !unwrap(lowest.y, highest.y, tolerance.y, wrap_v, shift_v))
    return false;

  // Where uv is (0, 0): g_e x + g_f y = -(c + shift). A map that squeezes the light onto a line of
  // the picture has no such place.
  const double spread = g_e.x * g_f.y - g_f.x * g_e.y;
  const double scale = (g_e.x * g_e.x + g_f.x * g_f.x) * (g_e.y * g_e.y + g_f.y * g_f.y);
  if (!(spread * spread > 1e-8 * scale)) return false;
  const Vec2d to_zero(-(mean.x + shift_u), -(mean.y + shift_v));
  const double x = (to_zero.x * g_f.y - g_f.x * to_zero.y) / spread;
  const double y = (g_e.x * to_zero.y - to_zero.x * g_e.y) / spread;
  const Vec3d u_gradient = e * g_e.x + f * g_f.x, v_gradient = e * g_e.y + f * g_f.y;
  light.texture = ref.texture;
  light.texture_corner = to_float(middle + e * x + f * y);
  light.texture_u = to_float(u_gradient / dot(u_gradient, u_gradient));
  light.texture_v = to_float(v_gradient / dot(v_gradient, v_gradient));
  return true;
}

int share_emission_texture(Scene& scene, int texture, std::vector<int>& known) {
  known.resize(scene.textures.size(), -1);
  int& index = known[std::size_t(texture)];
  if (index < 0) {
    index = int(scene.lights.textures.size());
    scene.lights.textures.push_back(scene.textures[std::size_t(texture)].image);
  }
  return index;
}

} // namespace openltc::scene
