// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points all over a subject, with the light that reaches each of its sides.

#pragma once

#include "openltc/render/view/sight_lines.h"
#include "openltc/scene/view/subject.h"

#include <array>
#include <vector>

namespace openltc::render {

struct ViewSample {
  Vec3d position;
  Vec3d normal; ///< unit, of the front
  bool two_sided = false;
  /// How much it is worth to see the front and the back: 1, less where little light falls.
  std::array<double, 2> worth{1, 1};
};

/// A thousand points, half of them even over the subject's area, half over its triangles, so that
/// plain walls and detailed things both count. Always the same for the same scene. The worth is of
/// scene.lights, with shadows, as far as one of them is brighter than 1 nit; otherwise 1 for all.
std::vector<ViewSample> sample_subject(const scene::Scene& scene, const scene::Subject& subject,
                                       const SightLines& sight);

} // namespace openltc::render
