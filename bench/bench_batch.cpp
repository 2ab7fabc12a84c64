// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points by lights through the public API: the scalar functions, and a batch in lanes. 64 x 64
// points lie in a core's cache with all their numbers, 512 x 512 come from memory.
//
// items_per_second counts pairs of a point and a light. threads 0: all cores.

#include "openltc/batch.h"
#include "openltc/openltc.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

using namespace openltc;

namespace {

struct Floor {
  std::size_t count;
  std::array<std::vector<float>, 3> position, normal, view;
  std::vector<Polygon> lamps;

  Floor(std::size_t side, std::size_t lights) : count(side * side) {
    for (std::size_t i = 0; i < count; ++i) {
      const float x = 4 * float(i % side) / float(side) - 2,
                  z = 4 * float(i / side) / float(side) - 2;
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
  const Floor floor(64, std::size_t(state.range(0)));
  const Material material;
  for (auto _ : state) {
    Vec3f sum(0.0f);
    for (std::size_t i = 0; i < floor.count; ++i) {
      const Surface surface = make_surface(at(floor.position, i), at(floor.normal, i),
                                           at(floor.view, i), material, built_in_table());
      for (const Polygon& lamp : floor.lamps)
        sum += shade(surface, lamp);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(floor.count) * state.range(0));
}
BENCHMARK(scalar)->ArgName("lights")->Arg(1)->Arg(8);

void batch(benchmark::State& state) {
  const Floor floor(std::size_t(state.range(0)), std::size_t(state.range(1)));
  const int threads = int(state.range(2));
  BatchLights lights;
  for (const Polygon& lamp : floor.lamps)
    lights.add(lamp, Vec3f(1));
  PointBatch points;
  points.count = floor.count;
  std::array<std::vector<float>, 3> radiance;
  float* out[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points.position[axis] = floor.position[axis].data();
    points.normal[axis] = floor.normal[axis].data();
    points.view[axis] = floor.view[axis].data();
    radiance[axis].resize(floor.count);
    out[axis] = radiance[axis].data();
  }
  for (auto _ : state) {
    shade_batch(points, lights, built_in_table(), out, {threads, "auto"});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(floor.count) * state.range(1));
}
BENCHMARK(batch)
    ->ArgNames({"side", "lights", "threads"})
    ->ArgsProduct({{64, 512}, {1, 8}, {1}})
    ->ArgsProduct({{512}, {1, 8}, {0}})
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
