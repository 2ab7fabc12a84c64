// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Arrays of points get what shade() gives one by one, however they are stored.

#include "tests/c_api/c_lights.h"
#include "tests/c_api/c_points.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

using namespace openltc;
using namespace openltc::testing;

namespace {

// Lanes fuse multiply and add, and normalise directions in other ways than the scalar functions: an
// ulp of them, over a lobe's width.
constexpr double k_lanes_apart = 1e-3;

Vec3f shade_all(const Surface& surface, const std::vector<CppLight>& lights) {
  Vec3f sum(0.0f);
  for (const CppLight& l : lights)
    sum +=
        std::visit([&](const auto& light) { return shade(surface, light, l.radiance); }, l.light);
  return sum;
}

std::vector<float> shade_in_c(const openltc_lobes* lobes, const openltc_lights* lights,
                              const openltc_points& points, int32_t threads = 1) {
  std::vector<float> radiance(3 * points.count, -1.0f);
  REQUIRE(openltc_shade(lobes, lights, &points, threads, radiance.data()) == OPENLTC_OK);
  return radiance;
}

} // namespace

TEST_CASE("every_light_gives_what_the_cpp_api_does") {
  const std::vector<Vertex> vertices = random_vertices(700); // more than a part
  const openltc_points points = points_of(vertices);
  const AllLights all;
  for (const int32_t form : {OPENLTC_TABLE, OPENLTC_POLYNOMIAL, OPENLTC_TWO_LOBE_TABLE}) {
    const LobesHandle lobes = built_in_lobes(form);
    const Lobes cpp_lobes = form == OPENLTC_TABLE        ? built_in_table()
                            : form == OPENLTC_POLYNOMIAL ? built_in_polynomial()
                                                         : built_in_two_lobe_table();
    const std::vector<float> radiance = shade_in_c(lobes.get(), all.c.get(), points);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3f expected = shade_all(surface_of(vertices[i], cpp_lobes), all.cpp);
      CAPTURE(i);
      CHECK(radiance[3 * i] == doctest::Approx(expected.x).epsilon(k_lanes_apart));
      CHECK(radiance[3 * i + 1] == doctest::Approx(expected.y).epsilon(k_lanes_apart));
      CHECK(radiance[3 * i + 2] == doctest::Approx(expected.z).epsilon(k_lanes_apart));
    }
  }
}

TEST_CASE("parts_have_the_bits_of_the_cpp_api") {
  const std::vector<Vertex> vertices = random_vertices(300);
  const openltc_points points = points_of(vertices);
  const LobesHandle lobes = built_in_lobes();
  const AllLights all;
  std::vector<float> diffuse(3 * points.count), specular(3 * points.count);
  REQUIRE(openltc_shade_parts(lobes.get(), all.c.get(), &points, 0, diffuse.data(),
                              specular.data()) == OPENLTC_OK);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Surface surface = surface_of(vertices[i], built_in_table());
    Vec3f from_diffuse(0.0f), from_specular(0.0f);
    for (const CppLight& l : all.cpp) {
      const ShadedParts parts =
          std::visit([&](const auto& light) { return shade_parts(surface, light); }, l.light);
      from_diffuse += parts.diffuse * l.radiance;
      from_specular += parts.specular * l.radiance;
    }
    CHECK(diffuse[3 * i + 1] == from_diffuse.y);
    CHECK(specular[3 * i + 1] == from_specular.y);
  }
}

TEST_CASE("each_kind_of_light_by_itself_lights_points") {
  const std::vector<Vertex> vertices = random_vertices(100);
  const AllLights all;
  REQUIRE(openltc_lights_count(all.c.get()) == all.cpp.size());
  for (std::size_t kind = 0; kind < all.cpp.size(); ++kind) {
    CAPTURE(all.kinds[kind]);
    int lit = 0;
    for (const Vertex& v : vertices)
      lit += shade_all(surface_of(v, built_in_table()), {all.cpp[kind]}).x > 0;
    CHECK(lit > 30);
  }
}

