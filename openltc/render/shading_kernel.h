// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The inner loop of rendering: many surface points, all lights, one call.
//
// The kernel is compiled once per instruction set from shading_kernel.inc; best_kernel() picks the
// widest that this machine has. The types here are plain, so that no library code is compiled for
// an instruction set that the machine may lack.

#pragma once

#include "openltc/render/batch_bounds.h"
#include "openltc/target/resources.h"

#include <cstddef>
#include <cstdint>

namespace openltc::render {

/// What is known of a surface point, one array per value. Directions are unit and in world space.
enum PointField {
  k_position_x,
  k_position_y,
  k_position_z,
  k_normal_x,
  k_normal_y,
  k_normal_z, ///< shading normal, on the viewer's side
  k_geometric_x,
  k_geometric_y,
  k_geometric_z, ///< of the triangle, on the viewer's side
  k_view_x,
  k_view_y,
  k_view_z, ///< to the viewer
  k_albedo_r,
  k_albedo_g,
  k_albedo_b, ///< (1 - metallic) base colour
  k_f0_r,
  k_f0_g,
  k_f0_b,
  k_f90,
  k_roughness, ///< perceptual
  k_offset,    ///< metres that shadow rays start off the surface
  k_point_field_count
};

/// What the shadow ratio needs of one polygon light, summed over a pixel's points and samples.
enum RatioSum {
  k_closed_r,
  k_closed_g,
  k_closed_b, ///< closed form, without shadow
  k_unshadowed_r,
  k_unshadowed_g,
  k_unshadowed_b, ///< its estimate by sampling
  k_shadowed_r,
  k_shadowed_g,
  k_shadowed_b, ///< the same samples times their visibility
  k_ratio_sum_count
};

/// Surface points in, radiance out. The arrays are padded to a multiple of k_batch_padding.
struct ShadingBatch {
  int count = 0;
  const float* in[k_point_field_count] = {};
  const float* weight = nullptr;        ///< share of the point in its camera sample
  const std::uint32_t* pixel = nullptr; ///< below pixel_count
  const std::uint32_t* seed = nullptr;  ///< of the pixel
  const std::uint32_t* index = nullptr; ///< of the camera sample within the pixel
  float* out[3] = {};                   ///< radiance, nits, without weight
  /// With the LTC integrator and shadows, polygon lights do not go to `out`: their weighted sums,
  /// for radiance 1, are added here, [slot][RatioSum][pixel]. Else unused.
  float* ratio_sums = nullptr;
  int pixel_count = 0;
  /// The polygon lights that shade the points, `light_count` of them, and the slot of each; null
  /// for all, with slots of the same numbers. The reference integrator takes all in any case.
  const std::int32_t* lights = nullptr;
  const std::int32_t* slots = nullptr;
  int light_count = 0;
};

inline constexpr int k_batch_padding = 16;

/// A polygon light with what sampling it needs; see light::PackedPolygon.
struct PolygonLightView {
  PolygonView shape;
  const float* triangles = nullptr;
  const float* triangle_cdf = nullptr;
  int triangle_count = 0;
  float area = 0;
  float surface_deviation = 0; ///< see light::PolygonLight
  float radiance[3] = {0, 0, 0};
};

struct PunctualLightView {
  float position[3] = {0, 0, 0};
  float direction[3] = {0, 0, -1}; ///< the way the light travels
  float intensity[3] = {0, 0, 0};  ///< candela, or lux when directional
  float range = 0;
  bool spot = false; ///< has a cone
  float cos_inner = 1, cos_outer = -1;
  bool directional = false;
};

/// Rays of one register's lanes; a ray runs from origin to origin + direction.
struct ShadowRays {
  int count = 0;
  const float* origin[3] = {};
  const float* direction[3] = {};
  const std::int32_t* active = nullptr; ///< -1 traced, 0 not
  float* transmittance = nullptr;       ///< out: 1 open, 0 blocked, between through glassy surfaces
};

using TraceShadows = void (*)(const void* tracer, const ShadowRays& rays);

enum class Integrator { ltc, reference };
enum class PunctualForm { exact, ltc };

struct KernelContext {
  LobeTableView table;
  LobePolynomialView polynomial; ///< instead of the table, where it has coefficients
  const PolygonLightView* polygons = nullptr;
  int polygon_count = 0;
  const PunctualLightView* punctual = nullptr;
  int punctual_count = 0;
  Integrator integrator = Integrator::ltc;
  PunctualForm punctual_form = PunctualForm::exact;
  int light_samples = 0;        ///< per point and polygon
  int brdf_samples = 0;         ///< per point, shared by all polygons; at most k_max_brdf_samples
  TraceShadows trace = nullptr; ///< null: no shadows
  const void* tracer = nullptr;
};

inline constexpr int k_max_brdf_samples = 64;

using ShadeFunction = void (*)(const KernelContext& context, const ShadingBatch& batch);
/// Finds the bounds of the points of a batch, of which it needs only `count` (not 0) and `in`.
using MeasureFunction = void (*)(const KernelContext& context, const ShadingBatch& batch,
                                 BatchBounds* bounds);

struct Kernel {
  const char* name = ""; ///< "scalar", "sse4", "avx2", "avx512", "neon"
  int lanes = 1;
  ShadeFunction shade = nullptr;
  MeasureFunction measure = nullptr;
};

/// The widest kernel that this machine runs.
Kernel best_kernel();

/// The kernel of that name, "auto" for the best; shade is null when this machine or build has none.
Kernel kernel_by_name(const char* name);

} // namespace openltc::render
