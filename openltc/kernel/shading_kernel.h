// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The inner loop of rendering: many surface points, all lights, one call.
//
// The kernel is compiled once per instruction set from shading_kernel.inc; best_kernel() picks the
// widest that this machine has. The types here are plain, so that no library code is compiled for
// an instruction set that the machine may lack.

#pragma once

#include "openltc/kernel/batch_bounds.h"
#include "openltc/target/resources.h"

#include <cstddef>
#include <cstdint>

namespace openltc::kernel {

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

/// What the shadow ratio needs of one area light, summed over a pixel's points and samples.
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

/// Polygon lights that a batch of points takes for one small patch; see FarLight in light_extent.h.
struct FarGroup {
  float center[3];
  float moment[3][3];  ///< sum of radiance times area times normal, for r, g and b
  float first[3][3];   ///< columns of the first moments, all channels together
  float channel[3];    ///< each channel's share of them
  float covariance[6]; ///< of places by power: xx yy zz yz xz xy
  bool exact;          ///< a single light, shaded in full; only its shadow is that of the groups
  bool specular;       ///< whether there is a specular part worth having
  bool plain;          ///< whether the moments of first and second order are left out
  float cdf;           ///< running share of the shadow samples, 1 for the last group of a set
  std::int32_t begin, end; ///< its lights, in FarLights::order
};

/// Groups whose shadow is one: of all their light together, over the samples that they share.
struct FarSet {
  const FarGroup* groups = nullptr;
  int count = 0;
  int slot = 0;    ///< of their sums, which are with the lights' radiance
  int samples = 0; ///< shadow samples, in those of a light with a shadow of its own
  /// Null, or for each group the sum of its samples without and with shadow, which are added here.
  float* reach = nullptr;
};

/// What is asked of a batch with shadows: the sums of the closed form, and all that needs no ratio;
/// the sums of the shadow rays; or both.
enum class ShadingPart : std::uint8_t { both, closed, rays };

/// Surface points in, radiance out. The arrays are padded to a multiple of k_batch_padding.
struct ShadingBatch {
  int count = 0;
  const float* in[k_point_field_count] = {};
  const float* weight = nullptr;        ///< share of the point in its camera sample
  const std::uint32_t* pixel = nullptr; ///< below pixel_count
  const std::uint32_t* seed = nullptr;  ///< of the pixel
  const std::uint32_t* index = nullptr; ///< of the camera sample, in the seed's sequence
  float* out[3] = {};                   ///< radiance, nits, without weight
  /// With the LTC integrator and shadows, area lights do not go to `out`: their weighted sums,
  /// for radiance 1, are added here, [slot][RatioSum][pixel]. Else unused.
  float* ratio_sums = nullptr;
  int pixel_count = 0;
  ShadingPart part = ShadingPart::both; ///< of the LTC integrator, with shadows
  /// Of ShadingPart::rays: sums like ratio_sums, with those of the closed form. A light without any
  /// in a pixel gets no rays there.
  const float* closed_sums = nullptr;
  /// The area lights that shade the points, `light_count` of them, and the slot of each; null for
  /// all, with slots of the same numbers. The reference integrator takes all in any case.
  const std::int32_t* lights = nullptr;
  const std::int32_t* slots = nullptr;
  int light_count = 0;
  /// Groups of further lights: those that reach points like these, and those that were found behind
  /// something. Apart, since bright lights that reach nothing would drown the others' shadow in
  /// noise.
  FarSet far[2];
};

inline constexpr int k_batch_padding = 16;

enum class LightShape : std::uint8_t { polygon, ellipse, sphere, tube, line };

/// A light with an extent, of any shape; see light::Emitter and the shapes beside it.
struct AreaLightView {
  LightShape shape = LightShape::polygon;
  PolygonView polygon;
  float center[3] = {0, 0, 0}; ///< ellipse, sphere
  float half_u[3] = {1, 0, 0}; ///< ellipse
  float half_v[3] = {0, 1, 0};
  float from[3] = {0, 0, 0}; ///< tube, line
  float to[3] = {1, 0, 0};
  float radius = 0;              ///< sphere, tube
  float caps = 0;                ///< tube: 0 none, 1 flat, 2 round
  bool two_sided = false;        ///< ellipse; the polygon has its own
  float radiance[3] = {0, 0, 0}; ///< nits; cd/m of a line
  float cosine_power = 0;        ///< see light::Emitter
  /// sphere, tube: mean of the emission over what one sees of it, see light::mean_emission
  float mean_emission = 1;
  float surface_deviation = 0; ///< see light::Emitter
  /// Polygons and ellipses: the picture that the radiance is multiplied by; no texels, no picture.
  EmissionTextureView emission;
};

/// What shadow rays to groups of lights need.
struct FarLights {
  const std::int32_t* order = nullptr; ///< numbers of the lights; a group is a range of them
  const float* cdf = nullptr;          ///< running sum of the power of the lights before each
  float surface_deviation = 0;         ///< largest of the lights, with its factor of safety
};

/// A light, or all lights of a branch of the light tree, as the choice of a light for a sample sees
/// them. Nodes lie in the order of a walk: the first child is the next node.
struct LightNode {
  float lower[3], upper[3]; ///< box around the lights, world space
  float axis[3];            ///< around which their normals lie
  float cos_spread;         ///< of the largest angle between the axis and one; -1: any direction
  float sin_spread;
  float power;        ///< peak luminous intensities, summed
  std::int32_t right; ///< second child; 0 = a leaf
  std::int32_t light; ///< of a leaf
};

/// A tree from which the reference draws lights with known probabilities.
struct LightNodes {
  const LightNode* nodes = nullptr; ///< null: every sample takes all lights
  int samples = 0; ///< rays to lights that a group of points sends; a few lights are drawn for each
};

struct PunctualLightView {
  float position[3] = {0, 0, 0};
  float direction[3] = {0, 0, -1}; ///< the way the light travels
  float intensity[3] = {0, 0, 0};  ///< candela, or lux when directional
  float range = 0;
  bool spot = false; ///< has a cone
  float cos_inner = 1, cos_outer = -1;
  bool directional = false;
  ProfileView profile; ///< no values: the same in every direction
  /// The profile's own axes, world space: see light::ProfileAxes.
  float profile_x[3] = {0, 1, 0}, profile_y[3] = {-1, 0, 0}, profile_z[3] = {0, 0, -1};
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
/// The specular part of area lights: by the fitted lobe alone, or times the BRDF's ratio to it in
/// each light's mean direction (blended_ratio, shade/surface.glsl), for lobes that were fitted to
/// GGX; by GGX itself (shade/exact/half_vector.glsl); or by that but of large polygons that the
/// ratio gives nearly as well (make_adaptive, shade/surface.glsl).
enum class SpecularForm { lobe, ratio, exact, adaptive };

struct KernelContext {
  LobeTableView table;
  LobePolynomialView polynomial; ///< instead of the table, where it has coefficients
  const AreaLightView* area_lights = nullptr;
  int area_light_count = 0;
  FarLights far_lights;
  LightNodes light_nodes; ///< of the reference
  const PunctualLightView* punctual = nullptr;
  int punctual_count = 0;
  Integrator integrator = Integrator::ltc;
  PunctualForm punctual_form = PunctualForm::exact;
  SpecularForm specular_form = SpecularForm::lobe;
  bool lobe_samples = true;     ///< of the reference: polygon lights are sampled by lobes
  int light_samples = 0;        ///< per point and area light
  int brdf_samples = 0;         ///< per point, shared by all lights; at most k_max_brdf_samples
  TraceShadows trace = nullptr; ///< null: no shadows
  const void* tracer = nullptr;
};

inline constexpr int k_max_brdf_samples = 64;
/// All groups of far lights that reach a point together take as many shadow samples as this many
/// lights; those that were found not to reach it as many as that.
inline constexpr int k_far_light_samples = 4, k_hidden_light_samples = 2;

inline constexpr int k_most_drawn_lights = 1024, k_lights_a_ray = 4;
/// More than the depth of any light tree, which is that of the logarithm of the number of lights.
inline constexpr int k_light_tree_depth = 64;

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

} // namespace openltc::kernel
