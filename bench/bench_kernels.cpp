// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Nanoseconds per surface point and light of the closed form, diffuse and specular, both horizons
// clipped, look-up of the lobe included: every kernel of this machine in one run.

#include "openltc/light/packed_polygon.h"
#include "openltc/render/light_set.h"
#include "openltc/render/point_buffer.h"
#include "openltc/table/lobe_table.h"

#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

using namespace openltc;

namespace {

constexpr int k_points = 4096;

light::Lights quads(int count, bool below_horizon_too) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  light::Lights lights;
  for (int i = 0; i < count; ++i) {
    light::PolygonLight light;
    const float x = 3 * uniform(random), z = 3 * uniform(random);
    if (below_horizon_too) // a wall that reaches below the floor
      light.vertices = {{x - 1, -1, -4}, {x + 1, -1, -4}, {x + 1, 2, -4}, {x - 1, 2, -4}};
    else // a ceiling lamp
      light.vertices = {{x - 1, 4, z - 1}, {x + 1, 4, z - 1}, {x + 1, 4, z + 1}, {x - 1, 4, z + 1}};
    light.normal = below_horizon_too ? Vec3f(0, 0, 1) : Vec3f(0, -1, 0);
    light.ring_end = {4};
    light.radiance = Vec3f(1);
    lights.polygons.push_back(light);
  }
  return lights;
}

void fill(render::PointBuffer& buffer) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < k_points; ++i) {
    render::SurfacePoint p;
    p.position = {4 * uniform(random) - 2, 0, 4 * uniform(random) - 2};
    p.normal = p.geometric = {0, 1, 0};
    p.view = normalize(Vec3f(uniform(random) - 0.5f, 0.1f + uniform(random), uniform(random)));
    p.albedo = Vec3f(0.5f);
    p.f0 = Vec3f(0.04f);
    p.roughness = uniform(random);
    buffer.add(p, {std::uint32_t(i), std::uint32_t(i) % 256, 1, 0, 1});
  }
}

void shade(benchmark::State& state, render::Kernel kernel, int light_count, bool clipped) {
  const render::LightSet lights = render::pack_lights(quads(light_count, clipped));
  render::KernelContext context;
  context.table = table::builtin_ggx_table().view();
  context.polygons = lights.polygons.data();
  context.polygon_count = int(lights.polygons.size());
  render::PointBuffer buffer(k_points);
  std::vector<Vec3f> samples(k_points);
  std::vector<float> no_ratio;
  for (auto _ : state) {
    state.PauseTiming();
    fill(buffer);
    state.ResumeTiming();
    buffer.shade(kernel, context, samples, no_ratio, 256);
    benchmark::DoNotOptimize(samples.data());
  }
  state.counters["ns/point/light"] = benchmark::Counter(
      1e-9 * double(k_points) * light_count, // so that its rate is per nanosecond
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

} // namespace

int main(int argc, char** argv) {
  for (const char* name : {"scalar", "sse4", "avx2", "avx512", "neon"}) {
    const render::Kernel kernel = render::kernel_by_name(name);
    if (!kernel.shade) continue;
    for (const int lights : {1, 5, 50})
      benchmark::RegisterBenchmark(
          (std::string("quads_above/") + name + "/" + std::to_string(lights)).c_str(), shade,
          kernel, lights, false);
    benchmark::RegisterBenchmark((std::string("quads_clipped/") + name + "/5").c_str(), shade,
                                 kernel, 5, true);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
