// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/api/light_sampling.h"
#include "openltc/c_api/handles.h"
#include "openltc/c_api/points.h"
#include "openltc/c_api/status.h"

#include <fmt/format.h>

#include <type_traits>

using namespace openltc;
using c_api::fail;

namespace {

constexpr openltc_vectors directions_at(const float* directions) { return {directions, 0}; }

void store(float (&values)[3], Vec3f v) {
  values[0] = v.x;
  values[1] = v.y;
  values[2] = v.z;
}

openltc_light_sample sample_of(const Surface& surface, const LightSample& s) {
  openltc_light_sample sample{};
  store(sample.position, s.position);
  store(sample.direction, s.direction);
  if (s.valid) store(sample.value, eval_surface(surface, s.direction));
  sample.distance = s.distance;
  sample.cos_light = s.cos_light;
  sample.pdf = s.pdf;
  sample.valid = s.valid ? 1 : 0;
  return sample;
}

/// Refuses what openltc_sample_light and openltc_intersect_light cannot work with.
openltc_status check(const openltc_lobes* lobes, const openltc_lights* lights, size_t light,
                     const openltc_points* points, const float* numbers,
                     const openltc_light_sample* samples) {
  if (!lobes) return fail(OPENLTC_INVALID_ARGUMENT, "lobes is null");
  if (!lights) return fail(OPENLTC_INVALID_ARGUMENT, "lights is null");
  if (light >= lights->lights.size())
    return fail(OPENLTC_INVALID_ARGUMENT,
                fmt::format("there is no light {}; there are {}", light, lights->lights.size()));
  if (const openltc_status status = c_api::check_points(points)) return status;
  if (points->count > 0 && (!numbers || !samples))
    return fail(OPENLTC_INVALID_ARGUMENT, "an array of one element a point is null");
  return OPENLTC_OK;
}

openltc_status check(const openltc_lobes* lobes, const openltc_points* points, const void* numbers,
                     const void* results) {
  if (!lobes) return fail(OPENLTC_INVALID_ARGUMENT, "lobes is null");
  if (const openltc_status status = c_api::check_points(points)) return status;
  if (points->count > 0 && (!numbers || !results))
    return fail(OPENLTC_INVALID_ARGUMENT, "an array of one element a point is null");
  return OPENLTC_OK;
}

} // namespace

openltc_status openltc_sample_light(const openltc_lobes* lobes, const openltc_lights* lights,
                                    size_t light, const openltc_points* points, int32_t threads,
                                    const float* u, openltc_light_sample* samples) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, lights, light, points, u, samples))
      return status;
    return std::visit(
        [&](const auto& shape) -> openltc_status {
          if constexpr (c_api::has_extent<std::decay_t<decltype(shape)>>) {
            return c_api::for_ranges(points->count, threads, [&](size_t begin, size_t end) {
              for (size_t i = begin; i < end; ++i) {
                const Surface surface = c_api::read_surface(lobes->view, *points, i);
                samples[i] =
                    sample_of(surface, sample_light(surface, shape, {u[2 * i], u[2 * i + 1]}));
              }
            });
          } else {
            return fail(OPENLTC_INVALID_ARGUMENT,
                        fmt::format("light {} has no extent: no points of it can be drawn", light));
          }
        },
        lights->lights[light].light);
  });
}

openltc_status openltc_intersect_light(const openltc_lobes* lobes, const openltc_lights* lights,
                                       size_t light, const openltc_points* points, int32_t threads,
                                       const float* directions, openltc_light_sample* samples) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, lights, light, points, directions, samples))
      return status;
    return std::visit(
        [&](const auto& shape) {
          using Light = std::decay_t<decltype(shape)>;
          return c_api::for_ranges(points->count, threads, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
              const Surface surface = c_api::read_surface(lobes->view, *points, i);
              LightSample met;
              if constexpr (c_api::has_extent<Light> && !std::is_same_v<Light, Line>)
                met = intersect_light(surface, shape,
                                      c_api::read_vector(directions_at(directions), i));
              samples[i] = sample_of(surface, met);
            }
          });
        },
        lights->lights[light].light);
  });
}

openltc_status openltc_sample_surface(const openltc_lobes* lobes, const openltc_points* points,
                                      int32_t threads, const float* u,
                                      openltc_direction_sample* samples) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, points, u, samples)) return status;
    return c_api::for_ranges(points->count, threads, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Surface surface = c_api::read_surface(lobes->view, *points, i);
        const DirectionSample s = sample_surface(surface, {u[2 * i], u[2 * i + 1]});
        samples[i] = openltc_direction_sample{};
        store(samples[i].direction, s.direction);
        store(samples[i].value, s.value);
        samples[i].pdf = s.pdf;
        samples[i].valid = s.valid ? 1 : 0;
      }
    });
  });
}

openltc_status openltc_eval_surface(const openltc_lobes* lobes, const openltc_points* points,
                                    int32_t threads, const float* directions, float* values,
                                    float* pdfs) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check(lobes, points, directions, values ? values : pdfs))
      return status;
    return c_api::for_ranges(points->count, threads, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Surface surface = c_api::read_surface(lobes->view, *points, i);
        const Vec3f wi = c_api::read_vector(directions_at(directions), i);
        if (values) {
          const Vec3f value = eval_surface(surface, wi);
          values[3 * i] = value.x;
          values[3 * i + 1] = value.y;
          values[3 * i + 2] = value.z;
        }
        if (pdfs) pdfs[i] = pdf_surface(surface, wi);
      }
    });
  });
}
