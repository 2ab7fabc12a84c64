// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Round lights in meshes: what is one, what is none, and that the flux stays what it was.

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/emissive/light_surface.h"
#include "tests/scene/emissive/round_meshes.h"
#include "tests/scene/gltf_builder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace openltc;
using namespace openltc::test;

constexpr double k_pi = std::numbers::pi;

scene::Material glowing(bool double_sided = false) {
  scene::Material material;
  material.emission = Vec3f(100, 50, 25);
  material.double_sided = double_sided;
  return material;
}

light::Lights recognise(const scene::Mesh& mesh, bool double_sided = false,
                        double tolerance = 0.01) {
  scene::EmissiveOptions options;
  options.recognise_shapes = true;
  options.shape_tolerance = tolerance;
  const scene::EmissiveLights found =
      scene::emissive_lights(mesh, glowing(double_sided), {}, options);
  CHECK(found.triangles_without_area == 0);
  found.lights.for_each_area_light([](const auto& light) {
    const Status status = light::validate(light);
    CHECK_MESSAGE(status.ok(), (status.ok() ? "" : status.error().message));
    CHECK(light.name == "lamp");
  });
  return found.lights;
}

// Shadow rays stop `surface_deviation` before the light; the mesh must not reach further out.
template <class Light> void check_surface(const Light& light, const scene::Mesh& mesh) {
  double outside = 0;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      outside = std::max(outside, scene::distance_outside(light, mesh.positions[v]));
  double magnitude = 0;
  for (const Vec3f p : mesh.positions)
    magnitude = std::max(magnitude, double(length(p)));
  CHECK(outside <= double(light.surface_deviation) + 1e-6 * magnitude);
  CHECK(double(light.surface_deviation) <= 1.2 * outside + 1e-6 * magnitude);
}

bool makes_polygons_only(const scene::Mesh& mesh, bool double_sided = false) {
  const light::Lights lights = recognise(mesh, double_sided);
  return !lights.polygons.empty() && lights.polygons.size() == lights.area_light_count();
}

const Vec3d k_even(0.3, 0.3, 0.3), k_one(1, 1, 1), k_none(0, 0, 0), k_far(20, -7, 3);

TEST_CASE("spheres_of_a_mesh_become_sphere_lights_of_the_same_flux") {
  for (const scene::Mesh& unit : {icosphere(2), icosphere(4), uv_sphere(16, 32), uv_sphere(24, 48)})
    for (const double size : {1.0, 0.01, 40.0}) {
      const scene::Mesh mesh = transformed(unit, 1.1, k_one * size, k_far * size);
      const light::Lights lights = recognise(mesh);
      REQUIRE(lights.area_light_count() == 1);
      REQUIRE(lights.spheres.size() == 1);
      const light::SphereLight& light = lights.spheres[0];
      CHECK(light::area(light) == doctest::Approx(area_of(mesh)).epsilon(1e-4));
      CHECK(double(light.radius) == doctest::Approx(size).epsilon(0.015));
      const Vec3d c = k_far * size;
      CHECK(double(length(light.center - Vec3f(float(c.x), float(c.y), float(c.z)))) < 1e-4 * size);
      CHECK(double(light.radiance.y) == 50);
      check_surface(light, mesh);
    }
}

TEST_CASE("a_sphere_of_two_sides_emits_outwards_as_one_of_one_side_does") {
  const light::Lights lights = recognise(icosphere(3), true);
  REQUIRE(lights.spheres.size() == 1);
  CHECK(!lights.spheres[0].two_sided);
}

