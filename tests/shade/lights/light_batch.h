// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights of one shape, each seen from a surface point of its own, as plain arrays: what the proofs
// hand to float, double and every lane build. Nothing inline, because files compiled for different
// instruction sets share it.

#pragma once

#include "openltc/target/resources.h"

namespace openltc::testing {

enum class LightShape {
  rectangle,
  polygon,
  disk,
  ellipse,
  sphere,
  tube_open, ///< lateral surface alone
  tube_flat, ///< solid cylinder
  capsule,
  line
};
constexpr int k_light_shapes = 9;

/// As many lights as the widest registers hold.
constexpr int k_batch = 16;

/// How ShadeLights shades.
enum class ShadingForm {
  even, ///< polygons: the specular albedo taken for the reflectance of the whole lobe, as renderers
        ///< usually do, instead of Fresnel's reflectance in the mean direction
  lobe, ///< as engines do it: one lobe
  ratio,     ///< times the BRDF's ratio to it in the mean direction
  two,       ///< with a second lobe, of 0.3: that of twice the width
  two_ratio, ///< and the ratio to both
  exact,     ///< by GGX itself
  adaptive,  ///< by GGX itself where these err
};

struct LightBatch {
  LightShape shape = LightShape::sphere;
  PolygonView polygon; ///< of rectangles and polygons: the same for all
  float position[3][k_batch], normal[3][k_batch], wo[3][k_batch]; ///< world space
  float roughness[k_batch], albedo[k_batch], f0[k_batch];
  /// Ellipse: centre, half_u, half_v. Sphere: centre. Tube and line: from, to. World space.
  float a[3][k_batch], b[3][k_batch], c[3][k_batch];
  float radius[k_batch];
  float two_sided[k_batch]; ///< 0 or 1; ellipses
  ShadingForm form = ShadingForm::lobe;
};

/// What the dialect makes of each, radiance 1.
struct LightAnswers {
  float diffuse[k_batch], specular[k_batch];
  float diffuse_direction[3][k_batch], specular_direction[3][k_batch]; ///< shading space
  float shaded[3][k_batch];                                            ///< shade_integral
};

using EvaluateLights = void (*)(const LightBatch& batch, const LobeTableView& table,
                                LightAnswers* answers);
/// Their light alone, RGB, as a renderer shades them.
using ShadeLights = void (*)(const LightBatch& batch, const LobeTableView& table,
                             float (*shaded)[k_batch]);

void evaluate_lights_scalar(const LightBatch&, const LobeTableView&, LightAnswers*);
void evaluate_lights_baseline(const LightBatch&, const LobeTableView&, LightAnswers*);
void evaluate_lights_sse4(const LightBatch&, const LobeTableView&, LightAnswers*);
void evaluate_lights_avx2(const LightBatch&, const LobeTableView&, LightAnswers*);
void evaluate_lights_avx512(const LightBatch&, const LobeTableView&, LightAnswers*);
void shade_lights_scalar(const LightBatch&, const LobeTableView&, float (*shaded)[k_batch]);
void shade_lights_baseline(const LightBatch&, const LobeTableView&, float (*shaded)[k_batch]);
void shade_lights_sse4(const LightBatch&, const LobeTableView&, float (*shaded)[k_batch]);
void shade_lights_avx2(const LightBatch&, const LobeTableView&, float (*shaded)[k_batch]);
void shade_lights_avx512(const LightBatch&, const LobeTableView&, float (*shaded)[k_batch]);

} // namespace openltc::testing
