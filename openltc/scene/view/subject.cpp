// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The unit is the part: triangles of a mesh that hang together. A part is weighed by its share of
// the scene's area and of its triangles alike: the first speaks for plain things, the second for
// detailed ones.

#include "openltc/scene/view/subject.h"

#include "openltc/scene/view/backdrop.h"
#include "openltc/scene/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace openltc::scene {

namespace {

// Larger meshes are one part: to take them apart costs more than to load them.
constexpr std::size_t k_most_triangles_to_part = 1000000;
constexpr std::size_t k_most_backdrops = 64;
// A subject that fills less than a third of its ground is a speck in a picture of the ground.
constexpr double k_backdrop_ratio = 3;
// Light of a surface that glows for the eye alone ends at glTF's plain emissive factor.
constexpr float k_lamp_nits = 1;

/// Which share of the scene may go for which shrinking of it.
struct StrayRule {
  double share, ratio;
};
constexpr StrayRule k_stray_rules[] = {{0.005, 3}, {0.05, 10}, {0.25, 50}};

Bounds joined(const Bounds& a, const Bounds& b) {
  return {Vec3f(std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y),
                std::min(a.lower.z, b.lower.z)),
          Vec3f(std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y),
                std::max(a.upper.z, b.upper.z))};
}

struct Part {
  SubjectPart subject;
  Bounds bounds;
  double diagonal = 0;
  double area = 0;
  double weight = 0; // of 1 for the whole scene
  bool is_lamp = false;
};

Part measured(const Scene& scene, SubjectPart of) {
  Part part;
  part.subject = std::move(of);
  const Mesh& mesh = scene.meshes[part.subject.mesh];
  bool first = true;
  for (const std::uint32_t t : part.subject.triangles) {
    const auto& corner = mesh.triangles[t];
    for (const std::uint32_t i : corner) {
      const Bounds point{mesh.positions[i], mesh.positions[i]};
      part.bounds = first ? point : joined(part.bounds, point);
      first = false;
    }
    part.area += length(area_vector(mesh, t));
  }
  part.diagonal = diagonal(part.bounds);
  const Material& material = scene.materials[std::size_t(mesh.material)];
  part.is_lamp =
      material.emission_texture.texture < 0 &&
      std::max({material.emission.x, material.emission.y, material.emission.z}) > k_lamp_nits;
  return part;
}

std::vector<Part> parts_of(const Scene& scene) {
  std::vector<Part> parts;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    if (mesh.triangles.empty()) continue;
    std::vector<std::vector<std::uint32_t>> islands;
    if (mesh.triangles.size() <= k_most_triangles_to_part) {
      const WeldedMesh welded = weld(mesh, extent_of(mesh, 1e-6, 1e-6));
      islands = islands_of(welded);
      for (auto& island : islands)
        for (std::uint32_t& triangle : island)
          triangle = welded.source[triangle];
    }
    if (islands.empty()) { // large, or of no area
      islands.emplace_back(mesh.triangles.size());
      std::iota(islands[0].begin(), islands[0].end(), 0u);
    }
    for (auto& island : islands)
      parts.push_back(measured(scene, {std::uint32_t(m), std::move(island)}));
  }
  double area = 0, triangles = 0;
  for (const Part& part : parts) {
    area += part.area;
    triangles += double(part.subject.triangles.size());
  }
  for (Part& part : parts)
    part.weight = 0.5 * (area > 0 ? part.area / area : 0.0) +
                  0.5 * double(part.subject.triangles.size()) / triangles;
  return parts;
}

Bounds bounds_of(const std::vector<Part>& parts) {
  Bounds all;
  for (std::size_t i = 0; i < parts.size(); ++i)
    all = i == 0 ? parts[0].bounds : joined(all, parts[i].bounds);
  return all;
}

// Takes out the largest parts if all of them are backdrops to all others.
bool drop_backdrops(const Scene& scene, std::vector<Part>& parts) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.diagonal > b.diagonal; });
  std::vector<Bounds> rest(parts.size()); // of this part and all smaller ones
  for (std::size_t i = parts.size(); i-- > 0;)
    rest[i] = i + 1 == parts.size() ? parts[i].bounds : joined(parts[i].bounds, rest[i + 1]);
  for (std::size_t large = 1; large < std::min(parts.size(), k_most_backdrops); ++large) {
    if (parts[large - 1].diagonal < k_backdrop_ratio * diagonal(rest[large])) continue;
    const bool all =
        std::all_of(parts.begin(), parts.begin() + std::ptrdiff_t(large), [&](const Part& part) {
          return is_backdrop(scene, part.subject, rest[large]);
        });
    if (!all) continue;
    parts.erase(parts.begin(), parts.begin() + std::ptrdiff_t(large));
    return true;
  }
  return false;
}

