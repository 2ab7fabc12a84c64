// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#pragma once

namespace openltc::fit {

/// What becomes of the part of a lobe below the surface's horizon.
enum class Horizon {
  leaking, ///< it is lost, or shines through the surface: D as it is. What engines do
  clipped  ///< shading divides by the share above, but by no less than k_min_share, as
           ///< shade/surface.glsl does: D / (1 - leak)
};

/// "leaking" or "clipped", as in a table's metadata.
constexpr const char* name_of(Horizon horizon) {
  return horizon == Horizon::clipped ? "clipped" : "leaking";
}

} // namespace openltc::fit
