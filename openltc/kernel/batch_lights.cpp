// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/kernel/batch_lights.h"

#include <cmath>

namespace openltc {

namespace {

constexpr float k_brightest = 1e20f;

bool is_light(Vec3f v) {
  const auto counts = [](float x) { return x >= 0 && x <= k_brightest; };
  return counts(v.x) && counts(v.y) && counts(v.z);
}

void store3(float* out, Vec3f v) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

kernel::AreaLightView area_light(kernel::LightShape shape, Vec3f radiance) {
  kernel::AreaLightView view;
  view.shape = shape;
  store3(view.radiance, radiance);
  return view;
}

kernel::PunctualLightView directed(Vec3f direction) {
  kernel::PunctualLightView view;
  store3(view.direction, direction);
  return view;
}

} // namespace

BatchLights::BatchLights() : packed_(std::make_unique<Packed>()) {}
BatchLights::~BatchLights() = default;

// What was moved from is empty and may be used again.
BatchLights::BatchLights(BatchLights&& other) noexcept : packed_(std::make_unique<Packed>()) {
  packed_.swap(other.packed_);
}
BatchLights& BatchLights::operator=(BatchLights&& other) noexcept {
  packed_.swap(other.packed_);
  return *this;
}

std::size_t BatchLights::size() const {
  return packed_->area_lights.size() + packed_->punctual.size();
}
void BatchLights::clear() { *packed_ = Packed(); }

bool BatchLights::add(const Polygon& light, Vec3f radiance) {
  if (!light.usable() || !is_light(radiance)) return false;
  packed_->polygons.push_back(light);
  kernel::AreaLightView view = area_light(kernel::LightShape::polygon, radiance);
  view.polygon = packed_->polygons.back().view();
  packed_->area_lights.push_back(view);
  return true;
}

bool BatchLights::add(const Ellipse& light, Vec3f radiance) {
  if (!detail::is_usable(light) || !is_light(radiance)) return false;
  kernel::AreaLightView view = area_light(kernel::LightShape::ellipse, radiance);
  store3(view.center, light.center);
  store3(view.half_u, light.half_u);
  store3(view.half_v, light.half_v);
  view.two_sided = light.two_sided;
  packed_->area_lights.push_back(view);
  return true;
}

bool BatchLights::add(const Sphere& light, Vec3f radiance) {
  if (!detail::is_usable(light) || !is_light(radiance)) return false;
  kernel::AreaLightView view = area_light(kernel::LightShape::sphere, radiance);
  store3(view.center, light.center);
  view.radius = light.radius;
  packed_->area_lights.push_back(view);
  return true;
}

bool BatchLights::add(const Tube& light, Vec3f radiance) {
  if (!detail::is_usable(light) || !is_light(radiance)) return false;
  const f32::Tube tube = detail::dialect_of(light);
  kernel::AreaLightView view = area_light(kernel::LightShape::tube, radiance);
  store3(view.from, tube.from);
  store3(view.to, tube.to);
  view.radius = tube.radius;
  view.caps = tube.caps;
  packed_->area_lights.push_back(view);
  return true;
}

bool BatchLights::add(const Line& light, Vec3f intensity_per_metre) {
  if (!detail::is_usable(light) || !is_light(intensity_per_metre)) return false;
  kernel::AreaLightView view = area_light(kernel::LightShape::line, intensity_per_metre);
  store3(view.from, light.from);
  store3(view.to, light.to);
  packed_->area_lights.push_back(view);
  return true;
}

bool BatchLights::add(const PointLight& light) {
  if (!detail::is_place(light.position) || !is_light(light.intensity)) return false;
  kernel::PunctualLightView view;
  store3(view.position, light.position);
  store3(view.intensity, light.intensity);
  view.range = light.range > 0 ? light.range : 0;
  packed_->punctual.push_back(view);
  return true;
}

bool BatchLights::add(const SpotLight& light) {
  const Vec3f axis = detail::unit_or(light.direction, Vec3f(0.0f));
  const float cos_inner = std::cos(light.inner_angle), cos_outer = std::cos(light.outer_angle);
  if (!detail::is_place(light.position) || !is_light(light.intensity) ||
      !(dot(axis, axis) > 0.5f) || !std::isfinite(cos_inner) || !std::isfinite(cos_outer))
    return false;
  kernel::PunctualLightView view = directed(axis);
  store3(view.position, light.position);
  store3(view.intensity, light.intensity);
  view.range = light.range > 0 ? light.range : 0;
  view.spot = true;
  view.cos_inner = cos_inner;
  view.cos_outer = cos_outer;
  packed_->punctual.push_back(view);
  return true;
}

bool BatchLights::add(const DirectionalLight& light) {
  const Vec3f axis = detail::unit_or(light.direction, Vec3f(0.0f));
  if (!is_light(light.illuminance) || !(dot(axis, axis) > 0.5f)) return false;
  kernel::PunctualLightView view = directed(axis);
  store3(view.intensity, light.illuminance);
  view.directional = true;
  packed_->punctual.push_back(view);
  return true;
}

} // namespace openltc
