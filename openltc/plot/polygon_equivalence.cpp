// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed
// Cosines", section 3 and figure 3. D dw = D_o dw_o by its very definition, and M^-1, being linear,
// takes the pyramid over P to that over M^-1 P.

#include "openltc/plot/polygon_equivalence.h"

#include "openltc/base/sampling.h"
#include "openltc/fit/measure/polygon_integral.h"
#include "openltc/plot/lobe_quadrature.h"
#include "openltc/scene/emissive/simple_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::plot {

namespace {

constexpr std::size_t k_most_corners = 64;
constexpr double k_plane_tolerance = 1e-6; // of the polygon's size

// Half the sum of the fan's cross products: along the normal, as long as the area.
Vec3d area_vector(std::span<const Vec3d> corners) {
  Vec3d sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum * 0.5;
}

double size_of(std::span<const Vec3d> corners) {
  double size = 0;
  for (const Vec3d& corner : corners)
    size = std::max(size, length(corner - corners[0]));
  return size;
}

struct PlaneAxes {
  Vec3d u, v;
};

PlaneAxes axes_of(Vec3d normal) {
  const Vec3d other = std::abs(normal.z) < 0.5 * length(normal) ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
  const Vec3d u = normalize(cross(other, normal));
  return {u, cross(normalize(normal), u)};
}

std::vector<Vec2d> in_plane(std::span<const Vec3d> corners, const PlaneAxes& axes) {
  std::vector<Vec2d> ring;
  for (const Vec3d& corner : corners)
    ring.push_back({dot(corner, axes.u), dot(corner, axes.v)});
  return ring;
}

Status check_polygon(std::span<const Vec3d> corners, const std::string& name) {
  if (corners.size() < 3)
    return Error{fmt::format("{}: a polygon needs three corners or more, there {} {}", name,
                             corners.size() == 1 ? "is" : "are", corners.size())};
  if (corners.size() > k_most_corners)
    return Error{fmt::format("{}: {} corners; {} at most", name, corners.size(), k_most_corners)};
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (const double v : {corners[i].x, corners[i].y, corners[i].z})
      if (!std::isfinite(v) || std::abs(v) > 1e6)
        return Error{fmt::format("{}: corner {} is not finite, or beyond a million", name, i + 1)};
  const double size = size_of(corners);
  const Vec3d area = area_vector(corners);
  if (!(length(area) > 1e-9 * size * size))
    return Error{fmt::format("{}: the corners lie on a line, or the outline encloses no area; give "
                             "them in order around the polygon",
                             name)};
  const Vec3d normal = normalize(area);
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (std::abs(dot(normal, corners[i] - corners[0])) > k_plane_tolerance * size)
      return Error{
          fmt::format("{}: corner {} does not lie in the plane of the others", name, i + 1)};
  if (std::abs(dot(normal, corners[0])) <= k_plane_tolerance * (size + length(corners[0])))
    return Error{
        fmt::format("{}: the polygon's plane holds the shaded point, the origin, from which "
                    "it is a line; move it aside",
                    name)};
  if (Status status = scene::check_simple(in_plane(corners, axes_of(normal))); !status)
    return Error{fmt::format("{}: {}", name, status.error().message)};
  return Success{};
}

void count_inside(PolygonSpace& space, Vec3d surface_horizon, Vec3d cosine_horizon) {
  for (const Vec3d& w : space.samples) {
    const bool inside = dot(w, surface_horizon) >= 0 && dot(w, cosine_horizon) >= 0 &&
                        ray_meets_polygon(space.corners, w);
    space.inside.push_back(inside);
    space.inside_count += inside;
  }
}

} // namespace

std::vector<Vec3d> clip_to_plane(std::span<const Vec3d> corners, Vec3d normal) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
    const double height_a = dot(a, normal), height_b = dot(b, normal);
    if (height_a >= 0) kept.push_back(a);
    if ((height_a >= 0) != (height_b >= 0))
      kept.push_back(a + (b - a) * (height_a / (height_a - height_b)));
  }
  return kept;
}

bool ray_meets_polygon(std::span<const Vec3d> corners, Vec3d direction) {
  const Vec3d normal = area_vector(corners);
  const double slope = dot(normal, direction);
  const double distance = dot(normal, corners[0]) / slope;
  if (!(distance > 0) || !std::isfinite(distance)) return false;
  const PlaneAxes axes = axes_of(normal);
  const std::vector<Vec2d> ring = in_plane(corners, axes);
  const Vec3d point = direction * distance;
  const double x = dot(point, axes.u), y = dot(point, axes.v);
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

Result<PolygonEquivalence> compare_spaces(const f64::Lobe& lobe, std::span<const Vec3d> corners,
                                          const std::string& name,
                                          const PolygonSampling& sampling) {
  if (Status status = check_polygon(corners, name); !status) return status.error();
  const Vec3d up(0, 0, 1);
  PolygonEquivalence result;
  result.horizon_normal_cosine = f64::horizon_normal_cosine(lobe);
  result.horizon_normal_shading = normalize(Vec3d(lobe.m20, 0, lobe.m22));

  PolygonSpace& shading = result.shading;
  PolygonSpace& cosine = result.cosine;
  shading.corners.assign(corners.begin(), corners.end());
  const std::vector<Vec3d> above = clip_to_plane(corners, up);
  if (above.size() < 3)
    return Error{fmt::format("{}: the whole polygon lies below the surface's horizon, z = 0, where "
                             "no light comes from; raise a corner",
                             name)};
  shading.kept = clip_to_plane(above, result.horizon_normal_shading);
  if (shading.kept.size() < 3)
    return Error{
        fmt::format("{}: the whole polygon lies below the cosine's horizon, where the lobe "
                    "is zero; move it towards ({:.2f}, 0, {:.2f})",
                    name, result.horizon_normal_shading.x, result.horizon_normal_shading.z)};
  for (const Vec3d& corner : shading.corners)
    cosine.corners.push_back(f64::to_cosine(lobe, corner));
  for (const Vec3d& corner : shading.kept)
    cosine.kept.push_back(f64::to_cosine(lobe, corner));

  shading.integral = integrate_over_polygon(lobe, shading.kept).mass;
  cosine.integral = fit::integrate_lobe_over_polygon(f64::cosine_lobe(), cosine.kept);

  for (int i = 0; i < sampling.samples; ++i) {
    const Sample2 u = owen_sobol(std::uint32_t(i), hash_combine(sampling.seed, 0));
    const Vec3d w = f64::sample_lobe(lobe, {double(u.u), double(u.v)});
    shading.samples.push_back(w);
    cosine.samples.push_back(normalize(f64::to_cosine(lobe, w)));
  }
  count_inside(shading, up, result.horizon_normal_shading);
  count_inside(cosine, result.horizon_normal_cosine, up);
  return result;
}

} // namespace openltc::plot
