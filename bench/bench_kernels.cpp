// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Nanoseconds per surface point and light of the closed form, diffuse and specular, both horizons
// clipped, look-up of the lobe included: every kernel of this machine in one run. Then the same
// with lobes from polynomials instead of the table, and the two look-ups by themselves.

#include "bench/lookup.h"
#include "openltc/light/packed_polygon.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/point_buffer.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <benchmark/benchmark.h>

#include <algorithm>
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

/// The built-in polynomial with terms left out or, of coefficient 0, added: as much work as any of
/// that degree. Degree 0 stands for the table.
table::LobePolynomial polynomial_of_degree(int degree) {
  const table::LobePolynomial& from = table::builtin_ggx_polynomial();
  table::LobePolynomial p;
  p.degree = degree;
  p.coefficients.assign(std::size_t(table::polynomial_terms(degree)) * p.k_channels, 0.0f);
  for (int j = 0, term = 0; j <= degree; ++j)
    for (int i = 0; i <= degree - j; ++i, ++term)
      for (int k = 0, source = 0; k <= from.degree; ++k)
        for (int l = 0; l <= from.degree - k; ++l, ++source)
          if (k == j && l == i) std::copy_n(from.term(source), p.k_channels, p.term(term));
  return p;
}

void shade(benchmark::State& state, render::Kernel kernel, int light_count, bool clipped,
           int degree) {
  const table::LobePolynomial polynomial = polynomial_of_degree(degree);
  const render::LightSet lights = render::pack_lights(quads(light_count, clipped));
  render::KernelContext context;
  context.table = table::builtin_ggx_table().view();
  if (degree > 0) context.polynomial = polynomial.view();
  context.area_lights = lights.area_lights.data();
  context.area_light_count = int(lights.area_lights.size());
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

void look_up(benchmark::State& state, bench::Lookup lookup, int degree) {
  const table::LobePolynomial polynomial = polynomial_of_degree(degree);
  const LobeTableView table = table::builtin_ggx_table().view();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> roughness(k_points), cos_theta(k_points), out(6 * k_points);
  for (int i = 0; i < k_points; ++i) {
    roughness[std::size_t(i)] = uniform(random);
    cos_theta[std::size_t(i)] = uniform(random);
  }
  for (auto _ : state) {
    lookup(table, degree > 0 ? polynomial.view() : LobePolynomialView(), roughness.data(),
           cos_theta.data(), k_points, out.data());
    benchmark::DoNotOptimize(out.data());
  }
  state.counters["ns/point"] =
      benchmark::Counter(1e-9 * double(k_points), benchmark::Counter::kIsIterationInvariantRate |
                                                      benchmark::Counter::kInvert);
}

struct NamedLookup {
  const char* name;
  bench::Lookup lookup;
};

const NamedLookup k_lookups[] = {{"scalar", bench::lookup_scalar},
#if defined(__x86_64__)
                                 {"sse4", bench::lookup_sse4},
                                 {"avx2", bench::lookup_avx2},
                                 {"avx512", bench::lookup_avx512}
#elif defined(__aarch64__)
                                 {"neon", bench::lookup_neon}
#endif
};

std::string form(int degree) {
  return degree > 0 ? "polynomial_" + std::to_string(degree) : "table";
}

} // namespace

int main(int argc, char** argv) {
  const auto register_one = [](const std::string& name, auto... arguments) {
    return benchmark::RegisterBenchmark(name.c_str(), arguments...);
  };
  for (const char* name : {"scalar", "sse4", "avx2", "avx512", "neon"}) {
    const render::Kernel kernel = render::kernel_by_name(name);
    if (!kernel.shade) continue;
    const std::string suffix = std::string("/") + name;
    for (const int lights : {1, 5, 50})
      register_one("quads_above" + suffix + "/" + std::to_string(lights), shade, kernel, lights,
                   false, 0);
    register_one("quads_clipped" + suffix + "/5", shade, kernel, 5, true, 0);
    for (const int degree : {0, 3, 4, 5, 6})
      register_one("one_quad_lobes_from_" + form(degree) + suffix, shade, kernel, 1, false, degree);
    for (const NamedLookup& l : k_lookups)
      if (l.name == std::string(name))
        for (const int degree : {0, 3, 4, 5, 6})
          register_one("look_up_" + form(degree) + suffix, look_up, l.lookup, degree);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
