// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Where the origin of a scene's single-precision coordinates lies.

#pragma once

#include "openltc/target/vec.h"

#include <vector>

namespace openltc::scene {

/// Collects what a scene holds, in the file's coordinates, and finds its middle. Most of the scene
/// decides: a stray object far away does not draw the origin to itself.
class OriginFinder {
public:
  /// A box of `weight` > 0, e.g. its number of triangles.
  void add(Vec3d lower, Vec3d upper, double weight);

  /// Zero where the scene lies about the file's origin, else a point near its middle, whose
  /// coordinates are multiples of a power of two not smaller than 16 times the scene's radius. So
  /// coordinates are at most about 9 radii, and a scene moved by such multiples has the same ones,
  /// to the last bit.
  Vec3d origin() const;

private:
  struct Box {
    Vec3d center, half;
    double weight;
  };
  std::vector<Box> boxes_;
};

} // namespace openltc::scene
