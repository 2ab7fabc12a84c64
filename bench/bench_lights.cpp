// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Nanoseconds per evaluation of a light of each shape: frame, look-up of the lobe, diffuse and
// specular integral clipped to both horizons, reflectance. Scalar and in the lanes of every
// instruction set of this CPU, on one core.
//
// In the same run: a quad in the usual scalar formulation, and how many times faster lanes are that
// return the same, with the albedo of the whole lobe for its reflectance; quads named _fresnel are
// shaded as the renderer does it, those named _exact by GGX itself. The multiply-adds that this CPU
// can do, and the fraction of them that a quad needs.

#include "bench/counted.h"
#include "bench/fma_peak.h"
#include "bench/usual_quad.h"
#include "openltc/table/lobe_table.h"
#include "tests/shade/lights/light_fixture.h"
#include "tests/shade/lights/light_targets.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

using namespace openltc;
using testing::k_batch;
using testing::LightBatch;
using testing::LightCase;
using testing::LightShape;
using testing::LightTarget;
using testing::Random;

namespace {

constexpr int k_batches = 64;

struct Work {
  std::vector<LightCase> lights; // they own the polygons
  std::vector<LightBatch> batches;

  void add(const std::vector<LightCase>& sixteen) {
    batches.emplace_back();
    for (int i = 0; i < k_batch; ++i)
      testing::set_lane(batches.back(), i, sixteen[std::size_t(i)]);
    lights.insert(lights.end(), sixteen.begin(), sixteen.end());
  }
};

/// Random lights of a shape; polygons are shared by the points of a batch.
Work random_work(LightShape shape) {
  Work work;
  Random random(31);
  for (int b = 0; b < k_batches; ++b) {
    std::vector<LightCase> sixteen;
    for (int i = 0; i < k_batch; ++i)
      sixteen.push_back(i > 0 && testing::is_polygon(shape)
                            ? testing::elsewhere(sixteen[0], false, random)
                            : testing::random_light(shape, random));
    work.add(sixteen);
  }
  return work;
}

/// What a camera sees of a room with one lamp: sixteen pixels side by side, of one material, as a
/// renderer shades them. The picture has 1280 pixels in 80 degrees; rows between two heights in
/// pixels from its middle.
Work room_work(const std::shared_ptr<const testing::TestPolygon>& lamp, double lowest,
               double highest) {
  Work work;
  Random random(33);
  const Vec3d camera(0.3, -2.9, 1.5), half(3, 3, 1.5), centre(0, 0, 1.5);
  for (int b = 0; b < k_batches; ++b) {
    const double column = random.uniform(-640, 640), row = random.uniform(lowest, highest);
    const float roughness = float(random.uniform());
    std::vector<LightCase> sixteen(k_batch);
    for (int i = 0; i < k_batch; ++i) {
      const Vec3d ray = normalize(Vec3d((column + i) / 763, 1, row / 763));
      const auto to_wall = [&](double c, double h, double x, double d) {
        return d == 0 ? 1e30 : (c + (d > 0 ? h : -h) - x) / d;
      };
      const Vec3d t(to_wall(centre.x, half.x, camera.x, ray.x),
                    to_wall(centre.y, half.y, camera.y, ray.y),
                    to_wall(centre.z, half.z, camera.z, ray.z));
      const double nearest = std::min({t.x, t.y, t.z});
      Vec3d normal(0, 0, 0);
      if (nearest == t.x)
        normal.x = ray.x > 0 ? -1 : 1;
      else if (nearest == t.y)
        normal.y = ray.y > 0 ? -1 : 1;
      else
        normal.z = ray.z > 0 ? -1 : 1;
      LightCase& light = sixteen[std::size_t(i)];
      light.shape = LightShape::rectangle;
      light.polygon = lamp;
      light.position = to_float(camera + ray * nearest);
      light.normal = to_float(normal);
      light.wo = to_float(ray * -1.0);
      light.roughness = roughness;
    }
    work.add(sixteen);
  }
  return work;
}

/// A lamp under the ceiling. Some points are cut, by either horizon; a fifth is behind it.
Work ceiling_lamp() {
  return room_work(std::make_shared<const testing::TestPolygon>(
                       std::vector<testing::Ring>{testing::rectangle(1.2, 1.2)}, Vec3d(0, 0, 2.8),
                       Vec3d(0, 1, 0), Vec3d(1, 0, 0)),
                   -360, 360);
}

/// The floor before a lamp in the far wall that reaches below it: its horizon cuts at every point.
Work wall_lamp() {
  return room_work(std::make_shared<const testing::TestPolygon>(
                       std::vector<testing::Ring>{testing::rectangle(2, 2)}, Vec3d(0, 2.9, 0.5),
                       Vec3d(1, 0, 0), Vec3d(0, 0, 1)),
                   -360, -230);
}

/// A floor's points under a quad, each seen from elsewhere: a ceiling lamp, or a wall that the
/// floor's horizon cuts.
Work quad_work(bool cut) {
  Work work;
  Random random(32);
  for (int b = 0; b < k_batches; ++b) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
    const auto quad = cut ? std::make_shared<const testing::TestPolygon>(
                                std::vector<testing::Ring>{testing::rectangle(2, 3)},
                                Vec3d(x, 4, 0.5), Vec3d(1, 0, 0), Vec3d(0, 0, 1))
                          : std::make_shared<const testing::TestPolygon>(
                                std::vector<testing::Ring>{testing::rectangle(2, 2)},
                                Vec3d(x, y, 4), Vec3d(0, 1, 0), Vec3d(1, 0, 0));
    std::vector<LightCase> sixteen(k_batch);
    for (LightCase& light : sixteen) {
      light.shape = LightShape::rectangle;
      light.polygon = quad;
      light.position = Vec3f(float(random.uniform(-2, 2)), float(random.uniform(-2, 2)), 0);
      Vec3d view = random.sphere();
      view.z = 0.1 + std::abs(view.z);
      light.wo = to_float(normalize(view));
      light.roughness = float(random.uniform());
    }
    work.add(sixteen);
  }
  return work;
}

