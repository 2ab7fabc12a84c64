// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The area of a planar ring is half the sum of cross products of consecutive vertices, taken
// about one of its own vertices so that a light far from the origin keeps its precision.

#include "openltc/light/polygon.h"

#include "openltc/light/emitter.h"

#include <algorithm>
#include <cmath>

namespace openltc::light {

std::span<const Vec3f> ring_vertices(const PolygonLight& light, std::size_t ring) {
  const std::size_t begin = ring == 0 ? 0 : light.ring_end[ring - 1];
  return std::span<const Vec3f>(light.vertices).subspan(begin, light.ring_end[ring] - begin);
}

double signed_ring_area(std::span<const Vec3f> ring, Vec3f normal) {
  if (ring.size() < 3) return 0;
  const Vec3d origin = to_double(ring[0]);
  Vec3d sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += cross(to_double(ring[i]) - origin, to_double(ring[i + 1]) - origin);
  return 0.5 * dot(sum, to_double(normal));
}

double area(const PolygonLight& light) {
  double sum = 0;
  for (std::size_t r = 0; r < light.ring_end.size(); ++r)
    sum += signed_ring_area(ring_vertices(light, r), light.normal);
  return sum;
}

Vec3f flux_lumens(const PolygonLight& light) {
  return light.radiance * float(exitance_per_radiance(light) * area(light));
}

Status validate(const PolygonLight& light) {
  const auto wrong = [&](const char* what) { return wrong_light(light.name, what); };
  if (light.ring_end.empty() || light.ring_end.back() != light.vertices.size())
    return wrong("ring_end does not end at the last vertex");
  std::size_t begin = 0;
  for (const std::uint32_t end : light.ring_end) {
    if (end > light.vertices.size() || end < begin + 3)
      return wrong("a ring has fewer than three vertices");
    begin = end;
  }
  if (!std::all_of(light.vertices.begin(), light.vertices.end(), is_place))
    return wrong("a vertex is not within 4e8 m of the scene");
  if (!is_finite(light.normal) || !is_unit(light.normal)) return wrong("the normal is not unit");
  if (const Status status = validate_emitter(light); !status.ok()) return status.error();
  const double total = area(light);
  if (!(total > 0) || !std::isfinite(total)) return wrong("the outline has no area");

  // Planar within rounding: 1e-4 of the extent, the tolerance with which emitters are merged,
  // plus the rounding of coordinates far from the origin.
  const Vec3d origin = to_double(light.vertices[0]);
  double extent = 0, distance = 0, magnitude = 0;
  for (const Vec3f vertex : light.vertices) {
    const Vec3d offset = to_double(vertex) - origin;
    extent = std::max(extent, length(offset));
    magnitude = std::max(magnitude, length(to_double(vertex)));
    distance = std::max(distance, std::abs(dot(offset, to_double(light.normal))));
  }
  if (distance > 1e-4 * extent + 1e-6 * magnitude)
    return wrong("the vertices are not in one plane");
  return Success{};
}

} // namespace openltc::light
