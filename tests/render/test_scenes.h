// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Small scenes made in code, for tests of rendering.

#pragma once

#include "openltc/render/renderer.h"
#include "openltc/scene/scene.h"

namespace openltc::test {

scene::Material diffuse_material(Vec3f color);
/// A dielectric of index 1.5 over a colour, or a metal.
scene::Material glossy_material(Vec3f color, float roughness, bool metal);

/// Adds a square in the plane y = height, side 2 * half, normal up.
void add_floor(scene::Scene& scene, float half, float height, const scene::Material& material);
/// Adds a sphere of smooth normals.
void add_sphere(scene::Scene& scene, Vec3f center, float radius, const scene::Material& material);

/// A light in the plane y = height that shines down, outline given as (x, z), counter-clockwise
/// seen from below.
light::PolygonLight ceiling_light(const std::vector<std::vector<Vec2f>>& rings, float height,
                                  float nits);
light::PolygonLight ceiling_rectangle(float x0, float z0, float x1, float z1, float height,
                                      float nits);

/// Camera at `from` that looks at `to`.
scene::Camera look_at(Vec3f from, Vec3f to, float fov_y_rad);

/// The picture of the scene's first camera with the built-in table; the test ends where there is
/// none.
render::Picture rendered(const scene::Scene& scene, const render::RenderOptions& options);
/// Largest difference of two values of pictures of one size.
double max_difference(const image::Image& a, const image::Image& b);

} // namespace openltc::test
