// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   fuzz_lights [COUNT]                COUNT lights of each shape (100000), half of them
//   adversarial fuzz_lights --shape NAME --seed N  print one batch again
//
// Every light in float, scalar and in the lanes of every instruction set of this CPU: no NaN, no
// infinity, nothing negative, no integral above 1 (lines, whose integrals are per metre, have no
// such bound) and no more light reflected than the light's radiance. Exit 1 on a violation.

#include "openltc/base/parallel.h"
#include "openltc/table/lobe_table.h"
#include "tests/shade/lights/light_fixture.h"
#include "tests/shade/lights/light_targets.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

using namespace openltc;
using testing::k_batch;
using testing::LightAnswers;
using testing::LightBatch;
using testing::LightCase;
using testing::LightShape;
using testing::LightTarget;

namespace {

LightBatch make_batch(const std::vector<LightCase>& lights) {
  LightBatch batch;
  for (int i = 0; i < k_batch; ++i)
    testing::set_lane(batch, i, lights[std::size_t(i)]);
  return batch;
}

/// What is wrong with lane i, or nullptr.
const char* complaint(LightShape shape, const LightAnswers& a, int i) {
  const float most = shape == LightShape::line ? 3e38f : 1.0f;
  for (const float x : {a.diffuse[i], a.specular[i]}) {
    if (!std::isfinite(x)) return "an integral is not finite";
    if (x < 0) return "an integral is negative";
    if (x > most) return "an integral is above 1";
  }
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(a.shaded[k][i])) return "reflected light is not finite";
    if (a.shaded[k][i] < 0) return "reflected light is negative";
    if (a.shaded[k][i] > most * 1.000001f) return "more light is reflected than arrives";
  }
  for (const auto* v : {&a.diffuse_direction, &a.specular_direction}) {
    const double x = double((*v)[0][i]), y = double((*v)[1][i]), z = double((*v)[2][i]);
    if (!(std::abs(std::sqrt(x * x + y * y + z * z) - 1) < 1e-4)) return "a direction is not unit";
  }
  return nullptr;
}

/// What a target makes of a batch: its integrals, and its light as a renderer asks for it.
struct Evaluated {
  static constexpr testing::ShadingForm k_forms[] = {
      testing::ShadingForm::lobe,      testing::ShadingForm::ratio, testing::ShadingForm::two,
      testing::ShadingForm::two_ratio, testing::ShadingForm::exact, testing::ShadingForm::adaptive};
  LightAnswers integrals, rendered[std::size(k_forms)];

  Evaluated(const LightTarget& target, LightBatch batch) {
    const LobeTableView table = table::builtin_ggx_table().view();
    target.evaluate(batch, table, &integrals);
    for (std::size_t k = 0; k < std::size(k_forms); ++k) {
      batch.form = k_forms[k];
      rendered[k] = integrals;
      target.shade(batch, table, rendered[k].shaded);
    }
  }
  const char* complaint_of(LightShape shape, int i) const {
    const char* what = complaint(shape, integrals, i);
    for (const LightAnswers& answers : rendered)
      if (!what) what = complaint(shape, answers, i);
    return what;
  }
};

void print_lane(const LightCase& light, const LightAnswers& a, int i, const char* what) {
  std::printf("  lane %d: %s\n", i, what ? what : "fine");
  const auto put = [](const char* name, Vec3f v) {
    std::printf("    %s %.9g %.9g %.9g\n", name, double(v.x), double(v.y), double(v.z));
  };
  put("position", light.position);
  put("normal", light.normal);
  put("wo", light.wo);
  put("a", light.a);
  put("b", light.b);
  put("c", light.c);
  std::printf("    roughness %.9g radius %.9g two_sided %d\n", double(light.roughness),
              double(light.radius), int(light.two_sided));
  if (light.polygon) {
    const PolygonView& view = light.polygon->view();
    for (int k = 0; k < view.point_count; ++k)
      put(f32::polygon_starts_ring(view, k) ? "ring" : "point", f32::polygon_point(view, k));
  }
  std::printf("    diffuse %.9g specular %.9g shaded %.9g\n", double(a.diffuse[i]),
              double(a.specular[i]), double(a.shaded[0][i]));
  for (const auto* v : {&a.diffuse_direction, &a.specular_direction})
    std::printf("    direction %.9g %.9g %.9g\n", double((*v)[0][i]), double((*v)[1][i]),
                double((*v)[2][i]));
}

