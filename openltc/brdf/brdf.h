// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The BRDFs that can be fitted, by name, and what it takes to add one: a function.
//
// All are isotropic and have one parameter, the perceptual roughness 0..1, or none. Directions are
// unit, in shading space, away from the surface; wo = (sin theta, 0, cos theta).

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/vec.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace openltc::brdf {

/// A BRDF times cos_i, with Schlick's Fresnel kept apart: f cos = f0 * scale + (f90 - f0) * bias.
struct BrdfValue {
  double scale = 0; ///< for F = 1, >= 0; the lobe that is fitted
  double bias = 0;  ///< its part weighted with (1 - wo.h)^5, 0..scale; 0 where there is no Fresnel
};

/// How wide the lobe is as roughness vanishes: what a table factors out of M^-1.
enum class LobeWidth {
  alpha, ///< roughness^2: microfacet lobes, a mirror at roughness 0
  one    ///< stays wide: diffuse, sheen, measured
};

/// A BRDF. eval is pure and may be called from any thread. No sampling is asked for: the fitter
/// brings its own quadrature (fit/quadrature.h).
struct Brdf {
  std::string name;      ///< what the tool calls it
  std::string variant;   ///< one line: which of the forms that go by this name
  std::string source;    ///< authors, title, year
  std::string parameter; ///< what roughness means to it; empty when it has no parameter
  LobeWidth width = LobeWidth::alpha;
  /// Cosine included, 1/steradian. Called only with wo.z > 0 and wi.z > 0.
  std::function<BrdfValue(Vec3d wo, Vec3d wi, double roughness)> eval;
  /// What eval gives of each wi, where many at once take less time; usually empty. Called with as
  /// many values as directions; see eval_all.
  std::function<void(Vec3d wo, std::span<const Vec3d> wi, double roughness,
                     std::span<BrdfValue> values)>
      eval_many = {};

  bool has_parameter() const { return !parameter.empty(); }
};

/// The values for one wo and many wi, as eval gives them; as many values as directions.
void eval_all(const Brdf& brdf, Vec3d wo, std::span<const Vec3d> wi, double roughness,
              std::span<BrdfValue> values);

/// All built-in entries.
std::span<const Brdf> all_brdfs();

/// The built-in entry of that name; nullptr when there is none.
const Brdf* find_brdf(std::string_view name);

/// A BRDF of one's own from a function of (wo, wi, roughness) that returns f, 1/steradian, without
/// the cosine. It need not be normalised and is fitted for F = 1.
Brdf brdf_from_function(std::string name, std::function<double(Vec3d, Vec3d, double)> f,
                        LobeWidth width = LobeWidth::alpha);

/// The same from a function of many directions at once: f of each wi into values.
using BatchFunction = std::function<void(Vec3d wo, std::span<const Vec3d> wi, double roughness,
                                         std::span<double> values)>;
Brdf brdf_from_batch(std::string name, BatchFunction f, LobeWidth width = LobeWidth::alpha);

} // namespace openltc::brdf
