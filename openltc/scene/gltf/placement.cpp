// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/placement.h"

#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::scene::gltf {

Placement placement_of(const Transform& to_world, const std::string& what, Document& document) {
  Placement placement;
  placement.position = to_world.column[3];
  const Vec3f p = to_float(placement.position);
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    fail(what, "its node lies outside the range of numbers; export the file again");
  const auto* column = to_world.column;
  placement.scale = std::max({length(column[0]), length(column[1]), length(column[2])});

  const double back_length = length(column[2]);
  const Vec3d right = cross(column[1], column[2]);
  const double right_length = length(right);
  if (!(back_length > 0) || !(right_length > 0) || !std::isfinite(right_length)) {
    document.warnings.add(
        fmt::format("{}: its node is scaled to nothing, so that it has no direction; it is "
                    "taken as not rotated",
                    what));
    return placement;
  }
  placement.right = right / right_length;
  placement.back = column[2] / back_length;
  placement.up = cross(placement.back, placement.right);
  return placement;
}

} // namespace openltc::scene::gltf
