// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One source, three number types: every public function in lanes, float and double.
//
// Lanes and float run the same operations in the same order; what may differ is a fused
// multiply-add, which the compiler makes of Highway's Mul and Add only where asked, and Highway's
// own sine and cosine. So they agree to a few units in the last place, magnified by how sensitive
// the function is to its inputs.

#include "openltc/light/emission_stack.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"
#include "parity.h"
#include "polygon_fixture.h"
#include "random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace openltc::f32 {
#include "parity_body.inc"
}
namespace openltc::f64 {
#include "parity_body.inc"
}

using namespace openltc;
using testing::Random;

namespace {

constexpr int k_count = 4096;

struct Batch {
  std::vector<float> in = std::vector<float>(std::size_t(testing::k_parity_inputs) * k_count);
};

// Everything is drawn in double and rounded once, so that all number types get the same numbers.
Batch make_batch(Random& random) {
  Batch batch;
  for (int i = 0; i < k_count; ++i) {
    int k = 0;
    const auto put = [&](double x) { batch.in[std::size_t(k++ * k_count + i)] = float(x); };
    const auto put3 = [&](Vec3d v) {
      put(v.x);
      put(v.y);
      put(v.z);
    };
    const double roughness = random.log_uniform(0.05, 1);
    const double theta = random.uniform(0, 1.5), c = std::cos(theta), s = std::sin(theta);
    put(roughness);
    put3(Vec3d(s, 0, c));
    put3(random.sphere());
    const Vec3d normal = random.sphere();
    Vec3d wo = random.sphere();
    if (dot(wo, normal) < 0) wo = -wo;
    put3(normal);
    put3(wo);
    const Vec3d position(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    put3(position);
    for (const double x : {0.2 + 0.7 * c, -0.8 * s, 1.3 * s, 0.2 + 1.6 * c})
      put(x);
    put(random.uniform());
    put(random.uniform());
    put3(Vec3d(random.uniform(), random.uniform(), random.uniform()));
    put3(random.sphere());
    put(random.uniform(0, 4));
    put(random.uniform(0, 3));
  }
  return batch;
}

// Tables of all sizes in turn: the built-in, and parts of it down to one column and one row.
LobeTableView table_of_round(int round) {
  const table::LobeTable& from = table::builtin_ggx_table();
  const int sizes[][2] = {{from.columns, from.rows}, {1, 1}, {1, 7}, {2, 1}, {3, 2}};
  static std::vector<float> texels;
  const int columns = sizes[round % 5][0], rows = sizes[round % 5][1];
  texels.clear();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      // Nodes spread over the whole table, without its first column, a mirror.
      const float* texel = from.texel(from.columns - 1 - x * (from.columns - 1) / columns,
                                      y * (from.rows - 1) / rows);
      texels.insert(texels.end(), texel, texel + table::LobeTable::k_channels);
    }
  return {texels.data(), columns, rows};
}

// Profiles of several sizes in turn: smooth, of one column, of one row, of a single value.
ProfileView profile_of_round(int round) {
  const int sizes[][2] = {{25, 19}, {1, 91}, {9, 1}, {1, 1}, {2, 2}};
  static std::vector<float> values;
  const int columns = sizes[round % 5][0], rows = sizes[round % 5][1];
  values.clear();
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      values.push_back(
          float(0.5 + 0.3 * std::cos(6.283185 * i / columns) + 0.2 * std::sin(3.0 * j / rows)));
  return {values.data(), columns, rows};
}

// A disk whose picture is noise of 48 x 40 pixels.
const EmissionTextureView& emission() {
  static const light::EmissionStack stack = [] {
    Random random(67);
    image::Image picture(48, 40, 3);
    for (float& value : picture.data)
      value = float(random.uniform());
    light::EllipseLight disk;
    disk.center = {0.4f, -0.3f, 1.2f};
    disk.half_u = {0.8f, 0.3f, 0};
    disk.half_v = {-0.3f, 0.8f, 0};
    disk.radiance = {1, 1, 1};
    light::place_picture(disk, 0, {1, 0, 0});
    return std::move(*light::build_emission_stack(picture, disk));
  }();
  return stack.view;
}

testing::ParityResources resources_of_round(int round, const testing::TestPolygon& polygon) {
  return {table_of_round(round), table::builtin_ggx_polynomial().view(), polygon.view(),
          profile_of_round(round), emission()};
}

// Runs the scalar form of one number type over a batch.
template <class R, class Evaluate>
int run_scalar(const Batch& batch, const testing::ParityResources& resources, Evaluate evaluate,
               std::vector<R>& out, const char** names) {
  out.resize(std::size_t(testing::k_parity_max_outputs) * k_count);
  int outputs = 0;
  for (int i = 0; i < k_count; ++i) {
    R inputs[testing::k_parity_inputs], results[testing::k_parity_max_outputs];
    for (int k = 0; k < testing::k_parity_inputs; ++k)
      inputs[k] = R(batch.in[std::size_t(k * k_count + i)]);
    outputs = evaluate(inputs, resources, results, names);
    for (int k = 0; k < outputs; ++k)
      out[std::size_t(k * k_count + i)] = results[k];
  }
  return outputs;
}

// Choices, a hit or the part that is sampled, may fall differently within rounding of their border.
bool is_choice(const std::string& name) {
  return name.find(".hit") != std::string::npos || name.find(".choice") != std::string::npos ||
         name == "apex_side";
}

struct Comparison {
  std::map<std::string, double> worst; // by function
  double largest = 0;
  std::string where;
  int flipped = 0;
  bool finite = true;
};

// Difference over max(|value|, 1): densities are relative, shares and directions absolute.
template <class A, class B>
void compare(const std::vector<A>& a, const std::vector<B>& b, int outputs, const char** names,
             Comparison& result) {
  for (int k = 0; k < outputs; ++k) {
    for (int i = 0; i < k_count; ++i) {
      const double x = double(a[std::size_t(k * k_count + i)]);
      const double y = double(b[std::size_t(k * k_count + i)]);
      if (!std::isfinite(x)) result.finite = false;
      const double difference = std::abs(x - y) / std::max(std::abs(y), 1.0);
      if (is_choice(names[k])) {
        result.flipped += difference > 1e-3;
        continue;
      }
      double& worst = result.worst[names[k]];
      worst = std::max(worst, difference);
      if (difference > result.largest) {
        result.largest = difference;
        result.where = names[k];
      }
    }
  }
}

void check_lanes(testing::ParityRun run, int lanes) {
  Random random(61);
  Comparison result;
  int outputs = 0;
  for (int round = 0; round < 5; ++round) {
    const Batch batch = make_batch(random);
    const testing::Plane p = testing::random_plane(random, Vec3d(0, 0, 0));
    const testing::TestPolygon polygon(testing::shape(round), p.origin, p.u, p.v, round % 2 == 1);
    const char* names[testing::k_parity_max_outputs] = {};
    std::vector<float> scalar, vector(std::size_t(testing::k_parity_max_outputs) * k_count);
    const testing::ParityResources resources = resources_of_round(round, polygon);
    outputs = run_scalar(batch, resources, f32::parity_evaluate, scalar, names);
    CHECK(run(batch.in.data(), k_count, resources, vector.data()) == outputs);
    compare(vector, scalar, outputs, names, result);
  }
  MESSAGE(lanes, " lanes: largest difference from float ", result.largest, " in ", result.where,
          "; choices that fell differently ", result.flipped);
  CHECK(result.finite);
  // Lanes fuse multiply and add and take their inverse square roots by a Newton step: a few units
  // in the last place, 1e-6, and more only where a function magnifies its input's rounding.
  const std::map<std::string, double> bounds = {
      // the tangent of a view close to the normal is a difference of nearly equal vectors
      {"shading_frame", 1e-5},
      {"to_shading", 1e-5},
      {"to_world", 1e-5},
      {"make_surface", 1e-5},
      // wo.h = sqrt((1 + wo.wi)/2) magnifies the rounding of opposite directions, at grazing views
      {"make_surface.axis_weight", 2e-4},
      // narrow lobes magnify the rounding of directions by 1/alpha, here up to 400
      {"sample_ggx", 1e-4},
      {"eval_ggx", 1e-4},
      {"eval_ggx_terms", 1e-4},
      {"pdf_ggx", 1e-4},
      {"eval_surface", 1e-4},
      {"eval_surface_ltc", 1e-4},
      {"pdf_surface", 1e-4},
      {"sample_surface", 1e-4},
      {"mirror_from_lobe", 1e-4},
      {"eval_lobe", 1e-4},
      {"pdf_lobe", 1e-4},
      // one edge by itself may pass right by the pole of its plane; the sum of an outline does not
      {"edge_term", 1e-5},
      {"edge_term_above", 1e-5},
      {"clipped_edge_term", 1e-3},
      {"integrate_polygon", 5e-5},
      {"shade_polygon", 5e-5},
      // the triangle's plane may cut right through a narrow lobe
      {"shade_polygon.tilted", 2e-4},
      // the axes of cells turn quickly where the lobe is nearly round on the light
      {"emission_seen.diffuse", 2e-4},
      {"emission_seen.specular", 2e-4},
      {"integrate_ellipse", 5e-5},
      {"integrate_sphere", 5e-5},
      {"integrate_tube", 1e-4},
      {"integrate_line", 1e-4},
      {"intersect_tube", 5e-3},
      {"sample_tube", 3e-5},
      {"sample_line", 1e-5},
      {"tube_emission", 5e-4},
      {"sample_ellipse", 1e-5},
      {"sample_sphere", 1e-5},
      // thin triangles and rays that graze the plane
      {"sample_spherical_triangle", 1e-4},
      {"polygon_point_towards", 1e-3},
      // rays that graze the light's plane
      {"intersect_polygon", 1e-3},
      {"intersect_ellipse", 5e-3},
      {"intersect_seen_ellipse", 5e-3},
      {"intersect_seen_tube", 1e-5},
      {"sample_seen_ellipse", 1e-5},
      // drawn on a rim that the ray just touches
      {"sample_seen_tube", 5e-2}};
  for (const auto& entry : result.worst) {
    const std::string& name = entry.first;
    const double worst = entry.second;
    CAPTURE(name);
    const auto bound = bounds.find(name);
    CHECK(worst <= (bound != bounds.end() ? bound->second : 1.2e-6));
  }
  CHECK(result.flipped <= 5);
}

} // namespace

