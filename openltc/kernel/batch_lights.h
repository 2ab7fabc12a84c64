// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights of the public API as the kernel has them.

#pragma once

#include "openltc/batch.h"
#include "openltc/kernel/shading_kernel.h"

#include <deque>
#include <vector>

namespace openltc {

struct BatchLights::Packed {
  std::deque<Polygon> polygons; // what the views point to, which do not move
  std::vector<kernel::AreaLightView> area_lights;
  std::vector<kernel::PunctualLightView> punctual;
};

} // namespace openltc
