// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// From triangles to planes, from planes to parts of a size that a light tree can choose among.
// Curved emitters of many facets have nearly coplanar ones joined first; see join_planes for how
// much that may change, and flat_part.h for what becomes of the area.

#include "openltc/scene/emissive/emissive.h"

#include "openltc/light/polygon.h"
#include "openltc/scene/emissive/emissive_texture.h"
#include "openltc/scene/emissive/facet_planes.h"
#include "openltc/scene/emissive/flat_part.h"
#include "openltc/scene/emissive/round_parts.h"
#include "openltc/scene/emissive/segment_grid.h"
#include "openltc/scene/emissive/surface_emission.h"
#include "openltc/scene/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace openltc::scene {

namespace {

// More lights than this deserve a word of warning: time grows with their number.
constexpr std::size_t k_many_lights = 256;
// The facets of a curved surface show little of the texture each: beyond this many, its mean does.
constexpr std::size_t k_max_pictures = 32;
// A tangle of facets is drawn as a picture of so many pixels on a side.
constexpr int k_tangle_side = 256;
constexpr int k_least_picture_side = 64;
// What a light's area may be off by, from outlines of fewer corners or facets that lean, before its
// radiance makes up for it. Below this it is rounding.
constexpr double k_area_rounding = 1e-4;

bool is_dark(Vec3f radiance) { return !(radiance.x > 0) && !(radiance.y > 0) && !(radiance.z > 0); }

// Makes the lights of a mesh, plane by plane.
class LightMaker {
public:
  LightMaker(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures,
             const EmissiveOptions& options, const Extent& extent, const SurfaceEmission& emission,
             EmissiveLights& result)
      : mesh_(mesh), material_(material), textures_(textures), options_(options), extent_(extent),
        emission_(emission), result_(result), pixels_left_(double(options.most_picture_pixels)) {}

  void add_all(const WeldedMesh& welded, const std::vector<FacetPlane>& planes) {
    may_have_pictures_ = planes.size() <= k_max_pictures;
    planes_left_ = planes.size();
    for (const FacetPlane& plane : planes) {
      add_plane(welded, plane);
      --planes_left_;
    }
  }

private:
  void add_plane(const WeldedMesh& welded, const FacetPlane& plane) {
    FlatPart part = flatten(welded, plane, extent_);
    if (!(area_of(part) > 0)) {
      result_.triangles_without_area += plane.triangles.size();
      return;
    }
    if (part.is_tangled) {
      add_tangle(part);
      return;
    }
    const SurfaceEmission::Mean mean = emission_.mean_over(patches_of(part, mesh_, extent_));
    if (is_dark(mean.radiance)) return; // by texture
    if (!mean.is_uniform && add_with_picture(part)) return;
    result_.is_texture_averaged = result_.is_texture_averaged || !mean.is_uniform;
    // Small outlines are kept to the last corner, large ones may lose some.
    std::vector<Ring> rings = outline_of(part, extent_.weld, extent_.weld);
    if (count_corners(rings) <= options_.most_corners) {
      add_light(part, rings, mean.radiance);
      return;
    }
    for (const FlatPart& piece :
         split(std::move(part), options_.most_corners, extent_.weld, extent_.plane))
      add_light(piece, outline_of(piece, extent_.weld, extent_.plane),
                mean.is_uniform ? mean.radiance
                                : emission_.mean_over(patches_of(piece, mesh_, extent_)).radiance);
  }

  static std::size_t count_corners(const std::vector<Ring>& rings) {
    std::size_t count = 0;
    for (const Ring& ring : rings)
      count += ring.size();
    return count;
  }

  // Radiance for the part's area times what its outline's is short of.
  Vec3f made_up(const FlatPart& part, const std::vector<Ring>& rings, Vec3f radiance) const {
    double outline = 0;
    for (const Ring& ring : rings)
      outline += signed_area(ring, part.normal);
    const double missing = part.stretch * area_of(part) / outline;
    return std::abs(missing - 1) > k_area_rounding ? radiance * float(missing) : radiance;
  }

  void add_light(const FlatPart& part, const std::vector<Ring>& rings, Vec3f radiance) {
    if (is_dark(radiance)) return;
    light::PolygonLight light = polygon_of(part, rings, extent_);
    light.radiance = made_up(part, rings, radiance);
    keep(std::move(light), part);
  }

  bool add_with_picture(const FlatPart& part) {
    if (!may_have_pictures_) return false;
    const std::vector<Ring> rings = outline_of(part, extent_.weld, extent_.weld);
    light::PolygonLight light = polygon_of(part, rings, extent_);
    light.radiance = made_up(part, rings, material_.emission);
    if (!emission_.place_texture_on(light, part)) {
      if (!emission_.is_cut()) return false;
      const int side = picture_side();
      if (side < k_least_picture_side) return false;
      if (!draw(part, light, side, false)) return false;
    }
    keep(std::move(light), part);
    return true;
  }

