// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lists of lights. What the C++ API takes for a dark light is refused here: there is a status to
// say so, and a caller in another language who cannot look into the light.

#include "openltc/api/light_sampling.h"
#include "openltc/c_api/handles.h"
#include "openltc/c_api/status.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>

using namespace openltc;
using c_api::fail;

namespace {

constexpr float k_brightest = 1e20f; // what BatchLights takes

struct NamedVector {
  const char* name;
  const float* data;
  bool is_emitted = false; ///< light: 0 to k_brightest
};

/// Refuses null lights, and vectors that are null, not finite, or no light where that is meant.
openltc_status check_vectors(const openltc_lights* lights,
                             std::initializer_list<NamedVector> vectors) {
  if (!lights) return fail(OPENLTC_INVALID_ARGUMENT, "lights is null");
  for (const NamedVector& vector : vectors) {
    if (!vector.data) return fail(OPENLTC_INVALID_ARGUMENT, fmt::format("{} is null", vector.name));
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(vector.data[i]))
        return fail(OPENLTC_INVALID_ARGUMENT, fmt::format("{} is not finite", vector.name));
      if (vector.is_emitted && !(vector.data[i] >= 0 && vector.data[i] <= k_brightest))
        return fail(OPENLTC_INVALID_ARGUMENT,
                    fmt::format("{} is negative, or above 1e20", vector.name));
    }
  }
  return OPENLTC_OK;
}

Vec3f vector_of(const float* data) { return {data[0], data[1], data[2]}; }

openltc_status add(openltc_lights& lights, c_api::AnyLight light, Vec3f radiance = Vec3f(1.0f)) {
  lights.lights.push_back({std::move(light), radiance});
  bool added = false;
  try {
    added = std::visit(
        [&](const auto& shape) {
          if constexpr (c_api::has_extent<std::decay_t<decltype(shape)>>)
            return lights.batch.add(shape, radiance);
          else
            return lights.batch.add(shape);
        },
        lights.lights.back().light);
  } catch (...) {
    lights.lights.pop_back();
    throw;
  }
  if (added) return OPENLTC_OK;
  lights.lights.pop_back();
  return fail(OPENLTC_INVALID_ARGUMENT, "the light cannot be shaded");
}

/// Adds a shape, or refuses it by what it asks of its numbers.
template <class Shape>
openltc_status add_shape(openltc_lights& lights, const Shape& shape, const char* asked,
                         const float* radiance) {
  if (!detail::is_usable(shape)) return fail(OPENLTC_INVALID_ARGUMENT, asked);
  return add(lights, shape, vector_of(radiance));
}

openltc_status add_polygon(openltc_lights& lights, const Polygon& polygon, const float* radiance) {
  if (polygon.error()) return fail(OPENLTC_INVALID_ARGUMENT, polygon.error());
  return add(lights, polygon, vector_of(radiance));
}

/// The rings of a polygon, or what is wrong with their ends.
openltc_status read_rings(const float* vertices, size_t vertex_count, const size_t* ring_ends,
                          size_t ring_count, std::vector<std::vector<Vec3f>>& rings) {
  const size_t whole[1] = {vertex_count};
  if (!ring_ends) {
    if (ring_count != 0) return fail(OPENLTC_INVALID_ARGUMENT, "ring_ends is null");
    ring_ends = whole;
    ring_count = 1;
  }
  // A ring takes three vertices: more rings than vertices would be a mistake, and much memory.
  if (ring_count == 0 || ring_count > vertex_count || ring_ends[ring_count - 1] != vertex_count)
    return fail(OPENLTC_INVALID_ARGUMENT, "ring_ends does not end with vertex_count");
  size_t begin = 0;
  for (size_t ring = 0; ring < ring_count; ++ring) {
    const size_t end = ring_ends[ring];
    if (end < begin || end > vertex_count)
      return fail(OPENLTC_INVALID_ARGUMENT, "ring_ends does not rise");
    rings.emplace_back();
    for (size_t i = begin; i < end; ++i)
      rings.back().push_back(vector_of(vertices + 3 * i));
    begin = end;
  }
  return OPENLTC_OK;
}

