// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polygon light as shading wants it.

#pragma once

#include "openltc/api/polygon_packing.h"
#include "openltc/light/light.h"

namespace openltc::light {

using openltc::PackedPolygon;

/// Packs a light. A light of no area gives a polygon without points, which lights nothing.
PackedPolygon pack_polygon(const PolygonLight& light);

} // namespace openltc::light
