// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Samples are those of the C++ API, and average to the closed form.

#include "tests/c_api/c_lights.h"
#include "tests/c_api/c_points.h"

#include <cmath>
#include <type_traits>

using namespace openltc;
using namespace openltc::testing;

namespace {

bool same(const float (&a)[3], Vec3f b) { return a[0] == b.x && a[1] == b.y && a[2] == b.z; }

template <class Light> constexpr bool is_punctual() {
  return std::is_same_v<Light, PointLight> || std::is_same_v<Light, SpotLight> ||
         std::is_same_v<Light, DirectionalLight>;
}

/// Two random-looking numbers for each point, the same every time.
std::vector<float> numbers_for(std::size_t count) {
  std::vector<float> u;
  for (std::size_t i = 0; i < 2 * count; ++i)
    u.push_back(float(i * 2654435761u % 65536) / 65536);
  return u;
}

} // namespace

TEST_CASE("samples_of_lights_are_those_of_the_cpp_api") {
  const std::vector<Vertex> vertices = random_vertices(64);
  const openltc_points points = points_of(vertices);
  const LobesHandle lobes = built_in_lobes();
  const AllLights all;
  const std::vector<float> u = numbers_for(points.count);
  std::vector<openltc_light_sample> drawn(points.count), met(points.count);
  std::vector<float> directions;
  for (std::size_t k = 0; k < all.cpp.size(); ++k) {
    CAPTURE(all.kinds[k]);
    const openltc_status status =
        openltc_sample_light(lobes.get(), all.c.get(), k, &points, 0, u.data(), drawn.data());
    std::visit(
        [&](const auto& light) {
          using Light = std::decay_t<decltype(light)>;
          if constexpr (is_punctual<Light>()) {
            CHECK(status == OPENLTC_INVALID_ARGUMENT);
            CHECK(last_error_says("no extent"));
          } else {
            REQUIRE(status == OPENLTC_OK);
            directions.clear();
            int valid = 0;
            for (std::size_t i = 0; i < points.count; ++i) {
              const Surface surface = surface_of(vertices[i], built_in_table());
              const LightSample s = sample_light(surface, light, {u[2 * i], u[2 * i + 1]});
              CHECK(drawn[i].valid == (s.valid ? 1 : 0));
              CHECK(same(drawn[i].position, s.position));
              CHECK(same(drawn[i].direction, s.direction));
              CHECK(drawn[i].pdf == s.pdf);
              CHECK(drawn[i].distance == s.distance);
              CHECK(drawn[i].cos_light == s.cos_light);
              if (s.valid) CHECK(same(drawn[i].value, eval_surface(surface, s.direction)));
              directions.insert(directions.end(), drawn[i].direction, drawn[i].direction + 3);
              valid += s.valid;
            }
            CHECK(valid > 10);
            // The ray to a drawn point meets the light, with the same density.
            REQUIRE(openltc_intersect_light(lobes.get(), all.c.get(), k, &points, 1,
                                            directions.data(), met.data()) == OPENLTC_OK);
            for (std::size_t i = 0; i < points.count; ++i)
              if constexpr (std::is_same_v<Light, Line>)
                CHECK(met[i].valid == 0);
              else if (drawn[i].valid && met[i].valid)
                CHECK(met[i].pdf == doctest::Approx(drawn[i].pdf).epsilon(0.02));
          }
        },
        all.cpp[k].light);
  }
}

TEST_CASE("many_samples_of_one_point_average_to_its_closed_form") {
  // A Lambertian, of which the closed form is exact.
  constexpr int k_side = 64;
  openltc_material material = openltc_material_default();
  material.specular = 0;
  const float origin[3] = {0, 0, 0}, up[3] = {0, 1, 0}, center[3] = {0.3f, 1, 0};
  const float nits[3] = {2, 2, 2};
  openltc_points points{};
  points.count = k_side * k_side;
  points.positions = {origin, OPENLTC_SAME};
  points.normals = points.views = {up, OPENLTC_SAME};
  points.materials = {&material, OPENLTC_SAME};
  std::vector<float> u;
  for (int i = 0; i < k_side * k_side; ++i) {
    u.push_back((float(i % k_side) + 0.5f) / k_side);
    u.push_back((float(i / k_side) + 0.5f) / k_side);
  }
  const LobesHandle lobes = built_in_lobes();
  const LightsHandle lights = no_lights();
  REQUIRE(openltc_lights_add_sphere(lights.get(), center, 0.4f, nits) == OPENLTC_OK);
  std::vector<openltc_light_sample> samples(points.count);
  REQUIRE(openltc_sample_light(lobes.get(), lights.get(), 0, &points, 0, u.data(),
                               samples.data()) == OPENLTC_OK);
  double sum = 0;
  for (const openltc_light_sample& s : samples)
    if (s.valid) sum += double(s.value[0]) * 2 / double(s.pdf);
  // A sphere above the horizon gives sin^2 of its angular radius, times the cosine, of its radiance
  // (Lambert).
  const double distance2 = 1.09, cosine = 1 / std::sqrt(distance2);
  const double exact = 2 * 0.16 / distance2 * cosine;
  CHECK(sum / double(points.count) == doctest::Approx(exact).epsilon(1e-3));
  points.count = 1;
  float radiance[3];
  REQUIRE(openltc_shade(lobes.get(), lights.get(), &points, 1, radiance) == OPENLTC_OK);
  CHECK(double(radiance[0]) == doctest::Approx(exact).epsilon(1e-5));
}

TEST_CASE("directions_of_surfaces_are_those_of_the_cpp_api") {
  const std::vector<Vertex> vertices = random_vertices(200);
  const openltc_points points = points_of(vertices);
  const LobesHandle lobes = built_in_lobes();
  const std::vector<float> u = numbers_for(points.count);
  std::vector<openltc_direction_sample> samples(points.count);
  REQUIRE(openltc_sample_surface(lobes.get(), &points, 0, u.data(), samples.data()) == OPENLTC_OK);
  std::vector<float> directions, values(3 * points.count), pdfs(points.count);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Surface surface = surface_of(vertices[i], built_in_table());
    const DirectionSample s = sample_surface(surface, {u[2 * i], u[2 * i + 1]});
    CHECK(samples[i].valid == (s.valid ? 1 : 0));
    CHECK(same(samples[i].direction, s.direction));
    CHECK(same(samples[i].value, s.value));
    CHECK(samples[i].pdf == s.pdf);
    directions.insert(directions.end(), samples[i].direction, samples[i].direction + 3);
  }
  REQUIRE(openltc_eval_surface(lobes.get(), &points, 1, directions.data(), values.data(),
                               pdfs.data()) == OPENLTC_OK);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Surface surface = surface_of(vertices[i], built_in_table());
    CHECK(values[3 * i] == eval_surface(surface, vector_of(samples[i].direction)).x);
    CHECK(pdfs[i] == pdf_surface(surface, vector_of(samples[i].direction)));
  }
}
