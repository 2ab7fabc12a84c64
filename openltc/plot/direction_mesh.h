// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Solids made of a lobe: the sphere of directions, coloured by the density, and the lobe itself,
// the surface at the distance D(w) from the origin.

#pragma once

#include "openltc/scene/scene.h"
#include "openltc/target/shade_f64.h"

#include <functional>

namespace openltc::plot {

/// Size of a mesh about the lobe's axis. Half of the rings, and half of the spokes, are spread
/// evenly over the sphere, the other half evenly over cosine space, which crowds them where the
/// density changes.
struct DirectionMeshSize {
  int rings = 160;
  int spokes = 192;
};

/// Linear Rec.709 colour of a direction; unit, the mesh's own space.
using DirectionColor = std::function<Vec3f(Vec3d)>;

/// The unit sphere around the origin, coloured by `color` at its corners.
scene::Mesh sphere_mesh(const f64::Lobe& lobe, const DirectionColor& color,
                        DirectionMeshSize size = {});

/// The surface w D(w) / scale over all directions w where D is positive. Closed: it returns to the
/// origin at the cosine's horizon.
scene::Mesh lobe_mesh(const f64::Lobe& lobe, double scale, const DirectionColor& color,
                      DirectionMeshSize size = {});

} // namespace openltc::plot
