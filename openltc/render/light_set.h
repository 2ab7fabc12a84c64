// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A scene's lights as the shading kernel wants them.

#pragma once

#include "openltc/light/packed_polygon.h"
#include "openltc/render/light_bound.h"
#include "openltc/render/shading_kernel.h"

#include <string>
#include <vector>

namespace openltc::render {

/// Owner of what the views in a KernelContext point to.
struct LightSet {
  std::vector<light::PackedPolygon> packed;
  std::vector<PolygonLightView> polygons;
  std::vector<LightExtent> extents; ///< of the polygons
  std::vector<PunctualLightView> punctual;
  std::vector<std::string> warnings; ///< lights that were left out, and why
};

LightSet pack_lights(const light::Lights& lights);

} // namespace openltc::render
