// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Emissive surfaces become area lights: polygons, and round ones where that is asked for.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/warnings.h"

#include <cstddef>
#include <vector>

namespace openltc::scene {

/// How emissive_lights makes lights. `weld` and `plane` are relative to the diagonal of the mesh's
/// bounding box.
struct EmissiveOptions {
  double weld = 1e-6;               ///< vertices closer than this are one
  double plane = 1e-4;              ///< triangles whose corners are this close to a plane lie in it
  double plane_angle_rad = 0.01745; ///< and whose normal is this close to the plane's (1 degree)
  /// Of more planes than this, nearly coplanar ones that share edges are joined: no corner leaves
  /// the joined plane by more than join_distance (relative to the diagonal), no normal by more than
  /// join_angle_rad (5 degrees), no radiance differs by more than join_radiance of the larger. A
  /// joined light has the flux of its facets; what it sends into a direction in which they all
  /// shine is off by 1 / cos(5 degrees) - 1 = 0.4 % at most.
  std::size_t few_planes = 64;
  double join_distance = 1e-3;
  double join_angle_rad = 0.0873;
  double join_radiance = 0.05;
  /// Outlines of more corners lose those within `plane` of an edge, and are cut into several
  /// lights.
  std::size_t most_corners = 64;
  /// Pictures that are made of emission that alpha cuts: pixels on a side, and in all.
  int most_picture_side = 1024;
  std::size_t most_picture_pixels = std::size_t(1) << 24;
  /// Whether parts that hang together and are a sphere, a disk, an ellipse or a cylinder become
  /// such lights, of the same area.
  bool recognise_shapes = false;
  /// By how much their facets may leave the shape, relative to its diameter: 0.01 takes circles of
  /// 16 corners and more, icospheres from the second subdivision on.
  double shape_tolerance = 0.01;
};

/// What became of an emissive mesh.
struct EmissiveLights {
  light::Lights lights;
  /// What lights have whose `texture` is not below textures.size(): pictures[texture - that size].
  std::vector<image::Texels> pictures;
  bool is_texture_averaged = false; ///< its emission texture is neither uniform nor a picture
  bool is_tangled = false;          ///< facets overlap so often that a picture stands for them
  std::size_t triangles_without_area = 0; ///< left out
  MemoryShare memory;                     ///< what the pictures take
  /// Why a picture was not made, empty = none was refused: memory_budget() had no room. Its light
  /// is averaged, or left out where facets overlap.
  std::string refusal;
};

/// The lights of `mesh`: one polygon for each plane in which emissive triangles lie, with as many
/// outlines as the plane has islands and holes, several where the outline is large, and one light
/// for each part that is recognised. What overlaps in a plane shines once.
/// Emission counts where the surface is: of alphaMode MASK and BLEND the share that alpha leaves.
/// An emission texture that lies evenly in a plane becomes the polygon's picture, its `texture` an
/// index into `textures`; where alpha varies a picture is made of both. On curved surfaces, and
/// where a texture lies otherwise, the radiance is material.emission times the mean over the
/// surface. One-sided unless the material is double-sided; closed shapes emit outwards in any
/// case. Empty when nothing is emitted.
EmissiveLights emissive_lights(const Mesh& mesh, const Material& material,
                               const std::vector<Texture>& textures,
                               const EmissiveOptions& options = {});

/// The lights of each mesh of `scene`, as many as it has meshes; none of those that are not to
/// emit. Their pictures go to scene.lights.textures and are counted in scene.memory.
std::vector<light::Lights> find_emissive_lights(Scene& scene, const EmissiveOptions& options,
                                                Warnings& warnings);

} // namespace openltc::scene
