// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/polygon.h"
#include "openltc/scene/emissive/emissive.h"
#include "tests/scene/gltf_builder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace openltc;
using namespace openltc::test;
using scene::EmissiveLights;

scene::Material glowing(float nits, bool double_sided = false) {
  scene::Material material;
  material.emission = Vec3f(nits, 0.5f * nits, 0);
  material.double_sided = double_sided;
  return material;
}

double total_area(const EmissiveLights& found) {
  double sum = 0;
  for (const auto& light : found.lights.polygons)
    sum += light::area(light);
  return sum;
}

// A box [0, 1]^3 with 8 shared corners.
scene::Mesh cube() {
  scene::Mesh mesh;
  mesh.name = "cube";
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(Vec3f(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  mesh.normals.assign(8, Vec3f(0, 0, 1));
  return mesh;
}

TEST_CASE("a_cube_is_six_lights_that_face_outwards") {
  const scene::Mesh mesh = cube();
  const EmissiveLights found = scene::emissive_lights(mesh, glowing(10), {});
  CHECK(found.lights.polygons.size() == 6);
  for (const auto& light : found.lights.polygons) {
    CHECK(light::validate(light).ok());
    CHECK(light::area(light) == doctest::Approx(1.0));
    CHECK(light.vertices.size() == 4);
    CHECK(dot(light.normal, light.vertices[0] - Vec3f(0.5f)) == doctest::Approx(0.5f));
    CHECK(light.radiance.x == 10.0f);
    CHECK(light.radiance.y == 5.0f);
    CHECK(light.name == "cube");
    CHECK(!light.two_sided);
  }
}

TEST_CASE("a_sphere_keeps_its_area_and_its_poles_are_triangles") {
  scene::Mesh mesh;
  constexpr std::uint32_t rings = 16, segments = 24;
  for (std::uint32_t r = 0; r <= rings; ++r)
    for (std::uint32_t s = 0; s <= segments; ++s) { // the seam is doubled, as exporters do
      const double theta = std::numbers::pi * r / rings, phi = 2 * std::numbers::pi * s / segments;
      mesh.positions.push_back(Vec3f(float(std::sin(theta) * std::cos(phi)), float(std::cos(theta)),
                                     float(-std::sin(theta) * std::sin(phi))));
    }
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t a = r * (segments + 1) + s, b = a + segments + 1;
      if (r != 0) mesh.triangles.push_back({a, b, a + 1});
      if (r + 1 != rings) mesh.triangles.push_back({a + 1, b, b + 1});
    }
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 1, 0));
  const EmissiveLights found = scene::emissive_lights(mesh, glowing(1), {});
  // Quads are planar; around the poles triangles lean by so little that some are joined.
  CHECK(found.lights.polygons.size() <= rings * segments);
  CHECK(found.lights.polygons.size() >= (rings - 4) * segments);
  double flux = 0;
  for (const auto& light : found.lights.polygons)
    flux += double(light::flux_lumens(light).x);
  CHECK(flux == doctest::Approx(std::numbers::pi * area_of(mesh)).epsilon(1e-4));
  // Without joining there is one for each.
  scene::EmissiveOptions exact;
  exact.few_planes = 1000;
  const EmissiveLights all = scene::emissive_lights(mesh, glowing(1), {}, exact);
  CHECK(all.lights.polygons.size() == rings * segments);
  CHECK(total_area(all) == doctest::Approx(area_of(mesh)).epsilon(1e-5));
  for (const auto& light : found.lights.polygons)
    CHECK(light::validate(light).ok());
}

TEST_CASE("islands_of_one_plane_are_one_light_and_parallel_planes_are_not") {
  scene::Mesh mesh;
  for (const float z : {0.0f, 0.0f, 1.0f}) {
    const float x = mesh.positions.empty() ? 0.0f : 3.0f;
    const std::uint32_t first = std::uint32_t(mesh.positions.size());
    for (const Vec3f p : {Vec3f(x, 0, z), Vec3f(x + 1, 0, z), Vec3f(x + 1, 1, z), Vec3f(x, 1, z)})
      mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1));
  const EmissiveLights found = scene::emissive_lights(mesh, glowing(1), {});
  REQUIRE(found.lights.polygons.size() == 2);
  CHECK(found.lights.polygons[0].ring_end.size() + found.lights.polygons[1].ring_end.size() == 3);
  CHECK(total_area(found) == doctest::Approx(3.0));
}

