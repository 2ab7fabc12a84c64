// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/emissive/round_parts.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/scene/emissive/recognise.h"

#include <algorithm>
#include <type_traits>
#include <variant>

namespace openltc::scene {

namespace {

// Moves a recognised light to where its mesh is.
void move_by(light::EllipseLight& light, Vec3d offset) {
  light.center = to_float(to_double(light.center) + offset);
}
void move_by(light::SphereLight& light, Vec3d offset) {
  light.center = to_float(to_double(light.center) + offset);
}
void move_by(light::TubeLight& light, Vec3d offset) {
  light.from = to_float(to_double(light.from) + offset);
  light.to = to_float(to_double(light.to) + offset);
}

std::vector<light::EllipseLight>& list_of(light::Lights& lights, const light::EllipseLight&) {
  return lights.ellipses;
}
std::vector<light::SphereLight>& list_of(light::Lights& lights, const light::SphereLight&) {
  return lights.spheres;
}
std::vector<light::TubeLight>& list_of(light::Lights& lights, const light::TubeLight&) {
  return lights.tubes;
}

// Adds `light` with its emission; false when it cannot be shaded.
bool add_recognised(std::monostate, const Extent&, Vec3f, const Mesh&, bool, light::Lights&) {
  return false;
}
template <class Light>
bool add_recognised(Light light, const Extent& extent, Vec3f radiance, const Mesh& mesh,
                    bool two_sided, light::Lights& lights) {
  if (!(radiance.x > 0) && !(radiance.y > 0) && !(radiance.z > 0)) return true; // by texture
  move_by(light, extent.center);
  light.name = mesh.name;
  light.radiance = radiance;
  light.two_sided = two_sided && std::is_same_v<Light, light::EllipseLight>;
  if (!light::validate(light).ok()) return false;
  list_of(lights, light).push_back(std::move(light));
  return true;
}

} // namespace

WeldedMesh take_round_parts(const WeldedMesh& welded, const Mesh& mesh, const Extent& extent,
                            bool two_sided, double tolerance, const SurfaceEmission& emission,
                            light::Lights& lights, bool& is_averaged) {
  std::vector<std::uint32_t> left;
  for (const auto& triangles : islands_of(welded)) {
    const Island island{welded, triangles, two_sided, tolerance};
    const RoundShape shape = recognise_shape(island, extent.plane);
    SurfaceEmission::Mean mean;
    if (shape.index() != 0) mean = emission.mean_over(patches_of(welded, triangles));
    // A flat light with a picture keeps it as a polygon.
    const bool is_pictured = !mean.is_uniform && std::holds_alternative<light::EllipseLight>(shape);
    const bool is_light =
        shape.index() != 0 && !is_pictured &&
        std::visit(
            [&](const auto& light) {
              return add_recognised(light, extent, mean.radiance, mesh, two_sided, lights);
            },
            shape);
    if (is_light) is_averaged = is_averaged || !mean.is_uniform;
    if (!is_light) left.insert(left.end(), triangles.begin(), triangles.end());
  }
  std::sort(left.begin(), left.end());
  return part_of(welded, left);
}

} // namespace openltc::scene
