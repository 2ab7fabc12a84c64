// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a picture of a scene is of: the scene without its ground, its sky, its far walls, its lamps
// out of the way and its strays.

#pragma once

#include "openltc/scene/scene.h"

#include <cstdint>
#include <vector>

namespace openltc::scene {

/// Triangles of one mesh that hang together.
struct SubjectPart {
  std::uint32_t mesh = 0;               ///< index into Scene::meshes
  std::vector<std::uint32_t> triangles; ///< indices into Mesh::triangles
};

struct Subject {
  std::vector<SubjectPart> parts; ///< empty only where the scene has no triangle
  Bounds bounds;                  ///< of the parts
  /// Whether something larger was left out: a camera that shows the subject then stands within the
  /// scene, and has ground or walls around it.
  bool has_backdrop = false;
  /// Unit normal of a subject that is flat, a card or a relief: most of its area faces along it, to
  /// one side or the other. (0, 0, 0) where it is not.
  Vec3d flat_normal{0, 0, 0};
};

/// Length of the box's diagonal, metres.
double diagonal(const Bounds& bounds);

/// Parts are left out when they are
/// - backdrops: three times as large as all that is smaller, and either thin, like a ground or a
///   wall, with the rest standing out of it, or all around the rest, like a sky or a room;
/// - strays: hardly any area or triangles, but without them the scene is a fraction as large;
/// - lamps (surfaces without a texture that emit more than 1 nit) beside what they light.
/// Something always remains.
Subject find_subject(const Scene& scene);

/// The vertices of the subject, each once.
std::vector<Vec3f> points_of(const Scene& scene, const Subject& subject);

} // namespace openltc::scene