openltc_status check_range(float range) {
  if (range >= 0 && std::isfinite(range)) return OPENLTC_OK;
  return fail(OPENLTC_INVALID_ARGUMENT, "range is negative or not finite");
}

openltc_status check_place(const float* position) {
  if (detail::is_place(vector_of(position))) return OPENLTC_OK;
  return fail(OPENLTC_INVALID_ARGUMENT, "position is further than 4e8 m away");
}

openltc_status check_direction(const char* name, const float* direction) {
  const Vec3f unit = detail::unit_or(vector_of(direction), Vec3f(0.0f));
  if (dot(unit, unit) > 0.5f) return OPENLTC_OK;
  return fail(OPENLTC_INVALID_ARGUMENT, fmt::format("{} has no length", name));
}

} // namespace

openltc_status openltc_lights_create(openltc_lights** lights) {
  return c_api::create(lights, [](openltc_lights&) -> openltc_status { return OPENLTC_OK; });
}

void openltc_lights_destroy(openltc_lights* lights) { delete lights; }

size_t openltc_lights_count(const openltc_lights* lights) {
  return lights ? lights->lights.size() : 0;
}

openltc_status openltc_lights_clear(openltc_lights* lights) {
  if (!lights) return fail(OPENLTC_INVALID_ARGUMENT, "lights is null");
  lights->lights.clear();
  lights->batch.clear();
  return OPENLTC_OK;
}

openltc_status openltc_lights_add_rectangle(openltc_lights* lights, const float* center,
                                            const float* half_u, const float* half_v,
                                            int32_t two_sided, const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(lights, {{"center", center},
                                                             {"half_u", half_u},
                                                             {"half_v", half_v},
                                                             {"radiance", radiance, true}}))
      return status;
    return add_polygon(
        *lights,
        Polygon::rectangle(vector_of(center), vector_of(half_u), vector_of(half_v), two_sided != 0),
        radiance);
  });
}

openltc_status openltc_lights_add_polygon(openltc_lights* lights, const float* vertices,
                                          size_t vertex_count, const size_t* ring_ends,
                                          size_t ring_count, int32_t two_sided,
                                          const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(lights, {{"radiance", radiance, true}}))
      return status;
    if (!vertices) return fail(OPENLTC_INVALID_ARGUMENT, "vertices is null");
    if (vertex_count < 3 || vertex_count > 1000000)
      return fail(OPENLTC_INVALID_ARGUMENT, "vertex_count is not from 3 to a million");
    std::vector<std::vector<Vec3f>> rings;
    if (const openltc_status status =
            read_rings(vertices, vertex_count, ring_ends, ring_count, rings))
      return status;
    return add_polygon(*lights, Polygon::from_rings(rings, two_sided != 0), radiance);
  });
}

openltc_status openltc_lights_add_ellipse(openltc_lights* lights, const float* center,
                                          const float* half_u, const float* half_v,
                                          int32_t two_sided, const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(lights, {{"center", center},
                                                             {"half_u", half_u},
                                                             {"half_v", half_v},
                                                             {"radiance", radiance, true}}))
      return status;
    const Ellipse ellipse{vector_of(center), vector_of(half_u), vector_of(half_v), two_sided != 0};
    return add_shape(*lights, ellipse,
                     "half_u and half_v are not perpendicular, or not from 1e-12 to 1e8 m long, or "
                     "center is further than 4e8 m away",
                     radiance);
  });
}

openltc_status openltc_lights_add_disk(openltc_lights* lights, const float* center,
                                       const float* normal, float radius, int32_t two_sided,
                                       const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(
            lights, {{"center", center}, {"normal", normal}, {"radiance", radiance, true}}))
      return status;
    if (const openltc_status status = check_direction("normal", normal)) return status;
    return add_shape(*lights, disk(vector_of(center), vector_of(normal), radius, two_sided != 0),
                     "radius is not from 1e-12 to 1e8 m, or center is further than 4e8 m away",
                     radiance);
  });
}

