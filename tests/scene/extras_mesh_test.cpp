// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Meshes of nodes whose extras say that they emit, or that they do not.

#include "gltf_builder.h"
#include "openltc/scene/emissive/light_surface.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace openltc;
using namespace openltc::test;

// An emissive unit square with these extras.
Result<scene::Scene> load_with_mesh(const json& extras, json node = json::object()) {
  GltfBuilder file;
  const int glow = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  json primitive = file.square_primitive();
  primitive["material"] = glow;
  node["extras"] = extras;
  node["name"] = "Lamp";
  file.add_mesh_node(primitive, node);
  return file.load();
}

TEST_CASE("a_light_stands_for_the_mesh_of_its_node") {
  // The square reaches from (0, 0) to (1, 1).
  const auto loaded = load_with_mesh(
      {{"openltc_light", {{"type", "sphere"}, {"radius", 1.25}, {"luminance_nits", 9}}}},
      {{"translation", {0, 0, 4}}});
  REQUIRE(loaded.ok());
  CHECK(loaded->meshes.size() == 1);
  CHECK(loaded->meshes[0].node == 0);
  CHECK(loaded->lights.polygons.empty());
  REQUIRE(loaded->lights.spheres.size() == 1);
  const light::SphereLight& light = loaded->lights.spheres[0];
  CHECK(double(light.surface_deviation) == doctest::Approx(std::sqrt(2.0) - 1.25).epsilon(1e-4));
  for (const Vec3f p : loaded->meshes[0].positions)
    CHECK(scene::distance_outside(light, p) <= double(light.surface_deviation) + 1e-6);

  // A light that was left out leaves the mesh its own emission.
  const auto broken = load_with_mesh({{"openltc_light", {{"type", "sphere"}, {"radius", 0}}}});
  REQUIRE(broken.ok());
  CHECK(broken->lights.polygons.size() == 1);
  // A mesh much larger than its light is no lamp's surface.
  const auto large = load_with_mesh(
      {{"openltc_light", {{"type", "sphere"}, {"radius", 0.1}, {"luminance_nits", 9}}}});
  REQUIRE(large.ok());
  CHECK(large->lights.spheres.at(0).surface_deviation == 0);
  CHECK(warns_about(*large, "beyond the light"));
}

TEST_CASE("a_mesh_may_glow_without_giving_light") {
  const auto dark = load_with_mesh({{"openltc_emits_light", false}});
  REQUIRE(dark.ok());
  CHECK(dark->lights.empty());
  CHECK(dark->materials[0].emission.x == 1);
  const auto wrong = load_with_mesh({{"openltc_emits_light", "no"}});
  REQUIRE(wrong.ok());
  CHECK(wrong->lights.polygons.size() == 1);
  CHECK(warns_about(*wrong, "openltc_emits_light"));
}

} // namespace