TEST_CASE("strides_and_threads_change_nothing") {
  const std::vector<Vertex> vertices = random_vertices(2000); // several parts
  openltc_points points = points_of(vertices);
  const LobesHandle lobes = built_in_lobes();
  const LightsHandle lights = no_lights();
  const float center[3] = {0.2f, 1, 0}, nits[3] = {1, 2, 3};
  REQUIRE(openltc_lights_add_sphere(lights.get(), center, 0.3f, nits) == OPENLTC_OK);
  const std::vector<float> expected = shade_in_c(lobes.get(), lights.get(), points, 1);
  CHECK(shade_in_c(lobes.get(), lights.get(), points, 0) == expected);
  CHECK(shade_in_c(lobes.get(), lights.get(), points, 3) == expected);

  // Separate arrays without gaps.
  std::vector<float> positions, normals;
  std::vector<openltc_material> materials;
  for (const Vertex& v : vertices) {
    positions.insert(positions.end(), v.position, v.position + 3);
    normals.insert(normals.end(), v.normal, v.normal + 3);
    materials.push_back(v.material);
  }
  points.positions = {positions.data(), 0};
  points.normals = {normals.data(), 12};
  points.materials = {materials.data(), 0};
  CHECK(shade_in_c(lobes.get(), lights.get(), points, 1) == expected);

  // One value for all, wherever it lies.
  std::vector<unsigned char> odd(sizeof(float) * 3 + 1);
  std::memcpy(odd.data() + 1, vertices[5].position, sizeof(float) * 3);
  const void* unaligned = odd.data() + 1;
  points.positions = {static_cast<const float*>(unaligned), OPENLTC_SAME};
  points.views.stride = points.normals.stride = points.materials.stride = OPENLTC_SAME;
  points.views.data = vertices[5].view;
  points.normals.data = vertices[5].normal;
  points.materials.data = &vertices[5].material;
  points.geometric_normals = {vertices[5].geometric, OPENLTC_SAME};
  points.position_errors = {&vertices[5].error, OPENLTC_SAME};
  const std::vector<float> same = shade_in_c(lobes.get(), lights.get(), points, 1);
  for (std::size_t i = 0; i < points.count; ++i)
    REQUIRE(std::memcmp(&same[3 * i], &expected[15], 12) == 0);
}

TEST_CASE("what_is_optional_may_be_null") {
  const std::vector<Vertex> vertices = random_vertices(50);
  openltc_points points = points_of(vertices);
  points.geometric_normals = {};
  points.position_errors = {};
  const LobesHandle lobes = built_in_lobes();
  const AllLights all;
  const std::vector<float> radiance = shade_in_c(lobes.get(), all.c.get(), points);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    Material material;
    material.base_color = vector_of(v.material.base_color);
    material.metallic = v.material.metallic;
    material.roughness = v.material.roughness;
    material.specular = v.material.specular;
    material.specular_color = vector_of(v.material.specular_color);
    material.ior = v.material.ior;
    const Surface surface = make_surface(vector_of(v.position), vector_of(v.normal),
                                         vector_of(v.view), material, built_in_table());
    CHECK(radiance[3 * i] == doctest::Approx(shade_all(surface, all.cpp).x).epsilon(k_lanes_apart));
  }
}

TEST_CASE("no_number_of_a_point_makes_nan_or_infinity") {
  const AllLights all;
  const LobesHandle lobes = built_in_lobes();
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity(),
                       std::numeric_limits<float>::max(),
                       -1e20f,
                       0.0f};
  std::vector<Vertex> vertices;
  const Vertex sound = random_vertices(1).front();
  for (std::size_t place = 0; place < sizeof(Vertex) / sizeof(float); ++place)
    for (const float value : bad) {
      vertices.push_back(sound);
      std::memcpy(reinterpret_cast<unsigned char*>(&vertices.back()) + place * sizeof(float),
                  &value, sizeof(float));
    }
  for (const float x : shade_in_c(lobes.get(), all.c.get(), points_of(vertices))) {
    REQUIRE(std::isfinite(x));
    REQUIRE(x >= 0);
  }
}

TEST_CASE("every_thread_has_its_own_last_error") {
  CHECK(openltc_lights_clear(nullptr) == OPENLTC_INVALID_ARGUMENT);
  std::string other = "unset";
  std::thread([&] { other = openltc_last_error(); }).join();
  CHECK(other.empty());
  CHECK(last_error_says("lights is null"));
}
