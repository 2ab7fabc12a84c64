// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Whether an outline drawn by hand bounds an area.

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/vec.h"

#include <span>
#include <vector>

namespace openltc::scene {

/// Half the sum of cross products: positive when counter-clockwise.
double signed_area(std::span<const Vec2d> ring);

/// Whether `ring` has three points or more, none twice, and no two of its edges cross or touch. The
/// error says which; edge i goes from point i to the next.
Status check_simple(std::span<const Vec2d> ring);

/// Whether `hole` lies inside `outer`, both simple, without crossing or touching it.
Status check_inside(std::span<const Vec2d> hole, std::span<const Vec2d> outer);

/// The same for two holes: neither crosses, touches or holds the other.
Status check_apart(std::span<const Vec2d> a, std::span<const Vec2d> b);

} // namespace openltc::scene
