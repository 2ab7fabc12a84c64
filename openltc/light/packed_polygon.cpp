// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/packed_polygon.h"

namespace openltc::light {

PackedPolygon pack_polygon(const PolygonLight& light) {
  return openltc::pack_polygon(light.vertices, light.ring_end, light.normal, light.two_sided);
}

} // namespace openltc::light
