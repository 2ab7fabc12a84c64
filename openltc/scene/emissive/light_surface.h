// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// How far the mesh that shows a light leaves the light's own shape.

#pragma once

#include "openltc/light/light.h"

namespace openltc::scene {

/// Metres by which `p` lies before the emitting surface of a flat light, on either side of one that
/// emits to both, or outside of a sphere, a tube or a line; 0 for points that cannot come between
/// the light and what it lights. Convex along any line, so that its largest value over a triangle
/// is at a corner.
double distance_outside(const light::PolygonLight& light, Vec3f p);
double distance_outside(const light::EllipseLight& light, Vec3f p);
double distance_outside(const light::SphereLight& light, Vec3f p);
double distance_outside(const light::TubeLight& light, Vec3f p);
double distance_outside(const light::LineLight& light, Vec3f p);

/// Half the light's largest extent in metres, roughly.
double reach_of(const light::PolygonLight& light);
double reach_of(const light::EllipseLight& light);
double reach_of(const light::SphereLight& light);
double reach_of(const light::TubeLight& light);
double reach_of(const light::LineLight& light);

} // namespace openltc::scene
