// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Cameras: glTF 2.0 specification, section 3.10.

#include "openltc/scene/gltf/camera.h"

#include "openltc/light/light.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/name.h"
#include "openltc/scene/gltf/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene::gltf {

namespace {

// Half the width or height of an orthographic view.
void check_mag(double metres, const std::string& field) {
  if (!(std::abs(metres) >= 1e-12) || !(std::abs(metres) <= light::k_max_metres))
    fail(field, fmt::format("{} is not between 1e-12 and {:g} m", metres, light::k_max_metres));
}

float near_plane(double metres, const std::string& field) {
  if (!(metres <= light::k_max_metres))
    fail(field,
         fmt::format("{} is more than {:g} m: nothing would be seen", metres, light::k_max_metres));
  return float(std::max(metres, 0.0));
}

// 0 = infinite, as is what no scene reaches.
float far_plane(double metres) {
  return metres <= 10 * light::k_max_metres ? float(std::max(metres, 0.0)) : 0.0f;
}

} // namespace

Camera read_camera(Document& document, int index, const Transform& to_world,
                   const std::string& node_name) {
  const tinygltf::Camera& from = document.model->cameras[std::size_t(index)];
  const std::string field = fmt::format("cameras[{}]", index);
  Camera to;
  to.name = first_name_of(node_name, from.name, field);
  const Placement placement = placement_of(to_world, field, document);
  to.position = to_float(placement.position);
  to.right = to_float(placement.right);
  to.up = to_float(placement.up);
  to.forward = to_float(-placement.back);
  if (from.type == "orthographic") {
    const auto& ortho = from.orthographic;
    to.projection = Projection::orthographic;
    check_mag(ortho.xmag, field + ".orthographic.xmag");
    check_mag(ortho.ymag, field + ".orthographic.ymag");
    to.height = float(2 * std::abs(ortho.ymag));
    to.aspect = float(std::abs(ortho.xmag / ortho.ymag));
    to.near = near_plane(ortho.znear, field + ".orthographic.znear");
    to.far = far_plane(ortho.zfar);
    if (!(ortho.zfar > ortho.znear))
      fail(field + ".orthographic.zfar", "must be greater than znear");
  } else {
    const auto& perspective = from.perspective;
    if (!(perspective.yfov > 0) || !(perspective.yfov < std::numbers::pi))
      fail(field + ".perspective.yfov",
           fmt::format("{} is not an angle between 0 and pi", perspective.yfov));
    // In single precision pi / 2 is more than a right angle, whose tangent is negative.
    to.fov_y_rad = float(std::min(perspective.yfov, 3.1415));
    to.aspect = float(std::max(perspective.aspectRatio, 0.0));
    to.near = near_plane(perspective.znear, field + ".perspective.znear");
    to.far = far_plane(perspective.zfar);
    if (to.far != 0 && to.far <= to.near)
      fail(field + ".perspective.zfar", "must be greater than znear");
  }
  return to;
}

} // namespace openltc::scene::gltf
