// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polygon light as shading wants it: outline in world space and in its own plane, and its area
// cut into triangles for sampling.

#pragma once

#include "openltc/light/light.h"
#include "openltc/target/resources.h"

#include <vector>

namespace openltc::light {

/// Owner of the arrays behind a PolygonView.
struct PackedPolygon {
  std::vector<float> points;       ///< see PolygonView
  std::vector<float> in_plane;     ///< see PolygonView
  std::vector<float> triangles;    ///< 9 floats each: corner, edge, edge; world space
  std::vector<float> triangle_cdf; ///< running share of the area, last element 1
  PolygonView view;                ///< points into the vectors above; moves with them
  float area = 0;                  ///< square metres

  PackedPolygon() = default;
  PackedPolygon(PackedPolygon&&) = default;
  PackedPolygon& operator=(PackedPolygon&&) = default;
};

/// Packs a light. A light of no area gives a polygon without points, which lights nothing.
PackedPolygon pack_polygon(const PolygonLight& light);

} // namespace openltc::light
