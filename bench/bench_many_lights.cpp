// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What many lights cost: time per frame of 5 to 5000 polygon lights, all shaded at every point and
// chosen by the bound, and what the choice changed in the picture beside what it may.
//
//   bench_many_lights [LIGHTS...]   numbers of lights, the first of which the others are compared
//   to; --two-lobes takes the table of two lobes, --lobe, --ratio, --adaptive or --exact that form
//   bench_many_lights --facets [FACETS...]   a glowing mesh of so many facets, each a light: time
//   and error of both integrators against 128 samples of the reference

#include "bench/many_lights_scenes.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>
#include <vector>

using namespace openltc;

namespace {

const table::LobeTable* lobes = &table::builtin_ggx_table();
std::optional<render::SpecularForm> form;

render::Picture rendered(const scene::Scene& scene, render::RenderOptions options) {
  options.specular_form = form;
  Result<render::Picture> picture = render::render(scene, scene.cameras.at(0), *lobes, options);
  if (!picture.ok()) {
    fmt::print(stderr, "{}\n", picture.error().message);
    std::exit(1);
  }
  return std::move(*picture);
}

struct Timed {
  render::Picture picture;
  double seconds;     ///< of the fastest run, acceleration structure and light tree included
  double cpu_seconds; ///< of all cores, of the last run; steadier where others share the machine
};

Timed timed(const scene::Scene& scene, const render::RenderOptions& options, int runs) {
  std::clock_t start = std::clock();
  Timed best{rendered(scene, options), 0, 0};
  best.seconds = best.picture.build_seconds + best.picture.render_seconds;
  for (int i = 1; i < runs; ++i) {
    start = std::clock();
    const render::Picture again = rendered(scene, options);
    best.seconds = std::min(best.seconds, again.build_seconds + again.render_seconds);
  }
  best.cpu_seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  return best;
}

double largest_difference(const image::Image& a, const image::Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    largest = std::max(largest, std::abs(double(a.data[i]) - double(b.data[i])));
  return largest;
}

void unshadowed(const char* name, scene::Scene (*make)(int), const std::vector<int>& counts) {
  fmt::print("{}, 1280x720, 1 sample per pixel, no shadows; error in nits\n"
             "  {:>6} | {:>8} | {:>8} {:>7} {:>7} {:>6} | {:>9} {:>9}\n",
             name, "lights", "all, s", "s", "x first", "exact", "far", "error", "bound");
  double first = 0;
  for (const int count : counts) {
    const scene::Scene scene = make(count);
    render::RenderOptions options;
    options.samples = 1;
    options.shadow_samples = 0;
    const Timed chosen = timed(scene, options, 3);
    if (first == 0) first = chosen.seconds;
    options.light_error = 0;
    const Timed all = timed(scene, options, count > 500 ? 1 : 2);
    fmt::print("  {:>6} | {:>8.3f} | {:>8.3f} {:>7.2f} {:>7.1f} {:>6.1f} | {:>9.2g} {:>9.2g}\n",
               count, all.seconds, chosen.seconds, chosen.seconds / first,
               chosen.picture.lights_per_point, chosen.picture.far_groups_per_point,
               largest_difference(all.picture.radiance, chosen.picture.radiance),
               chosen.picture.light_error_nits);
  }
}

/// Mean of the absolute difference over the mean of the truth.
double relative_error(const image::Image& picture, const image::Image& truth) {
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < truth.data.size(); ++i) {
    difference += std::abs(double(picture.data[i]) - double(truth.data[i]));
    sum += double(truth.data[i]);
  }
  return difference / sum;
}

/// Noise of the shadows: what a small picture of them differs from one of many rays.
double shadow_noise(const scene::Scene& scene) {
  render::RenderOptions options;
  options.width = 160;
  options.height = 90;
  options.samples = 1;
  options.filter = render::PixelFilter::none;
  const render::Picture picture = rendered(scene, options);
  options.shadow_samples = 512;
  options.seed = 1;
  return relative_error(picture.radiance, rendered(scene, options).radiance);
}

