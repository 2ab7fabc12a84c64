// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the opaque types of openltc/openltc_c.h are.

#pragma once

#include "openltc/api/area_lights.h"
#include "openltc/api/lobes.h"
#include "openltc/api/polygon.h"
#include "openltc/api/punctual_lights.h"
#include "openltc/batch.h"
#include "openltc/openltc_c.h"

#include <type_traits>
#include <variant>
#include <vector>

struct openltc_lobes {
  std::vector<float> numbers; ///< empty: those of the library
  std::vector<float> second;  ///< of a table of two lobes
  openltc::Lobes view;        ///< of `numbers` and `second`, or built in
};

namespace openltc::c_api {

using AnyLight =
    std::variant<Polygon, Ellipse, Sphere, Tube, Line, PointLight, SpotLight, DirectionalLight>;

/// Whether a light has a size, and so a radiance beside it; others have an intensity of their own.
template <class Light>
inline constexpr bool has_extent =
    !std::is_same_v<Light, PointLight> && !std::is_same_v<Light, SpotLight> &&
    !std::is_same_v<Light, DirectionalLight>;

/// A light of a list.
struct ListedLight {
  AnyLight light;
  Vec3f radiance{1, 1, 1}; ///< 1 for those that have an intensity of their own
};

} // namespace openltc::c_api

struct openltc_lights {
  std::vector<openltc::c_api::ListedLight> lights; ///< as they were added
  openltc::BatchLights batch;                      ///< the same, as lanes read them
};
