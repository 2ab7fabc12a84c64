// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled as C++14: see metal_stdlib.

#include "tests/shaders/metal/metal_case.h"

#include <ltc_lights_sampling.metal>

namespace {

float3 vector_of(const float* p) { return float3(p[0], p[1], p[2]); }

// A light by its functions for points: of two numbers, or of a direction.
struct Points {
  const metal_run::Case& at;
  float3 a, b, c;
  const float* l;

  explicit Points(const metal_run::Case& shaded)
      : at(shaded), a(vector_of(shaded.light)), b(vector_of(shaded.light + 3)),
        c(vector_of(shaded.light + 6)), l(shaded.light) {}

  ltc_LightPoint draw(float3 position, float2 u) const {
    switch (at.shape) {
    case metal_run::k_polygon:
      return ltc_draw_polygon(reinterpret_cast<const float4*>(at.polygon), position, u);
    case metal_run::k_disk:
      return ltc_draw_ellipse(ltc_make_disk(a, b, l[6], l[7]), position, u);
    case metal_run::k_sphere:
      return ltc_draw_sphere(ltc_make_sphere(a, l[3]), position, u);
    case metal_run::k_tube:
      return ltc_draw_tube(ltc_make_tube(a, b, l[6], l[7]), position, u);
    case metal_run::k_line:
      return ltc_draw_line(ltc_make_line(a, b), position, u);
    default:
      return ltc_draw_quad(ltc_make_quad(a, b, c, l[9]), position, u);
    }
  }

  ltc_LightPoint meet(float3 position, float3 direction) const {
    switch (at.shape) {
    case metal_run::k_polygon:
      return ltc_meet_polygon(reinterpret_cast<const float4*>(at.polygon), position, direction);
    case metal_run::k_disk:
      return ltc_meet_ellipse(ltc_make_disk(a, b, l[6], l[7]), position, direction);
    case metal_run::k_sphere:
      return ltc_meet_sphere(ltc_make_sphere(a, l[3]), position, direction);
    case metal_run::k_tube:
      return ltc_meet_tube(ltc_make_tube(a, b, l[6], l[7]), position, direction);
    default:
      return ltc_meet_quad(ltc_make_quad(a, b, c, l[9]), position, direction);
    }
  }
};

} // namespace

void metal_run::shade_by_points(const Case& at, int side, float by_lobe, double out[3]) {
  ltc_Surface surface =
      ltc_gltf_surface(vector_of(at.position), vector_of(at.normal), vector_of(at.view),
                       vector_of(at.base_color), at.metallic, at.roughness);
  if (at.tilted) surface = ltc_set_geometric_normal(surface, vector_of(at.geometric));
  const Points points(at);
  out[0] = out[1] = out[2] = 0.0;
  const auto add = [&](ltc_LightPoint point, float share) {
    const float density = ltc_point_density(surface, point, by_lobe);
    const float3 light = ltc_eval_point(surface, point, density) * share;
    out[0] += double(light.x) / (side * side);
    out[1] += double(light.y) / (side * side);
    out[2] += double(light.z) / (side * side);
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const float2 u((float(i) + 0.5f) / float(side), (float(j) + 0.5f) / float(side));
      if (by_lobe < 1.0f) add(points.draw(surface.position, u), 1.0f - by_lobe);
      if (by_lobe > 0.0f)
        add(points.meet(surface.position, ltc_lobe_direction(surface, u)), by_lobe);
    }
}