benchmark::Counter per_evaluation(int evaluations) {
  return benchmark::Counter(1e-9 * evaluations, benchmark::Counter::kIsIterationInvariantRate |
                                                    benchmark::Counter::kInvert);
}

void run_target(benchmark::State& state, const Work& work, testing::ShadeLights shade) {
  const LobeTableView table = table::builtin_ggx_table().view();
  float shaded[3][k_batch];
  for (auto _ : state)
    for (const LightBatch& batch : work.batches) {
      shade(batch, table, shaded);
      benchmark::DoNotOptimize(shaded);
      benchmark::ClobberMemory();
    }
  state.counters["ns/eval"] = per_evaluation(k_batches * k_batch);
}

void run_usual(benchmark::State& state, const Work& work) {
  const bench::UsualTable table = bench::usual_table();
  float out[3][k_batch];
  for (auto _ : state)
    for (const LightBatch& batch : work.batches) {
      bench::usual_quad(batch, table, 0, k_batch, out);
      benchmark::DoNotOptimize(out);
      benchmark::ClobberMemory();
    }
  state.counters["ns/eval"] = per_evaluation(k_batches * k_batch);
}

void run_peak(benchmark::State& state, bench::FmaPeak peak) {
  float sink[2] = {0.001f, 0};
  double operations = 0;
  for (auto _ : state) {
    operations += peak(10000, sink);
    benchmark::DoNotOptimize(sink);
  }
  state.counters["Gflop/s"] = benchmark::Counter(1e-9 * operations, benchmark::Counter::kIsRate);
}

double least(const std::vector<double>& of) { return *std::min_element(of.begin(), of.end()); }
double largest(const std::vector<double>& of) { return *std::max_element(of.begin(), of.end()); }

