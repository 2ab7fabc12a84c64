// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The same picture wherever in the world a scene stands, and no surface that shadows itself.

#include "../scene/gltf_builder.h"
#include "openltc/render/renderer.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace openltc;

namespace {

image::Image rendered(const scene::Scene& scene, const scene::Camera& camera,
                      render::Integrator integrator, int shadow_samples) {
  render::RenderOptions options;
  options.width = 48;
  options.height = 32;
  options.samples = 4;
  options.integrator = integrator;
  options.shadow_samples = shadow_samples;
  auto picture = render::render(scene, camera, table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return std::move(picture->radiance);
}

using test::GltfBuilder;
using test::json;

// A floor, a slab that stands on it, a lamp of emissive squares, a disk and a bulb, below nodes
// whose translations are large and cancel but for `at`.
GltfBuilder room_at(Vec3d at) {
  GltfBuilder file;
  file.root["materials"] = json::array(
      {{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.4}}}},
       {{"emissiveFactor", {1, 1, 1}},
        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 300}}}}}}});
  const double h = std::sqrt(0.5);
  json square = file.square_primitive();
  square["material"] = 0;
  const json down = {-h, 0, 0, h}; // the square's +z becomes +y
  file.add_mesh_node(square,
                     {{"translation", {-3, 0, 3}}, {"scale", {6, 6, 1}}, {"rotation", down}});
  file.add_mesh_node(square, {{"translation", {-0.5, 0, 0}}, {"scale", {1, 0.7, 1}}});
  json lamp = square;
  lamp["material"] = 1;
  file.add_mesh_node(
      lamp,
      {{"translation", {-0.3, 2, 1.1}}, {"scale", {0.6, 0.4, 1}}, {"rotation", {h, 0, 0, h}}});
  json& nodes = file.root["nodes"];
  nodes.push_back(
      {{"extras",
        {{"openltc_light", {{"type", "disk"}, {"radius", 0.3}, {"luminance_nits", 200}}}}},
       {"rotation", {-h, 0, 0, h}},
       {"translation", {1.2, 1.6, 0.4}}});
  nodes.push_back({{"extras", {{"openltc_light", {{"type", "point"}, {"intensity_candela", 30}}}}},
                   {"translation", {-1.1, 1.3, 1.2}}});
  file.root["cameras"] =
      json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.01}}}}});
  nodes.push_back({{"camera", 0}, {"translation", {0, 1, 3.5}}, {"rotation", {-0.1, 0, 0, 0.995}}});
  nodes.push_back({{"children", {0, 1, 2, 3, 4, 5}}, {"translation", {-3e6, 8e6, 5e6}}});
  nodes.push_back({{"children", {6}}, {"translation", {at.x + 3e6, at.y - 8e6, at.z - 5e6}}});
  file.root["scenes"][0]["nodes"] = json::array({7});
  return file;
}

} // namespace

TEST_CASE("a scene looks the same at 0, 5, 500 and 6000 km") {
  const auto home = room_at({0, 0, 0}).load();
  REQUIRE(home.ok());
  REQUIRE(home->lights.area_light_count() == 2);
  for (const auto integrator : {render::Integrator::ltc, render::Integrator::reference}) {
    const image::Image wanted = rendered(*home, home->cameras.at(0), integrator, 4);
    double mean = 0;
    for (const float v : wanted.data)
      mean += double(v) / double(wanted.data.size());
    REQUIRE(mean > 1);
    for (const Vec3d at : {Vec3d(5e3, 0.1, -3.3), Vec3d(-3.7, 5e5, 5e5), Vec3d(6e6, -120.3, 6e6)}) {
      const auto far = room_at(at).load();
      REQUIRE(far.ok());
      const image::Image got = rendered(*far, far->cameras.at(0), integrator, 4);
      double difference = 0;
      std::size_t visible = 0; // a sample more or less at a shadow's edge
      for (std::size_t i = 0; i < got.data.size(); ++i) {
        const double d = std::abs(double(got.data[i]) - double(wanted.data[i]));
        difference += d / double(wanted.data.size());
        visible += d > 1e-3 * (mean + double(wanted.data[i]));
      }
      CAPTURE(at.x);
      CHECK(difference < 1e-3 * mean);
      CHECK(visible < wanted.data.size() / 50);
    }
  }
}

TEST_CASE("a plain of rounded triangles does not shadow itself, near the middle or at its rim") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double half : {3.0, 4000.0, 5e7}) {
    // A plane in a direction of its own: every coordinate is rounded.
    const Vec3d n = normalize(Vec3d(0.3, 1, -0.2));
    const Vec3d u = normalize(cross(n, Vec3d(0.1, 0.2, 1))), v = cross(n, u);
    scene::Scene scene;
    scene.materials.push_back(test::diffuse_material({0.5f, 0.5f, 0.5f}));
    scene.meshes.emplace_back();
    scene::Mesh& mesh = scene.meshes[0];
    constexpr std::uint32_t k_cells = 24;
    for (std::uint32_t j = 0; j <= k_cells; ++j)
      for (std::uint32_t i = 0; i <= k_cells; ++i) {
        const double x = half * (2 * (i + 0.4 * unit(random)) / k_cells - 1);
        const double y = half * (2 * (j + 0.4 * unit(random)) / k_cells - 1);
        mesh.positions.push_back(to_float(u * x + v * y));
        mesh.normals.push_back(to_float(n));
        const std::uint32_t a = j * (k_cells + 1) + i;
        if (i < k_cells && j < k_cells) {
          mesh.triangles.push_back({a, a + k_cells + 1, a + 1});
          mesh.triangles.push_back({a + 1, a + k_cells + 1, a + k_cells + 2});
        }
      }
    const auto& t = mesh.triangles[0];
    const Vec3f facing = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                               mesh.positions[t[2]] - mesh.positions[t[0]]);
    if (dot(to_double(facing), n) < 0)
      for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    for (const double place : {0.0, 0.9}) {
      const Vec3d middle = u * (half * place);
      light::SphereLight lamp;
      lamp.radiance = Vec3f(100);
      lamp.radius = float(half * 0.02);
      lamp.center = to_float(middle + n * (half * 0.05) + v * (half * 0.3)); // grazing
      scene.lights.spheres = {lamp};
      const scene::Camera camera = test::look_at(to_float(middle + n * (half * 0.1)),
                                                 to_float(middle + v * (half * 0.1)), 1);
      for (const auto integrator : {render::Integrator::ltc, render::Integrator::reference}) {
        const image::Image lit = rendered(scene, camera, integrator, 0);
        const image::Image shadowed = rendered(scene, camera, integrator, 4);
        CAPTURE(half);
        CAPTURE(place);
        CHECK(*std::max_element(lit.data.begin(), lit.data.end()) > 0);
        double largest = 0;
        for (std::size_t i = 0; i < lit.data.size(); ++i)
          largest = std::max(largest, std::abs(double(lit.data[i]) - double(shadowed.data[i])) /
                                          std::max(double(lit.data[i]), 1e-6));
        CHECK(largest < 1e-4);
      }
    }
  }
}
