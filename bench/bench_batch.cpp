// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points by lights through the public API: the scalar functions, and a batch in lanes, one thread.
//
// items_per_second counts pairs of a point and a light.

#include "openltc/batch.h"
#include "openltc/openltc.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

using namespace openltc;

namespace {

constexpr std::size_t k_points = 4096;

struct Floor {
  std::array<std::vector<float>, 3> position, normal, view;
  std::vector<Polygon> lamps;

  explicit Floor(std::size_t lights) {
    for (std::size_t i = 0; i < k_points; ++i) {
      const float x = float(i % 64) / 16 - 2, z = float(i / 64) / 16 - 2;
      const float p[3] = {x, 0, z}, n[3] = {0, 1, 0}, v[3] = {-x, 1.5f, 4 - z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[axis].push_back(p[axis]);
        normal[axis].push_back(n[axis]);
        view[axis].push_back(v[axis]);
      }
    }
    for (std::size_t k = 0; k < lights; ++k)
      lamps.push_back(Polygon::rectangle({float(k) * 0.3f - 1, 1, 0}, {0.1f, 0, 0}, {0, 0, 0.4f}));
  }
};

Vec3f at(const std::array<std::vector<float>, 3>& arrays, std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

void scalar(benchmark::State& state) {
  const Floor floor(std::size_t(state.range(0)));
  const Material material;
  for (auto _ : state) {
    Vec3f sum(0.0f);
    for (std::size_t i = 0; i < k_points; ++i) {
      const Surface surface = make_surface(at(floor.position, i), at(floor.normal, i),
                                           at(floor.view, i), material, built_in_table());
      for (const Polygon& lamp : floor.lamps)
        sum += shade(surface, lamp);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(k_points) * state.range(0));
}
BENCHMARK(scalar)->Arg(1)->Arg(8);

void batch(benchmark::State& state) {
  const Floor floor(std::size_t(state.range(0)));
  BatchLights lights;
  for (const Polygon& lamp : floor.lamps)
    lights.add(lamp, Vec3f(1));
  PointBatch points;
  points.count = k_points;
  std::array<std::vector<float>, 3> radiance;
  float* out[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points.position[axis] = floor.position[axis].data();
    points.normal[axis] = floor.normal[axis].data();
    points.view[axis] = floor.view[axis].data();
    radiance[axis].resize(k_points);
    out[axis] = radiance[axis].data();
  }
  for (auto _ : state) {
    shade_batch(points, lights, built_in_table(), out, {1, "auto"});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(k_points) * state.range(0));
}
BENCHMARK(batch)->Arg(1)->Arg(8);

} // namespace

BENCHMARK_MAIN();
