// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Triangles of one plane that lie on top of each other. The camera sees one of them, so their light
// counts once: what counts is the union.

#pragma once

#include "openltc/scene/emissive/outline.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace openltc::scene {

/// Whether the inside of `rings`, from trace_outline with the same normal and tolerance (metres),
/// covers a place more than once. True as well when telling takes too long.
bool covers_twice(std::span<const Ring> rings, Vec3d normal, double tolerance);

/// Triangles that cover each place of a plane once.
struct Cover {
  std::vector<Vec3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise about the normal
  std::vector<std::uint32_t> of; ///< the triangle of the input that each is a part of
  bool is_complete = true;       ///< false when it took too long; the rest is then empty
};

/// What `triangles`, of one plane and counter-clockwise about `normal`, cover together, each place
/// once; slivers thinner than `tolerance` are left out. Larger triangles lie on top.
Cover cover_once(std::span<const Vec3d> points,
                 std::span<const std::array<std::uint32_t, 3>> triangles, Vec3d normal,
                 double tolerance);

} // namespace openltc::scene
