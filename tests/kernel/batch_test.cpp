// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Batches of points: against a form factor from outside, and against the scalar functions for
// everything else.

#include "openltc/batch.h"
#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace openltc;

namespace {

struct Random {
  std::mt19937 engine{11};
  float between(float a, float b) { return std::uniform_real_distribution<float>(a, b)(engine); }
  Vec3f in_box(float half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
};

/// Vectors as three arrays.
struct Vectors {
  std::array<std::vector<float>, 3> values;
  void add(Vec3f v) {
    values[0].push_back(v.x);
    values[1].push_back(v.y);
    values[2].push_back(v.z);
  }
  Vec3f at(std::size_t i) const { return {values[0][i], values[1][i], values[2][i]}; }
  void to(const float* (&arrays)[3]) const {
    for (std::size_t k = 0; k < 3; ++k)
      arrays[k] = values[k].data();
  }
};

struct Points {
  Vectors position, normal, view, geometric, base_color;
  std::vector<float> metallic, roughness;

  std::size_t size() const { return roughness.size(); }
  PointBatch batch() const {
    PointBatch batch;
    batch.count = size();
    position.to(batch.position);
    normal.to(batch.normal);
    view.to(batch.view);
    geometric.to(batch.geometric_normal);
    base_color.to(batch.base_color);
    batch.metallic = metallic.data();
    batch.roughness = roughness.data();
    return batch;
  }
  Surface surface(std::size_t i, const Lobes& lobes) const {
    Material material;
    material.base_color = base_color.at(i);
    material.metallic = metallic[i];
    material.roughness = roughness[i];
    return make_surface(position.at(i), normal.at(i), view.at(i), material, lobes, geometric.at(i));
  }
};

Points random_points(std::size_t count) {
  Random random;
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f n = random.in_box(1);
    points.position.add(random.in_box(1));
    points.normal.add(n);
    points.view.add(random.in_box(1));
    points.geometric.add(n + random.in_box(0.3f));
    points.base_color.add({random.between(0, 1), random.between(0, 1), random.between(0, 1)});
    points.metallic.push_back(i % 3 == 0 ? 1.0f : 0.0f);
    points.roughness.push_back(random.between(0.1f, 1));
  }
  return points;
}

struct Radiance {
  std::array<std::vector<float>, 3> values;
  explicit Radiance(std::size_t count, float fill = -1) {
    for (auto& channel : values)
      channel.assign(count, fill);
  }
  std::array<float*, 3> arrays() { return {values[0].data(), values[1].data(), values[2].data()}; }
};

Radiance shaded(const PointBatch& points, const BatchLights& lights, const Lobes& lobes,
                const BatchOptions& options = {}) {
  Radiance out(points.count);
  const char* error = shade_batch(points, lights, lobes, out.arrays().data(), options);
  CHECK(error == nullptr);
  return out;
}

const Polygon k_panel = Polygon::rectangle({0.3f, 1.5f, 0.2f}, {0.5f, 0, 0}, {0, 0.1f, 0.4f}, true);
const Ellipse k_disk = disk({-1, 1, 0.5f}, {0.3f, -1, 0}, 0.4f);
const Sphere k_ball{{0.5f, -1.6f, 0.3f}, 0.3f};
const Tube k_tube{{-1, 1.5f, 1}, {1, 1.4f, 1.2f}, 0.05f, TubeCaps::round};
const Line k_line{{1.5f, -1, 0}, {1.6f, 1, 0.5f}};
const PointLight k_point{{1, 1.5f, -1}, {3, 2, 1}, 4};
const SpotLight k_spot{{-1.5f, 1, -1}, {1, -1, 1}, {9, 9, 8}, 0, 0.2f, 0.9f};
const DirectionalLight k_sun{{0.2f, -1, 0.3f}, {2, 2, 2}};

} // namespace