openltc_status openltc_lights_add_sphere(openltc_lights* lights, const float* center, float radius,
                                         const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status =
            check_vectors(lights, {{"center", center}, {"radiance", radiance, true}}))
      return status;
    return add_shape(*lights, Sphere{vector_of(center), radius},
                     "radius is not from 1e-12 to 1e8 m, or center is further than 4e8 m away",
                     radiance);
  });
}

openltc_status openltc_lights_add_tube(openltc_lights* lights, const float* from, const float* to,
                                       float radius, int32_t caps, const float* radiance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status =
            check_vectors(lights, {{"from", from}, {"to", to}, {"radiance", radiance, true}}))
      return status;
    if (caps < OPENLTC_CAPS_NONE || caps > OPENLTC_CAPS_ROUND)
      return fail(OPENLTC_INVALID_ARGUMENT, "caps is none of OPENLTC_CAPS_NONE, _FLAT, _ROUND");
    const TubeCaps kind = caps == OPENLTC_CAPS_NONE   ? TubeCaps::none
                          : caps == OPENLTC_CAPS_FLAT ? TubeCaps::flat
                                                      : TubeCaps::round;
    return add_shape(*lights, Tube{vector_of(from), vector_of(to), radius, kind},
                     "radius or length is not from 1e-12 to 1e8 m, or an end is further than 4e8 m "
                     "away",
                     radiance);
  });
}

openltc_status openltc_lights_add_line(openltc_lights* lights, const float* from, const float* to,
                                       const float* intensity_per_metre) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(
            lights,
            {{"from", from}, {"to", to}, {"intensity_per_metre", intensity_per_metre, true}}))
      return status;
    return add_shape(*lights, Line{vector_of(from), vector_of(to)},
                     "the length is not from 1e-12 to 1e8 m, or an end is further than 4e8 m away",
                     intensity_per_metre);
  });
}

openltc_status openltc_lights_add_point(openltc_lights* lights, const float* position,
                                        const float* intensity, float range) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status =
            check_vectors(lights, {{"position", position}, {"intensity", intensity, true}}))
      return status;
    if (const openltc_status status = check_place(position)) return status;
    if (const openltc_status status = check_range(range)) return status;
    return add(*lights, PointLight{vector_of(position), vector_of(intensity), range});
  });
}

openltc_status openltc_lights_add_spot(openltc_lights* lights, const float* position,
                                       const float* direction, const float* intensity, float range,
                                       float inner_angle, float outer_angle) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status = check_vectors(
            lights,
            {{"position", position}, {"direction", direction}, {"intensity", intensity, true}}))
      return status;
    if (const openltc_status status = check_place(position)) return status;
    if (const openltc_status status = check_direction("direction", direction)) return status;
    if (const openltc_status status = check_range(range)) return status;
    // The float next to pi/2 is above it.
    if (!(inner_angle >= 0 && inner_angle <= outer_angle && outer_angle <= 1.5707964f))
      return fail(OPENLTC_INVALID_ARGUMENT,
                  "not 0 <= inner_angle <= outer_angle <= pi/2: they are radians");
    return add(*lights, SpotLight{vector_of(position), vector_of(direction), vector_of(intensity),
                                  range, inner_angle, outer_angle});
  });
}

openltc_status openltc_lights_add_directional(openltc_lights* lights, const float* direction,
                                              const float* illuminance) {
  return c_api::guarded([&]() -> openltc_status {
    if (const openltc_status status =
            check_vectors(lights, {{"direction", direction}, {"illuminance", illuminance, true}}))
      return status;
    if (const openltc_status status = check_direction("direction", direction)) return status;
    return add(*lights, DirectionalLight{vector_of(direction), vector_of(illuminance)});
  });
}
