// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights as many small flat patches, to add up what all of them send in every direction.

#pragma once

#include "openltc/light/light.h"

#include <vector>

namespace openltc::light::test {

struct Patch {
  Vec3d normal; ///< of unit length, to where it shines
  double area;
};
using Patches = std::vector<Patch>;

Patches patches_of(const SphereLight& light);
Patches patches_of(const EllipseLight& light);
Patches patches_of(const TubeLight& light);
/// Of bent_polygon(): its three squares.
Patches patches_of(const PolygonLight& light);

/// An L of three unit squares.
PolygonLight bent_polygon();

/// Flux of patches of radiance 1 times the cosine to `power`: their emission over the hemisphere.
double summed_flux(const Patches& patches, double power);

/// Their luminous intensity in a direction of unit length.
double summed_intensity(const Patches& patches, double power, Vec3d direction);

} // namespace openltc::light::test
