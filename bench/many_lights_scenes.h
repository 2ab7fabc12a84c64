// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Scenes of any number of polygon lights, made in code. The geometry does not depend on the number.

#pragma once

#include "openltc/light/shapes.h"
#include "openltc/scene/scene.h"

#include <cmath>
#include <random>

namespace openltc::bench {

inline int add_material(scene::Scene& scene, Vec3f color, float roughness, bool metal) {
  scene::Material m;
  m.base_color = {color.x, color.y, color.z, 1};
  m.metallic = metal ? 1.0f : 0.0f;
  m.roughness = roughness;
  m.double_sided = true;
  scene.materials.push_back(m);
  return int(scene.materials.size()) - 1;
}

/// A quadrilateral from a corner along two edges; its normal is u x v.
inline void add_quad(scene::Scene& scene, Vec3f corner, Vec3f u, Vec3f v, int material) {
  scene::Mesh mesh;
  mesh.material = material;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.normals.assign(4, normalize(cross(u, v)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
}

inline void add_box(scene::Scene& scene, Vec3f low, Vec3f high, int material) {
  const Vec3f s = high - low;
  const Vec3f x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
  add_quad(scene, low, z, y, material);
  add_quad(scene, low + x, y, z, material);
  add_quad(scene, low + y, z, x, material);
  add_quad(scene, low, y, x, material);
  add_quad(scene, low + z, x, y, material);
}

inline scene::Camera look_at(Vec3f from, Vec3f to) {
  scene::Camera camera;
  camera.position = from;
  camera.forward = normalize(to - from);
  camera.right = normalize(cross(camera.forward, Vec3f(0, 1, 0)));
  camera.up = cross(camera.right, camera.forward);
  camera.fov_y_rad = 0.9f;
  return camera;
}

/// Rectangle of two half sides that faces n.
inline light::PolygonLight panel(Vec3f center, Vec3f n, float half_u, float half_v, float turn,
                                 Vec3f radiance) {
  const Vec3f side = std::abs(n.y) < 0.9f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0);
  const Vec3f t = normalize(cross(side, n)), b = cross(n, t);
  const float c = std::cos(turn), s = std::sin(turn);
  return light::rectangle(center, (t * c + b * s) * half_u, (b * c - t * s) * half_v, radiance);
}

inline Vec3f lamp_color(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  return Vec3f(1.0f, 0.6f + 0.4f * uniform(random), 0.3f + 0.7f * uniform(random));
}

/// A hall of 120 x 80 x 9 metres with boxes of all roughnesses; panels hang from its whole ceiling,
/// a fifth of them turned.
inline scene::Scene hall(int lights) {
  scene::Scene scene;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  const int floor = add_material(scene, {0.45f, 0.42f, 0.4f}, 0.25f, false);
  const int wall = add_material(scene, {0.6f, 0.6f, 0.55f}, 0.8f, false);
  add_quad(scene, {-60, 0, -40}, {0, 0, 80}, {120, 0, 0}, floor);
  add_quad(scene, {-60, 9, -40}, {120, 0, 0}, {0, 0, 80}, wall);
  add_quad(scene, {-60, 0, -40}, {120, 0, 0}, {0, 9, 0}, wall);
  add_quad(scene, {-60, 0, -40}, {0, 9, 0}, {0, 0, 80}, wall);
  add_quad(scene, {60, 0, -40}, {0, 0, 80}, {0, 9, 0}, wall);
  for (int i = 0; i < 120; ++i) {
    const Vec3f at(-55 + 110 * uniform(random), 0, -38 + 70 * uniform(random));
    const Vec3f size(0.5f + 2 * uniform(random), 0.5f + 3 * uniform(random),
                     0.5f + 2 * uniform(random));
    const Vec3f color(0.2f + 0.7f * uniform(random), 0.2f + 0.7f * uniform(random),
                      0.2f + 0.7f * uniform(random));
    const float roughness = 0.05f + 0.9f * uniform(random);
    add_box(scene, at, at + size, add_material(scene, color, roughness, i % 3 == 0));
  }
  std::mt19937 lamp(11);
  for (int i = 0; i < lights; ++i) {
    const Vec3f at(-58 + 116 * uniform(lamp), 6 + 2.5f * uniform(lamp), -38 + 76 * uniform(lamp));
    Vec3f n(0, -1, 0);
    if (i % 5 == 4) n = normalize(Vec3f(uniform(lamp) - 0.5f, -0.5f, uniform(lamp) - 0.5f));
    const float size = 0.1f + 0.5f * uniform(lamp) * uniform(lamp);
    scene.lights.polygons.push_back(panel(at, n, size, size * (0.3f + 0.7f * uniform(lamp)),
                                          6.28f * uniform(lamp), lamp_color(lamp) * 3000.0f));
  }
  scene.cameras.push_back(look_at({0, 3, 36}, {0, 1, 0}));
  return scene;
}

/// A street of 300 metres between two rows of houses: lamps above the road, signs and windows on
/// the fronts, boxes as cars.
inline scene::Scene street(int lights) {
  scene::Scene scene;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0, 1);
  const int road = add_material(scene, {0.08f, 0.08f, 0.09f}, 0.35f, false);
  add_quad(scene, {-14, 0, -300}, {0, 0, 310}, {28, 0, 0}, road);
  for (int i = 0; i < 40; ++i) {
    const float side = i % 2 ? 1.0f : -1.0f, z = -300 + 15.5f * float(i / 2);
    const int front = add_material(
        scene, Vec3f(0.3f + 0.4f * uniform(random), 0.3f + 0.3f * uniform(random), 0.3f),
        0.3f + 0.6f * uniform(random), false);
    const float near = side * (9.5f + uniform(random)), far = side * 14;
    add_box(scene, {std::min(near, far), 0, z},
            {std::max(near, far), 8 + 14 * uniform(random), z + 15.5f}, front);
  }
  for (int i = 0; i < 50; ++i) {
    const float side = i % 2 ? 1.0f : -1.0f, z = 2 - 290 * uniform(random);
    const int paint = add_material(scene, Vec3f(uniform(random), uniform(random), uniform(random)),
                                   0.1f + 0.2f * uniform(random), i % 3 == 0);
    add_box(scene, {side * 4.5f - 0.9f, 0.2f, z}, {side * 4.5f + 0.9f, 1.6f, z + 4}, paint);
  }
  std::mt19937 lamp(13);
  for (int i = 0; i < lights; ++i) {
    const float side = uniform(lamp) < 0.5f ? -1.0f : 1.0f, z = 5 - 300 * uniform(lamp);
    const Vec3f color = lamp_color(lamp);
    const float a = uniform(lamp), b = uniform(lamp), c = uniform(lamp);
    if (i % 3 == 0) // lamp
      scene.lights.polygons.push_back(
          panel({side * 6, 6 + a, z}, {0, -1, 0}, 0.1f + 0.1f * b, 0.3f, 0, color * 20000.0f));
    else if (i % 3 == 1) // sign across the pavement, lit on one side
      scene.lights.polygons.push_back(panel({side * 8.7f, 2.5f + 3 * a, z},
                                            {0, 0, b < 0.5f ? 1.0f : -1.0f}, 0.3f, 0.2f + c, 0,
                                            color * 800.0f));
    else // window
      scene.lights.polygons.push_back(panel({side * 9.45f, 1.5f + 7 * a, z}, {-side, 0, 0},
                                            0.4f + 0.6f * b, 0.5f + 0.5f * c, 0, color * 300.0f));
  }
  scene.cameras.push_back(look_at({1, 2.2f, 8}, {0, 2, -30}));
  return scene;
}

/// A glowing ring above a floor with five boxes around it, its surface cut into
/// about `facets` triangles, each a light. The more facets, the smaller: the light stays the same.
inline scene::Scene ring_of_facets(int facets) {
  scene::Scene scene;
  add_quad(scene, {-12, 0, -12}, {0, 0, 24}, {24, 0, 0},
           add_material(scene, Vec3f(0.5f, 0.45f, 0.4f), 0.3f, false));
  for (int i = 0; i < 5; ++i) {
    const float angle = 1.2566f * float(i) + 0.4f, x = 2.6f * std::cos(angle),
                z = 2.6f * std::sin(angle);
    add_box(scene, {x - 0.4f, 0, z - 0.4f}, {x + 0.4f, 0.6f + 0.3f * float(i), z + 0.4f},
            add_material(scene, Vec3f(0.8f, 0.3f + 0.1f * float(i), 0.5f), 0.2f + 0.15f * float(i),
                         i % 2 == 0));
  }
  // A torus: twice as many steps around as across, two triangles each.
  const int across = std::max(3, int(std::sqrt(double(facets) / 4))), around = 2 * across;
  const auto point = [&](int i, int j) {
    const double u = 6.283185307 * i / around, v = 6.283185307 * j / across;
    const double r = 1.0 + 0.3 * std::cos(v);
    return Vec3f(float(r * std::cos(u)), float(1.6 + 0.3 * std::sin(v)), float(r * std::sin(u)));
  };
  scene::Material glow;
  glow.emission = Vec3f(400, 250, 120);
  scene.materials.push_back(glow);
  scene::Mesh mesh;
  mesh.material = int(scene.materials.size()) - 1;
  const auto add = [&](Vec3f a, Vec3f b, Vec3f c) {
    const auto first = std::uint32_t(mesh.positions.size());
    const Vec3f n = normalize(cross(b - a, c - a));
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.normals.insert(mesh.normals.end(), 3, n);
    mesh.triangles.push_back({first, first + 1, first + 2});
    light::PolygonLight light;
    light.vertices = {a, b, c};
    light.ring_end = {3};
    light.normal = n;
    light.radiance = glow.emission;
    scene.lights.polygons.push_back(light);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      add(point(i, j), point(i, j + 1), point(i + 1, j + 1));
      add(point(i, j), point(i + 1, j + 1), point(i + 1, j));
    }
  scene.meshes.push_back(mesh);
  scene.cameras.push_back(look_at({1.5f, 3.2f, 5.5f}, {0, 0.7f, 0}));
  return scene;
}

} // namespace openltc::bench
