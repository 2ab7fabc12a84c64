// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Light that a wall holds back changes nothing: neither by being there, nor by what it makes of the
// errors that are allowed. The room is empty and convex, so that each of its own lamps is seen
// whole from every point and every shadow ratio is 1 or 0: what differs is an error, not noise.

#include "openltc/light/shapes.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace openltc;
using test::max_difference;
using test::rendered;

namespace {

constexpr float k_width = 6, k_depth = 5, k_height = 3; // metres, from 0

/// A quadrilateral seen from both sides.
void add_wall(scene::Scene& scene, Vec3f corner, Vec3f u, Vec3f v) {
  scene::Material material = test::diffuse_material({0.6f, 0.5f, 0.4f});
  material.double_sided = true;
  scene.materials.push_back(material);
  scene::Mesh mesh;
  mesh.material = int(scene.materials.size()) - 1;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.normals.assign(4, normalize(cross(u, v)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
}

void add_closed_box(scene::Scene& scene, Vec3f low, Vec3f size) {
  const Vec3f x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  for (const Vec3f& offset : {Vec3f(0, 0, 0), z})
    add_wall(scene, low + offset, x, y);
  for (const Vec3f& offset : {Vec3f(0, 0, 0), x})
    add_wall(scene, low + offset, z, y);
  for (const Vec3f& offset : {Vec3f(0, 0, 0), y})
    add_wall(scene, low + offset, x, z);
}

/// A square that shines down.
light::PolygonLight lamp(float x, float y, float z, float half, float nits) {
  return light::rectangle({x, y, z}, {half, 0, 0}, {0, 0, half}, Vec3f(nits));
}

scene::Scene room(int lamps, float nits) {
  scene::Scene scene;
  add_closed_box(scene, {0, 0, 0}, {k_width, k_height, k_depth});
  for (int i = 0; i < lamps; ++i)
    scene.lights.polygons.push_back(lamp(0.5f + 5.0f * float(i % 4) / 3, k_height - 0.02f,
                                         0.6f + 3.8f * float(i / 4) / 3, 0.15f, nits));
  scene.cameras.push_back(test::look_at({5.7f, 1.6f, 4.7f}, {1, 0.9f, 0.8f}, 1.2f));
  return scene;
}

struct Family {
  const char* name;
  void (*add)(scene::Scene&);
};

const Family k_families[] = {
    {"a sun outside",
     [](scene::Scene& scene) {
       light::PunctualLight sun;
       sun.type = light::PunctualType::directional;
       sun.direction = normalize(Vec3f(0.3f, -1, 0.2f));
       sun.intensity = Vec3f(100000);
       scene.lights.punctual.push_back(sun);
     }},
    {"a bright sky above the roof",
     [](scene::Scene& scene) { scene.lights.polygons.push_back(lamp(3, 30, 3, 40, 20000)); }},
    {"the next room's lamps",
     [](scene::Scene& scene) {
       add_closed_box(scene, {-8, 0, 0}, {7.9f, k_height, k_depth});
       for (int i = 0; i < 30; ++i) // they shine at the wall between
         scene.lights.polygons.push_back(
             light::rectangle({-1.2f - 0.2f * float(i % 5), 0.4f + 0.4f * float(i / 5), 2.5f},
                              {0, 0, -0.1f}, {0, 0.1f, 0}, Vec3f(20000)));
     }},
    {"bulbs in closed shades", [](scene::Scene& scene) {
       for (int i = 0; i < 6; ++i) {
         const Vec3f at(0.9f + 0.8f * float(i), 2.2f, 1.5f);
         add_closed_box(scene, at - Vec3f(0.06f), Vec3f(0.12f));
         light::SphereLight bulb;
         bulb.center = at;
         bulb.radius = 0.03f;
         bulb.radiance = Vec3f(20000);
         scene.lights.spheres.push_back(bulb);
       }
     }}};

render::RenderOptions small_picture() {
  render::RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.samples = 1;
  options.shadow_samples = 4;
  return options;
}

double mean(const image::Image& picture) {
  double sum = 0;
  for (const float v : picture.data)
    sum += double(v);
  return sum / double(picture.data.size());
}

float brightest(const image::Image& picture) {
  return *std::max_element(picture.data.begin(), picture.data.end());
}

} // namespace

TEST_CASE("lights that reach nothing change no pixel by more than the error that is allowed") {
  render::RenderOptions options = small_picture();
  // Shades stand in the room and cast shadows: there the lamps are compared with themselves.
  for (const Family& family : k_families) {
    CAPTURE(std::string(family.name));
    scene::Scene without = room(12, 300), with = without;
    family.add(with);
    without.meshes = with.meshes; // the same walls
    without.materials = with.materials;
    options.light_error = 0;
    const render::Picture truth = rendered(without, options);
    options.light_error = 0.003f;
    const render::Picture picture = rendered(with, options);
    CHECK(mean(truth.radiance) > 1);
    CHECK(mean(picture.radiance) == doctest::Approx(mean(truth.radiance)).epsilon(0.003));
    // What is allowed is measured by what is seen, and the sun and the sky are not.
    CHECK(picture.light_error_nits <= 0.003 * double(brightest(truth.radiance)));
    if (with.lights.spheres.empty())
      CHECK(max_difference(picture.radiance, truth.radiance) <=
            picture.light_error_nits + 1e-5 * mean(truth.radiance));
  }
}

TEST_CASE("a room with blocked lights is as bright as its reference") {
  render::RenderOptions options = small_picture();
  for (const Family& family : k_families) {
    CAPTURE(std::string(family.name));
    scene::Scene scene = room(12, 300);
    family.add(scene);
    options.integrator = render::Integrator::ltc;
    options.samples = 4;
    const double closed = mean(rendered(scene, options).radiance);
    options.integrator = render::Integrator::reference;
    options.samples = 32;
    CHECK(closed == doctest::Approx(mean(rendered(scene, options).radiance)).epsilon(0.01));
  }
}

TEST_CASE("dim lamps beside a bright one keep their light where the bright one does not reach") {
  // A wall across the room: one lamp of 20,000 nits on its far side, dim ones on both.
  scene::Scene scene = room(12, 30);
  add_wall(scene, {2.4f, 0, 0}, {0, 0, k_depth}, {0, k_height, 0});
  scene.lights.polygons.push_back(lamp(1, 2.9f, 2.5f, 0.3f, 20000));
  render::RenderOptions options = small_picture();
  options.shadow_samples = 16;
  options.light_error = 0;
  const render::Picture all = rendered(scene, options);
  options.light_error = 0.003f;
  const render::Picture chosen = rendered(scene, options);
  CHECK(mean(chosen.radiance) == doctest::Approx(mean(all.radiance)).epsilon(0.003));
  double largest = 0;
  for (std::size_t i = 0; i < all.radiance.data.size(); ++i)
    largest =
        std::max(largest, std::abs(double(all.radiance.data[i]) - double(chosen.radiance.data[i])) /
                              std::max(double(all.radiance.data[i]), 0.1));
  CHECK(largest < 0.2); // the noise of a penumbra at the wall's edges; it was 1, black blocks
}

TEST_CASE("the reference that draws some of many lights has the light of one that takes all") {
  // 300 small lamps that together are three large ones, which are few enough to be taken all.
  scene::Scene large = room(0, 0);
  large.lights.polygons = {lamp(1, 2.9f, 1, 0.5f, 200), lamp(4, 2.9f, 2, 0.5f, 500),
                           lamp(2, 2.9f, 4, 0.5f, 90)};
  scene::Scene many = large;
  many.lights.polygons.clear();
  for (const light::PolygonLight& l : large.lights.polygons)
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j) {
        const Vec3f c = (l.vertices[0] + l.vertices[2]) * 0.5f;
        many.lights.polygons.push_back(lamp(c.x - 0.45f + 0.1f * float(i), c.y,
                                            c.z - 0.45f + 0.1f * float(j), 0.05f, l.radiance.x));
      }
  for (scene::Scene* scene : {&large, &many}) {
    test::add_sphere(*scene, {3, 0.8f, 2}, 0.5f,
                     test::glossy_material({0.9f, 0.8f, 0.7f}, 0.3f, true));
    test::add_sphere(*scene, {1.5f, 0.5f, 2.5f}, 0.4f,
                     test::glossy_material({0.5f, 0.4f, 0.7f}, 0.1f, false));
  }
  render::RenderOptions options = small_picture();
  options.integrator = render::Integrator::reference;
  options.samples = 128;
  const render::Picture a = rendered(large, options), b = rendered(many, options);
  CHECK(mean(a.radiance) == doctest::Approx(mean(b.radiance)).epsilon(0.005));
  // Each pixel within what both say of their own noise; 1 in 500 may be further than 4 of it.
  int far = 0;
  for (std::size_t i = 0; i < a.radiance.data.size(); ++i) {
    const double noise =
        std::hypot(double(a.standard_error.data[i]), double(b.standard_error.data[i])) +
        1e-4 * mean(a.radiance);
    far += std::abs(double(a.radiance.data[i]) - double(b.radiance.data[i])) > 4 * noise;
  }
  CHECK(far < int(a.radiance.data.size() / 500));
}
