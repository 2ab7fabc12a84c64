// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Point by point over the scalar API. A kernel in lanes would take the place of this file.

#include "openltc/c_api/shade_points.h"

#include "openltc/c_api/points.h"

namespace openltc::c_api {

namespace {

void store(float* values, std::size_t i, Vec3f value) {
  values[3 * i] = value.x;
  values[3 * i + 1] = value.y;
  values[3 * i + 2] = value.z;
}

} // namespace

void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end,
                  float* radiance) {
  for (std::size_t i = begin; i < end; ++i) {
    const Surface surface = read_surface(lobes.view, points, i);
    Vec3f sum(0.0f);
    for (const ListedLight& listed : lights.lights)
      sum += std::visit([&](const auto& light) { return shade(surface, light, listed.radiance); },
                        listed.light);
    store(radiance, i, detail::finite_light(sum));
  }
}

void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end, float* diffuse,
                  float* specular) {
  for (std::size_t i = begin; i < end; ++i) {
    const Surface surface = read_surface(lobes.view, points, i);
    ShadedParts sum;
    for (const ListedLight& listed : lights.lights) {
      const ShadedParts parts =
          std::visit([&](const auto& light) { return shade_parts(surface, light); }, listed.light);
      sum.diffuse += detail::finite_light(parts.diffuse * listed.radiance);
      sum.specular += detail::finite_light(parts.specular * listed.radiance);
    }
    store(diffuse, i, detail::finite_light(sum.diffuse));
    store(specular, i, detail::finite_light(sum.specular));
  }
}

} // namespace openltc::c_api