// Not all lights one by one, which with shadows take minutes.
void shadowed(const char* name, scene::Scene (*make)(int), const std::vector<int>& counts) {
  fmt::print("{}, 1280x720, 1 sample per pixel, 16 shadow samples; noise by 160x90 against 512\n"
             "  {:>6} | {:>8} {:>7} {:>7} {:>6} | {:>7}\n",
             name, "lights", "s", "x first", "exact", "far", "noise");
  double first = 0;
  for (const int count : counts) {
    const scene::Scene scene = make(count);
    render::RenderOptions options;
    options.samples = 1;
    const Timed chosen = timed(scene, options, 2);
    if (first == 0) first = chosen.seconds;
    fmt::print("  {:>6} | {:>8.3f} {:>7.2f} {:>7.1f} {:>6.1f} | {:>6.2f}%\n", count, chosen.seconds,
               chosen.seconds / first, chosen.picture.lights_per_point,
               chosen.picture.far_groups_per_point, 100 * shadow_noise(scene));
  }
}

// The reference's time to an error of 1 %: its error falls with the root of its samples.
void facets(const std::vector<int>& counts, int truth_samples) {
  fmt::print("ring of facets, 4 samples per pixel, 16 shadow samples; reference of 16 samples; "
             "seconds of all cores. LTC at 480x270, its error and the reference at 160x90\n"
             "  {:>6} | {:>8} {:>7} {:>7} {:>7} {:>8} | {:>8} {:>7} {:>8} {:>9} {:>7}\n",
             "facets", "LTC", "x first", "exact", "far", "error", "ref.", "x first", "error",
             "s to 1 %", "x first");
  double first_ltc = 0, first_reference = 0, first_to_one_percent = 0;
  for (const int count : counts) {
    const scene::Scene scene = bench::ring_of_facets(count);
    render::RenderOptions options;
    options.filter = render::PixelFilter::none;
    options.samples = 4;
    options.width = 480;
    options.height = 270;
    const Timed ltc = timed(scene, options, 1);
    options.width = 160;
    options.height = 90;
    const render::Picture small = rendered(scene, options);
    options.integrator = render::Integrator::reference;
    options.samples = 16;
    const Timed reference = timed(scene, options, 1);
    options.samples = truth_samples;
    options.seed = 1;
    const render::Picture truth = rendered(scene, options);
    const double error = relative_error(reference.picture.radiance, truth.radiance);
    const double to_one_percent = reference.cpu_seconds * error * error / 1e-4;
    if (first_ltc == 0) {
      first_ltc = ltc.cpu_seconds;
      first_reference = reference.cpu_seconds;
      first_to_one_percent = to_one_percent;
    }
    fmt::print(
        "  {:>6} | {:>8.3f} {:>7.2f} {:>7.1f} {:>7.1f} {:>7.2f}% | {:>8.3f} {:>7.2f} {:>7.3f}% "
        "{:>9.3f} {:>7.2f}\n",
        scene.lights.polygons.size(), ltc.cpu_seconds, ltc.cpu_seconds / first_ltc,
        ltc.picture.lights_per_point, ltc.picture.far_groups_per_point,
        100 * relative_error(small.radiance, truth.radiance), reference.cpu_seconds,
        reference.cpu_seconds / first_reference, 100 * error, to_one_percent,
        to_one_percent / first_to_one_percent);
  }
}

} // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::vector<int> counts;
  bool of_facets = false;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--facets") of_facets = true;
    if (std::string_view(argv[i]) == "--two-lobes") lobes = &table::builtin_ggx_two_lobe_table();
    if (std::string_view(argv[i]) == "--lobe") form = render::SpecularForm::lobe;
    if (std::string_view(argv[i]) == "--ratio") form = render::SpecularForm::ratio;
    if (std::string_view(argv[i]) == "--exact") form = render::SpecularForm::exact;
    if (std::string_view(argv[i]) == "--adaptive") form = render::SpecularForm::adaptive;
    if (argv[i][0] != '-') counts.push_back(std::max(std::atoi(argv[i]), 1));
  }
  if (of_facets) {
    facets(counts.empty() ? std::vector<int>{100, 1000, 10000} : counts, 128);
    return 0;
  }
  if (counts.empty()) counts = {5, 50, 500, 5000};
  unshadowed("hall", bench::hall, counts);
  unshadowed("street", bench::street, counts);
  shadowed("hall", bench::hall, counts);
  shadowed("street", bench::street, counts);
}
