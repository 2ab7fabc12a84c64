// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights and the surface points that see them, at random and made to break things.

#pragma once

#include "openltc/target/shade_f32.h"
#include "tests/shade/lights/light_batch.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace openltc::testing {

/// One light and one surface point; all numbers single precision, so that a reference in double
/// starts from the very same input.
struct LightCase {
  LightShape shape = LightShape::sphere;
  Vec3f position, normal{0, 0, 1}, wo{0, 0, 1}; ///< world space; unit normal and wo
  float roughness = 0.5f;
  float albedo = 0.5f, f0 = 0.04f;
  Vec3f a, b, c; ///< as in LightBatch
  float radius = 0;
  bool two_sided = false;
  std::shared_ptr<const TestPolygon> polygon; ///< rectangles and polygons
};

const char* shape_name(LightShape shape);
LightShape shape_of_index(int index);
bool is_polygon(LightShape shape);

/// A light near enough to matter: half its size 0.01 to 3 times its distance, that 0.1 to 10, its
/// emitting side towards the point, its centre around the mirror direction (45 of 100), anywhere
/// above (40) or at the horizon (15). Roughness 0.01 to 1, uniform in the logarithm, and the ends 0
/// and 1 (5 of 100 each); cosine of the view uniform. The point lies outside of spheres and tubes.
LightCase random_light(LightShape shape, Random& random);

/// A random light bent in one to three ways: degenerate, edge-on, touching the horizon, huge, tiny,
/// far, at or in the light, wo along the normal, grazing, roughness 0 or 1, or all coordinates
/// whole numbers.
LightCase adversarial_light(LightShape shape, Random& random);

/// Writes a case into lane i of a batch of its shape. A polygon has to outlive the batch.
void set_lane(LightBatch& batch, int i, const LightCase& light);

/// The lobe and the frame that single precision shades a case with, in double without change.
struct CaseView {
  Vec3d position;
  f64::Frame frame;
  f64::Lobe lobe;
};
CaseView view_of(const LightCase& light);

/// The dialect's answer in float for one case.
struct CaseAnswer {
  float diffuse, specular;
  Vec3f diffuse_direction, specular_direction, shaded;
};
CaseAnswer evaluate(const LightCase& light, EvaluateLights with = evaluate_lights_scalar);

/// The dialect's integrals in double, for a frame and a lobe given.
f64::LightIntegral evaluate_precise(const LightCase& light, const CaseView& view);

/// Another surface point and roughness before the same light, for lanes that share a polygon.
LightCase elsewhere(const LightCase& light, bool adversarial, Random& random);

/// k_batch lights of a seed; those of odd seeds are adversarial. Of a polygon all are the same
/// light.
std::vector<LightCase> fuzz_lights(LightShape shape, std::uint64_t seed);

} // namespace openltc::testing
