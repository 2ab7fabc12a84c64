// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a surface emits from place to place: its emission, where the surface is.
//
// glTF 2.0, section 3.9.4: of alphaMode MASK a place is there when its alpha is at least
// alphaCutoff, of BLEND it is there to the share alpha. Alpha is that of the base colour: factor,
// texture and vertex colour.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/light/light.h"
#include "openltc/scene/emissive/flat_part.h"
#include "openltc/scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace openltc::scene {

/// A triangle of a mesh, or a part of it.
struct Patch {
  std::uint32_t triangle = 0;                                          ///< of the mesh
  Vec3d corners[3] = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}; ///< barycentric
  double area = 0; ///< any unit, the same for all patches of a surface
};

class SurfaceEmission {
public:
  /// All three must outlive it.
  SurfaceEmission(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures);

  struct Mean {
    Vec3f radiance{0, 0, 0}; ///< nits
    bool is_uniform = true;  ///< the same all over, within a hundredth of what is most
  };

  /// Mean over a surface. Textures are looked at texel by texel, so that a single one is found.
  Mean mean_over(std::span<const Patch> patches) const;

  /// Share of material.emission that leaves a place, by its barycentric coordinates.
  Vec3f at(std::uint32_t triangle, Vec3d barycentric) const;

  /// Whether alpha takes something away, anywhere.
  bool is_cut() const { return is_cut_; }

  /// Makes the emission texture itself the picture of a light made of `part`, where that is right:
  /// nothing is cut, and it lies evenly; see place_emission_texture.
  bool place_texture_on(light::PolygonLight& light, const FlatPart& part) const;

  /// A picture of the emission of `part`, over material.emission, `most_side` pixels on a side at
  /// most, and its place on `light` but for the index. Along the texels of a texture that lies
  /// evenly, else along the light's longest edge. Where triangles overlap one of them counts. With
  /// `is_cutout` what is not covered is black: then the light may be larger than the part. What the
  /// picture takes is counted in `memory`; an error, which names the mesh, when there is no room.
  Result<image::Image> picture_of(const FlatPart& part, const Mesh& mesh, const Extent& extent,
                                  light::PolygonLight& light, int most_side, bool is_cutout,
                                  MemoryShare& memory) const;

private:
  const Texture* finest() const;
  Vec2d coordinates(const TextureRef& ref, std::uint32_t triangle, Vec3d barycentric) const;

  const Mesh& mesh_;
  const Material& material_;
  const Texture* glow_ = nullptr;  ///< the emission texture
  const Texture* alpha_ = nullptr; ///< the base colour texture, where its alpha counts
  bool has_alpha_ = false, has_vertex_alpha_ = false, is_cut_ = false;
};

/// The triangles with these numbers, as they are in their mesh.
std::vector<Patch> patches_of(const WeldedMesh& welded, std::span<const std::uint32_t> triangles);

/// The triangles of `part` as parts of those of the mesh.
std::vector<Patch> patches_of(const FlatPart& part, const Mesh& mesh, const Extent& extent);

} // namespace openltc::scene
