// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A scene's lights as the shading kernel wants them.

#pragma once

#include "openltc/light/emission_stack.h"
#include "openltc/light/packed_polygon.h"
#include "openltc/render/kernel_types.h"
#include "openltc/render/lights/light_tree.h"

#include <memory>
#include <string>
#include <vector>

namespace openltc::render {

/// Owner of what the views in a KernelContext point to.
struct LightSet {
  std::vector<light::PackedPolygon> packed;    ///< of the polygons among the area lights
  std::vector<light::EmissionStack> emissions; ///< of those that have a picture
  std::vector<AreaLightView> area_lights;
  std::vector<TreeLight> tree_lights; ///< the same
  std::vector<PunctualLightView> punctual;
  std::vector<std::shared_ptr<const light::IesProfile>> profiles; ///< of the punctual lights
  std::vector<std::string> warnings; ///< lights that were left out, and why
};

/// Packs what a scene has. The views also point to lights.textures, which must outlive them.
LightSet pack_lights(const light::Lights& lights);

} // namespace openltc::render
