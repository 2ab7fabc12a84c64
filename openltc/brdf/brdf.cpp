// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/brdf/brdf.h"

#include "openltc/brdf/entries.h"

#include <utility>
#include <vector>

namespace openltc::brdf {

namespace {

const std::vector<Brdf>& registry() {
  static const std::vector<Brdf> entries = {
      // Microfacet and glossy lobes: a mirror at roughness 0.
      make_ggx(),
      make_ggx_separable(),
      make_ggx_ms(),
      make_beckmann(),
      make_blinn(),
      make_phong(),
      // Diffuse reflection and sheen.
      make_burley(),
      make_oren_nayar(),
      make_eon(),
      make_charlie(),
  };
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

Brdf brdf_from_batch(std::string name, BatchFunction f, LobeWidth width) {
  Brdf brdf = brdf_from_function(
      std::move(name),
      [f](Vec3d wo, Vec3d wi, double roughness) {
        double value = 0;
        f(wo, {&wi, 1}, roughness, {&value, 1});
        return value;
      },
      width);
  brdf.eval_many = [f = std::move(f)](Vec3d wo, std::span<const Vec3d> wi, double roughness,
                                      std::span<BrdfValue> values) {
    std::vector<double> plain(wi.size());
    f(wo, wi, roughness, plain);
    for (std::size_t i = 0; i < wi.size(); ++i)
      values[i] = {plain[i] * wi[i].z, 0};
  };
  return brdf;
}

void eval_all(const Brdf& brdf, Vec3d wo, std::span<const Vec3d> wi, double roughness,
              std::span<BrdfValue> values) {
  if (brdf.eval_many) return brdf.eval_many(wo, wi, roughness, values);
  for (std::size_t i = 0; i < wi.size(); ++i)
    values[i] = brdf.eval(wo, wi[i], roughness);
}

} // namespace openltc::brdf
