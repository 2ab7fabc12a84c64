// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The scene of vulkan.cpp: a warm quad and a cool star over a dark floor, as in scenes/engines.glb.
// Metres, +Y up.

#pragma once

#include "openltc/openltc.h"

#include <cmath>
#include <cstdint>
#include <vector>

using openltc::Vec3f;

constexpr std::uint32_t k_width = 960, k_height = 540;
const double k_degree = std::acos(-1.0) / 180;

/// The numbers of a uniform block: vectors of four.
struct Block {
  std::vector<float> numbers;

  void add(Vec3f v, float w = 0) { numbers.insert(numbers.end(), {v.x, v.y, v.z, w}); }
  /// A polygon for ltc_shade_polygon.
  void add(const openltc::PolygonView& polygon) {
    const std::vector<float> elements = openltc::polygon_elements(polygon);
    numbers.insert(numbers.end(), elements.begin(), elements.end());
  }
};

/// Ten points around a centre, counter-clockwise as seen from where half_u x half_v points to.
inline openltc::Polygon make_star(Vec3f center, Vec3f half_u, Vec3f half_v) {
  std::vector<Vec3f> points;
  for (int k = 0; k < 10; ++k) {
    const double angle = (90 + 36 * k) * k_degree, radius = k % 2 == 0 ? 1 : 0.45;
    points.push_back(center + half_u * float(radius * std::cos(angle)) +
                     half_v * float(radius * std::sin(angle)));
  }
  return openltc::Polygon::from_vertices(points);
}

/// Block `Scene` of scene.glsl.
inline Block make_scene() {
  const Vec3f eye(0, 1.8f, 6), target(0, 0.2f, 0);
  const Vec3f back = normalize(eye - target), right = normalize(cross(Vec3f(0, 1, 0), back));
  const float tangent = float(std::tan(17 * k_degree)); // 34 degrees of height
  Block scene;
  scene.add(Vec3f(float(k_width), float(k_height), 0));
  scene.add(eye);
  scene.add(right * tangent);
  scene.add(cross(back, right) * tangent);
  scene.add(back);
  scene.add(Vec3f(0.4f, 0.4f, 0.4f), 0.4f); // the floor: base colour, metallic
  scene.add(Vec3f(0.2f, 0, 0));             // roughness
  scene.add(Vec3f(-1.25f, 0.85f, -0.4f));   // the quad
  scene.add(Vec3f(0.6f, 0, -0.4f));
  scene.add(Vec3f(0.12f, 0.7f, 0.18f));
  scene.add(Vec3f(6, 2.1f, 0.5f)); // its radiance
  scene.add(Vec3f(0.7f, 2, 6));    // the star's
  scene.add(make_star({1.2f, 0.95f, -0.5f}, {0.85f, -0.15f, 0.3f}, {0.15f, 0.85f, 0}).view());
  return scene;
}
