// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What is no light is refused, with a reason, and adds nothing.

#include "tests/c_api/c_lights.h"

#include <cmath>
#include <limits>

using namespace openltc;
using namespace openltc::testing;

namespace {

const float k_nan = std::numeric_limits<float>::quiet_NaN();
const float k_center[3] = {0, 1, 0}, k_u[3] = {1, 0, 0}, k_v[3] = {0, 0, 1}, k_down[3] = {0, -1, 0};
const float k_nits[3] = {1, 1, 1}, k_zero[3] = {0, 0, 0};

void check_refused(openltc_status status, const char* words) {
  CHECK(status == OPENLTC_INVALID_ARGUMENT);
  CHECK_MESSAGE(last_error_says(words), openltc_last_error());
}

} // namespace

TEST_CASE("numbers_that_are_no_light_are_refused") {
  const LightsHandle handle = no_lights();
  openltc_lights* lights = handle.get();
  const float bad[3] = {0, k_nan, 0}, dark[3] = {1, -1, 1}, far[3] = {5e8f, 0, 0};
  check_refused(openltc_lights_add_rectangle(lights, bad, k_u, k_v, 0, k_nits),
                "center is not finite");
  check_refused(openltc_lights_add_rectangle(lights, k_center, k_u, k_u, 0, k_nits), "no area");
  check_refused(openltc_lights_add_rectangle(lights, k_center, k_u, k_v, 0, dark),
                "radiance is negative");
  check_refused(openltc_lights_add_rectangle(lights, k_center, k_u, k_v, 0, bad),
                "radiance is not finite");
  const float glaring[3] = {1, 1e21f, 1};
  check_refused(openltc_lights_add_sphere(lights, k_center, 1, glaring),
                "radiance is negative, or");
  const float slanted[3] = {0.5f, 0, 1};
  check_refused(openltc_lights_add_ellipse(lights, k_center, k_u, slanted, 0, k_nits),
                "not perpendicular");
  check_refused(openltc_lights_add_disk(lights, k_center, k_zero, 1, 0, k_nits),
                "normal has no length");
  check_refused(openltc_lights_add_disk(lights, k_center, k_down, 0, 0, k_nits), "radius");
  check_refused(openltc_lights_add_sphere(lights, k_center, k_nan, k_nits), "radius");
  check_refused(openltc_lights_add_sphere(lights, far, 1, k_nits), "center");
  check_refused(openltc_lights_add_tube(lights, k_center, k_center, 1, 0, k_nits), "length");
  check_refused(openltc_lights_add_tube(lights, k_center, k_u, 1, 3, k_nits), "caps");
  check_refused(openltc_lights_add_line(lights, k_center, k_center, k_nits), "length");
  check_refused(openltc_lights_add_line(lights, k_center, k_u, dark),
                "intensity_per_metre is negative");
  check_refused(openltc_lights_add_point(lights, far, k_nits, 0), "position");
  check_refused(openltc_lights_add_point(lights, k_center, k_nits, -1), "range");
  check_refused(openltc_lights_add_spot(lights, k_center, k_zero, k_nits, 0, 0, 1), "direction");
  check_refused(openltc_lights_add_spot(lights, k_center, k_down, k_nits, 0, 30, 45), "radians");
  check_refused(openltc_lights_add_spot(lights, k_center, k_down, k_nits, 0, 0.5f, 0.4f),
                "inner_angle <= outer_angle");
  check_refused(openltc_lights_add_directional(lights, k_zero, k_nits), "direction");
  check_refused(openltc_lights_add_directional(lights, k_down, dark), "illuminance is negative");
  CHECK(openltc_lights_count(lights) == 0);
}

TEST_CASE("outlines_that_are_none_are_refused") {
  const LightsHandle handle = no_lights();
  openltc_lights* lights = handle.get();
  const float square[4][3] = {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
  const float bent[4][3] = {{0, 1, 0}, {1, 1, 0}, {1, 2, 1}, {0, 1, 1}};
  const float* vertices = square[0];
  check_refused(openltc_lights_add_polygon(lights, bent[0], 4, nullptr, 0, 0, k_nits), "plane");
  check_refused(openltc_lights_add_polygon(lights, vertices, 2, nullptr, 0, 0, k_nits),
                "vertex_count");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, nullptr, 1, 0, k_nits),
                "ring_ends is null");
  const size_t beyond[1] = {5}, early[1] = {3}, falling[3] = {3, 2, 4}, small[2] = {1, 4};
  const size_t huge[3] = {3, SIZE_MAX, 4};
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, beyond, 1, 0, k_nits), "ring_ends");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, early, 1, 0, k_nits), "ring_ends");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, early, 0, 0, k_nits), "ring_ends");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, falling, 3, 0, k_nits), "rise");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, huge, 3, 0, k_nits), "rise");
  check_refused(openltc_lights_add_polygon(lights, vertices, 4, small, 2, 0, k_nits),
                "fewer than three");
  CHECK(openltc_lights_count(lights) == 0);
  CHECK(openltc_lights_add_polygon(lights, vertices, 4, nullptr, 0, 0, k_nits) == OPENLTC_OK);
  CHECK(openltc_lights_count(lights) == 1);
}