TEST_CASE("a_plate_with_a_hole_in_any_position_keeps_its_area") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3f n = normalize(Vec3f(uniform(random), uniform(random) + 0.05f, uniform(random)));
    const Vec3f t = normalize(cross(n, std::abs(n.x) < 0.7f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0)));
    const Vec3f b = cross(n, t);
    const float size = std::pow(10.0f, 3 * uniform(random));
    const Vec3f shift = Vec3f(uniform(random), uniform(random), uniform(random)) * (30 * size);
    scene::Mesh mesh;
    const auto add = [&](float x, float y) {
      mesh.positions.push_back(shift + t * (x * size) + b * (y * size));
      return std::uint32_t(mesh.positions.size() - 1);
    };
    // unshared corners, a fan of four trapezoids around the hole
    const float outer[4][2] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    for (int i = 0; i < 4; ++i) {
      const float *p = outer[i], *q = outer[(i + 1) % 4];
      const float hole = 0.25f;
      mesh.triangles.push_back({add(p[0], p[1]), add(q[0], q[1]), add(q[0] * hole, q[1] * hole)});
      mesh.triangles.push_back(
          {add(p[0], p[1]), add(q[0] * hole, q[1] * hole), add(p[0] * hole, p[1] * hole)});
    }
    mesh.normals.assign(mesh.positions.size(), n);
    const EmissiveLights found = scene::emissive_lights(mesh, glowing(1), {});
    REQUIRE(found.lights.polygons.size() == 1);
    const light::PolygonLight& light = found.lights.polygons[0];
    CHECK(light::validate(light).ok());
    REQUIRE(light.ring_end.size() == 2);
    CHECK(light.ring_end[0] == 4);
    CHECK(light.ring_end[1] == 8);
    CHECK(light::area(light) == doctest::Approx(15.0 * double(size) * double(size)).epsilon(1e-3));
    CHECK(dot(light.normal, n) > 0.9999f);
  }
}

TEST_CASE("double_sided_surfaces_shine_to_both_sides_once") {
  scene::Mesh mesh;
  mesh.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)};
  mesh.normals.assign(4, Vec3f(0, 0, 1));
  // the second triangle is drawn from the other side, the first one twice
  mesh.triangles = {{0, 1, 2}, {0, 3, 2}, {2, 1, 0}};
  const EmissiveLights found = scene::emissive_lights(mesh, glowing(1, true), {});
  REQUIRE(found.lights.polygons.size() == 1);
  CHECK(found.lights.polygons[0].two_sided);
  CHECK(light::area(found.lights.polygons[0]) == doctest::Approx(1.0));
  CHECK(found.lights.polygons[0].vertices.size() == 4);
}

TEST_CASE("dark_and_unlit_materials_are_no_lights") {
  const scene::Mesh mesh = cube();
  CHECK(scene::emissive_lights(mesh, glowing(0), {}).lights.empty());
  scene::Material unlit = glowing(1);
  unlit.unlit = true;
  CHECK(scene::emissive_lights(mesh, unlit, {}).lights.empty());
}

TEST_CASE("textured_emission_that_is_no_picture_is_averaged_over_the_surface") {
  scene::Texture texture;
  image::Image picture(64, 16, 4);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = 1.0f;
  texture.image = picture;
  scene::Mesh mesh;
  mesh.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)};
  // Four times beside itself: one picture does not cover the light.
  mesh.tex_coord_0 = {Vec2f(0, 1), Vec2f(4, 1), Vec2f(4, 0), Vec2f(0, 0)};
  mesh.normals.assign(4, Vec3f(0, 0, 1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene::Material material = glowing(100);
  material.emission_texture.texture = 0;
  auto found = scene::emissive_lights(mesh, material, {texture});
  REQUIRE(found.lights.polygons.size() == 1);
  CHECK(found.is_texture_averaged);
  CHECK(found.lights.polygons[0].texture == -1);
  CHECK(found.lights.polygons[0].radiance.x == doctest::Approx(25.0f).epsilon(0.15));
  // the right half of the picture is dark: no light at all
  for (Vec2f& uv : mesh.tex_coord_0)
    uv.x = 0.5f + 0.1f * uv.x;
  found = scene::emissive_lights(mesh, material, {texture});
  CHECK(found.lights.polygons.empty());
}

TEST_CASE("emitters_in_a_file_become_lights_and_stay_visible") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials",
      {{"emissiveFactor", {1, 1, 1}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2500}}}}}});
  file.add_mesh_node(primitive, {{"name", "panel"}, {"scale", {-2, 3, 1}}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->meshes.size() == 1);
  REQUIRE(loaded->lights.polygons.size() == 1);
  const light::PolygonLight& light = loaded->lights.polygons[0];
  CHECK(light.name == "panel");
  CHECK(light.radiance.z == 2500.0f);
  CHECK(light::area(light) == doctest::Approx(6.0));
  CHECK(light.normal.z == doctest::Approx(1.0f));
}

TEST_CASE("many_facets_are_warned_of_and_take_little_time") {
  // a wavy sheet: every triangle has a plane of its own
  GltfBuilder file;
  constexpr int n = 60;
  std::vector<float> positions;
  std::vector<std::uint16_t> corners;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      positions.insert(
          positions.end(),
          {float(x), float(y), 3 * std::sin(0.5f * float(x)) * std::cos(0.4f * float(y))});
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      for (const int c : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1})
        corners.push_back(std::uint16_t(c));
    }
  const int material = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  file.add_mesh_node({{"attributes", {{"POSITION", file.add_vec3(positions)}}},
                      {"indices", file.add_indices(corners)},
                      {"material", material}});
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->lights.polygons.size() > 1000);
  CHECK(warns_about(*loaded, "polygon lights"));
  double flux = 0;
  for (const auto& light : loaded->lights.polygons)
    flux += double(light::flux_lumens(light).x);
  CHECK(flux == doctest::Approx(std::numbers::pi * area_of(loaded->meshes[0])).epsilon(1e-3));
}

} // namespace