TEST_CASE("what_is_no_sphere_is_not_taken_for_one") {
  CHECK(makes_polygons_only(icosphere(0)));                       // too coarse
  CHECK(makes_polygons_only(icosphere(1)));                       // the same
  CHECK(makes_polygons_only(uv_sphere(16, 32, k_pi / 2 + 1e-3))); // a hemisphere
  CHECK(makes_polygons_only(uv_sphere(16, 32, k_pi * 0.95)));     // open at a pole
  CHECK(makes_polygons_only(transformed(icosphere(3), 0.4, Vec3d(1, 1, 1.06), k_none)));
  CHECK(makes_polygons_only(transformed(icosphere(3), 0, Vec3d(-1, 1, 1), k_none))); // inside out
  scene::Mesh dented = icosphere(3);
  for (Vec3f& p : dented.positions)
    if (length(p - dented.positions[0]) < 1e-4f) p = p * 0.9f;
  CHECK(makes_polygons_only(dented));
  scene::Mesh holed = icosphere(3);
  holed.triangles.erase(holed.triangles.begin() + 100);
  CHECK(makes_polygons_only(holed));
  CHECK(recognise(icosphere(1), false, 0.03).spheres.size() == 1); // a wider tolerance takes it
  CHECK(recognise(icosphere(3), false, 0.0005).spheres.empty());
}

TEST_CASE("disks_of_sixteen_corners_and_more_become_disks_of_the_same_flux") {
  for (const std::uint32_t corners : {16u, 20u, 32u, 64u})
    for (const bool two_sided : {false, true}) {
      const scene::Mesh mesh = transformed(disk_mesh(corners), 0.7, k_even, k_far);
      const light::Lights lights = recognise(mesh, two_sided);
      REQUIRE(lights.area_light_count() == 1);
      REQUIRE(lights.ellipses.size() == 1);
      const light::EllipseLight& light = lights.ellipses[0];
      CHECK(light::area(light) == doctest::Approx(area_of(mesh)).epsilon(1e-4));
      CHECK(double(length(light.half_u)) == doctest::Approx(double(length(light.half_v))));
      CHECK(light.two_sided == two_sided);
      const Vec3f a = mesh.positions[0] - mesh.positions[corners],
                  b = mesh.positions[1] - mesh.positions[corners];
      CHECK(dot(normalize(cross(light.half_u, light.half_v)), normalize(cross(a, b))) >
            0.99999f); // the side that emits
      CHECK(double(length(light.center - mesh.positions[corners])) < 1e-5);
    }
}

TEST_CASE("stretched_disks_are_ellipses_along_their_axes") {
  const light::Lights lights = recognise(disk_mesh(48, 2, 0.5));
  REQUIRE(lights.ellipses.size() == 1);
  const light::EllipseLight& light = lights.ellipses[0];
  CHECK(std::abs(light.half_u.x) == doctest::Approx(2).epsilon(0.005));
  CHECK(std::abs(light.half_v.y) == doctest::Approx(0.5).epsilon(0.005));
  CHECK(light::area(light) == doctest::Approx(area_of(disk_mesh(48, 2, 0.5))).epsilon(1e-4));
}

TEST_CASE("what_is_no_disk_is_not_taken_for_one") {
  for (const std::uint32_t corners : {4u, 6u, 8u, 12u})
    CHECK(makes_polygons_only(disk_mesh(corners)));
  scene::Mesh half = disk_mesh(64);
  half.triangles.resize(32);
  CHECK(makes_polygons_only(half));
  scene::Mesh ring = disk_mesh(64); // with a hole
  for (std::uint32_t i = 0; i < 64; ++i)
    ring.positions.push_back(ring.positions[i] * 0.5f);
  ring.triangles.clear();
  for (std::uint32_t i = 0; i < 64; ++i) {
    const std::uint32_t k = (i + 1) % 64;
    ring.triangles.push_back({i, k, 65 + k});
    ring.triangles.push_back({i, 65 + k, 65 + i});
  }
  ring.normals.assign(ring.positions.size(), Vec3f(0, 0, 1));
  CHECK(makes_polygons_only(ring));
  scene::Mesh bowl = disk_mesh(64);
  bowl.positions[64].z = -0.1f;
  CHECK(makes_polygons_only(bowl));
}

