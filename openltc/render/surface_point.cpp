// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The material model is that of openltc/api/material.h.

#include "openltc/render/surface_point.h"

#include "openltc/api/material.h"

#include <algorithm>
#include <cmath>

namespace openltc::render {

namespace {

using detail::unit_or;

struct Corner {
  std::uint32_t a, b, c;
  float wa, wb, wc;
};

Corner corner(const scene::Mesh& mesh, std::uint32_t triangle, float u, float v) {
  const auto& t = mesh.triangles[triangle];
  return {t[0], t[1], t[2], 1 - u - v, u, v};
}

Vec3f interpolate(const std::vector<Vec3f>& values, const Corner& c) {
  return values[c.a] * c.wa + values[c.b] * c.wb + values[c.c] * c.wc;
}
Vec2f interpolate(const std::vector<Vec2f>& values, const Corner& c) {
  if (values.empty()) return {0, 0};
  return values[c.a] * c.wa + values[c.b] * c.wb + values[c.c] * c.wc;
}
Vec4f interpolate(const std::vector<Vec4f>& values, const Corner& c) {
  if (values.empty()) return {1, 1, 1, 1};
  const Vec4f &a = values[c.a], &b = values[c.b], &d = values[c.c];
  return {a.x * c.wa + b.x * c.wb + d.x * c.wc, a.y * c.wa + b.y * c.wb + d.y * c.wc,
          a.z * c.wa + b.z * c.wb + d.z * c.wc, a.w * c.wa + b.w * c.wb + d.w * c.wc};
}

// In double, so that it is off by no more than its rounding.
Vec3f position_of(const scene::Mesh& mesh, const Corner& c) {
  return to_float(to_double(mesh.positions[c.a]) * (1 - double(c.wb) - double(c.wc)) +
                  to_double(mesh.positions[c.b]) * double(c.wb) +
                  to_double(mesh.positions[c.c]) * double(c.wc));
}

// How far shadow rays start off the surface. The corners, the point and the ray's origin are
// rounded to 2^-24 of their coordinates each; the ray tracer subtracts the origin from the corners
// and multiplies, which errs by a few times 2^-24 of the triangle's size. All that does not depend
// on how far away the camera is.
float offset_of(const scene::Mesh& mesh, const Corner& c) {
  constexpr float k_roundings = 16.0f / 16777216;
  const Vec3f &pa = mesh.positions[c.a], &pb = mesh.positions[c.b], &pc = mesh.positions[c.c];
  float magnitude = 0;
  for (const Vec3f& p : {pa, pb, pc})
    magnitude = std::max({magnitude, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const Vec3f e1 = pb - pa, e2 = pc - pa;
  const float size = std::max({std::abs(e1.x), std::abs(e1.y), std::abs(e1.z), std::abs(e2.x),
                               std::abs(e2.y), std::abs(e2.z)});
  return k_roundings * (magnitude + size);
}

// Side of a square of uv that covers as much as a square metre of the triangle.
float uv_per_metre(const std::vector<Vec2f>& tex_coord, const Corner& c, Vec3f area_vector) {
  if (tex_coord.empty()) return 0;
  const Vec2f e1 = tex_coord[c.b] - tex_coord[c.a];
  const Vec2f e2 = tex_coord[c.c] - tex_coord[c.a];
  const float uv_area2 = std::abs(e1.x * e2.y - e1.y * e2.x);
  const float area2 = length(area_vector);
  return area2 > 0 ? std::sqrt(uv_area2 / area2) : 0.0f;
}

Vec3f mapped_normal(const scene::Mesh& mesh, const scene::Material& m, const TextureSet& textures,
                    const Corner& c, const Vec2f uv[2], const float width[2], Vec3f normal) {
  if (m.normal_texture.texture < 0 || mesh.tangents.empty()) return normal;
  const Vec4f t4 = interpolate(mesh.tangents, c);
  const Vec3f t3(t4.x, t4.y, t4.z);
  const Vec3f tangent = unit_or(t3 - normal * dot(normal, t3), Vec3f(0.0f));
  if (dot(tangent, tangent) == 0) return normal;
  const Vec3f bitangent = cross(normal, tangent) * (t4.w < 0 ? -1.0f : 1.0f);
  const Vec4f texel = textures.sample(m.normal_texture, uv, width);
  const Vec3f n((2 * texel.x - 1) * m.normal_scale, (2 * texel.y - 1) * m.normal_scale,
                2 * texel.z - 1);
  return unit_or(tangent * n.x + bitangent * n.y + normal * n.z, normal);
}

} // namespace

float surface_alpha(const scene::Scene& scene, const TextureSet& textures, std::uint32_t mesh_index,
                    std::uint32_t triangle, float u, float v) {
  const scene::Mesh& mesh = scene.meshes[mesh_index];
  const scene::Material& m = scene.materials[std::size_t(mesh.material)];
  const Corner c = corner(mesh, triangle, u, v);
  const Vec2f uv[2] = {interpolate(mesh.tex_coord_0, c), interpolate(mesh.tex_coord_1, c)};
  const float sharp[2] = {0, 0};
  return detail::saturate(m.base_color.w * interpolate(mesh.colors, c).w *
                          textures.sample(m.base_color_texture, uv, sharp).w);
}

SurfacePoint evaluate_surface(const scene::Scene& scene, const TextureSet& textures,
                              std::uint32_t mesh_index, std::uint32_t triangle, float u, float v,
                              Vec3f direction, float footprint) {
  const scene::Mesh& mesh = scene.meshes[mesh_index];
  const scene::Material& m = scene.materials[std::size_t(mesh.material)];
  const Corner c = corner(mesh, triangle, u, v);

  SurfacePoint s;
  s.view = -direction;
  s.position = position_of(mesh, c);
  const Vec3f& pa = mesh.positions[c.a];
  const Vec3f area_vector = cross(mesh.positions[c.b] - pa, mesh.positions[c.c] - pa);
  const Vec3f front = unit_or(area_vector, s.view);
  const bool from_front = dot(front, s.view) >= 0;
  s.geometric = from_front ? front : -front;

  s.offset = offset_of(mesh, c);

  // Footprint of the pixel on the surface, in uv; the shorter axis of the ellipse, since several
  // samples per pixel cover the longer one.
  const Vec2f uv[2] = {interpolate(mesh.tex_coord_0, c), interpolate(mesh.tex_coord_1, c)};
  const float cos_view = std::max(std::abs(dot(front, s.view)), 0.05f);
  const float on_surface = footprint / std::sqrt(cos_view);
  const float width[2] = {on_surface * uv_per_metre(mesh.tex_coord_0, c, area_vector),
                          on_surface * uv_per_metre(mesh.tex_coord_1, c, area_vector)};

  Vec3f normal = unit_or(interpolate(mesh.normals, c), front);
  normal = mapped_normal(mesh, m, textures, c, uv, width, normal);
  if (!from_front) normal = -normal;
  s.normal = detail::towards_viewer(normal, s.view);

  const Vec4f vertex_color = interpolate(mesh.colors, c);
  const Vec4f base_texel = textures.sample(m.base_color_texture, uv, width);
  const Vec3f base(m.base_color.x * vertex_color.x * base_texel.x,
                   m.base_color.y * vertex_color.y * base_texel.y,
                   m.base_color.z * vertex_color.z * base_texel.z);
  // glTF culls the back of a surface that has one side only.
  if (!from_front && !m.double_sided)
    s.alpha = 0;
  else if (m.alpha_mode == scene::AlphaMode::blend)
    s.alpha = detail::saturate(m.base_color.w * vertex_color.w * base_texel.w);

  const Vec4f mr = textures.sample(m.metallic_roughness_texture, uv, width);
  const Vec4f specular_texel = textures.sample(m.specular_texture, uv, width);
  const Vec4f tint = textures.sample(m.specular_color_texture, uv, width);
  const Reflectance reflectance =
      mix_reflectance(base, m.metallic * mr.z, m.roughness * mr.y, m.specular * specular_texel.w,
                      m.specular_color * dielectric_f0(m.ior) * Vec3f(tint.x, tint.y, tint.z));
  s.f0 = reflectance.f0;
  s.f90 = reflectance.f90;
  s.albedo = reflectance.albedo;
  s.roughness = reflectance.roughness;

  const Vec4f glow = textures.sample(m.emission_texture, uv, width);
  const bool emits = from_front || m.double_sided;
  s.emission = emits ? m.emission * Vec3f(glow.x, glow.y, glow.z) : Vec3f(0.0f);
  s.lit = !m.unlit;
  if (m.unlit) s.emission = base;
  return s;
}

} // namespace openltc::render
