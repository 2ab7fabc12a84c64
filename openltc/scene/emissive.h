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
  bool is_texture_averaged = false;       ///< its emission texture is neither uniform nor a picture
  std::size_t triangles_without_area = 0; ///< left out
};

/// The lights of `mesh`: one polygon for each plane in which emissive triangles lie, with as many
/// outlines as the plane has islands and holes, and one light for each part that is recognised.
/// An emission texture that lies evenly in a plane becomes the polygon's picture, its `texture` an
/// index into `textures`; otherwise the radiance is material.emission times the texture's mean over
/// the surface. One-sided unless the material is double-sided; closed shapes emit outwards in any
/// case. Empty when nothing is emitted.
EmissiveLights emissive_lights(const Mesh& mesh, const Material& material,
                               const std::vector<Texture>& textures,
                               const EmissiveOptions& options = {});

/// The lights of each mesh of `scene`, as many as it has meshes; none of those that are not to
/// emit. Their pictures go to scene.lights.textures.
std::vector<light::Lights> find_emissive_lights(Scene& scene, const EmissiveOptions& options,
                                                Warnings& warnings);

/// Appends copies of the lights `from` to `to`. Both have the same textures or `from` uses none.
void append_lights(const light::Lights& from, light::Lights& to);

} // namespace openltc::scene
