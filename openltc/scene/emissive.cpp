// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From triangles to planes: take the largest triangle that is left, collect everything that lies in
// its plane within the tolerances, go on with the rest. Flat emitters give one plane for each of
// their sides, curved ones one for each facet. A hash over plane normal and offset finds the
// candidates, so that the time grows with the number of triangles and not with its square.

#include "openltc/scene/emissive.h"

#include "openltc/light/curved.h"
#include "openltc/light/polygon.h"
#include "openltc/scene/emissive_texture.h"
#include "openltc/scene/grid.h"
#include "openltc/scene/outline.h"
#include "openltc/scene/recognise.h"
#include "openltc/scene/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <variant>

namespace openltc::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
// More lights than this deserve a word of warning: time grows with their number.
constexpr std::size_t k_many_lights = 256;
// The facets of a curved surface show little of the texture each: beyond this many, its mean does.
constexpr std::size_t k_max_pictures = 32;

// Triangles of one plane, all counter-clockwise about the plane's normal.
struct Plane {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> members; // of the welded mesh
};

class PlaneFinder {
public:
  PlaneFinder(const WeldedMesh& mesh, const Extent& extent, const EmissiveOptions& options,
              bool two_sided)
      : mesh_(mesh), extent_(extent), two_sided_(two_sided),
        cos_angle_(std::cos(options.plane_angle_rad)), normal_cell_(1.05 * options.plane_angle_rad),
        // Normals that differ by the angle shift the offset of a plane through the same point by up
        // to half the diagonal times the angle.
        offset_cell_(extent.diagonal * options.plane_angle_rad + 2 * extent.plane),
        is_taken_(mesh.triangles.size(), false) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      grid_[cell_of(mesh.normals[i], offset_of(i))].push_back(std::uint32_t(i));
  }

  std::vector<Plane> find() {
    std::vector<std::uint32_t> by_area(mesh_.triangles.size());
    std::iota(by_area.begin(), by_area.end(), 0u);
    std::stable_sort(by_area.begin(), by_area.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.areas[a] > mesh_.areas[b];
    });
    std::vector<Plane> planes;
    for (const std::uint32_t seed : by_area)
      if (!is_taken_[seed]) planes.push_back(collect(seed));
    return planes;
  }

private:
  double offset_of(std::size_t triangle) const {
    return dot(mesh_.normals[triangle], mesh_.points[mesh_.triangles[triangle][0]]);
  }

  Cell cell_of(Vec3d normal, double offset) const {
    return {std::llround(normal.x / normal_cell_), std::llround(normal.y / normal_cell_),
            std::llround(normal.z / normal_cell_), std::llround(offset / offset_cell_)};
  }

  Plane collect(std::uint32_t seed) {
    Plane plane;
    const Vec3d normal = mesh_.normals[seed];
    const double offset = offset_of(seed);
    gather(normal, offset, normal, offset, false, plane);
    // Light that leaves both sides does not care which side a triangle was drawn from.
    if (two_sided_) gather(-normal, -offset, normal, offset, true, plane);
    std::sort(plane.members.begin(), plane.members.end());
    remove_duplicates(plane, normal);
    return plane;
  }

  void gather(Vec3d key_normal, double key_offset, Vec3d normal, double offset, bool is_reversed,
              Plane& plane) {
    for_neighbours(cell_of(key_normal, key_offset), 4, [&](const Cell& cell) {
      const auto found = grid_.find(cell);
      if (found == grid_.end()) return;
      std::vector<std::uint32_t>& candidates = found->second;
      std::size_t left = 0;
      for (const std::uint32_t candidate : candidates) {
        if (is_taken_[candidate]) continue;
        const double cos_to_plane = dot(mesh_.normals[candidate], normal) * (is_reversed ? -1 : 1);
        if (cos_to_plane >= cos_angle_ && lies_in(candidate, normal, offset)) {
          is_taken_[candidate] = true;
          plane.members.push_back(candidate);
        } else {
          candidates[left++] = candidate;
        }
      }
      candidates.resize(left);
    });
  }

  bool lies_in(std::uint32_t triangle, Vec3d normal, double offset) const {
    for (const std::uint32_t corner : mesh_.triangles[triangle])
      if (!(std::abs(dot(mesh_.points[corner], normal) - offset) <= extent_.plane)) return false;
    return true;
  }

  // A triangle that stands twice in the same place shines once: the camera sees one of them.
  void remove_duplicates(Plane& plane, Vec3d normal) const {
    std::set<Triangle> seen;
    std::vector<std::uint32_t> members;
    for (const std::uint32_t member : plane.members) {
      Triangle t = mesh_.triangles[member];
      if (dot(mesh_.normals[member], normal) < 0) std::swap(t[1], t[2]);
      Triangle sorted = t;
      std::sort(sorted.begin(), sorted.end());
      if (!seen.insert(sorted).second) continue;
      members.push_back(member);
      plane.triangles.push_back(t);
    }
    plane.members = std::move(members);
  }

  const WeldedMesh& mesh_;
  const Extent& extent_;
  bool two_sided_;
  double cos_angle_;
  double normal_cell_;
  double offset_cell_;
  std::vector<bool> is_taken_;
  Grid grid_;
};