template <class... Arguments>
void add_benchmark(const std::string& name, Arguments&&... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), std::forward<Arguments>(arguments)...)
      ->ComputeStatistics("fastest", least);
}

/// Keeps what the console prints.
class Keeper : public benchmark::ConsoleReporter {
public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      for (const auto& counter : run.counters) {
        // Of repetitions the fastest: who else is on the machine makes none faster.
        if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "fastest") continue;
        values[run.run_name.function_name + " " + counter.first] = double(counter.second);
      }
  }
  double value(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? 0 : found->second;
  }
  std::map<std::string, double> values;
};

struct NamedPeak {
  const char* name;
  bench::FmaPeak peak;
};
const NamedPeak k_peaks[] = {
#if defined(__x86_64__)
    {"sse4", bench::fma_peak_sse4},
    {"avx2", bench::fma_peak_avx2},
    {"avx512", bench::fma_peak_avx512}
#else
    {"baseline", bench::fma_peak_baseline}
#endif
};

Work of_form(Work work, testing::ShadingForm form) {
  for (LightBatch& batch : work.batches)
    batch.form = form;
  return work;
}

/// Quads to be shaded in several ways.
struct Quads {
  std::string name;
  Work evenly;  ///< returns what the usual formulation does
  Work fresnel; ///< by one lobe, Fresnel's reflectance in the mean direction
  Work ratio;   ///< and the BRDF's ratio to the lobe there
  Work two;     ///< by two lobes
  Work two_ratio;
  Work exact;    ///< by GGX itself
  Work adaptive; ///< by GGX itself where two lobes with the ratio err

  Quads(const char* n, const Work& work)
      : name(n), evenly(of_form(work, testing::ShadingForm::even)), fresnel(work),
        ratio(of_form(work, testing::ShadingForm::ratio)),
        two(of_form(work, testing::ShadingForm::two)),
        two_ratio(of_form(work, testing::ShadingForm::two_ratio)),
        exact(of_form(work, testing::ShadingForm::exact)),
        adaptive(of_form(work, testing::ShadingForm::adaptive)) {}
};

/// Lights of a shape, in the forms between which a renderer chooses.
struct Shape {
  Work lobe, two_ratio, exact;

  explicit Shape(const Work& work)
      : lobe(work), two_ratio(of_form(work, testing::ShadingForm::two_ratio)),
        exact(of_form(work, testing::ShadingForm::exact)) {}
};

double mean_operations(const Work& work) {
  double sum = 0;
  for (const LightBatch& batch : work.batches)
    sum += bench::count_operations(batch, table::builtin_ggx_table().view());
  return sum / double(work.batches.size());
}

/// Both formulations of a quad must find the same light, or their times say nothing: the mean
/// difference of what they return, and of the usual one the mean. Their tables hold other numbers,
/// which interpolate otherwise between nodes.
struct Difference {
  double mean;
  double of;
};

Difference difference_from_usual(const Work& work) {
  const LobeTableView lobes = table::builtin_ggx_table().view();
  const bench::UsualTable table = bench::usual_table();
  Difference difference = {0, 0};
  for (const LightBatch& batch : work.batches) {
    float ours[3][k_batch], usual[3][k_batch];
    testing::shade_lights_scalar(batch, lobes, ours);
    bench::usual_quad(batch, table, 0, k_batch, usual);
    for (int i = 0; i < k_batch; ++i) {
      difference.mean += double(std::abs(ours[0][i] - usual[0][i]));
      difference.of += double(usual[0][i]);
    }
  }
  const double points = double(work.batches.size() * k_batch);
  return {difference.mean / points, difference.of / points};
}