TEST_CASE("float follows double in every function") {
  Random random(61);
  Comparison result;
  for (int round = 0; round < 5; ++round) {
    const Batch batch = make_batch(random);
    const testing::Plane p = testing::random_plane(random, Vec3d(0, 0, 0));
    const testing::TestPolygon polygon(testing::shape(round), p.origin, p.u, p.v, round % 2 == 1);
    const char* names[testing::k_parity_max_outputs] = {};
    std::vector<float> single;
    std::vector<double> exact;
    const testing::ParityResources resources = resources_of_round(round, polygon);
    const int outputs = run_scalar(batch, resources, f32::parity_evaluate, single, names);
    CHECK(run_scalar(batch, resources, f64::parity_evaluate, exact, names) == outputs);
    compare(single, exact, outputs, names, result);
  }
  MESSAGE("largest difference ", result.largest, " in ", result.where,
          "; choices that fell differently ", result.flipped);
  CHECK(result.finite);
  for (const auto& entry : result.worst) {
    const std::string& name = entry.first;
    const double worst = entry.second;
    CAPTURE(name);
    // Rays that graze the light's plane meet it far away.
    const bool grazes =
        name == "intersect_ellipse" || name == "intersect_seen_ellipse" || name == "intersect_tube";
    // Drawn on a rim that the ray just touches.
    const bool touches = name == "sample_seen_tube";
    CHECK(worst < (touches ? 5e-2 : grazes ? 2e-2 : 2e-4));
  }
  CHECK(result.flipped <= 20);
}

