// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shadow rays against brute force: every blended triangle on the way counts, and counts once.

#include "openltc/render/ray_scene.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace openltc;

namespace {

constexpr float k_alpha = 0.1f;
constexpr std::size_t k_rays = 8 * render::RayPacket::k_size;

using Point = std::array<double, 3>;

Point point_of(Vec3f v) { return {double(v.x), double(v.y), double(v.z)}; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
// Six times the volume of the tetrahedron o a b c.
double volume(const Point& o, const Point& a, const Point& b, const Point& c) {
  const Point x = minus(a, o), y = minus(b, o), z = minus(c, o);
  return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
         x[2] * (y[0] * z[1] - y[1] * z[0]);
}

// Long thin triangles across each other, each much smaller than its bounding box: what an
// acceleration structure wants to split.
scene::Scene slivers(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto any = [&] { return Vec3f(unit(random), unit(random), unit(random)); };
  scene::Scene scene;
  scene.materials.push_back(test::diffuse_material({0, 0, 0}));
  scene.materials[0].alpha_mode = scene::AlphaMode::blend;
  scene.materials[0].base_color.w = k_alpha;
  scene.meshes.emplace_back();
  scene::Mesh& mesh = scene.meshes[0];
  mesh.material = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec3f middle = any(), along = any() * 1.5f, across = any() * 0.1f;
    mesh.positions.insert(mesh.positions.end(), {middle - along, middle + along, middle + across});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
  return scene;
}

// Triangles that the segment a b crosses; -1 where a crossing is too close to an edge or an end to
// be sure of in single precision.
int crossings(const scene::Mesh& mesh, const Point& a, const Point& b) {
  int count = 0;
  for (const auto& t : mesh.triangles) {
    const Point p = point_of(mesh.positions[t[0]]), q = point_of(mesh.positions[t[1]]),
                r = point_of(mesh.positions[t[2]]);
    double sides[3] = {volume(a, b, p, q), volume(a, b, q, r), volume(a, b, r, p)};
    double ends[2] = {volume(a, p, q, r), -volume(b, p, q, r)};
    if (sides[0] + sides[1] + sides[2] < 0)
      for (double& side : sides)
        side = -side;
    if (ends[0] + ends[1] < 0)
      for (double& end : ends)
        end = -end;
    double smallest = ends[0];
    for (const double x : {ends[1], sides[0], sides[1], sides[2]})
      smallest = std::min(smallest, x);
    if (std::abs(smallest) < 1e-6) return -1;
    count += smallest > 0;
  }
  return count;
}

} // namespace

TEST_CASE("each blended triangle dims a shadow ray once") {
  std::mt19937 random(20240601);
  std::uniform_real_distribution<float> unit(-1, 1);
  const scene::Scene scene = slivers(random);
  const render::TextureSet textures(scene);
  const auto rays = render::RayScene::create(scene, textures);
  REQUIRE(rays.ok());

  // Rays of a packet go all ways, as they do to a light right above.
  std::vector<float> origin[3], direction[3], transmittance(k_rays);
  const std::vector<std::int32_t> active(k_rays, -1);
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < k_rays; ++i) {
      origin[axis].push_back(unit(random));
      direction[axis].push_back(unit(random));
    }
  for (std::size_t first = 0; first < k_rays; first += render::RayPacket::k_size) {
    render::ShadowRays packet;
    packet.count = render::RayPacket::k_size;
    for (int axis = 0; axis < 3; ++axis) {
      packet.origin[axis] = &origin[axis][first];
      packet.direction[axis] = &direction[axis][first];
    }
    packet.active = &active[first];
    packet.transmittance = &transmittance[first];
    (*rays)->trace_shadows(packet);
  }

  int compared = 0, most = 0;
  for (std::size_t i = 0; i < k_rays; ++i) {
    Point a, b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = double(origin[axis][i]);
      b[axis] = a[axis] + double(direction[axis][i]);
    }
    const int count = crossings(scene.meshes[0], a, b);
    if (count < 0) continue;
    CHECK(double(transmittance[i]) ==
          doctest::Approx(std::pow(1 - double(k_alpha), count)).epsilon(1e-4));
    ++compared;
    most = std::max(most, count);
  }
  CHECK(compared > 40);
  CHECK(most >= 10);
}