TEST_CASE("cylinders_become_tubes_of_the_same_flux") {
  for (const std::uint32_t corners : {16u, 32u, 64u})
    for (const double length : {0.2, 1.0, 2.0, 2.1, 30.0}) // where side and ends are as large, too
      for (const int ends : {0, 2}) {
        CAPTURE(corners);
        CAPTURE(length);
        CAPTURE(ends);
        const scene::Mesh mesh =
            transformed(cylinder_mesh(corners, length, ends), 2.0, k_even, k_far * 0.1);
        const light::Lights lights = recognise(mesh);
        REQUIRE(lights.area_light_count() == 1);
        REQUIRE(lights.tubes.size() == 1);
        const light::TubeLight& light = lights.tubes[0];
        CHECK(light.caps == (ends == 2 ? light::TubeCaps::flat : light::TubeCaps::none));
        CHECK(light::area(light) == doctest::Approx(area_of(mesh)).epsilon(1e-4));
        CHECK(double(openltc::length(light.to - light.from)) ==
              doctest::Approx(0.3 * length).epsilon(1e-4));
        CHECK(double(light.radius) == doctest::Approx(0.3).epsilon(0.02));
        check_surface(light, mesh);
      }
}

TEST_CASE("what_is_no_cylinder_is_not_taken_for_one") {
  CHECK(makes_polygons_only(cylinder_mesh(8, 3, 2)));
  CHECK(makes_polygons_only(cylinder_mesh(32, 3, 1)));      // closed at one end
  CHECK(makes_polygons_only(cylinder_mesh(32, 3, 0, 0.5))); // half of one
  CHECK(makes_polygons_only(cylinder_mesh(64, 3, 0, 63 / 64.0)));
  CHECK(makes_polygons_only(cylinder_mesh(32, 3, 0), true)); // its inside is seen
  CHECK(!makes_polygons_only(cylinder_mesh(32, 3, 2), true));
  CHECK(makes_polygons_only(transformed(cylinder_mesh(32, 3, 2), 0, Vec3d(1, 1, 1.2), k_none)));
  scene::Mesh cone = cylinder_mesh(32, 3, 2);
  for (Vec3f& p : cone.positions)
    if (p.x > 1) p = Vec3f(p.x, p.y * 0.8f, p.z * 0.8f);
  CHECK(makes_polygons_only(cone));
}

TEST_CASE("each_island_of_a_mesh_is_looked_at_on_its_own") {
  scene::Mesh mesh = together(icosphere(3), disk_mesh(32), Vec3f(5, 0, 0));
  mesh = together(mesh, cylinder_mesh(32, 2, 2), Vec3f(0, 5, 0));
  mesh = together(mesh, disk_mesh(4), Vec3f(0, 0, 5));
  const light::Lights lights = recognise(mesh);
  CHECK(lights.spheres.size() == 1);
  CHECK(lights.ellipses.size() == 1);
  CHECK(lights.tubes.size() == 1);
  CHECK(lights.polygons.size() == 1);
}

TEST_CASE("nothing_is_recognised_unless_asked_for") {
  const auto found = scene::emissive_lights(icosphere(2), glowing(), {});
  CHECK(found.lights.polygons.size() == 320);
  CHECK(found.lights.area_light_count() == 320);
}

TEST_CASE("random_blobs_never_gain_or_lose_flux") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 40; ++i) {
    scene::Mesh mesh = i % 2 ? icosphere(2) : cylinder_mesh(24, 1.5, 2);
    const double noise = std::pow(10.0, -4 + 3 * std::abs(uniform(random)));
    mesh = transformed(mesh, uniform(random) * 3,
                       Vec3d(1, 1 + noise * uniform(random), 1 + noise * uniform(random)), k_far);
    const light::Lights lights = recognise(mesh);
    double area = 0;
    lights.for_each_area_light([&](const auto& light) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(light)>, light::LineLight>)
        area += light::area(light);
    });
    CHECK(area == doctest::Approx(area_of(mesh)).epsilon(1e-3));
  }
}

} // namespace
