// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Wall time of whole fits on all cores, then of their parts on one: the quadrature, the inner sums
// by instruction set, one lobe.

#include "openltc/fit/lobe_fit.h"
#include "openltc/fit/lobe_sums.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/table_fit.h"
#include "openltc/fit/two_lobe_fit.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

using namespace openltc;

namespace {

void table_fit(benchmark::State& state, const brdf::Brdf* brdf, int size, const char* objective) {
  fit::TableFitOptions options;
  options.size = size;
  options.lobe.objective = *fit::find_objective(objective);
  for (auto _ : state) {
    const Result<table::LobeTable> fitted = fit::fit_table(*brdf, options);
    if (!fitted) state.SkipWithError(fitted.error().message.c_str());
  }
}

void two_lobe_fit(benchmark::State& state, int size, const char* objective) {
  fit::TableFitOptions options;
  options.size = size;
  options.lobe.objective = *fit::find_objective(objective);
  for (auto _ : state) {
    const auto fitted = fit::fit_two_lobe_table(*brdf::find_brdf("ggx"), options);
    if (!fitted) state.SkipWithError(fitted.error().message.c_str());
  }
}

void polynomial_fit(benchmark::State& state, int degree) {
  fit::PolynomialFitOptions options;
  options.degree = degree;
  for (auto _ : state) {
    const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(*brdf::find_brdf("ggx"), options);
    if (!fitted) state.SkipWithError(fitted.error().message.c_str());
  }
}

void quadrature(benchmark::State& state) {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::HalfVectors half_vectors = fit::find_half_vectors(ggx, 0.4);
  for (auto _ : state)
    benchmark::DoNotOptimize(fit::make_quadrature(ggx, 0.4, 0.3, half_vectors, {20, 32})->n1);
}

void single_lobe(benchmark::State& state) {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const fit::Quadrature rule = *fit::make_quadrature(ggx, 0.4, 0.3, {20, 32});
  const fit::Quadrature before = *fit::make_quadrature(ggx, 0.416, 0.3, {20, 32});
  const Vec4d start = fit::fit_lobe(before, fit::cosine_start(before.width, 0.3), {}).mirror;
  int steps = 0;
  for (auto _ : state)
    steps += fit::fit_lobe(rule, start, {}).iterations;
  state.counters["steps"] = benchmark::Counter(double(steps), benchmark::Counter::kAvgIterations);
}

// Derivatives of the objective over the points of one rule.
void sums(benchmark::State& state, fit::LobeSums variant) {
  const fit::Quadrature q = *fit::make_quadrature(*brdf::find_brdf("ggx"), 0.4, 0.3, {20, 32});
  fit::LobeSumsInput in;
  in.x = q.x_mirror.data();
  in.y = q.y.data();
  in.z = q.z_mirror.data();
  in.weight = q.weight.data();
  in.density = q.density.data();
  in.count = q.size();
  const double m[4] = {0.3, -0.04, 0.15, 0.06}, slope[4] = {2.1, -4.3, 1.2, 9.0};
  for (int k = 0; k < 4; ++k) {
    in.m[k] = m[k];
    in.log_slope[k] = slope[k];
  }
  in.det = 0.00764;
  in.tv = 1;
  in.squares = 0.2;
  in.cubes = 0.1;
  in.rounding = 0.05;
  in.floor = 1e-3;
  fit::LobeDerivatives out;
  for (auto _ : state) {
    variant.derivatives(in, out);
    benchmark::DoNotOptimize(out);
  }
  state.counters["ns/point"] =
      benchmark::Counter(double(q.size()), benchmark::Counter::kIsIterationInvariantRate |
                                               benchmark::Counter::kInvert);
}

} // namespace

int main(int argc, char** argv) {
  const brdf::Brdf* ggx = brdf::find_brdf("ggx");
  const auto milliseconds = [](benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  for (const int size : {8, 16, 64, 256})
    milliseconds(
        benchmark::RegisterBenchmark(("ggx table " + std::to_string(size) + ", balanced").c_str(),
                                     table_fit, ggx, size, "balanced"));
  for (const char* objective : {"tv", "l2", "l3"})
    milliseconds(benchmark::RegisterBenchmark((std::string("ggx table 64, ") + objective).c_str(),
                                              table_fit, ggx, 64, objective));
  for (const char* objective : {"balanced", "tv"})
    for (const int size : {16, 32, 64})
      milliseconds(benchmark::RegisterBenchmark(
          ("ggx two lobes " + std::to_string(size) + ", " + objective).c_str(), two_lobe_fit, size,
          objective));
  for (int degree = 3; degree <= 6; ++degree)
    milliseconds(benchmark::RegisterBenchmark(
        ("ggx polynomial of degree " + std::to_string(degree)).c_str(), polynomial_fit, degree));
  for (const brdf::Brdf& brdf : brdf::all_brdfs())
    if (&brdf != ggx)
      milliseconds(benchmark::RegisterBenchmark((brdf.name + " table 64").c_str(), table_fit, &brdf,
                                                64, "balanced"));
  benchmark::RegisterBenchmark("quadrature of 20 x 32 points, ggx", quadrature)
      ->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("one lobe from its neighbour's", single_lobe)
      ->Unit(benchmark::kMicrosecond);
  const std::vector<fit::LobeSums> variants = fit::all_lobe_sums();
  const char* const names[] = {"baseline", "AVX2", "AVX-512"};
  for (std::size_t k = 0; k < variants.size(); ++k)
    benchmark::RegisterBenchmark((std::string("derivatives, ") + names[k]).c_str(), sums,
                                 variants[k])
        ->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