TEST_CASE("a floor under a square lamp has the light that its form factor says") {
  // From an element to a parallel square of side 1 m in a distance of 1 m, over its corner: Howell,
  // "A Catalog of Radiation Heat Transfer Configuration Factors", B-4. Of index 1 a dielectric
  // reflects nothing specularly but at grazing angles, which `specular` 0 takes away.
  const double a = 1 / std::sqrt(2.0);
  const double factor = 2 * a * std::atan(a) / (2 * 3.14159265358979);
  const std::vector<float> zero(3, 0.0f), one(3, 1.0f), roughness = {0.1f, 0.5f, 1.0f};
  PointBatch points;
  points.count = 3;
  for (int axis = 0; axis < 3; ++axis) {
    points.position[axis] = zero.data();
    points.normal[axis] = axis == 1 ? one.data() : zero.data();
    points.view[axis] = axis == 0 ? zero.data() : one.data();
  }
  points.roughness = roughness.data();
  points.material.base_color = {0.25f, 0.5f, 1};
  points.material.specular = 0;
  BatchLights lights;
  REQUIRE(lights.add(Polygon::rectangle({0.5f, 1, 0.5f}, {0.5f, 0, 0}, {0, 0, 0.5f}), {8, 8, 8}));
  for (const char* kernel : {"scalar", "auto"}) {
    const Radiance out = shaded(points, lights, built_in_table(), {1, kernel});
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(out.values[c][i] == doctest::Approx(8 * factor *
                                                  (c == 0   ? 0.25
                                                   : c == 1 ? 0.5
                                                            : 1))
                                      .epsilon(1e-4));
  }
}

TEST_CASE("a batch is the sum of the scalar functions, in every kernel and by every light") {
  const Points points = random_points(1037); // no multiple of any width, more than a block
  struct Form {
    Lobes lobes;
    BatchOptions options;
    void (*ask)(Surface&);
  };
  Form forms[] = {{built_in_polynomial(), {}, [](Surface&) {}},
                  {built_in_table(), {}, correct_at_mean},
                  {built_in_two_lobe_table(), {}, make_adaptive},
                  {built_in_table(), {}, make_exact}};
  forms[1].options.correct_at_mean = true;
  forms[2].options.adaptive = true;
  forms[3].options.exact = true;
  for (Form& form : forms) {
    const Lobes& lobes = form.lobes;
    BatchLights lights;
    REQUIRE(lights.add(k_panel, {5, 4, 3}));
    REQUIRE(lights.add(k_disk, {9, 9, 9}));
    REQUIRE(lights.add(k_ball, {7, 1, 2}));
    REQUIRE(lights.add(k_tube, {30, 30, 20}));
    REQUIRE(lights.add(k_line, {1, 2, 3}));
    REQUIRE(lights.add(k_point));
    REQUIRE(lights.add(k_spot));
    REQUIRE(lights.add(k_sun));
    CHECK(lights.size() == 8);
    int kernels = 0;
    for (const char* kernel : {"scalar", "sse4", "avx2", "avx512", "neon"}) {
      Radiance out(points.size());
      form.options.threads = 1;
      form.options.kernel = kernel;
      if (shade_batch(points.batch(), lights, lobes, out.arrays().data(), form.options)) continue;
      ++kernels;
      int lit = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        Surface s = points.surface(i, lobes);
        form.ask(s);
        const Vec3f sum = shade(s, k_panel, {5, 4, 3}) + shade(s, k_disk, {9, 9, 9}) +
                          shade(s, k_ball, {7, 1, 2}) + shade(s, k_tube, {30, 30, 20}) +
                          shade(s, k_line, {1, 2, 3}) + shade(s, k_point) + shade(s, k_spot) +
                          shade(s, k_sun);
        CAPTURE(i);
        CAPTURE(std::string(kernel));
        // Directions are normalised in other ways: an ulp of them, over a lobe's width.
        const double expected[] = {double(sum.x), double(sum.y), double(sum.z)};
        for (std::size_t c = 0; c < 3; ++c)
          CHECK(std::abs(double(out.values[c][i]) - expected[c]) <= 2e-4 * (1 + expected[c]));
        lit += sum.y > 0;
      }
      CHECK(lit > 500);
    }
    CHECK(kernels >= 1);
  }
}

