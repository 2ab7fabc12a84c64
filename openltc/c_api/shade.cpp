// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/c_api/points.h"
#include "openltc/c_api/shade_points.h"
#include "openltc/c_api/status.h"

using namespace openltc;
using c_api::fail;

namespace {

openltc_status check(const openltc_lobes* lobes, const openltc_lights* lights,
                     const openltc_points* points) {
  if (!lobes) return fail(OPENLTC_INVALID_ARGUMENT, "lobes is null");
  if (!lights) return fail(OPENLTC_INVALID_ARGUMENT, "lights is null");
  return c_api::check_points(points);
}

} // namespace

openltc_status openltc_shade(const openltc_lobes* lobes, const openltc_lights* lights,
                             const openltc_points* points, int32_t threads, float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, lights, points)) return status;
    if (!radiance && points->count > 0) return fail(OPENLTC_INVALID_ARGUMENT, "radiance is null");
    return c_api::for_ranges(points->count, threads, [&](std::size_t begin, std::size_t end) {
      c_api::shade_points(*lobes, *lights, *points, begin, end, radiance);
    });
  });
}

openltc_status openltc_shade_parts(const openltc_lobes* lobes, const openltc_lights* lights,
                                   const openltc_points* points, int32_t threads, float* diffuse,
                                   float* specular) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, lights, points)) return status;
    if ((!diffuse || !specular) && points->count > 0)
      return fail(OPENLTC_INVALID_ARGUMENT, "diffuse or specular is null");
    return c_api::for_ranges(points->count, threads, [&](std::size_t begin, std::size_t end) {
      c_api::shade_parts_of_points(*lobes, *lights, *points, begin, end, diffuse, specular);
    });
  });
}
