// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/brdf/brdf.h"

#include "openltc/target/shade_f64.h"

#include <array>
#include <utility>

namespace openltc::brdf {

namespace {

const std::array<Brdf, 1>& registry() {
  static const std::array<Brdf, 1> entries = {Brdf{
      "ggx",
      "Trowbridge-Reitz, height-correlated Smith, F = 1",
      "Walter, Marschner, Li, Torrance 2007; Heitz 2014 (shade/ggx.glsl)",
      "alpha = roughness^2, the width of the distribution of normals",
      LobeWidth::alpha,
      [](Vec3d wo, Vec3d wi, double roughness) {
        const f64::GgxTerms terms =
            f64::eval_ggx_terms(wo, wi, f64::alpha_from_roughness(roughness));
        return BrdfValue{terms.scale, terms.bias};
      },
  }};
  return entries;
}

} // namespace

std::span<const Brdf> all_brdfs() { return registry(); }

const Brdf* find_brdf(std::string_view name) {
  for (const Brdf& entry : registry())
    if (entry.name == name) return &entry;
  return nullptr;
}

Brdf brdf_from_function(std::string name, std::function<double(Vec3d, Vec3d, double)> f,
                        LobeWidth width) {
  Brdf brdf;
  brdf.name = std::move(name);
  brdf.variant = "from a function";
  brdf.parameter = "roughness";
  brdf.width = width;
  brdf.eval = [f = std::move(f)](Vec3d wo, Vec3d wi, double roughness) {
    return BrdfValue{f(wo, wi, roughness) * wi.z, 0};
  };
  return brdf;
}

} // namespace openltc::brdf