  // Facets that lie on top of each other many times over: a rectangle around them, and a picture of
  // where they are.
  void add_tangle(FlatPart& part) {
    const PlaneAxes axes(part.normal);
    Vec2d lower(1e300, 1e300), upper(-1e300, -1e300);
    for (const Vec3d& p : part.points) {
      const Vec2d q = axes.in_plane(p);
      lower = {std::min(lower.x, q.x), std::min(lower.y, q.y)};
      upper = {std::max(upper.x, q.x), std::max(upper.y, q.y)};
    }
    const double height = dot(part.points[0], part.normal);
    const auto corner = [&](double x, double y) {
      return axes.x * x + axes.y * y + part.normal * height;
    };
    const Ring ring = {corner(lower.x, lower.y), corner(upper.x, lower.y), corner(upper.x, upper.y),
                       corner(lower.x, upper.y)};
    light::PolygonLight light = polygon_of(part, {ring}, extent_);
    light.radiance = material_.emission;
    const int side = std::min(std::max(picture_side(), k_least_picture_side), k_tangle_side);
    if (!draw(part, light, side, true)) return;
    result_.is_tangled = true;
    keep(std::move(light), part);
  }

  // False when there is no memory for it.
  bool draw(const FlatPart& part, light::PolygonLight& light, int side, bool is_cutout) {
    Result<image::Image> picture =
        emission_.picture_of(part, mesh_, extent_, light, side, is_cutout, result_.memory);
    if (!picture) {
      if (result_.refusal.empty()) result_.refusal = picture.error().message;
      return false;
    }
    pixels_left_ -= double(picture->pixel_count());
    result_.pictures.emplace_back(std::move(*picture));
    light.texture = int(textures_.size() + result_.pictures.size() - 1);
    return true;
  }

  // What the next plane may have, if those to come shall have as much.
  int picture_side() const {
    int side = options_.most_picture_side;
    while (side > 0 && double(side) * side * double(planes_left_) > pixels_left_)
      side /= 2;
    return side;
  }

  void keep(light::PolygonLight light, const FlatPart& part) {
    light.name = mesh_.name;
    light.two_sided = material_.double_sided;
    if (light::validate(light).ok())
      result_.lights.polygons.push_back(std::move(light));
    else
      result_.triangles_without_area += part.triangles.size();
  }

  const Mesh& mesh_;
  const Material& material_;
  const std::vector<Texture>& textures_;
  const EmissiveOptions& options_;
  const Extent& extent_;
  const SurfaceEmission& emission_;
  EmissiveLights& result_;
  double pixels_left_;
  bool may_have_pictures_ = true;
  std::size_t planes_left_ = 0;
};

// Joins nearly coplanar planes where there are many.
std::vector<FacetPlane> join_if_many(const WeldedMesh& welded, const Extent& extent,
                                     std::vector<FacetPlane> planes,
                                     const SurfaceEmission& emission,
                                     const EmissiveOptions& options, bool two_sided) {
  if (planes.size() <= options.few_planes) return planes;
  std::vector<Vec3f> radiances;
  for (const FacetPlane& plane : planes)
    radiances.push_back(emission.mean_over(patches_of(welded, plane.members)).radiance);
  const JoinLimits limits{options.join_distance * extent.diagonal + extent.weld,
                          options.join_angle_rad, options.join_radiance};
  return join_planes(welded, std::move(planes), radiances, limits, two_sided);
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
  const SurfaceEmission emission(mesh, material, textures);
  if (options.recognise_shapes)
    welded = take_round_parts(welded, mesh, extent, two_sided, options.shape_tolerance, emission,
                              result.lights, result.is_texture_averaged);
  const std::vector<FacetPlane> planes =
      join_if_many(welded, extent, find_planes(welded, extent, options.plane_angle_rad, two_sided),
                   emission, options, two_sided);
  LightMaker(mesh, material, textures, options, extent, emission, result).add_all(welded, planes);
  return result;
}

std::vector<light::Lights> find_emissive_lights(Scene& scene, const EmissiveOptions& options,
                                                Warnings& warnings) {
  std::vector<light::Lights> lights;
  std::vector<int> shared_textures;
  EmissiveOptions left = options;
  for (const Mesh& mesh : scene.meshes) {
    lights.emplace_back();
    if (!mesh.emits_light) continue;
    EmissiveLights found =
        emissive_lights(mesh, scene.materials[std::size_t(mesh.material)], scene.textures, left);
    if (!found.refusal.empty())
      warnings.add(found.refusal + "; its light is averaged, or missing where facets overlap");
    scene.memory->take_over(std::move(found.memory));
    if (found.is_texture_averaged)
      warnings.add_for_mesh(mesh.name,
                            "the emission texture is averaged for the light that it gives "
                            "to others; the camera sees it in full");
    if (found.is_tangled)
      warnings.add_for_mesh(mesh.name,
                            "its emissive facets overlap each other many times over; their light "
                            "comes from a picture of where they are");
    if (found.triangles_without_area != 0)
      warnings.add_for_mesh(mesh.name, "emissive triangles that are too small give no light");
    if (found.lights.polygons.size() > k_many_lights)
      warnings.add_for_mesh(
          mesh.name,
          fmt::format("the curved emissive surface makes {} polygon lights, which takes long to "
                      "render; fewer facets help{}",
                      found.lights.polygons.size(),
                      options.recognise_shapes ? "" : ", or recognising round shapes"));
    const int textures = int(scene.textures.size()), first = int(scene.lights.textures.size());
    for (image::Texels& picture : found.pictures) {
      left.most_picture_pixels -= std::min(left.most_picture_pixels, picture.pixel_count());
      scene.lights.textures.push_back(std::move(picture));
    }
    for (light::PolygonLight& light : found.lights.polygons)
      if (light.texture >= 0)
        light.texture = light.texture >= textures
                            ? first + light.texture - textures
                            : share_emission_texture(scene, light.texture, shared_textures);
    lights.back() = std::move(found.lights);
  }
  return lights;
}

} // namespace openltc::scene
