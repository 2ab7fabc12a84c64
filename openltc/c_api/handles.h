// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the opaque types of openltc/openltc_c.h are.

#pragma once

#include "openltc/api/area_lights.h"
#include "openltc/api/lobes.h"
#include "openltc/api/polygon.h"
#include "openltc/api/punctual_lights.h"
#include "openltc/openltc_c.h"

#include <variant>
#include <vector>

struct openltc_lobes {
  std::vector<float> numbers; ///< empty: those of the library
  openltc::Lobes view;        ///< of `numbers`, or built in
};

namespace openltc::c_api {

using AnyLight =
    std::variant<Polygon, Ellipse, Sphere, Tube, Line, PointLight, SpotLight, DirectionalLight>;

/// A light of a list.
struct ListedLight {
  AnyLight light;
  Vec3f radiance{1, 1, 1}; ///< 1 for those that have an intensity of their own
};

} // namespace openltc::c_api

struct openltc_lights {
  std::vector<openltc::c_api::ListedLight> lights;
};
