// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The convention of MikkTSpace (M. Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008),
// which glTF names as the one that normal maps are baked for:
//
//   dp/du of each triangle, projected into the plane of the vertex normal and brought to unit
//   length, weighted by the corner's angle, summed over the corners that share position, normal,
//   texture coordinates and handedness.
//
// The bitangent is cross(normal, tangent) w. glTF's v points down the picture but the green of its
// normal maps up, so that w is +1 where the texture's area is negative: on a picture seen upright.
//
// It differs in that corners are joined over the whole mesh instead of over connected faces, which
// tells only where unconnected faces touch with equal normals and coordinates.

#include "openltc/scene/tangents.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace openltc::scene {

namespace {

// The bits of what makes two corners one.
struct CornerKey {
  std::array<std::uint32_t, 9> bits;
  bool operator==(const CornerKey&) const = default;
};

struct CornerHash {
  std::size_t operator()(const CornerKey& key) const {
    std::uint64_t h = 14695981039346656037u; // FNV-1a, word-wise
    for (const std::uint32_t word : key.bits)
      h = (h ^ word) * 1099511628211u;
    return std::size_t(h ^ (h >> 29));
  }
};

CornerKey corner_key(Vec3f p, Vec3f n, Vec2f uv, bool is_negative) {
  // + 0.0f turns -0 into 0
  const float values[8] = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f,  n.x + 0.0f,
                           n.y + 0.0f, n.z + 0.0f, uv.x + 0.0f, uv.y + 0.0f};
  CornerKey key;
  std::memcpy(key.bits.data(), values, sizeof values);
  key.bits[8] = is_negative;
  return key;
}

Vec3d any_perpendicular(Vec3d n) {
  const Vec3d axis = std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  return normalize(cross(n, axis));
}

// Angle at corner a of triangle abc.
double corner_angle(Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d u = b - a, v = c - a;
  return std::atan2(length(cross(u, v)), dot(u, v));
}

template <class T> void duplicate(std::vector<T>& values, std::size_t index) {
  if (!values.empty()) values.push_back(T(values[index]));
}

// Signed area in texture space, whose sign tells mirrored triangles from the others.
double uv_area(const std::vector<Vec2f>& uv, const std::array<std::uint32_t, 3>& t) {
  const Vec2f a = uv[t[0]], b = uv[t[1]], c = uv[t[2]];
  return (double(b.x) - double(a.x)) * (double(c.y) - double(a.y)) -
         (double(c.x) - double(a.x)) * (double(b.y) - double(a.y));
}

// Gives vertices that both kinds of triangles use a second copy. Returns each vertex's kind.
std::vector<bool> split_by_handedness(Mesh& mesh, int tex_coord) {
  constexpr std::uint32_t k_none = 0xFFFFFFFF;
  enum : std::uint8_t { unknown, positive, negative };
  const std::size_t original = mesh.positions.size();
  std::vector<std::uint8_t> kind(original, unknown);
  std::vector<std::uint32_t> copy(original, k_none);
  auto& uv = tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
  for (auto& triangle : mesh.triangles) {
    const double area = uv_area(uv, triangle);
    if (area == 0) continue; // gives no tangent, joins either kind
    const std::uint8_t wanted = area > 0 ? positive : negative;
    for (std::uint32_t& corner : triangle) {
      if (kind[corner] == unknown) kind[corner] = wanted;
      if (kind[corner] == wanted) continue;
      if (copy[corner] == k_none) {
        copy[corner] = std::uint32_t(mesh.positions.size());
        duplicate(mesh.positions, corner);
        duplicate(mesh.normals, corner);
        duplicate(mesh.tex_coord_0, corner);
        duplicate(mesh.tex_coord_1, corner);
        duplicate(mesh.colors, corner);
        kind.push_back(wanted);
        copy.push_back(k_none);
      }
      corner = copy[corner];
    }
  }
  std::vector<bool> is_negative(kind.size());
  for (std::size_t i = 0; i < kind.size(); ++i)
    is_negative[i] = kind[i] == negative;
  return is_negative;
}

} // namespace

void compute_tangents(Mesh& mesh, int tex_coord) {
  const std::vector<bool> is_negative = split_by_handedness(mesh, tex_coord);
  const auto& uv = tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;

  // Join corners.
  std::unordered_map<CornerKey, std::uint32_t, CornerHash> joined;
  std::vector<std::uint32_t> group(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const CornerKey key = corner_key(mesh.positions[i], mesh.normals[i], uv[i], is_negative[i]);
    group[i] = joined.try_emplace(key, std::uint32_t(joined.size())).first->second;
  }

  // Sum dp/du, angle-weighted.
  std::vector<Vec3d> sums(joined.size(), Vec3d(0, 0, 0));
  for (const auto& t : mesh.triangles) {
    const double area = uv_area(uv, t);
    if (area == 0 || !std::isfinite(area)) continue;
    const Vec3d p[3] = {to_double(mesh.positions[t[0]]), to_double(mesh.positions[t[1]]),
                        to_double(mesh.positions[t[2]])};
    const double dv1 = double(uv[t[1]].y) - double(uv[t[0]].y);
    const double dv2 = double(uv[t[2]].y) - double(uv[t[0]].y);
    // dp/du = (dv2 e1 - dv1 e2) / area; only the direction counts
    const Vec3d dp_du = ((p[1] - p[0]) * dv2 - (p[2] - p[0]) * dv1) * (area > 0 ? 1.0 : -1.0);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d n = to_double(mesh.normals[t[c]]);
      const Vec3d projected = dp_du - n * dot(n, dp_du);
      const double l = length(projected);
      if (!(l > 0) || !std::isfinite(l)) continue;
      sums[group[t[c]]] += projected * (corner_angle(p[c], p[(c + 1) % 3], p[(c + 2) % 3]) / l);
    }
  }

  mesh.tangents.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d n = to_double(mesh.normals[i]);
    Vec3d tangent = sums[group[i]] - n * dot(n, sums[group[i]]);
    const double l = length(tangent);
    tangent = l > 1e-12 ? tangent / l : any_perpendicular(n);
    mesh.tangents[i] =
        Vec4f(float(tangent.x), float(tangent.y), float(tangent.z), is_negative[i] ? 1.0f : -1.0f);
  }
}

bool repair_tangents(Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    Vec4f& t = mesh.tangents[i];
    const Vec3f n = mesh.normals[i];
    const Vec3f v = Vec3f(t.x, t.y, t.z) - n * dot(n, Vec3f(t.x, t.y, t.z));
    const float l = length(v);
    if (!(l > 1e-6f) || !std::isfinite(l)) {
      mesh.tangents.clear();
      return false;
    }
    t = Vec4f(v.x / l, v.y / l, v.z / l, t.w < 0 ? -1.0f : 1.0f);
  }
  return true;
}

} // namespace openltc::scene