#ifdef OPENLTC_PARITY_BASELINE
TEST_CASE("lanes of the baseline instruction set agree with float") {
  check_lanes(testing::parity_run_baseline, testing::parity_lanes_baseline());
}
#endif

#ifdef OPENLTC_PARITY_SSE4
TEST_CASE("lanes of SSE4 agree with float") {
  if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("aes")) {
    MESSAGE("skipped: this CPU has no SSE4");
    return;
  }
  CHECK(testing::parity_lanes_sse4() == 4);
  check_lanes(testing::parity_run_sse4, testing::parity_lanes_sse4());
}
#endif

#ifdef OPENLTC_PARITY_AVX2
TEST_CASE("lanes of AVX2 agree with float") {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    MESSAGE("skipped: this CPU has no AVX2");
    return;
  }
  CHECK(testing::parity_lanes_avx2() == 8);
  check_lanes(testing::parity_run_avx2, testing::parity_lanes_avx2());
}
#endif

#ifdef OPENLTC_PARITY_AVX512
TEST_CASE("lanes of AVX-512 agree with float") {
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512bw") ||
      !__builtin_cpu_supports("avx512dq") || !__builtin_cpu_supports("avx512vl")) {
    MESSAGE("skipped: this CPU has no AVX-512");
    return;
  }
  CHECK(testing::parity_lanes_avx512() == 16);
  check_lanes(testing::parity_run_avx512, testing::parity_lanes_avx512());
}
#endif
