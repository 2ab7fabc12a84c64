// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points under lights at random, for the shader files.

#pragma once

#include "openltc/api/polygon_packing.h"
#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"
#include "tests/shaders/metal/metal_case.h"

#include <vector>

namespace openltc::testing {

void store(Vec3d v, float* out);
Vec3d load(const float* p);
Vec3f load_float(const float* p);
Vec3d unit(Vec3d v);

/// A point under a light, and what its light is.
struct LightSample {
  metal_run::Case at;
  PackedPolygon packed;
  std::vector<float> elements; ///< of a polygon, as the shader files want them
};

/// From small to large against the distance; above, across and below the horizon.
LightSample make_light_sample(Random& random, metal_run::Shape shape);

/// The quad of a case as a polygon.
PackedPolygon corners_of(const metal_run::Case& at);

} // namespace openltc::testing
