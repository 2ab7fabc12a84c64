// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Whether a scene is lit by its own lights, by a studio rig, or by both, and how the picture is
// then exposed.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/scene.h"

#include <optional>

namespace openltc::render {

/// Which lights a picture is wanted with.
enum class LightsFrom {
  automatic, ///< the scene's; the rig too, or alone, where the scene says nothing to see by
  scene,
  studio,
  both,
};

/// What decided.
enum class LightsReason {
  asked,           ///< the caller, or lights of the scene that one can see by
  unusable_lights, ///< the scene describes lights, but none that can be used: it stays dark
  no_lights,       ///< the scene says nothing of lights: the rig alone
  dim_lights,      ///< only surfaces that emit 1 nit or less: the rig is added
};

struct LightsChosen {
  LightsReason reason = LightsReason::asked;
  /// Walls keep the rig from the subject: it is one soft box under the ceiling.
  bool rig_is_in_room = false;
  /// With the rig at its own level, a white card at 1 nit: the background that sets it off in nits,
  /// and the factor from nits that brings the card just to white.
  std::optional<float> background_nits, usual_exposure;
  /// Radiance in nits from which a pixel shows a light, not what it lights;
  /// image::DisplayOptions::light_nits.
  float light_nits = 0;
  light::Lights rig;             ///< of the studio, if there is one
  bool leaves_out_scene = false; ///< whether it takes the place of the scene's lights
};

/// Leaves in `scene` the lights that are wanted. Fails as studio_for.
Result<LightsChosen> choose_lights(scene::Scene& scene, LightsFrom from,
                                   const scene::Camera& camera);

/// The lights that were chosen for another pose of this scene, whose origin is the same.
void use_lights(scene::Scene& scene, const LightsChosen& chosen);

} // namespace openltc::render