float wrapped(float u, Wrap wrap) {
  if (wrap == Wrap::clamp_to_edge) return std::clamp(u, 0.0f, 1.0f);
  if (wrap == Wrap::repeat) return u - std::floor(u);
  const float v = u - 2 * std::floor(u / 2); // 0 .. 2
  return v <= 1 ? v : 2 - v;
}

Vec3f nearest_texel(const Texture& texture, float u, float v) {
  const int width = texture.image.width, height = texture.image.height;
  const int x = std::min(int(wrapped(u, texture.wrap_u) * float(width)), width - 1);
  const int y = std::min(int(wrapped(v, texture.wrap_v) * float(height)), height - 1);
  return texture.image.rgb(x, y);
}

struct TextureMean {
  Vec3d sum{0, 0, 0};
  double weight = 0;
  double lowest = 1e30, highest = -1e30;
};

// Adds one triangle with weight `area`: as many well-spread points as it covers texels.
void add_samples(const Mesh& mesh, const TextureRef& ref, const Texture& texture,
                 std::uint32_t triangle, double area, TextureMean& mean) {
  const auto& tex_coord = ref.tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
  Vec2f uv[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec2f raw = tex_coord[mesh.triangles[triangle][c]];
    uv[c] = Vec2f(ref.uv_row0[0] * raw.x + ref.uv_row0[1] * raw.y + ref.uv_row0[2],
                  ref.uv_row1[0] * raw.x + ref.uv_row1[1] * raw.y + ref.uv_row1[2]);
  }
  const Vec2f e1 = uv[1] - uv[0], e2 = uv[2] - uv[0];
  const double texels = 0.5 * std::abs(double(e1.x) * double(e2.y) - double(e1.y) * double(e2.x)) *
                        texture.image.width * texture.image.height;
  const int count = int(std::clamp(texels, 16.0, 16384.0));
  for (int i = 0; i < count; ++i) {
    // Additive recurrence with the plastic number (M. Roberts, 2018), folded into the triangle.
    double a = std::fmod(0.5 + 0.7548776662466927 * (i + 1), 1.0);
    double b = std::fmod(0.5 + 0.5698402909980532 * (i + 1), 1.0);
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    const Vec2f at = uv[0] + e1 * float(a) + e2 * float(b);
    const Vec3f value =
        std::isfinite(at.x) && std::isfinite(at.y) && std::abs(at.x) < 1e9f && std::abs(at.y) < 1e9f
            ? nearest_texel(texture, at.x, at.y)
            : Vec3f(0, 0, 0);
    mean.sum += to_double(value) * (area / count);
    mean.lowest = std::min({mean.lowest, double(value.x), double(value.y), double(value.z)});
    mean.highest = std::max({mean.highest, double(value.x), double(value.y), double(value.z)});
  }
  mean.weight += area;
}

// The plane through all members: area-weighted normal and centre.
void fit_plane(const WeldedMesh& mesh, const Plane& plane, Vec3d& normal, Vec3d& center) {
  Vec3d normal_sum{0, 0, 0}, center_sum{0, 0, 0};
  double area_sum = 0;
  for (const Triangle& t : plane.triangles) {
    const Vec3d a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    const Vec3d doubled = cross(b - a, c - a);
    const double area = 0.5 * length(doubled);
    normal_sum += doubled;
    center_sum += (a + b + c) * (area / 3);
    area_sum += area;
  }
  normal = normalize(normal_sum);
  center = center_sum / area_sum;
}

