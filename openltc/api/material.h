// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Material model: glTF 2.0 Appendix B (metallic-roughness) with KHR_materials_specular and
// KHR_materials_ior.

#pragma once

#include "openltc/api/vectors.h"

namespace openltc {

/// \addtogroup surface
/// @{

/// A material at one point: textures are looked up, and vertex colours multiplied in.
///
/// Values outside of their range are clamped; what is not a number counts as 0.
struct Material {
  Vec3f base_color{1, 1, 1}; ///< linear Rec.709, 0..1: diffuse albedo, or reflectance of a metal
  float metallic = 0;        ///< 0..1; glTF's factor is 1 by default
  float roughness = 1;       ///< perceptual, 0..1; alpha = roughness^2
  float specular = 1; ///< KHR_materials_specular: strength of a dielectric's reflection, 0..1
  Vec3f specular_color{1, 1, 1}; ///< and its tint at normal incidence; above 1 is possible
  float ior = 1.5f;              ///< KHR_materials_ior: >= 1, or 0, which reflects all
};

/// What shading knows of a material.
struct Reflectance {
  Vec3f f0;      ///< specular reflectance at normal incidence, 0..1
  float f90 = 1; ///< and at grazing incidence, 0..1
  Vec3f albedo;  ///< (1 - metallic) base colour: diffuse, before the specular part takes its share
  float roughness = 1; ///< perceptual, 0..1
};

/// Reflectance of a dielectric at normal incidence from its index of refraction, ((n - 1)/(n +
/// 1))^2 (Fresnel); 0 stands for "as bright as possible", 1.
inline float dielectric_f0(float ior) {
  const float r = ior > 0.0f && ior < 1.0e30f ? (ior - 1) / (ior + 1) : 1.0f;
  return r * r;
}

/// The mix of a dielectric and a metal of glTF 2.0, Appendix B: `dielectric_f0` is tinted, and not
/// yet limited to 1; the other values are as in Material.
inline Reflectance mix_reflectance(Vec3f base_color, float metallic, float roughness,
                                   float specular, Vec3f dielectric_f0) {
  using detail::saturate;
  metallic = saturate(metallic);
  specular = saturate(specular);
  const Vec3f color(saturate(base_color.x), saturate(base_color.y), saturate(base_color.z));
  const Vec3f dielectric(saturate(dielectric_f0.x) * specular, saturate(dielectric_f0.y) * specular,
                         saturate(dielectric_f0.z) * specular);
  Reflectance r;
  r.f0 = dielectric * (1 - metallic) + color * metallic;
  r.f90 = specular * (1 - metallic) + metallic;
  r.albedo = color * (1 - metallic);
  r.roughness = saturate(roughness);
  return r;
}

/// Reflectance of a material.
inline Reflectance reflectance_of(const Material& m) {
  return mix_reflectance(m.base_color, m.metallic, m.roughness, m.specular,
                         m.specular_color * dielectric_f0(m.ior));
}

/// @}

} // namespace openltc