// The box that all but `share` of the parts' weight reach, on each of its sides.
Bounds robust_bounds(const std::vector<Part>& parts, double share) {
  std::array<double, 6> side{};
  for (int s = 0; s < 6; ++s) {
    const int axis = s % 3;
    const bool is_upper = s >= 3;
    const auto component = [&](Vec3f v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    std::vector<std::pair<double, double>> ends; // from outside to inside
    double total = 0;
    for (const Part& part : parts) {
      ends.emplace_back(is_upper ? -double(component(part.bounds.upper))
                                 : double(component(part.bounds.lower)),
                        part.weight);
      total += part.weight;
    }
    std::sort(ends.begin(), ends.end());
    double dropped = 0;
    std::size_t i = 0;
    while (i + 1 < ends.size() && dropped + ends[i].second <= share * total)
      dropped += ends[i++].second;
    side[std::size_t(s)] = is_upper ? -ends[i].first : ends[i].first;
  }
  return {Vec3f(float(side[0]), float(side[1]), float(side[2])),
          Vec3f(float(side[3]), float(side[4]), float(side[5]))};
}

bool meet(const Bounds& a, const Bounds& b, float margin) {
  return a.lower.x - margin <= b.upper.x && b.lower.x - margin <= a.upper.x &&
         a.lower.y - margin <= b.upper.y && b.lower.y - margin <= a.upper.y &&
         a.lower.z - margin <= b.upper.z && b.lower.z - margin <= a.upper.z;
}

void drop_strays(std::vector<Part>& parts) {
  for (const StrayRule& rule : k_stray_rules) {
    const Bounds robust = robust_bounds(parts, rule.share);
    if (!(diagonal(bounds_of(parts)) > rule.ratio * diagonal(robust))) continue;
    std::vector<Part> kept;
    for (const Part& part : parts)
      if (meet(part.bounds, robust, float(0.25 * diagonal(robust)))) kept.push_back(part);
    if (kept.empty()) continue; // the sides of the box may be those of different parts
    parts = std::move(kept);
    return;
  }
}

// A lamp that hangs far above belongs into the picture only when there is nothing else.
void drop_lamps(std::vector<Part>& parts) {
  std::vector<Part> things;
  for (const Part& part : parts)
    if (!part.is_lamp) things.push_back(part);
  if (things.empty() || things.size() == parts.size()) return;
  const Bounds bounds = bounds_of(things);
  const float margin = float(0.1 * diagonal(bounds));
  for (const Part& part : parts)
    if (part.is_lamp && meet(part.bounds, bounds, margin)) things.push_back(part);
  parts = std::move(things);
}

} // namespace

double diagonal(const Bounds& b) { return length(to_double(b.upper) - to_double(b.lower)); }

Subject find_subject(const Scene& scene) {
  std::vector<Part> parts = parts_of(scene);
  Subject subject;
  if (parts.empty()) return subject;
  drop_strays(parts);
  while (parts.size() > 1 && drop_backdrops(scene, parts))
    subject.has_backdrop = true;
  if (subject.has_backdrop) drop_strays(parts); // what was small beside the ground
  drop_lamps(parts);
  subject.bounds = bounds_of(parts);
  for (Part& part : parts)
    subject.parts.push_back(std::move(part.subject));
  subject.flat_normal = common_normal(scene, subject.parts);
  return subject;
}

std::vector<Vec3f> points_of(const Scene& scene, const Subject& subject) {
  std::vector<std::vector<bool>> used(scene.meshes.size());
  std::vector<Vec3f> points;
  for (const SubjectPart& part : subject.parts) {
    const Mesh& mesh = scene.meshes[part.mesh];
    auto& of_mesh = used[part.mesh];
    of_mesh.resize(mesh.positions.size());
    for (const std::uint32_t triangle : part.triangles)
      for (const std::uint32_t i : mesh.triangles[triangle])
        if (!of_mesh[i]) {
          of_mesh[i] = true;
          points.push_back(mesh.positions[i]);
        }
  }
  return points;
}

} // namespace openltc::scene
