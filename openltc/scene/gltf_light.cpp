// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// KHR_lights_punctual; EXT_lights_area (draft); cameras: glTF 2.0 specification, section 3.10.

#include "openltc/scene/gltf_light.h"

#include "openltc/light/polygon.h"
#include "openltc/light/shapes.h"
#include "openltc/scene/gltf_document.h"
#include "openltc/scene/gltf_failure.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene::gltf {

namespace {

constexpr double k_pi = std::numbers::pi;

Vec3f to_float(Vec3d v) { return {float(v.x), float(v.y), float(v.z)}; }

struct Frame {
  Vec3d right, up, back; // orthonormal, x y z of the node
};

// The node's rotation, without scale, shear or mirroring.
Frame rotation_of(const Transform& to_world, const std::string& what, Document& document) {
  const Vec3d back = to_world.column[2];
  const Vec3d up_hint = to_world.column[1];
  const double back_length = length(back);
  Vec3d right = cross(up_hint, back);
  const double right_length = length(right);
  if (!(back_length > 0) || !(right_length > 0) || !std::isfinite(right_length)) {
    document.warnings.add(
        fmt::format("{}: its node is scaled to nothing, so that it has no direction; it is "
                    "taken as not rotated",
                    what));
    return {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  }
  right = right / right_length;
  const Vec3d unit_back = back / back_length;
  return {right, cross(unit_back, right), unit_back};
}

Vec3f position_of(const Transform& to_world, const std::string& what) {
  const Vec3f position = to_float(to_world.column[3]);
  if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
    fail(what, "its node lies outside the range of numbers; export the file again");
  return position;
}

std::string first_of(const std::string& a, const std::string& b, const std::string& c) {
  return !a.empty() ? a : !b.empty() ? b : c;
}

double not_negative(double value, const std::string& field, Document& document) {
  if (value >= 0) return value;
  document.warnings.add(fmt::format("{}: {} is negative; 0 is used", field, value));
  return 0;
}

double member(const tinygltf::Value& object, const char* name, double otherwise) {
  return object.Has(name) ? object.Get(name).GetNumberAsDouble() : otherwise;
}

} // namespace

light::PunctualLight read_punctual_light(Document& document, int index, const Transform& to_world,
                                         const std::string& node_name) {
  const tinygltf::Light& from = document.model->lights[std::size_t(index)];
  const std::string field = fmt::format("extensions.KHR_lights_punctual.lights[{}]", index);
  light::PunctualLight to;
  to.name = first_of(node_name, from.name, field);
  to.type = from.type == "spot"          ? light::PunctualType::spot
            : from.type == "directional" ? light::PunctualType::directional
                                         : light::PunctualType::point;
  to.position = position_of(to_world, field);
  if (to.type != light::PunctualType::point)
    to.direction = to_float(-rotation_of(to_world, field, document).back);
  const double intensity = not_negative(from.intensity, field + ".intensity", document);
  double color[3] = {1, 1, 1};
  for (std::size_t c = 0; c < 3 && c < from.color.size(); ++c)
    color[c] = not_negative(from.color[c], field + ".color", document);
  to.intensity = Vec3f(float(std::min(color[0] * intensity, 1e30)),
                       float(std::min(color[1] * intensity, 1e30)),
                       float(std::min(color[2] * intensity, 1e30)));
  to.range = float(not_negative(from.range, field + ".range", document));
  if (to.type == light::PunctualType::spot) {
    double inner = from.spot.innerConeAngle, outer = from.spot.outerConeAngle;
    if (!(outer > 0) || outer > k_pi / 2 || inner < 0 || inner > outer) {
      document.warnings.add(
          fmt::format("{}.spot: the cone angles {} and {} are not 0 <= inner <= outer <= "
                      "pi/2; the nearest usable ones are used",
                      field, inner, outer));
      outer = std::clamp(outer, 1e-3, k_pi / 2);
      inner = std::clamp(inner, 0.0, outer);
    }
    to.cos_inner = float(std::cos(inner));
    to.cos_outer = float(std::cos(outer));
  }
  return to;
}

light::PolygonLight read_area_light(Document& document, int index, const Transform& to_world,
                                    const std::string& node_name) {
  const std::string field = fmt::format("extensions.EXT_lights_area.lights[{}]", index);
  const tinygltf::Value& from =
      document.model->extensions.at("EXT_lights_area").Get("lights").Get(index);
  const double size = member(from, "size", 1);
  if (!(size > 0)) fail(field + ".size", fmt::format("{} must be greater than 0", size));
  const double intensity = member(from, "intensity", 1000);
  if (!(intensity >= 0))
    fail(field + ".intensity", fmt::format("{} must not be negative", intensity));
  double color[3] = {1, 1, 1};
  if (from.Has("color"))
    for (int c = 0; c < 3; ++c)
      color[c] =
          not_negative(from.Get("color").Get(c).GetNumberAsDouble(), field + ".color", document);
  const Vec3f radiance(float(std::min(color[0] * intensity, 1e30)),
                       float(std::min(color[1] * intensity, 1e30)),
                       float(std::min(color[2] * intensity, 1e30)));

  // Scaled by the largest component of the world scale; emits along -Z, so that its own right-hand
  // frame has x turned over.
  const double scale = std::max(
      {length(to_world.column[0]), length(to_world.column[1]), length(to_world.column[2])});
  const Frame frame = rotation_of(to_world, field, document);
  const Vec3f center = position_of(to_world, field);
  const std::string type = from.Get("type").Get<std::string>();
  light::PolygonLight to;
  if (type == "rect") {
    const double aspect = from.Has("rect") ? member(from.Get("rect"), "aspect", 1) : 1;
    if (!(aspect > 0))
      fail(field + ".rect.aspect", fmt::format("{} must be greater than 0", aspect));
    const double half_height = 0.5 * size * scale;
    to = light::rectangle(center, to_float(-frame.right * (half_height * aspect)),
                          to_float(frame.up * half_height), radiance);
  } else {
    to = light::disk(center, to_float(-frame.right), to_float(frame.up), float(0.5 * size * scale),
                     radiance);
  }
  const std::string own_name = from.Has("name") ? from.Get("name").Get<std::string>() : "";
  to.name = first_of(node_name, own_name, field);
  to.normal = to_float(-frame.back);
  if (const Status status = light::validate(to); !status.ok())
    fail(field + ".size", fmt::format("it gives no usable light ({}); check its node's scale",
                                      status.error().message));
  return to;
}

Camera read_camera(Document& document, int index, const Transform& to_world,
                   const std::string& node_name) {
  const tinygltf::Camera& from = document.model->cameras[std::size_t(index)];
  const std::string field = fmt::format("cameras[{}]", index);
  Camera to;
  to.name = first_of(node_name, from.name, field);
  to.position = position_of(to_world, field);
  const Frame frame = rotation_of(to_world, field, document);
  to.right = to_float(frame.right);
  to.up = to_float(frame.up);
  to.forward = to_float(-frame.back);
  if (from.type == "orthographic") {
    const auto& ortho = from.orthographic;
    to.projection = Projection::orthographic;
    if (ortho.xmag == 0 || ortho.ymag == 0)
      fail(field + ".orthographic", "xmag and ymag must not be 0");
    to.height = float(2 * std::abs(ortho.ymag));
    to.aspect = float(std::abs(ortho.xmag / ortho.ymag));
    to.near = float(std::max(ortho.znear, 0.0));
    to.far = float(ortho.zfar);
    if (!(ortho.zfar > ortho.znear))
      fail(field + ".orthographic.zfar", "must be greater than znear");
  } else {
    const auto& perspective = from.perspective;
    if (!(perspective.yfov > 0) || !(perspective.yfov < k_pi))
      fail(field + ".perspective.yfov",
           fmt::format("{} is not an angle between 0 and pi", perspective.yfov));
    to.fov_y_rad = float(perspective.yfov);
    to.aspect = float(std::max(perspective.aspectRatio, 0.0));
    to.near = float(std::max(perspective.znear, 0.0));
    to.far = float(std::max(perspective.zfar, 0.0));
    if (to.far != 0 && to.far <= to.near)
      fail(field + ".perspective.zfar", "must be greater than znear");
  }
  return to;
}

} // namespace openltc::scene::gltf