void compare_with_usual(const Keeper& keeper, const std::string& name, const Work& work,
                        double usual) {
  const double operations = mean_operations(work);
  std::printf("  %s: %.0f floating-point operations\n", name.c_str(), operations);
  for (const LightTarget& target : testing::light_targets()) {
    const double ns = keeper.value(name + "/" + target.name + " ns/eval");
    const double peak = keeper.value(std::string("peak/") + target.name + " Gflop/s");
    if (ns <= 0) continue;
    std::printf("    %-8s %6.1f ns, %5.1f times the usual formulation's speed", target.name, ns,
                usual / ns);
    if (peak > 0) std::printf(", %4.1f %% of %.0f Gflop/s", 100 * operations / ns / peak, peak);
    std::printf("\n");
  }
}

} // namespace

int main(int argc, char** argv) {
  std::vector<Shape> shapes;
  for (int k = 0; k < testing::k_light_shapes; ++k)
    shapes.emplace_back(random_work(testing::shape_of_index(k)));
  const Quads quads[] = {Quads("quad_above", quad_work(false)), Quads("quad_room", ceiling_lamp()),
                         Quads("quad_floor", wall_lamp()), Quads("quad_cut", quad_work(true))};

  for (const LightTarget& target : testing::light_targets()) {
    const std::string suffix = std::string("/") + target.name;
    for (const Quads& q : quads) {
      add_benchmark(q.name + suffix, run_target, std::cref(q.evenly), target.shade);
      add_benchmark(q.name + "_fresnel" + suffix, run_target, std::cref(q.fresnel), target.shade);
      add_benchmark(q.name + "_ratio" + suffix, run_target, std::cref(q.ratio), target.shade);
      add_benchmark(q.name + "_two" + suffix, run_target, std::cref(q.two), target.shade);
      add_benchmark(q.name + "_two_ratio" + suffix, run_target, std::cref(q.two_ratio),
                    target.shade);
      add_benchmark(q.name + "_exact" + suffix, run_target, std::cref(q.exact), target.shade);
      add_benchmark(q.name + "_adaptive" + suffix, run_target, std::cref(q.adaptive), target.shade);
    }
    for (int k = 0; k < testing::k_light_shapes; ++k) {
      const Shape& shape = shapes[std::size_t(k)];
      const std::string name = testing::shape_name(testing::shape_of_index(k));
      add_benchmark(name + suffix, run_target, std::cref(shape.lobe), target.shade);
      add_benchmark(name + "_two_ratio" + suffix, run_target, std::cref(shape.two_ratio),
                    target.shade);
      add_benchmark(name + "_exact" + suffix, run_target, std::cref(shape.exact), target.shade);
    }
    for (const NamedPeak& p : k_peaks)
      if (p.name == std::string(target.name))
        benchmark::RegisterBenchmark(("peak" + suffix).c_str(), run_peak, p.peak)
            ->ComputeStatistics("fastest", largest);
  }
  for (const Quads& q : quads)
    add_benchmark(q.name + "/usual", run_usual, std::cref(q.evenly));
  benchmark::Initialize(&argc, argv);
  Keeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  for (const LightTarget& target : testing::light_targets())
    for (const Quads& q : quads) {
      const auto ns = [&](const char* form) {
        return keeper.value(q.name + form + "/" + target.name + " ns/eval");
      };
      const double one = ns("_fresnel");
      if (one > 0)
        std::printf(
            "%s, %s: over one lobe's time, with the ratio %.2f, two lobes %.2f, two with the "
            "ratio %.2f\n",
            q.name.c_str(), target.name, ns("_ratio") / one, ns("_two") / one,
            ns("_two_ratio") / one);
    }

  for (const Quads& q : quads) {
    const double usual = keeper.value(q.name + "/usual ns/eval");
    if (usual <= 0) continue;
    const Difference difference = difference_from_usual(q.evenly);
    std::printf("\n%s: usual scalar formulation %.1f ns; light %.4f, mean difference %.1e\n",
                q.name.c_str(), usual, difference.of, difference.mean);
    compare_with_usual(keeper, q.name, q.evenly, usual);
    compare_with_usual(keeper, q.name + "_fresnel", q.fresnel, usual);
  }
}
