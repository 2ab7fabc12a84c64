// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/view/studio_room.h"

#include "openltc/render/view/sight_lines.h"
#include "openltc/render/view/view_samples.h"
#include "openltc/scene/view/studio.h"
#include "openltc/scene/view/subject.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace openltc::render {

namespace {

constexpr double k_off_surface = 1e-4; // of the scene's diagonal
// A rig that reaches less than this share of what faces it is taken for one behind walls.
constexpr double k_least_reached = 0.05;
constexpr double k_below_ceiling = 0.03;   // of the room's height
constexpr double k_share_of_ceiling = 0.5; // of its width and depth

/// A point that the camera sees, a little off its surface, and the normal on that side.
struct SeenPoint {
  Vec3d position, normal;
};

std::vector<SeenPoint> seen_points(const std::vector<ViewSample>& samples, Vec3d eye,
                                   const SightLines& sight, double off_surface) {
  std::vector<SightLine> lines;
  std::vector<SeenPoint> points;
  for (const ViewSample& sample : samples) {
    const double facing = dot(sample.normal, eye - sample.position);
    if (facing <= 0 && !sample.two_sided) continue;
    const Vec3d normal = facing > 0 ? sample.normal : -sample.normal;
    points.push_back({sample.position + normal * off_surface, normal});
    lines.push_back({points.back().position, eye});
  }
  sight.trace(lines, SightLines::Blocks::what_is_seen);
  std::vector<SeenPoint> seen;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].is_free) seen.push_back(points[i]);
  return seen;
}

// Share of pairs of a soft box and a point that faces it between which nothing stands.
double share_reached(const light::Lights& rig, const std::vector<SeenPoint>& points,
                     const SightLines& sight) {
  std::vector<SightLine> lines;
  for (const light::PolygonLight& box : rig.polygons) {
    Vec3d middle(0, 0, 0);
    for (const Vec3f v : box.vertices)
      middle += to_double(v) / double(box.vertices.size());
    for (const SeenPoint& point : points)
      if (dot(point.normal, middle - point.position) > 0) lines.push_back({point.position, middle});
  }
  sight.trace(lines, SightLines::Blocks::all);
  const auto reached =
      std::count_if(lines.begin(), lines.end(), [](const SightLine& line) { return line.is_free; });
  return lines.empty() ? 1 : double(reached) / double(lines.size());
}

} // namespace

Result<light::Lights> studio_for(const scene::Scene& scene, const scene::Camera& camera,
                                 double white_nits) {
  const scene::Subject subject = scene::find_subject(scene);
  const double diagonal = scene::diagonal(scene.bounds);
  if (!(scene::diagonal(subject.bounds) > 0))
    return scene::studio_lights(scene.bounds, camera, white_nits);
  light::Lights rig = scene::studio_lights(subject.bounds, camera, white_nits);
  Result<SightLines> sight = SightLines::create(scene);
  if (!sight) return sight.error();
  const std::vector<ViewSample> samples = sample_subject(scene, subject, *sight);
  const Vec3d eye = to_double(camera.position);
  if (share_reached(rig, seen_points(samples, eye, *sight, k_off_surface * diagonal), *sight) >=
      k_least_reached)
    return rig;
  // From a camera outside, which sees through the backs of walls, the room is where its middle is.
  const Vec3d low = to_double(scene.bounds.lower), high = to_double(scene.bounds.upper);
  const bool is_inside = low.x < eye.x && eye.x < high.x && low.y < eye.y && eye.y < high.y &&
                         low.z < eye.z && eye.z < high.z;
  const Vec3d in_room = is_inside ? eye : (low + high) * 0.5;
  const auto free = [&](double x, double y, double z) {
    return sight->free_distance(in_room, Vec3d(x, y, z), diagonal);
  };
  const double above = free(0, 1, 0), below = free(0, -1, 0);
  if (!(above < diagonal)) return rig;
  const double left = free(-1, 0, 0), right = free(1, 0, 0);
  const double behind = free(0, 0, -1), before = free(0, 0, 1);
  const double height = above + below;
  return scene::ceiling_light(
      in_room +
          Vec3d(0.5 * (right - left), above - k_below_ceiling * height, 0.5 * (before - behind)),
      k_share_of_ceiling * 0.5 * (left + right), k_share_of_ceiling * 0.5 * (behind + before),
      (0.5 - k_below_ceiling) * height, white_nits);
}

} // namespace openltc::render
