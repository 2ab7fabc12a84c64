// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Handles that destroy themselves, and the same lights by the C API and by that of C++.

#pragma once

#include "openltc/openltc.h"
#include "openltc/openltc_c.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace openltc::testing {

struct Destroy {
  void operator()(openltc_lobes* lobes) const { openltc_lobes_destroy(lobes); }
  void operator()(openltc_lights* lights) const { openltc_lights_destroy(lights); }
};
using LobesHandle = std::unique_ptr<openltc_lobes, Destroy>;
using LightsHandle = std::unique_ptr<openltc_lights, Destroy>;

inline LobesHandle built_in_lobes(int32_t form = OPENLTC_TABLE) {
  openltc_lobes* lobes = nullptr;
  REQUIRE(openltc_lobes_create_built_in(form, &lobes) == OPENLTC_OK);
  return LobesHandle(lobes);
}

inline LightsHandle no_lights() {
  openltc_lights* lights = nullptr;
  REQUIRE(openltc_lights_create(&lights) == OPENLTC_OK);
  return LightsHandle(lights);
}

inline bool last_error_says(const std::string& words) {
  return std::string(openltc_last_error()).find(words) != std::string::npos;
}

/// A light of the C++ API with its radiance, 1 for those that have an intensity.
struct CppLight {
  std::variant<Polygon, Ellipse, Sphere, Tube, Line, PointLight, SpotLight, DirectionalLight> light;
  Vec3f radiance{1, 1, 1};
};

/// One of each kind in both; `kinds` names them in order.
struct AllLights {
  LightsHandle c = no_lights();
  std::vector<CppLight> cpp;
  std::vector<const char*> kinds;

  AllLights() {
    const float center[3] = {0.2f, 1.5f, -0.3f}, u[3] = {0.5f, 0.1f, 0}, v[3] = {0, 0.2f, 0.6f};
    const float down[3] = {0.1f, -1, 0.2f}, end[3] = {1, 1.2f, 0.4f}, rgb[3] = {3, 2, 0.5f};
    const Vec3f p(0.2f, 1.5f, -0.3f), hu(0.5f, 0.1f, 0), hv(0, 0.2f, 0.6f), q(1, 1.2f, 0.4f);
    const Vec3f d(0.1f, -1, 0.2f), l(3, 2, 0.5f);
    openltc_lights* lights = c.get();
    const auto add = [&](const char* kind, openltc_status status, CppLight light) {
      REQUIRE_MESSAGE(status == OPENLTC_OK, openltc_last_error());
      cpp.push_back(std::move(light));
      kinds.push_back(kind);
    };
    add("rectangle", openltc_lights_add_rectangle(lights, center, u, v, 1, rgb),
        {Polygon::rectangle(p, hu, hv, true), l});
    // An L with a triangular hole, above the floor, which it faces.
    const float outline[9][3] = {{0, 2, 0},       {1, 2, 0},       {1, 2, 0.4f},
                                 {0.4f, 2, 0.4f}, {0.4f, 2, 1},    {0, 2, 1},
                                 {0.1f, 2, 0.1f}, {0.1f, 2, 0.3f}, {0.3f, 2, 0.1f}};
    const size_t ends[2] = {6, 9};
    std::vector<std::vector<Vec3f>> rings(2);
    for (int i = 0; i < 9; ++i)
      rings[i < 6 ? 0 : 1].push_back({outline[i][0], outline[i][1], outline[i][2]});
    add("polygon", openltc_lights_add_polygon(lights, outline[0], 9, ends, 2, 1, rgb),
        {Polygon::from_rings(rings, true), l});
    add("one ring", openltc_lights_add_polygon(lights, outline[0], 6, nullptr, 0, 1, rgb),
        {Polygon::from_vertices(rings[0], true), l});
    const float short_axis[3] = {0, 0.3f, 0};
    const float long_axis[3] = {0.6f, 0, 0.2f};
    add("ellipse", openltc_lights_add_ellipse(lights, center, long_axis, short_axis, 1, rgb),
        {Ellipse{p, {0.6f, 0, 0.2f}, {0, 0.3f, 0}, true}, l});
    add("disk", openltc_lights_add_disk(lights, center, down, 0.4f, 0, rgb), {disk(p, d, 0.4f), l});
    add("sphere", openltc_lights_add_sphere(lights, center, 0.3f, rgb), {Sphere{p, 0.3f}, l});
    add("open tube", openltc_lights_add_tube(lights, center, end, 0.1f, OPENLTC_CAPS_NONE, rgb),
        {Tube{p, q, 0.1f, TubeCaps::none}, l});
    add("cylinder", openltc_lights_add_tube(lights, center, end, 0.1f, OPENLTC_CAPS_FLAT, rgb),
        {Tube{p, q, 0.1f, TubeCaps::flat}, l});
    add("capsule", openltc_lights_add_tube(lights, center, end, 0.1f, OPENLTC_CAPS_ROUND, rgb),
        {Tube{p, q, 0.1f, TubeCaps::round}, l});
    add("line", openltc_lights_add_line(lights, center, end, rgb), {Line{p, q}, l});
    add("point", openltc_lights_add_point(lights, center, rgb, 9), {PointLight{p, l, 9}});
    add("spot", openltc_lights_add_spot(lights, center, down, rgb, 9, 0.3f, 0.8f),
        {SpotLight{p, d, l, 9, 0.3f, 0.8f}});
    add("directional", openltc_lights_add_directional(lights, down, rgb), {DirectionalLight{d, l}});
  }
};

} // namespace openltc::testing
