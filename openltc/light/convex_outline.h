// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Whether an outline is convex, so that no plane through a point cuts it more than twice.

#pragma once

#include "openltc/target/vec.h"

#include <cstddef>
#include <functional>
#include <span>

namespace openltc::light {

/// Whether `points` (plane coordinates), rings one after the other, each closed by repeating its
/// first point, are a single ring that turns counter-clockwise all the way and once around. Corners
/// that lie on a straight side are allowed.
bool is_convex_outline(std::span<const Vec2d> points,
                       const std::function<bool(std::size_t)>& starts_ring);

} // namespace openltc::light
