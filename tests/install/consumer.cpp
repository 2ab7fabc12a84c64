// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What an engine includes: a white matte floor under a square metre of 1 nit, a metre above it.

#include "openltc/openltc.h"

#include <cmath>
#include <cstdio>

int main() {
  const openltc::Polygon lamp = openltc::Polygon::rectangle({0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f});
  openltc::Material matte;
  matte.base_color = {1, 1, 1};
  matte.specular = 0; // KHR_materials_specular: then the surface is Lambert's
  const openltc::Surface floor =
      openltc::make_surface({0, 0, 0}, {0, 1, 0}, {1, 2, 3}, matte, openltc::built_in_table());
  const float nits = openltc::shade(floor, lamp, openltc::Vec3f(1.0f)).y;
  // The form factor of a rectangle parallel to an element below one of its corners, a by b at
  // distance c (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3), four
  // times.
  const double side = 0.5, slant = std::sqrt(1 + side * side);
  const double expected =
      4 * 2 * side / slant * std::atan(side / slant) / (2 * 3.14159265358979324);
  std::printf("%.6f nits, expected %.6f\n", double(nits), expected);
  return std::abs(double(nits) - expected) < 1e-6 ? 0 : 1;
}
