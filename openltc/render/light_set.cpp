// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/light_set.h"

#include "openltc/light/curved.h"
#include "openltc/light/polygon.h"

#include <fmt/format.h>

namespace openltc::render {

namespace {

void copy3(float* out, Vec3f v) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

void pack(const light::PolygonLight& light, AreaLightView& view, LightSet& set) {
  set.packed.push_back(light::pack_polygon(light));
  const light::PackedPolygon& kept = set.packed.back();
  view.shape = LightShape::polygon;
  view.polygon = kept.view;
  view.triangles = kept.triangles.data();
  view.triangle_cdf = kept.triangle_cdf.data();
  view.triangle_count = int(kept.triangle_cdf.size());
}

void pack(const light::EllipseLight& light, AreaLightView& view, LightSet&) {
  view.shape = LightShape::ellipse;
  copy3(view.center, light.center);
  copy3(view.half_u, light.half_u);
  copy3(view.half_v, light.half_v);
}

void pack(const light::SphereLight& light, AreaLightView& view, LightSet&) {
  view.shape = LightShape::sphere;
  copy3(view.center, light.center);
  view.radius = light.radius;
}

void pack(const light::TubeLight& light, AreaLightView& view, LightSet&) {
  view.shape = LightShape::tube;
  copy3(view.from, light.from);
  copy3(view.to, light.to);
  view.radius = light.radius;
  view.caps = light.caps == light::TubeCaps::none   ? 0.0f
              : light.caps == light::TubeCaps::flat ? 1.0f
                                                    : 2.0f;
}

void pack(const light::LineLight& light, AreaLightView& view, LightSet&) {
  view.shape = LightShape::line;
  copy3(view.from, light.from);
  copy3(view.to, light.to);
  copy3(view.radiance, light.intensity_per_metre);
  view.cosine_power = 0;
}

} // namespace

LightSet pack_lights(const light::Lights& lights) {
  LightSet set;
  set.packed.reserve(lights.polygons.size());
  lights.for_each_area_light([&](const auto& light) {
    if (const Status valid = light::validate(light); !valid.ok()) {
      set.warnings.push_back(valid.error().message + "; it is left out");
      return;
    }
    AreaLightView view;
    copy3(view.radiance, light.radiance);
    view.two_sided = light.two_sided;
    view.cosine_power = light.cosine_power;
    view.surface_deviation = light.surface_deviation;
    pack(light, view, set);
    set.area_lights.push_back(view);
    set.tree_lights.push_back(tree_light(light));
  });
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
