// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Disney's diffuse reflection.
//
// Source: Burley 2012, "Physically Based Shading at Disney", section 5.3.
//
//   f = 1/pi (1 + (F_D90 - 1)(1 - cos_i)^5)(1 + (F_D90 - 1)(1 - cos_o)^5)
//   F_D90 = 1/2 + 2 roughness (wi.h)^2
//
// White base colour; no flattening towards subsurface. Its Fresnel-like factors belong to the model
// and do not depend on F0: there is no separate Schlick part. The model does not conserve energy:
// the albedo passes 1 for rough surfaces at grazing angles (the test states the figure).

#include "openltc/brdf/entries.h"
#include "openltc/target/shade_f64.h"

namespace openltc::brdf {

Brdf make_burley() {
  return {"burley",
          "Disney diffuse of 2012, white base colour",
          "Burley 2012, Physically Based Shading at Disney",
          "roughness as it is; 2 roughness (wi.h)^2 + 1/2 is the reflectance at grazing angles",
          LobeWidth::one,
          [](Vec3d wo, Vec3d wi, double roughness) {
            const double cos2_h = 0.5 + 0.5 * dot(wo, wi);
            const double rise = 2 * roughness * cos2_h - 0.5;
            const double value = f64::k_inv_pi * (1 + rise * f64::schlick_weight(wi.z)) *
                                 (1 + rise * f64::schlick_weight(wo.z)) * wi.z;
            return BrdfValue{value, 0};
          }};
}

} // namespace openltc::brdf
