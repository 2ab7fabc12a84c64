// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Many points at once: arrays of surface points in, radiance out, by any set of lights. The closed
// forms of openltc/openltc.h in SIMD lanes; the widest instruction set that the machine has is
// found at run time. C++17; link openltc::batch.
//
//   openltc::BatchLights lights;
//   lights.add(openltc::Polygon::rectangle(center, half_u, half_v), nits);
//   openltc::PointBatch points;
//   points.count = n;
//   points.position[0] = x; ...                           // one array of n floats per number
//   float* radiance[3] = {r, g, b};
//   const char* error = openltc::shade_batch(points, lights, openltc::built_in_table(), radiance);
//
// Everywhere: world space, metres, directions away from the surface, colours linear Rec.709.
// Against the scalar functions lanes fuse multiply and add: results differ by a few times 1e-6 of
// them, more where a lobe is narrow.

#pragma once

// The first and the last say which words are ours in between.
// clang-format off
#include "openltc/target/own_names.inc"
#include "openltc/api/area_lights.h"
#include "openltc/api/lobes.h"
#include "openltc/api/material.h"
#include "openltc/api/polygon.h"
#include "openltc/api/punctual_lights.h"
#include "openltc/target/names_back.inc"
// clang-format on

#include <cstddef>
#include <memory>

namespace openltc {

/// \addtogroup batch
/// @{

/// A set of lights, each packed once, when it is added. Constant, it may be shared by threads.
class BatchLights {
public:
  /// No lights: all points are black.
  BatchLights();
  ~BatchLights();
  /// Takes the lights of another set, which may be used again.
  BatchLights(BatchLights&& other) noexcept;
  /// The same.
  BatchLights& operator=(BatchLights&& other) noexcept;

  /// Adds a light of that radiance, in nits as a rule, per linear Rec.709 channel; of a line, cd/m.
  /// False, and nothing added, where it cannot be shaded: see the shapes; or where a channel is
  /// negative, not finite or above 1e20.
  bool add(const Polygon& light, Vec3f radiance);
  bool add(const Ellipse& light, Vec3f radiance); ///< the same
  bool add(const Sphere& light, Vec3f radiance);  ///< the same
  bool add(const Tube& light, Vec3f radiance);    ///< the same
  /// The same in cd/m.
  bool add(const Line& light, Vec3f intensity_per_metre);
  /// Lights without extent have an intensity of their own. False where they light nothing.
  bool add(const PointLight& light);
  bool add(const SpotLight& light);        ///< the same
  bool add(const DirectionalLight& light); ///< the same

  std::size_t size() const; ///< lights that were added
  void clear();             ///< leaves no light

  struct Packed; ///< the library's own
  /// What the kernel reads.
  const Packed& packed() const { return *packed_; }

private:
  std::unique_ptr<Packed> packed_;
};

/// Points of surfaces, one array of `count` floats per number. `position`, `normal` and `view` must
/// be there; of the others a null pointer stands for what is said.
struct PointBatch {
  std::size_t count = 0;         ///< points, and floats in each array
  const float* position[3] = {}; ///< x y z
  const float* normal[3] = {};   ///< of shading, on the viewer's side; of any length but 0
  const float* view[3] = {};     ///< from the surface to the eye; of any length but 0
  /// Of the triangle, either side; what lies behind it is hidden. Null: there is no triangle.
  const float* geometric_normal[3] = {};
  const float* position_error = nullptr; ///< metres, see set_position_error; null: rounding

  Material material;                   ///< of all points, but for the arrays of these:
  const float* base_color[3] = {};     ///< r g b, see Material; null: that of `material`
  const float* metallic = nullptr;     ///< see Material; null: that of `material`
  const float* roughness = nullptr;    ///< see Material; null: that of `material`
  const float* specular = nullptr;     ///< see Material; null: that of `material`
  const float* specular_color[3] = {}; ///< r g b, see Material; null: that of `material`
  const float* ior = nullptr;          ///< see Material; null: that of `material`
};

/// How a batch is shaded.
struct BatchOptions {
  int threads = 0;             ///< at most; 0 = all cores
  const char* kernel = "auto"; ///< or one of "scalar", "sse4", "avx2", "avx512", "neon"
  /// Area lights times the ratio of GGX to its lobe, see correct_at_mean in openltc/api/surface.h.
  bool correct_at_mean = false;
  /// Instead: by GGX itself wherever it is worth its time, see make_adaptive there,
  bool adaptive = false;
  bool exact = false; ///< or everywhere, see make_exact
};

/// Radiance that each point reflects to its viewer from all lights together, without shadow, in
/// closed form: `radiance` has three arrays of points.count floats, r g b, in the unit of the
/// lights' radiance. Finite and not negative; 0 at points that cannot be shaded (see make_surface).
///
/// Returns null, or what is wrong with the call, with `radiance` as it was: arrays that are
/// missing, lobes of nothing, a kernel that this machine has not. The text lives as long as the
/// program. The result does not depend on the number of threads.
const char* shade_batch(const PointBatch& points, const BatchLights& lights, const Lobes& lobes,
                        float* const radiance[3], const BatchOptions& options = {});

/// Name of the kernel that "auto" takes on this machine.
const char* batch_kernel();

/// @}

} // namespace openltc
