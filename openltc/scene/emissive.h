// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Emissive surfaces become polygon lights.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/scene/warnings.h"

#include <cstddef>
#include <vector>

namespace openltc::scene {

/// Tolerances of emissive_lights, relative to the diagonal of the mesh's bounding box.
struct EmissiveOptions {
  double weld = 1e-6;               ///< vertices closer than this are one
  double plane = 1e-4;              ///< triangles whose corners are this close to a plane lie in it
  double plane_angle_rad = 0.01745; ///< and whose normal is this close to the plane's (1 degree)
};

/// What became of an emissive mesh.
struct EmissiveLights {
  std::vector<light::PolygonLight> lights;
  bool is_texture_averaged = false;       ///< its emission texture is neither uniform nor a picture
  std::size_t triangles_without_area = 0; ///< left out
};

/// The polygon lights of `mesh`: one for each plane in which emissive triangles lie, with as many
/// outlines as the plane has islands and holes. An emission texture that lies evenly in the plane
/// becomes the light's picture, its `texture` an index into `textures`; otherwise the radiance is
/// material.emission times the texture's mean over the plane's surface. One-sided unless the
/// material is double-sided. Empty when nothing is emitted.
EmissiveLights emissive_lights(const Mesh& mesh, const Material& material,
                               const std::vector<Texture>& textures,
                               const EmissiveOptions& options = {});

/// Adds the lights of all emissive meshes, and their pictures, to scene.lights. The meshes stay:
/// the camera sees them.
void add_emissive_lights(Scene& scene, Warnings& warnings);

} // namespace openltc::scene