TEST_CASE("a batch is the same for any number of threads, and any other points beside") {
  const Points points = random_points(3000);
  BatchLights lights;
  REQUIRE(lights.add(k_panel, {5, 4, 3}));
  REQUIRE(lights.add(k_ball, {7, 1, 2}));
  const Radiance one = shaded(points.batch(), lights, built_in_table(), {1, "auto"});
  const Radiance many = shaded(points.batch(), lights, built_in_table(), {4, "auto"});
  PointBatch few = points.batch();
  few.count = 1;
  const Radiance first = shaded(few, lights, built_in_table());
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(one.values[c] == many.values[c]);
    CHECK(first.values[c][0] == one.values[c][0]);
  }
}

TEST_CASE("lights move with their set") {
  const Points points = random_points(40);
  BatchLights lights;
  REQUIRE(lights.add(k_panel, {5, 4, 3}));
  const Radiance before = shaded(points.batch(), lights, built_in_table());
  BatchLights moved = std::move(lights);
  for (int i = 0; i < 200; ++i)
    REQUIRE(moved.add(k_panel, {0, 0, 0}));
  CHECK(shaded(points.batch(), moved, built_in_table()).values[1] == before.values[1]);
  moved.clear();
  CHECK(moved.size() == 0);
  const Radiance dark = shaded(points.batch(), moved, built_in_table());
  for (const float v : dark.values[0])
    CHECK(v == 0);
}

TEST_CASE("what cannot be shaded is black or refused, and never NaN") {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  BatchLights lights;
  CHECK_FALSE(lights.add(Polygon(), {1, 1, 1}));
  CHECK_FALSE(lights.add(k_panel, {nan, 1, 1}));
  CHECK_FALSE(lights.add(k_panel, {1, -1, 1}));
  CHECK_FALSE(lights.add(k_ball, {infinity, 1, 1}));
  CHECK_FALSE(lights.add(Sphere{{0, nan, 0}, 1}, {1, 1, 1}));
  CHECK_FALSE(lights.add(Tube{{0, 0, 0}, {0, 0, 0}, 1, TubeCaps::flat}, {1, 1, 1}));
  CHECK_FALSE(lights.add(Line{{0, 0, 0}, {0, infinity, 0}}, {1, 1, 1}));
  CHECK_FALSE(lights.add(SpotLight{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, 0, 0, 1}));
  CHECK_FALSE(lights.add(DirectionalLight{{0, nan, 0}, {1, 1, 1}}));
  CHECK(lights.size() == 0);
  REQUIRE(lights.add(k_panel, {1e19f, 1, 1}));
  REQUIRE(lights.add(k_line, {1, 1, 1}));
  REQUIRE(lights.add(k_point));

  Points points = random_points(64);
  const float bad[] = {nan, infinity, -infinity, 0, 1e30f};
  std::size_t i = 0;
  for (const float value : bad)
    for (Vectors* vectors : {&points.position, &points.normal, &points.view, &points.geometric})
      vectors->values[i % 3][i] = value, ++i;
  for (const float value : bad) {
    points.roughness[i++] = value;
    points.metallic[i++] = value;
    points.base_color.values[0][i++] = value;
  }
  REQUIRE(i < points.size());
  const Radiance out = shaded(points.batch(), lights, built_in_table());
  for (const auto& channel : out.values)
    for (const float v : channel) {
      CHECK(std::isfinite(v));
      CHECK(v >= 0);
    }
  CHECK(out.values[0][0] == 0); // a position that is not a number

  PointBatch batch = points.batch();
  Radiance kept(points.size(), 7);
  const auto error = [&](const Lobes& lobes = built_in_table(), const BatchOptions& options = {}) {
    const char* text = shade_batch(batch, lights, lobes, kept.arrays().data(), options);
    return std::string(text ? text : "");
  };
  batch.view[1] = nullptr;
  CHECK(error().find("views") != std::string::npos);
  batch = points.batch();
  batch.base_color[2] = nullptr;
  CHECK(error().find("base_color") != std::string::npos);
  batch = points.batch();
  CHECK(error(Lobes()).find("lobes") != std::string::npos);
  CHECK(error(built_in_table(), {0, "abacus"}).find("kernel") != std::string::npos);
  CHECK(shade_batch(batch, lights, built_in_table(), nullptr) != nullptr);
  CHECK(kept.values[0][0] == 7);
  batch.count = 0;
  CHECK(error().empty());
  CHECK(std::string(batch_kernel()).size() > 3);
}
