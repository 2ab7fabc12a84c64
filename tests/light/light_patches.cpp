// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/light/light_patches.h"

#include <cmath>
#include <numbers>

namespace openltc::light::test {

namespace {

constexpr double k_pi = std::numbers::pi;

// A sphere's upper part, z >= z0, about `axis`: rings of equal area.
void add_cap(Patches& patches, Vec3d axis, double radius, double z0) {
  const Vec3d u = normalize(cross(axis, Vec3d(0.3, -0.5, 0.8))), v = cross(axis, u);
  constexpr int rings = 400, sectors = 400;
  const double each = 2 * k_pi * radius * radius * (1 - z0) / (rings * sectors);
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < sectors; ++i) {
      const double z = z0 + (1 - z0) * (j + 0.5) / rings, s = std::sqrt(1 - z * z);
      const double phi = 2 * k_pi * (i + 0.5) / sectors;
      patches.push_back({u * (s * std::cos(phi)) + v * (s * std::sin(phi)) + axis * z, each});
    }
}

} // namespace

Patches patches_of(const SphereLight& light) {
  Patches patches;
  add_cap(patches, {0, 0, 1}, double(light.radius), -1);
  return patches;
}

Patches patches_of(const EllipseLight& light) {
  // Squares of a fine grid over the square around the ellipse, those whose middle is inside.
  const Vec3d n = cross(to_double(light.half_u), to_double(light.half_v));
  constexpr int cells = 1000;
  Patches patches;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const double x = 2 * (i + 0.5) / cells - 1, y = 2 * (j + 0.5) / cells - 1;
      if (x * x + y * y <= 1) patches.push_back({normalize(n), 4 * length(n) / (cells * cells)});
    }
  return patches;
}

Patches patches_of(const TubeLight& light) {
  const Vec3d along = to_double(light.to) - to_double(light.from), axis = normalize(along);
  const Vec3d u = normalize(cross(axis, Vec3d(0.3, -0.5, 0.8))), v = cross(axis, u);
  const double r = double(light.radius);
  Patches patches;
  constexpr int sectors = 20000;
  for (int i = 0; i < sectors; ++i) {
    const double phi = 2 * k_pi * (i + 0.5) / sectors;
    patches.push_back(
        {u * std::cos(phi) + v * std::sin(phi), 2 * k_pi * r / sectors * length(along)});
  }
  for (const double side : {-1.0, 1.0}) {
    if (light.caps == TubeCaps::flat) patches.push_back({axis * side, k_pi * r * r});
    if (light.caps == TubeCaps::round) add_cap(patches, axis * side, r, 0);
  }
  return patches;
}

PolygonLight bent_polygon() {
  PolygonLight light;
  light.vertices = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
  light.ring_end = {6};
  return light;
}

Patches patches_of(const PolygonLight& light) { return Patches(3, {to_double(light.normal), 1}); }

// A square metre's emission over the hemisphere, ring by ring.
double summed_flux(const Patches& patches, double power) {
  constexpr int rings = 4000;
  double per_area = 0, area = 0;
  for (int i = 0; i < rings; ++i) {
    const double c = (i + 0.5) / rings;
    per_area += std::pow(c, power) * c * 2 * k_pi / rings;
  }
  for (const Patch& patch : patches)
    area += patch.area;
  return area * per_area;
}

double summed_intensity(const Patches& patches, double power, Vec3d direction) {
  double sum = 0;
  for (const Patch& patch : patches) {
    const double c = dot(patch.normal, direction);
    if (c > 0) sum += patch.area * std::pow(c, power + 1);
  }
  return sum;
}

} // namespace openltc::light::test
