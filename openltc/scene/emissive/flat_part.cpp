// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/flat_part.h"

#include "openltc/scene/emissive/ring_overlap.h"
#include "openltc/scene/emissive/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

namespace openltc::scene {

namespace {

double doubled_area(const FlatPart& part, const std::array<std::uint32_t, 3>& t) {
  const Vec3d a = part.points[t[0]];
  return dot(cross(part.points[t[1]] - a, part.points[t[2]] - a), part.normal);
}

std::size_t corner_count(const std::vector<Ring>& rings) {
  std::size_t count = 0;
  for (const Ring& ring : rings)
    count += ring.size();
  return count;
}

// The triangles of `part` with these numbers, and only their points.
FlatPart chosen(const FlatPart& part, std::span<const std::uint32_t> numbers) {
  FlatPart result;
  result.normal = part.normal;
  result.deviation = part.deviation;
  result.stretch = part.stretch;
  std::unordered_map<std::uint32_t, std::uint32_t> local;
  for (const std::uint32_t i : numbers) {
    auto t = part.triangles[i];
    for (std::uint32_t& corner : t) {
      const auto [place, is_new] = local.try_emplace(corner, std::uint32_t(result.points.size()));
      if (is_new) result.points.push_back(part.points[corner]);
      corner = place->second;
    }
    result.triangles.push_back(t);
    result.source.push_back(part.source[i]);
  }
  return result;
}

// Two halves on either side of the median of the triangles' centres, across the longer extent.
std::array<FlatPart, 2> halves(const FlatPart& part) {
  const PlaneAxes axes(part.normal);
  std::vector<Vec2d> centers;
  Vec2d lower(1e300, 1e300), upper(-1e300, -1e300);
  for (const auto& t : part.triangles) {
    const Vec2d c =
        axes.in_plane((part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3.0);
    centers.push_back(c);
    lower = {std::min(lower.x, c.x), std::min(lower.y, c.y)};
    upper = {std::max(upper.x, c.x), std::max(upper.y, c.y)};
  }
  const bool across_x = upper.x - lower.x > upper.y - lower.y;
  std::vector<std::uint32_t> order(part.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const double x = across_x ? centers[a].x : centers[a].y;
    const double y = across_x ? centers[b].x : centers[b].y;
    return x != y ? x < y : a < b;
  };
  const std::size_t middle = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(middle), order.end(), before);
  const std::span<std::uint32_t> all(order);
  std::sort(order.begin(), order.begin() + std::ptrdiff_t(middle));
  std::sort(order.begin() + std::ptrdiff_t(middle), order.end());
  return {chosen(part, all.first(middle)), chosen(part, all.subspan(middle))};
}

void split_into(FlatPart part, std::size_t most_corners, double tolerance, double straight,
                std::vector<FlatPart>& parts) {
  if (part.triangles.size() < 2 ||
      corner_count(outline_of(part, tolerance, straight)) <= most_corners) {
    parts.push_back(std::move(part));
    return;
  }
  for (FlatPart& half : halves(part))
    split_into(std::move(half), most_corners, tolerance, straight, parts);
}

} // namespace

FlatPart flatten(const WeldedMesh& mesh, const FacetPlane& plane, const Extent& extent) {
  FlatPart part;
  Vec3d normal_sum{0, 0, 0}, center_sum{0, 0, 0};
  double facets = 0;
  for (const auto& t : plane.triangles) {
    const Vec3d a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    const Vec3d doubled = cross(b - a, c - a);
    const double area = 0.5 * length(doubled);
    normal_sum += doubled;
    center_sum += (a + b + c) * (area / 3);
    facets += area;
  }
  if (!(length(normal_sum) > 0)) return part;
  part.normal = normalize(normal_sum);
  const Vec3d center = center_sum / facets;
  std::unordered_map<std::uint32_t, std::uint32_t> local;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
    auto t = plane.triangles[i];
    for (std::uint32_t& corner : t) {
      const auto [place, is_new] = local.try_emplace(corner, std::uint32_t(part.points.size()));
      if (is_new) {
        const Vec3d p = mesh.points[corner];
        const double height = dot(p - center, part.normal);
        part.deviation = std::max(part.deviation, std::abs(height));
        part.points.push_back(p - part.normal * height);
      }
      corner = place->second;
    }
    part.triangles.push_back(t);
    part.source.push_back(mesh.source[plane.members[i]]);
  }
  const double image = area_of(part);
  if (image > 0) part.stretch = std::max(facets / image, 1.0);

  if (!covers_twice(outline_of(part, extent.weld, extent.weld), part.normal, extent.weld))
    return part;
  Cover cover = cover_once(part.points, part.triangles, part.normal, extent.weld);
  part.is_tangled = !cover.is_complete;
  if (part.is_tangled) return part;
  for (std::uint32_t& i : cover.of)
    i = part.source[i];
  part.points = std::move(cover.points);
  part.triangles = std::move(cover.triangles);
  part.source = std::move(cover.of);
  return part;
}

double area_of(const FlatPart& part) {
  double sum = 0;
  for (const auto& t : part.triangles)
    sum += 0.5 * doubled_area(part, t);
  return sum;
}

std::vector<Ring> outline_of(const FlatPart& part, double tolerance, double straight) {
  return trace_outline(part.points, part.triangles, part.normal, tolerance, straight);
}

std::vector<FlatPart> split(FlatPart part, std::size_t most_corners, double tolerance,
                            double straight) {
  std::vector<FlatPart> parts;
  split_into(std::move(part), most_corners, tolerance, straight, parts);
  return parts;
}

light::PolygonLight polygon_of(const FlatPart& part, const std::vector<Ring>& rings,
                               const Extent& extent) {
  light::PolygonLight light;
  light.normal = to_float(part.normal);
  light.surface_deviation = float(part.deviation);
  for (const Ring& ring : rings) {
    for (const Vec3d& p : ring)
      light.vertices.push_back(to_float(p + extent.center));
    light.ring_end.push_back(std::uint32_t(light.vertices.size()));
  }
  return light;
}

} // namespace openltc::scene
