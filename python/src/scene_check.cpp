// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/scene_check.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace openltc::python {

namespace {

constexpr float k_most = std::numeric_limits<float>::max();
constexpr float k_unit_error = 1e-3f;      // of a direction's length and of a right angle's cosine
constexpr float k_max_cosine_power = 1e6f; // narrower than a tenth of a degree

/// What is wrong first with the fields of one part.
class Fields {
public:
  explicit Fields(std::string part) : part_(std::move(part)) {}

  void number(const char* field, float x, float least, float most) {
    if (!(x >= least && x <= most))
      say(field, fmt::format("is {}, not within {:g} and {:g}", x, least, most));
  }
  void numbers(const char* field, Vec3f v, float least, float most) {
    for (const float x : {v.x, v.y, v.z})
      number(field, x, least, most);
  }
  void place(const char* field, Vec3f v) {
    numbers(field, v, -float(light::k_max_metres), float(light::k_max_metres));
  }
  void light_of(const char* field, Vec3f v) { numbers(field, v, 0, k_most); }
  void unit(const char* field, Vec3f v) {
    const float off = std::abs(length(v) - 1);
    if (!(off < k_unit_error)) say(field, "is not of length 1");
  }
  void right_angle(const char* field, Vec3f a, Vec3f b) {
    const float cosine = std::abs(dot(a, b));
    if (!(cosine < k_unit_error)) say(field, "are not at right angles");
  }
  void say(const char* field, const std::string& what) {
    if (status_) status_ = Error{fmt::format("{}: {} {}", part_, field, what)};
  }
  Status status() const { return status_; }

private:
  std::string part_;
  Status status_ = Success{};
};

void look(Fields& fields, const light::PolygonLight& polygon) {
  for (const Vec3f& vertex : polygon.vertices)
    fields.place("vertices", vertex);
  fields.unit("normal", polygon.normal);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : polygon.ring_end) {
    if (end < begin || end - begin < 3)
      fields.say("ring_ends", "part the vertices into rings of fewer than 3");
    begin = end;
  }
  if (begin != polygon.vertices.size() || begin == 0)
    fields.say("ring_ends", "do not end where the vertices do");
}

void look(Fields& fields, const light::EllipseLight& ellipse) {
  fields.place("center", ellipse.center);
  fields.place("half_u", ellipse.half_u);
  fields.place("half_v", ellipse.half_v);
}

void look(Fields& fields, const light::SphereLight& sphere) {
  fields.place("center", sphere.center);
  fields.number("radius_metres", sphere.radius, 0, float(light::k_max_metres));
}

void look(Fields& fields, const light::TubeLight& tube) {
  fields.place("start", tube.from);
  fields.place("end", tube.to);
  fields.number("radius_metres", tube.radius, 0, float(light::k_max_metres));
}

void look(Fields& fields, const light::LineLight& line) {
  fields.place("start", line.from);
  fields.place("end", line.to);
  fields.light_of("intensity_candela_per_metre", line.intensity_per_metre);
}

void look(Fields& fields, const light::PunctualLight& light) {
  fields.place("position", light.position);
  fields.light_of("intensity_candela_or_lux", light.intensity);
  fields.number("range_metres", light.range, 0, k_most);
  if (light.type != light::PunctualType::point || light.profile)
    fields.unit("direction", light.direction);
  fields.number("cos_inner", light.cos_inner, -1, 1);
  fields.number("cos_outer", light.cos_outer, -1, 1);
}

void look_at_emitter(Fields& fields, const light::Emitter& emitter) {
  fields.light_of("radiance_nits", emitter.radiance);
  fields.number("cosine_power", emitter.cosine_power, 0, k_max_cosine_power);
}

} // namespace

Status check_lights(const light::Lights& lights) {
  Status first = Success{};
  std::size_t i = 0;
  lights.for_each_area_light([&](const auto& light) {
    Fields fields(light.name.empty() ? fmt::format("lights, area light {}", i)
                                     : fmt::format("lights, \"{}\"", light.name));
    look_at_emitter(fields, light);
    look(fields, light);
    if (first) first = fields.status();
    ++i;
  });
  for (const light::PunctualLight& light : lights.punctual) {
    Fields fields(light.name.empty() ? "lights, a light without extent"
                                     : fmt::format("lights, \"{}\"", light.name));
    look(fields, light);
    if (first) first = fields.status();
  }
  return first;
}

Status check_materials(const std::vector<scene::Material>& materials) {
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const scene::Material& m = materials[i];
    Fields fields(fmt::format("materials[{}], \"{}\"", i, m.name));
    const Vec4f c = m.base_color;
    for (const float x : {c.x, c.y, c.z, c.w})
      fields.number("base_color", x, 0, 1);
    fields.number("metallic", m.metallic, 0, 1);
    fields.number("roughness", m.roughness, 0, 1);
    fields.number("normal_scale", m.normal_scale, -k_most, k_most);
    fields.light_of("emission_nits", m.emission);
    fields.number("specular", m.specular, 0, 1);
    fields.numbers("specular_color", m.specular_color, 0, k_most);
    fields.number("ior", m.ior, 0, k_most);
    fields.number("alpha_cutoff", m.alpha_cutoff, -k_most, k_most);
    if (Status status = fields.status(); !status) return status;
  }
  return Success{};
}

Status check_camera(const scene::Camera& camera) {
  Fields fields("camera");
  fields.place("position", camera.position);
  fields.unit("right", camera.right);
  fields.unit("up", camera.up);
  fields.unit("forward", camera.forward);
  fields.right_angle("right and up", camera.right, camera.up);
  fields.right_angle("up and forward", camera.up, camera.forward);
  fields.right_angle("right and forward", camera.right, camera.forward);
  if (camera.projection == scene::Projection::perspective)
    fields.number("fov_y_rad", camera.fov_y_rad, 1e-4f, 3.14f);
  else
    fields.number("height_metres", camera.height, 1e-6f, float(light::k_max_metres));
  fields.number("aspect", camera.aspect, 0, 1e6f);
  fields.number("near_metres", camera.near, 0, float(light::k_max_metres));
  fields.number("far_metres", camera.far, 0, k_most);
  if (camera.far > 0 && camera.far <= camera.near)
    fields.say("far_metres", "is not beyond near_metres");
  return fields.status();
}

} // namespace openltc::python
