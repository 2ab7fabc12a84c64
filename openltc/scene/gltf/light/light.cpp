// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// KHR_lights_punctual; EXT_lights_area (draft).

#include "openltc/scene/gltf/light/light.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/light/shapes.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/name.h"
#include "openltc/scene/gltf/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::scene::gltf {

namespace {

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
  to.name = first_name_of(node_name, from.name, field);
  to.type = from.type == "spot"          ? light::PunctualType::spot
            : from.type == "directional" ? light::PunctualType::directional
                                         : light::PunctualType::point;
  const Placement placement = placement_of(to_world, field, document);
  if (to.type != light::PunctualType::directional) to.position = to_float(placement.position);
  if (to.type != light::PunctualType::point) to.direction = to_float(-placement.back);
  const double intensity = not_negative(from.intensity, field + ".intensity", document);
  double color[3] = {1, 1, 1};
  for (std::size_t c = 0; c < 3 && c < from.color.size(); ++c)
    color[c] = not_negative(from.color[c], field + ".color", document);
  to.intensity = Vec3f(float(std::min(color[0] * intensity, 1e30)),
                       float(std::min(color[1] * intensity, 1e30)),
                       float(std::min(color[2] * intensity, 1e30)));
  // Nothing is further away than this.
  to.range = float(
      std::min(not_negative(from.range, field + ".range", document), 1e2 * light::k_max_metres));
  if (to.type == light::PunctualType::spot) {
    double inner = from.spot.innerConeAngle, outer = from.spot.outerConeAngle;
    if (!(outer > 0) || outer > std::numbers::pi / 2 || inner < 0 || inner > outer) {
      document.warnings.add(
          fmt::format("{}.spot: the cone angles {} and {} are not 0 <= inner <= outer <= "
                      "pi/2; the nearest usable ones are used",
                      field, inner, outer));
      outer = std::clamp(outer, 1e-3, std::numbers::pi / 2);
      inner = std::clamp(inner, 0.0, outer);
    }
    to.cos_inner = float(std::cos(inner));
    to.cos_outer = float(std::cos(outer));
  }
  return to;
}

void read_area_light(Document& document, int index, const Transform& to_world,
                     const std::string& node_name, double surface_deviation,
                     light::Lights& lights) {
  const std::string field = fmt::format("extensions.EXT_lights_area.lights[{}]", index);
  const auto leave_out = [&](const std::string& member_name, const std::string& what) {
    document.warnings.add(
        fmt::format("{}.{}: {}; the light is left out", field, member_name, what));
  };
  const tinygltf::Value& from =
      document.model->extensions.at("EXT_lights_area").Get("lights").Get(index);
  const double size = member(from, "size", 1);
  if (!(size > 0)) return leave_out("size", fmt::format("{} must be greater than 0", size));
  if (size > light::k_max_metres)
    return leave_out("size", fmt::format("{} is more than {:g} m", size, light::k_max_metres));
  const double intensity = member(from, "intensity", 1000);
  if (!(intensity >= 0))
    return leave_out("intensity", fmt::format("{} must not be negative", intensity));
  const bool is_rect = from.Get("type").Get<std::string>() == "rect";
  const double aspect = is_rect && from.Has("rect") ? member(from.Get("rect"), "aspect", 1) : 1;
  if (!(aspect > 0))
    return leave_out("rect.aspect", fmt::format("{} must be greater than 0", aspect));
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
  const Placement placement = placement_of(to_world, field, document);
  const Vec3f center = to_float(placement.position);
  const double half = 0.5 * size * placement.scale;
  const Vec3f half_x = to_float(-placement.right * (half * aspect));
  const Vec3f half_y = to_float(placement.up * half);
  const std::string own_name = from.Has("name") ? from.Get("name").Get<std::string>() : "";
  const auto finish = [&](auto light, auto& list) {
    light.name = first_name_of(node_name, own_name, field);
    light.surface_deviation = float(surface_deviation);
    if (const Status status = light::validate(light); !status.ok())
      return leave_out("size", fmt::format("it gives no usable light ({}); check its node's scale",
                                           status.error().message));
    list.push_back(std::move(light));
  };
  if (is_rect) {
    light::PolygonLight rectangle = light::rectangle(center, half_x, half_y, radiance);
    rectangle.normal = to_float(-placement.back);
    finish(std::move(rectangle), lights.polygons);
  } else {
    finish(light::ellipse(center, half_x, half_y, radiance), lights.ellipses);
  }
}

} // namespace openltc::scene::gltf
