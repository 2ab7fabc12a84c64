// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a picture of a scene without camera shows, stated in the geometry of scenes made here.

#include "openltc/render/view/studio_room.h"
#include "openltc/render/view/view_choice.h"
#include "openltc/scene/view/studio.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace openltc::test {

namespace {

scene::Material paint(bool two_sided) {
  scene::Material material = diffuse_material({0.7f, 0.7f, 0.7f});
  material.double_sided = two_sided;
  return material;
}

// A rectangle whose front looks along cross(half_u, half_v).
void add_wall(scene::Scene& scene, Vec3f middle, Vec3f half_u, Vec3f half_v,
              const scene::Material& material) {
  scene.materials.push_back(material);
  scene::Mesh& mesh = scene.meshes.emplace_back();
  mesh.material = int(scene.materials.size()) - 1;
  mesh.positions = {middle - half_u - half_v, middle + half_u - half_v, middle + half_u + half_v,
                    middle - half_u + half_v};
  mesh.normals.assign(4, normalize(cross(half_u, half_v)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
}

enum Side { left, right, bottom, top, back, front, none };

// A room of half width w, half height h, half depth d around the origin, without one of its sides;
// fronts of all walls look inwards.
void add_room(scene::Scene& scene, float w, float h, float d, Side open, bool two_sided) {
  const scene::Material m = paint(two_sided);
  const Vec3f x(w, 0, 0), y(0, h, 0), z(0, 0, d);
  if (open != left) add_wall(scene, -x, y, z, m);
  if (open != right) add_wall(scene, x, z, y, m);
  if (open != bottom) add_wall(scene, -y, z, x, m);
  if (open != top) add_wall(scene, y, x, z, m);
  if (open != back) add_wall(scene, -z, x, y, m);
  if (open != front) add_wall(scene, z, y, x, m);
}

Vec3f outwards(Side side) {
  const Vec3f directions[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  return directions[side];
}

void close(scene::Scene& scene) { // its bounds, as a reader states them
  bool first = true;
  for (const scene::Mesh& mesh : scene.meshes)
    for (const Vec3f p : mesh.positions) {
      if (first) scene.bounds = {p, p};
      first = false;
      scene.bounds.lower = {std::min(scene.bounds.lower.x, p.x),
                            std::min(scene.bounds.lower.y, p.y),
                            std::min(scene.bounds.lower.z, p.z)};
      scene.bounds.upper = {std::max(scene.bounds.upper.x, p.x),
                            std::max(scene.bounds.upper.y, p.y),
                            std::max(scene.bounds.upper.z, p.z)};
    }
}

constexpr float k_aspect = 16.0f / 9;

scene::Camera view_of(scene::Scene& scene) {
  close(scene);
  const Result<scene::Camera> camera = render::choose_view(scene, k_aspect);
  REQUIRE(camera.ok());
  CHECK(std::abs(length(camera->forward) - 1) < 1e-5f);
  CHECK(length(cross(camera->right, camera->up) + camera->forward) < 1e-5f);
  return *camera;
}

// Height of points in the picture as a share of the picture's; more than 1 where one is cut off.
float share_of_height(const scene::Camera& camera, const std::vector<Vec3f>& points) {
  const float tan_y = std::tan(0.5f * camera.fov_y_rad);
  float low = 1e30f, high = -1e30f;
  for (const Vec3f p : points) {
    const Vec3f d = p - camera.position;
    const float depth = dot(d, camera.forward);
    if (!(depth > camera.near)) return 2;
    const float y = dot(d, camera.up) / (depth * tan_y);
    if (std::abs(dot(d, camera.right)) > depth * tan_y * k_aspect || std::abs(y) > 1) return 2;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return 0.5f * (high - low);
}

} // namespace

TEST_CASE("a subject on a ground of any size fills two thirds of the picture's height") {
  for (const float ground : {5.0f, 50.0f, 5000.0f})
    for (const Vec3f at : {Vec3f(0, 0.5f, 0), Vec3f(1, 0.5f, -2)})
      for (const bool two_sided : {false, true}) {
        CAPTURE(ground);
        scene::Scene scene;
        add_floor(scene, ground, 0, paint(two_sided));
        add_sphere(scene, at, 0.5f, paint(false));
        const scene::Camera camera = view_of(scene);
        const float share = share_of_height(camera, scene.meshes[1].positions);
        CHECK(share > 0.66f);
        CHECK(share <= 1);
        CHECK(camera.position.y > 0); // and the ground is seen from above
      }
}

TEST_CASE("a ground that is hardly larger than what stands on it belongs to the picture") {
  scene::Scene scene;
  add_floor(scene, 0.6f, 0, paint(false));
  add_sphere(scene, {0, 0.5f, 0}, 0.5f, paint(false));
  const scene::Camera camera = view_of(scene);
  CHECK(share_of_height(camera, scene.meshes[0].positions) <= 1);
  CHECK(share_of_height(camera, scene.meshes[1].positions) <= 1);
}

TEST_CASE("a print on a card is no subject before a ground") {
  scene::Scene scene;
  add_floor(scene, 1, 0, paint(false));
  add_floor(scene, 0.1f, 0.001f, paint(false));
  const scene::Camera camera = view_of(scene);
  CHECK(share_of_height(camera, scene.meshes[0].positions) <= 1);
}

TEST_CASE("the open side of a box faces the camera") {
  for (const Side open : {front, back, left, right})
    for (const bool two_sided : {false, true})
      for (const bool lit : {false, true}) {
        CAPTURE(int(open));
        CAPTURE(two_sided);
        CAPTURE(lit);
        scene::Scene scene;
        add_room(scene, 1, 1, 1, open, two_sided);
        add_sphere(scene, {0.2f, -0.6f, -0.1f}, 0.4f, paint(false));
        if (lit) scene.lights.polygons = {ceiling_rectangle(-0.3f, -0.3f, 0.3f, 0.3f, 0.99f, 100)};
        const scene::Camera camera = view_of(scene);
        // Through one-sided walls one looks from outside; what must be seen is the inside of the
        // other walls, and what stands there. Two-sided walls leave the open side alone.
        if (two_sided) CHECK(dot(-camera.forward, outwards(open)) > 0.7f);
        CHECK(share_of_height(camera, scene.meshes.back().positions) <= 1);
      }
}

TEST_CASE("a closed room that is lit inside is seen from inside") {
  scene::Scene scene;
  add_room(scene, 2, 1.3f, 2.5f, none, true);
  add_sphere(scene, {0, -0.9f, -0.5f}, 0.4f, paint(false));
  scene.lights.polygons = {ceiling_rectangle(-0.4f, -0.4f, 0.4f, 0.4f, 1.29f, 100)};
  const scene::Camera camera = view_of(scene);
  CHECK(std::abs(camera.position.x) < 2);
  CHECK(std::abs(camera.position.y) < 1.3f);
  CHECK(std::abs(camera.position.z) < 2.5f);
  CHECK(share_of_height(camera, scene.meshes.back().positions) <= 1);
}

TEST_CASE("a card is looked at from the side that it shows") {
  for (const Vec3f normal : {Vec3f(0, 0, 1), Vec3f(0, 0, -1), Vec3f(1, 0, 0), Vec3f(-1, 0, 0),
                             Vec3f(0, 1, 0), Vec3f(0.6f, 0, -0.8f)}) {
    scene::Scene scene;
    const Vec3f u = std::abs(normal.y) > 0.5f ? Vec3f(0, 0, 1) : Vec3f(0, 1, 0);
    add_wall(scene, {0, 0, 0}, u * 0.5f, cross(normal, u), paint(false));
    const scene::Camera camera = view_of(scene);
    CHECK(dot(-camera.forward, normal) > 0.6f);
  }
}

TEST_CASE("a stray triangle far away does not make a speck of the scene") {
  scene::Scene scene;
  add_sphere(scene, {0, 1, 0}, 1, paint(false));
  add_floor(scene, 0.001f, 900, paint(false));
  CHECK(share_of_height(view_of(scene), scene.meshes[0].positions) > 0.8f);
}

TEST_CASE("a small thing beside a large one leaves both in the picture") {
  scene::Scene scene;
  add_sphere(scene, {0, 10, 0}, 10, paint(false));
  add_sphere(scene, {10.5f, 0.05f, 3}, 0.05f, paint(false));
  const scene::Camera camera = view_of(scene);
  CHECK(share_of_height(camera, scene.meshes[0].positions) <= 1);
  CHECK(share_of_height(camera, scene.meshes[1].positions) <= 1);
}

TEST_CASE("views of one scene are the same, and scale with it") {
  scene::Scene scene;
  add_floor(scene, 20, 0, paint(true));
  add_sphere(scene, {0, 0.5f, 0}, 0.5f, paint(false));
  const scene::Camera one = view_of(scene), two = view_of(scene);
  CHECK(length(one.position - two.position) == 0);
  for (scene::Mesh& mesh : scene.meshes)
    for (Vec3f& p : mesh.positions)
      p = p * 1024.0f;
  const scene::Camera large = view_of(scene);
  CHECK(length(large.position - one.position * 1024.0f) < 1e-3f * length(large.position));
  scene::Scene empty;
  CHECK(std::isfinite(view_of(empty).position.z));
}

TEST_CASE("the studio lights what the picture is of, however large the ground and the sky") {
  scene::Scene scene;
  add_floor(scene, 3000, 0, paint(false));
  add_sphere(scene, {0, 0.5f, 0}, 0.5f, paint(false));
  const scene::Camera camera = view_of(scene);
  const auto rig = render::studio_for(scene, camera, 1);
  REQUIRE(rig.ok());
  REQUIRE(rig->polygons.size() == 3);
  for (const light::PolygonLight& box : rig->polygons)
    CHECK(length(box.vertices[0]) < 10); // a few radii of the ball
}

TEST_CASE("a closed room without lights gets one under its ceiling that makes white paper white") {
  for (const bool two_sided : {false, true}) {
    scene::Scene scene;
    add_room(scene, 2, 1.3f, 2.5f, none, two_sided);
    add_sphere(scene, {0, -0.75f, -0.5f}, 0.5f, paint(false));
    close(scene);
    const scene::Camera camera = look_at({0, 0, 2}, {0, -0.5f, -1}, 1);
    const auto lights = render::studio_for(scene, camera, 1);
    REQUIRE(lights.ok());
    REQUIRE(lights->polygons.size() == 1);
    const light::PolygonLight& box = lights->polygons[0];
    CHECK(box.normal.y == doctest::Approx(-1));
    double irradiance = 0; // of a card at half height that faces it, by summing over the light
    const Vec3f a = box.vertices[1] - box.vertices[0], b = box.vertices[3] - box.vertices[0];
    Vec3f middle = box.vertices[0] + a * 0.5f + b * 0.5f;
    CHECK(middle.y < 1.3f);
    CHECK(middle.y > 1.1f);
    middle.y = 0;
    constexpr int n = 200;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec3f p = box.vertices[0] + a * ((float(i) + 0.5f) / n) + b * ((float(j) + 0.5f) / n);
        CHECK(std::abs(p.x) < 2);
        CHECK(std::abs(p.z) < 2.5f);
        const Vec3f d = p - middle;
        const double r2 = double(dot(d, d));
        irradiance += double(d.y) * double(d.y) / (r2 * r2);
      }
    irradiance *= double(box.radiance.x) * double(length(cross(a, b))) / (n * n);
    CHECK(irradiance / 3.14159265 == doctest::Approx(1).epsilon(0.01));
  }
}

} // namespace openltc::test
