// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The BRDFs that can be fitted, by name.
//
// All are isotropic and have one parameter, the perceptual roughness 0..1. Directions are unit, in
// shading space, away from the surface; wo = (sin theta, 0, cos theta).

#pragma once

#include "openltc/target/vec.h"

#include <span>
#include <string>
#include <string_view>

namespace openltc::brdf {

/// A BRDF times cos_i, with Schlick's Fresnel kept apart: f cos = f0 * scale + (f90 - f0) * bias.
struct BrdfValue {
  double scale = 0; ///< for F = 1, >= 0; the lobe that is fitted
  double bias = 0;  ///< its part weighted with (1 - wo.h)^5, 0..scale
};

/// One entry of the registry. All functions are pure and may be called from any thread.
struct Brdf {
  std::string name;    ///< what the tool calls it
  std::string variant; ///< one line: which of the forms that go by this name
  std::string source;  ///< authors, title, year
  /// Zero below the horizon. Cosine included.
  BrdfValue (*eval)(Vec3d wo, Vec3d wi, double roughness) = nullptr;
  /// A direction for u in [0, 1)^2; below the horizon it counts as nothing. Roughness may exceed 1:
  /// the fitter widens it. u.x in (0, 1/2) gives y > 0, so half the symmetric domain can be drawn.
  Vec3d (*sample)(Vec3d wo, double roughness, Vec2d u) = nullptr;
  /// Density of sample per solid angle, zero below the horizon.
  double (*pdf)(Vec3d wo, Vec3d wi, double roughness) = nullptr;
};

/// All entries.
std::span<const Brdf> all_brdfs();

/// The entry of that name; nullptr when there is none.
const Brdf* find_brdf(std::string_view name);

} // namespace openltc::brdf