int replay(LightShape shape, std::uint64_t seed) {
  const std::vector<LightCase> lights = testing::fuzz_lights(shape, seed);
  const LightBatch batch = make_batch(lights);
  int wrong = 0;
  for (const LightTarget& target : testing::light_targets()) {
    const Evaluated evaluated(target, batch);
    std::printf("%s\n", target.name);
    for (int i = 0; i < k_batch; ++i) {
      const char* what = evaluated.complaint_of(shape, i);
      if (what)
        for (const LightAnswers& answers : evaluated.rendered)
          print_lane(lights[std::size_t(i)], answers, i, what);
      wrong += what != nullptr;
    }
  }
  std::printf("%d violations\n", wrong);
  return wrong > 0;
}

struct Tally {
  std::atomic<std::int64_t> violations{0};
  std::atomic<std::uint64_t> first{~std::uint64_t(0)}; // smallest seed, for any number of threads
};

void run_batch(LightShape shape, std::uint64_t seed, std::vector<Tally>& tallies) {
  const std::vector<LightCase> lights = testing::fuzz_lights(shape, seed);
  const LightBatch batch = make_batch(lights);
  const std::vector<LightTarget>& targets = testing::light_targets();
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const Evaluated evaluated(targets[t], batch);
    for (int i = 0; i < k_batch; ++i) {
      if (!evaluated.complaint_of(shape, i)) continue;
      ++tallies[t].violations;
      std::uint64_t first = tallies[t].first;
      while (seed < first && !tallies[t].first.compare_exchange_weak(first, seed)) {
      }
    }
  }
}

} // namespace

int main(int argc, char** argv) {
  std::int64_t count = 100000;
  std::string only;
  std::int64_t seed = -1;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--shape") == 0 && i + 1 < argc)
      only = argv[++i];
    else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc)
      seed = std::atoll(argv[++i]);
    else
      count = std::atoll(argv[i]);
  }
  bool known = only.empty();
  for (int k = 0; k < testing::k_light_shapes; ++k)
    known = known || only == testing::shape_name(testing::shape_of_index(k));
  if (count < k_batch || !known || (seed >= 0 && only.empty())) {
    std::fprintf(stderr, "usage: fuzz_lights [COUNT] [--shape NAME [--seed N]]; COUNT from 16\n");
    return 2;
  }

  std::int64_t wrong = 0;
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    if (!only.empty() && only != testing::shape_name(shape)) continue;
    if (seed >= 0) return replay(shape, std::uint64_t(seed));
    const std::vector<LightTarget>& targets = testing::light_targets();
    std::vector<Tally> tallies(targets.size());
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t batches = (count + k_batch - 1) / k_batch, chunk = 64;
    parallel_for((batches + chunk - 1) / chunk, 0, [&](std::int64_t c) {
      for (std::int64_t b = c * chunk; b < std::min((c + 1) * chunk, batches); ++b)
        run_batch(shape, std::uint64_t(b), tallies);
    });
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%-10s %lld lights in %.1f s:", testing::shape_name(shape),
                static_cast<long long>(batches * k_batch), seconds);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const std::int64_t violations = tallies[t].violations;
      std::printf(" %s %lld", targets[t].name, static_cast<long long>(violations));
      if (violations > 0)
        std::printf(" (replay: fuzz_lights --shape %s --seed %llu)", testing::shape_name(shape),
                    static_cast<unsigned long long>(tallies[t].first));
      wrong += violations;
    }
    std::printf(" violations\n");
    std::fflush(stdout);
  }
  return wrong > 0 ? 1 : 0;
}
