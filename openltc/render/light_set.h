// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A scene's lights as the shading kernel wants them.

#pragma once

#include "openltc/light/packed_polygon.h"
#include "openltc/render/light_tree.h"
#include "openltc/render/shading_kernel.h"

#include <string>
#include <vector>

namespace openltc::render {

/// Owner of what the views in a KernelContext point to.
struct LightSet {
  std::vector<light::PackedPolygon> packed; ///< of the polygons among the area lights
  std::vector<AreaLightView> area_lights;
  std::vector<TreeLight> tree_lights; ///< the same
  std::vector<PunctualLightView> punctual;
  std::vector<std::string> warnings; ///< lights that were left out, and why
};

LightSet pack_lights(const light::Lights& lights);

} // namespace openltc::render
