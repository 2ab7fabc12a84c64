// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/brdf/brdf.h"

#include "openltc/target/shade_f64.h"

#include <array>

namespace openltc::brdf {

namespace {

const std::array<Brdf, 1>& registry() {
  static const std::array<Brdf, 1> entries = {Brdf{
      "ggx",
      "Trowbridge-Reitz, height-correlated Smith, F = 1",
      "Walter, Marschner, Li, Torrance 2007; Heitz 2014 (shade/ggx.glsl)",
      [](Vec3d wo, Vec3d wi, double roughness) {
        const f64::GgxTerms terms =
            f64::eval_ggx_terms(wo, wi, f64::alpha_from_roughness(roughness));
        return BrdfValue{terms.scale, terms.bias};
      },
      [](Vec3d wo, double roughness, Vec2d u) {
        return f64::sample_ggx(wo, f64::alpha_from_roughness(roughness), u);
      },
      [](Vec3d wo, Vec3d wi, double roughness) {
        return f64::pdf_ggx(wo, wi, f64::alpha_from_roughness(roughness));
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

} // namespace openltc::brdf
