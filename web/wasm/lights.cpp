// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the reader of glTF files answers: the lights of the file of "size" bytes "at" an address,
// which goes by its "name".

#include "openltc/scene/gltf.h"
#include "requests.h"

#include <cstdint>

namespace openltc::wasm {

namespace {

Json numbers(Vec3f v) { return Json::array({v.x, v.y, v.z}); }

// Coordinates of a scene as its file has them.
struct Place {
  Vec3d origin;
  Json operator()(Vec3f p) const {
    return Json::array({origin.x + double(p.x), origin.y + double(p.y), origin.z + double(p.z)});
  }
};

// What all shapes but lines have.
Json emitter_of(const char* type, const light::Emitter& light) {
  return {{"type", type},
          {"name", light.name},
          {"radiance", numbers(light.radiance)},
          {"twoSided", light.two_sided},
          {"cosinePower", light.cosine_power}};
}

Json describe(const light::PolygonLight& light, const Place& place) {
  Json json = emitter_of("polygon", light);
  json["normal"] = numbers(light.normal);
  json["rings"] = Json::array();
  std::size_t i = 0;
  for (const std::uint32_t end : light.ring_end) {
    Json ring = Json::array();
    for (; i < end; ++i)
      ring.push_back(place(light.vertices[i]));
    json["rings"].push_back(std::move(ring));
  }
  return json;
}

Json describe(const light::EllipseLight& light, const Place& place) {
  Json json = emitter_of("ellipse", light);
  json["center"] = place(light.center);
  json["halfU"] = numbers(light.half_u);
  json["halfV"] = numbers(light.half_v);
  return json;
}

Json describe(const light::SphereLight& light, const Place& place) {
  Json json = emitter_of("sphere", light);
  json["center"] = place(light.center);
  json["radius"] = light.radius;
  return json;
}

Json describe(const light::TubeLight& light, const Place& place) {
  Json json = emitter_of("tube", light);
  json["from"] = place(light.from);
  json["to"] = place(light.to);
  json["radius"] = light.radius;
  json["caps"] = light.caps == light::TubeCaps::none   ? "none"
                 : light.caps == light::TubeCaps::flat ? "flat"
                                                       : "round";
  return json;
}

Json describe(const light::LineLight& light, const Place& place) {
  return {{"type", "line"},
          {"name", light.name},
          {"from", place(light.from)},
          {"to", place(light.to)},
          {"intensityPerMetre", numbers(light.intensity_per_metre)}};
}

} // namespace

Result<Answer> answer(const Json& request) {
  scene::EmissiveOptions emissive;
  emissive.recognise_shapes = number_of(request, "recogniseShapes", 0) != 0;
  const auto at = std::uintptr_t(number_of(request, "at", 0));
  const auto size = std::size_t(number_of(request, "size", 0));
  const Result<scene::Scene> scene =
      scene::load_gltf_memory({reinterpret_cast<const std::uint8_t*>(at), size},
                              text_of(request, "name", "scene.glb"), {}, emissive);
  if (!scene) return scene.error();
  Answer answer;
  answer.json["lights"] = Json::array();
  const Place place{scene->origin};
  scene->lights.for_each_area_light(
      [&](const auto& light) { answer.json["lights"].push_back(describe(light, place)); });
  answer.json["describesLights"] = scene->describes_lights;
  answer.json["warnings"] = scene->warnings;
  return answer;
}

} // namespace openltc::wasm
