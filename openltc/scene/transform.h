// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Affine transforms of the node hierarchy, in double precision.

#pragma once

#include "openltc/target/vec.h"

#include <array>
#include <cmath>

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

inline Transform translation(Vec3d by) {
  Transform result;
  result.column[3] = by;
  return result;
}

/// First the scale, then the rotation by the quaternion (x, y, z, w) of any length, then the
/// translation. A quaternion without a length does not rotate, and `has_rotation` becomes false.
inline Transform transform_of(Vec3d translated, const std::array<double, 4>& rotation, Vec3d scale,
                              bool& has_rotation) {
  Transform t;
  double l = 0;
  for (const double c : rotation)
    l = std::hypot(l, c);
  has_rotation = l > 0 && std::isfinite(l);
  if (has_rotation) {
    const double x = rotation[0] / l, y = rotation[1] / l, z = rotation[2] / l, w = rotation[3] / l;
    t.column[0] = Vec3d(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y));
    t.column[1] = Vec3d(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x));
    t.column[2] = Vec3d(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
  }
  t.column[0] = t.column[0] * scale.x;
  t.column[1] = t.column[1] * scale.y;
  t.column[2] = t.column[2] * scale.z;
  t.column[3] = translated;
  return t;
}

} // namespace openltc::scene
