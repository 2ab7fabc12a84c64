// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/light_set.h"

#include "openltc/light/polygon.h"

#include <fmt/format.h>

namespace openltc::render {

namespace {

void copy3(float* out, Vec3f v) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

} // namespace

LightSet pack_lights(const light::Lights& lights) {
  LightSet set;
  set.packed.reserve(lights.polygons.size());
  for (const light::PolygonLight& light : lights.polygons) {
    if (const Status valid = light::validate(light); !valid.ok()) {
      set.warnings.push_back(valid.error().message + "; it is left out");
      continue;
    }
    light::PackedPolygon packed = light::pack_polygon(light);
    PolygonLightView view;
    set.packed.push_back(std::move(packed));
    const light::PackedPolygon& kept = set.packed.back();
    view.shape = kept.view;
    view.triangles = kept.triangles.data();
    view.triangle_cdf = kept.triangle_cdf.data();
    view.triangle_count = int(kept.triangle_cdf.size());
    view.area = kept.area;
    view.surface_deviation = kept.surface_deviation;
    copy3(view.radiance, kept.radiance);
    set.polygons.push_back(view);
    set.extents.push_back(light_extent(light));
  }
  for (const light::PunctualLight& light : lights.punctual) {
    if (const Status valid = light::validate(light); !valid.ok()) {
      set.warnings.push_back(valid.error().message + "; it is left out");
      continue;
    }
    PunctualLightView view;
    copy3(view.position, light.position);
    copy3(view.direction, light.direction);
    copy3(view.intensity, light.intensity);
    view.range = light.range;
    view.directional = light.type == light::PunctualType::directional;
    view.spot = light.type == light::PunctualType::spot;
    view.cos_inner = light.cos_inner;
    view.cos_outer = light.cos_outer;
    set.punctual.push_back(view);
  }
  return set;
}

} // namespace openltc::render