light::PolygonLight light_of(const WeldedMesh& mesh, const Plane& plane, const Extent& extent) {
  Vec3d normal, center;
  fit_plane(mesh, plane, normal, center);
  // Only this plane's corners, moved into the plane.
  std::unordered_map<std::uint32_t, std::uint32_t> local;
  std::vector<Vec3d> points;
  double deviation = 0;
  std::vector<Triangle> triangles = plane.triangles;
  for (Triangle& t : triangles) {
    for (std::uint32_t& corner : t) {
      const auto [place, is_new] = local.try_emplace(corner, std::uint32_t(points.size()));
      if (is_new) {
        const Vec3d p = mesh.points[corner];
        const double height = dot(p - center, normal);
        deviation = std::max(deviation, std::abs(height));
        points.push_back(p - normal * height);
      }
      corner = place->second;
    }
  }
  light::PolygonLight light;
  light.normal = to_float(normal);
  light.surface_deviation = float(deviation);
  for (const Ring& ring : trace_outline(points, triangles, normal, extent.weld)) {
    for (const Vec3d& p : ring)
      light.vertices.push_back(to_float(p + extent.center));
    light.ring_end.push_back(std::uint32_t(light.vertices.size()));
  }
  return light;
}

// Radiance over triangles of a welded mesh.
class Emission {
public:
  Emission(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures)
      : mesh_(mesh), material_(material) {
    const TextureRef& ref = material.emission_texture;
    const auto& tex_coord = ref.tex_coord == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
    if (ref.texture >= 0 && !tex_coord.empty()) texture_ = &textures[std::size_t(ref.texture)];
  }

  struct Mean {
    Vec3f radiance;
    bool is_uniform = true; ///< the texture has one colour there
  };

  Mean mean_over(const WeldedMesh& welded, std::span<const std::uint32_t> triangles) const {
    if (!texture_) return {material_.emission, true};
    TextureMean mean;
    for (const std::uint32_t i : triangles)
      add_samples(mesh_, material_.emission_texture, *texture_, welded.source[i], welded.areas[i],
                  mean);
    return {material_.emission * to_float(mean.sum / mean.weight),
            !(mean.highest - mean.lowest > 0.01)};
  }

  // Makes the texture the picture of a light made of `triangles`; see place_emission_texture.
  bool place_on(light::PolygonLight& light, const WeldedMesh& welded,
                std::span<const std::uint32_t> triangles) const {
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t i : triangles)
      sources.push_back(welded.source[i]);
    return texture_ &&
           place_emission_texture(mesh_, material_.emission_texture, *texture_, sources, light);
  }

private:
  const Mesh& mesh_;
  const Material& material_;
  const Texture* texture_ = nullptr;
};

bool is_dark(Vec3f radiance) { return !(radiance.x > 0) && !(radiance.y > 0) && !(radiance.z > 0); }

// Moves a recognised light to where its mesh is.
void move_by(light::EllipseLight& light, Vec3d offset) {
  light.center = to_float(to_double(light.center) + offset);
}
void move_by(light::SphereLight& light, Vec3d offset) {
  light.center = to_float(to_double(light.center) + offset);
}
void move_by(light::TubeLight& light, Vec3d offset) {
  light.from = to_float(to_double(light.from) + offset);
  light.to = to_float(to_double(light.to) + offset);
}

std::vector<light::EllipseLight>& list_of(light::Lights& lights, const light::EllipseLight&) {
  return lights.ellipses;
}
std::vector<light::SphereLight>& list_of(light::Lights& lights, const light::SphereLight&) {
  return lights.spheres;
}
std::vector<light::TubeLight>& list_of(light::Lights& lights, const light::TubeLight&) {
  return lights.tubes;
}

// Adds `light` with its emission; false when it cannot be shaded.
bool add_recognised(std::monostate, const Extent&, Vec3f, const Mesh&, bool, light::Lights&) {
  return false;
}
template <class Light>
bool add_recognised(Light light, const Extent& extent, Vec3f radiance, const Mesh& mesh,
                    bool two_sided, light::Lights& lights) {
  if (is_dark(radiance)) return true; // dark by texture
  move_by(light, extent.center);
  light.name = mesh.name;
  light.radiance = radiance;
  light.two_sided = two_sided && std::is_same_v<Light, light::EllipseLight>;
  if (!light::validate(light).ok()) return false;
  list_of(lights, light).push_back(std::move(light));
  return true;
}

