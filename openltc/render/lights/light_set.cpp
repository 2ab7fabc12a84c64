// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/lights/light_set.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emitter.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"

#include <optional>
#include <type_traits>
#include <vector>

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
  view.mean_emission = light::mean_emission(light);
}

void pack(const light::TubeLight& light, AreaLightView& view, LightSet&) {
  view.shape = LightShape::tube;
  copy3(view.from, light.from);
  copy3(view.to, light.to);
  view.radius = light.radius;
  view.mean_emission = light::mean_emission(light);
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

// All stacks of a scene together take about this much; each has its share.
constexpr double k_emission_bytes = 256e6;

int emission_side(const light::Lights& lights) {
  int count = 0;
  lights.for_each_area_light([&](const light::Emitter& light) { count += light.texture >= 0; });
  int side = light::EmissionStackOptions().max_side;
  while (side > 64 && double(side) * side * (16 * 4 / 3 + 5) * count > k_emission_bytes)
    side /= 2;
  return side;
}

template <class Light>
void pack_emission(const Light& light, const light::Lights& lights, int side, AreaLightView& view,
                   LightSet& set) {
  if constexpr (std::is_same_v<Light, light::PolygonLight> ||
                std::is_same_v<Light, light::EllipseLight>) {
    if (light.texture < 0) return;
    if (std::size_t(light.texture) >= lights.textures.size()) {
      set.warnings.push_back(light::wrong_light(light.name, "its texture is missing").message +
                             "; it shines evenly");
      return;
    }
    auto stack =
        light::build_emission_stack(lights.textures[std::size_t(light.texture)], light, {side});
    if (!stack.ok()) {
      set.warnings.push_back(stack.error().message + "; it shines evenly");
      return;
    }
    set.emissions.push_back(std::move(*stack));
    view.emission = set.emissions.back().view;
  }
}

// The largest values of pictures, each looked for once however many lights show it.
class LargestValues {
public:
  Vec3f of(const std::vector<image::Texels>& textures, int texture) {
    known_.resize(textures.size());
    std::optional<Vec3f>& largest = known_[std::size_t(texture)];
    if (!largest) largest = textures[std::size_t(texture)].largest_rgb();
    return *largest;
  }

private:
  std::vector<std::optional<Vec3f>> known_;
};

} // namespace

LightSet pack_lights(const light::Lights& lights) {
  LightSet set;
  set.packed.reserve(lights.polygons.size());
  const int side = emission_side(lights);
  LargestValues largest;
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
    pack_emission(light, lights, side, view, set);
    set.area_lights.push_back(view);
    TreeLight in_tree;
    if constexpr (std::is_same_v<std::decay_t<decltype(light)>, light::PolygonLight>)
      in_tree = tree_light(light, set.packed.back());
    else
      in_tree = tree_light(light);
    if (view.emission.texels)
      in_tree =
          textured(in_tree, largest.of(lights.textures, light.texture), set.emissions.back().mean);
    set.tree_lights.push_back(in_tree);
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
    if (light.profile) {
      view.profile = light.profile->view();
      const light::ProfileAxes axes = light::profile_axes(
          light.profile->type, light.right, cross(light.right, light.direction), light.direction);
      copy3(view.profile_x, axes.x);
      copy3(view.profile_y, axes.y);
      copy3(view.profile_z, axes.z);
      set.profiles.push_back(light.profile);
    }
    set.punctual.push_back(view);
  }
  return set;
}

} // namespace openltc::render
