// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights as EXT_lights_area can say them.

#pragma once

#include "openltc/light/light.h"

#include <string>
#include <vector>

namespace openltc::scene {

/// A rectangle or disk that emits alike in all directions, to one side.
struct AreaLight {
  std::string name;
  bool is_disk = false;
  Vec3d center{0, 0, 0};
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}; ///< orthonormal; it emits along -z, as in glTF
  double width = 1, height = 1;             ///< metres, along x and y; a disk's diameter
  Vec3f radiance{0, 0, 0};
  float surface_deviation = 0;
};

/// Lights as area lights, and the names of those that are none.
struct AreaLights {
  std::vector<AreaLight> lights;    ///< one of two sides is two
  std::vector<std::string> refused; ///< "\"Bulb\": a sphere", ...
};

AreaLights area_lights_of(const light::Lights& lights);

} // namespace openltc::scene