// Takes the islands that are round out of `welded` and adds them to `lights`.
WeldedMesh take_round_parts(const WeldedMesh& welded, const Mesh& mesh, const Extent& extent,
                            bool two_sided, const EmissiveOptions& options,
                            const Emission& emission, EmissiveLights& result) {
  std::vector<std::uint32_t> left;
  for (const auto& triangles : islands_of(welded)) {
    const Island island{welded, triangles, two_sided, options.shape_tolerance};
    const RoundShape shape = recognise_shape(island, extent.plane);
    const Emission::Mean mean =
        shape.index() != 0 ? emission.mean_over(welded, triangles) : Emission::Mean{};
    // A flat light with a picture keeps it as a polygon.
    const bool is_pictured = !mean.is_uniform && std::holds_alternative<light::EllipseLight>(shape);
    const bool is_light =
        shape.index() != 0 && !is_pictured &&
        std::visit(
            [&](const auto& light) {
              return add_recognised(light, extent, mean.radiance, mesh, two_sided, result.lights);
            },
            shape);
    if (is_light) result.is_texture_averaged = result.is_texture_averaged || !mean.is_uniform;
    if (!is_light) left.insert(left.end(), triangles.begin(), triangles.end());
  }
  std::sort(left.begin(), left.end());
  return part_of(welded, left);
}

} // namespace

EmissiveLights emissive_lights(const Mesh& mesh, const Material& material,
                               const std::vector<Texture>& textures,
                               const EmissiveOptions& options) {
  EmissiveLights result;
  if (is_dark(material.emission) || material.unlit || mesh.triangles.empty()) return result;

  const Extent extent = extent_of(mesh, options.weld, options.plane);
  WeldedMesh welded = weld(mesh, extent);
  result.triangles_without_area = mesh.triangles.size() - welded.triangles.size();
  const bool two_sided = material.double_sided;
  const Emission emission(mesh, material, textures);
  if (options.recognise_shapes)
    welded = take_round_parts(welded, mesh, extent, two_sided, options, emission, result);
  const std::vector<Plane> planes = PlaneFinder(welded, extent, options, two_sided).find();
  for (const Plane& plane : planes) {
    const Emission::Mean mean = emission.mean_over(welded, plane.members);
    if (is_dark(mean.radiance)) continue; // by texture
    light::PolygonLight light = light_of(welded, plane, extent);
    light.name = mesh.name;
    light.radiance = mean.radiance;
    light.two_sided = two_sided;
    if (!mean.is_uniform) {
      if (planes.size() <= k_max_pictures && emission.place_on(light, welded, plane.members))
        light.radiance = material.emission;
      else
        result.is_texture_averaged = true;
    }
    if (light::validate(light).ok())
      result.lights.polygons.push_back(std::move(light));
    else
      result.triangles_without_area += plane.triangles.size();
  }
  return result;
}

std::vector<light::Lights> find_emissive_lights(Scene& scene, const EmissiveOptions& options,
                                                Warnings& warnings) {
  std::vector<light::Lights> lights;
  std::vector<int> shared_textures;
  for (const Mesh& mesh : scene.meshes) {
    lights.emplace_back();
    if (!mesh.emits_light) continue;
    EmissiveLights found =
        emissive_lights(mesh, scene.materials[std::size_t(mesh.material)], scene.textures, options);
    if (found.is_texture_averaged)
      warnings.add_for_mesh(mesh.name,
                            "the emission texture is averaged for the light that it gives "
                            "to others; the camera sees it in full");
    if (found.triangles_without_area != 0)
      warnings.add_for_mesh(mesh.name, "emissive triangles that are too small give no light");
    if (found.lights.polygons.size() > k_many_lights)
      warnings.add_for_mesh(
          mesh.name,
          fmt::format("the curved emissive surface makes {} polygon lights, which takes long to "
                      "render; fewer facets help{}",
                      found.lights.polygons.size(),
                      options.recognise_shapes ? "" : ", or recognising round shapes"));
    for (light::PolygonLight& light : found.lights.polygons)
      if (light.texture >= 0)
        light.texture = share_emission_texture(scene, light.texture, shared_textures);
    lights.back() = std::move(found.lights);
  }
  return lights;
}

void append_lights(const light::Lights& from, light::Lights& to) {
  const auto append = [](const auto& some, auto& all) {
    all.insert(all.end(), some.begin(), some.end());
  };
  append(from.polygons, to.polygons);
  append(from.ellipses, to.ellipses);
  append(from.spheres, to.spheres);
  append(from.tubes, to.tubes);
  append(from.lines, to.lines);
  append(from.punctual, to.punctual);
}

} // namespace openltc::scene
