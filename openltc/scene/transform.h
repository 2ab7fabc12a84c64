// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Affine transforms of the node hierarchy, in double precision.

#pragma once

#include "openltc/target/vec.h"

namespace openltc::scene {

/// x_world = column[0] x + column[1] y + column[2] z + column[3].
struct Transform {
  Vec3d column[4] = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1), Vec3d(0, 0, 0)};

  Vec3d direction(Vec3d v) const { return column[0] * v.x + column[1] * v.y + column[2] * v.z; }
  Vec3d point(Vec3d v) const { return direction(v) + column[3]; }
  double determinant() const { return dot(column[0], cross(column[1], column[2])); }

  /// Directions perpendicular to surfaces: the inverse transpose times the determinant, which also
  /// exists for a flattening transform. Turn the result over where the determinant is negative.
  Vec3d normal(Vec3d n) const {
    return cross(column[1], column[2]) * n.x + cross(column[2], column[0]) * n.y +
           cross(column[0], column[1]) * n.z;
  }
};

/// First `inner`, then `outer`.
inline Transform compose(const Transform& outer, const Transform& inner) {
  Transform result;
  for (int c = 0; c < 3; ++c)
    result.column[c] = outer.direction(inner.column[c]);
  result.column[3] = outer.point(inner.column[3]);
  return result;
}

} // namespace openltc::scene
