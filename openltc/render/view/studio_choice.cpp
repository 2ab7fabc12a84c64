// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/view/studio_choice.h"

#include "openltc/light/light_list.h"
#include "openltc/render/view/studio_room.h"
#include "openltc/scene/view/studio.h"

#include <algorithm>
#include <cmath>

namespace openltc::render {

namespace {

// Behind what a studio rig lights: dark enough to set it off, bright enough to show dark outlines.
// Relative to a white card of 1 nit.
constexpr float k_studio_background_nits = 0.07f;
// Brings that card just to white; what the fill light adds may lower it.
constexpr float k_studio_exposure = 1.2f;
// No white paper gets as bright by the three soft boxes together: mirror images of them.
constexpr float k_studio_light_nits = 2.0f;

// Whether the only lights are surfaces that emit no more than glTF's plain emissive factor: labels
// and lamps drawn for the eye, too dim to see anything else by.
bool only_glows(const light::Lights& lights) {
  if (!lights.punctual.empty() || !lights.lines.empty() || lights.empty()) return false;
  bool is_dim = true;
  lights.for_each_area_light([&](const light::Emitter& light) {
    is_dim = is_dim && std::max({light.radiance.x, light.radiance.y, light.radiance.z}) <= 1.0f;
  });
  return is_dim;
}

// What `automatic` stands for. What the file says of its lights stands, also when it is dim or
// cannot be read.
LightsFrom lights_for(const scene::Scene& scene, LightsReason& reason) {
  if (scene.describes_lights) {
    if (scene.lights.empty()) reason = LightsReason::unusable_lights;
    return LightsFrom::scene;
  }
  if (scene.lights.empty()) {
    reason = LightsReason::no_lights;
    return LightsFrom::studio;
  }
  if (!only_glows(scene.lights)) return LightsFrom::scene;
  reason = LightsReason::dim_lights;
  return LightsFrom::both;
}

} // namespace

Result<LightsChosen> choose_lights(scene::Scene& scene, LightsFrom from,
                                   const scene::Camera& camera) {
  LightsChosen chosen;
  if (from == LightsFrom::automatic) from = lights_for(scene, chosen.reason);
  if (from == LightsFrom::scene) {
    chosen.light_nits = scene::least_nits_of_lights(scene.lights);
    return chosen;
  }
  if (from == LightsFrom::studio) scene.lights = {};
  // Beside other lights the rig is as bright as they are.
  const bool own_level = scene.lights.empty() || only_glows(scene.lights);
  const double level = own_level ? 1.0 : scene::white_level_nits(scene.lights, scene.bounds);
  const Result<light::Lights> studio =
      studio_for(scene, camera, level > 0 && std::isfinite(level) ? level : 1.0);
  if (!studio) return studio.error();
  chosen.rig_is_in_room = studio->polygons.size() == 1;
  chosen.rig = *studio;
  chosen.leaves_out_scene = from == LightsFrom::studio;
  use_lights(scene, chosen);
  if (own_level) {
    chosen.background_nits = k_studio_background_nits;
    chosen.usual_exposure = k_studio_exposure;
  }
  chosen.light_nits = own_level ? k_studio_light_nits : scene::least_nits_of_lights(scene.lights);
  return chosen;
}

void use_lights(scene::Scene& scene, const LightsChosen& chosen) {
  if (chosen.leaves_out_scene) scene.lights = {};
  light::append_lights(chosen.rig, scene.lights);
}

} // namespace openltc::render
