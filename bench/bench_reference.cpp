// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The reference integrator's ways of sampling polygon lights beside each other, in one run:
// variance and time of the same number of samples, without shadows, and the variance in equal time.

#include "openltc/render/renderer.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/lobe_table.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

using namespace openltc;

namespace {

struct Options {
  std::vector<std::string> scenes;
  int samples = 16, seeds = 12, shadow_samples = 0;
  int width = 192, height = 108;
  bool two_lobes = false;
};

/// Pictures of several seeds by one way of sampling.
struct Spread {
  std::vector<double> mean, variance; ///< of each value of a picture of Options::samples
  double seconds = 1e300;             ///< of all cores, of a picture, the fastest
};

[[noreturn]] void end(const std::string& message) {
  fmt::print(stderr, "bench_reference: {}\n", message);
  std::exit(1);
}

Spread spread_of(const scene::Scene& scene, const Options& options, bool lobe_samples) {
  render::RenderOptions o;
  o.width = options.width;
  o.height = options.height;
  o.samples = options.samples;
  o.shadow_samples = options.shadow_samples;
  o.filter = render::PixelFilter::none; // what varies is the light, not the place in the pixel
  o.integrator = render::Integrator::reference;
  o.lobe_samples = lobe_samples;
  Spread spread;
  std::vector<double> square;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    o.seed = std::uint32_t(seed);
    const std::clock_t start = std::clock();
    const auto picture = render::render(
        scene, scene.cameras.at(0),
        options.two_lobes ? table::builtin_ggx_two_lobe_table() : table::builtin_ggx_table(), o);
    if (!picture) end(picture.error().message);
    const std::vector<float>& data = picture->radiance.data;
    spread.mean.resize(data.size());
    square.resize(data.size());
    for (std::size_t i = 0; i < data.size(); ++i) {
      spread.mean[i] += double(data[i]);
      square[i] += double(data[i]) * double(data[i]);
    }
    spread.seconds = std::min(spread.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  const double n = options.seeds;
  spread.variance.resize(square.size());
  for (std::size_t i = 0; i < square.size(); ++i) {
    spread.mean[i] /= n;
    spread.variance[i] =
        std::max(square[i] / n - spread.mean[i] * spread.mean[i], 0.0) * n / (n - 1);
  }
  return spread;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values)
    sum += v;
  return sum;
}

/// Mean over the lit values of variance / (mean + 1 % of the picture's)^2; `mean`: of both ways.
double relative_variance(const std::vector<double>& variance, const std::vector<double>& mean) {
  const double floor = 0.01 * sum_of(mean) / double(mean.size());
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (mean[i] <= floor) continue;
    sum += variance[i] / ((mean[i] + floor) * (mean[i] + floor));
    ++count;
  }
  return count > 0 ? sum / double(count) : 0;
}

void compare(const std::string& path, const Options& options) {
  auto scene = scene::load_gltf(path);
  if (!scene) end(scene.error().message);
  const Spread before = spread_of(*scene, options, false), now = spread_of(*scene, options, true);
  std::vector<double> mean(before.mean.size());
  for (std::size_t i = 0; i < mean.size(); ++i)
    mean[i] = 0.5 * (before.mean[i] + now.mean[i]);
  const double a = relative_variance(before.variance, mean),
               b = relative_variance(now.variance, mean);
  const double sums = sum_of(before.variance) / sum_of(now.variance);
  const double slower = now.seconds / before.seconds;
  // How far the means are apart, over the standard error of their difference.
  const double apart = (sum_of(now.mean) - sum_of(before.mean)) /
                       std::sqrt((sum_of(before.variance) + sum_of(now.variance)) / options.seeds);
  std::string name = path.substr(path.find_last_of('/') + 1);
  name = name.substr(0, name.find_last_of('.'));
  fmt::print("| {} | {:.2e} | {:.2e} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:+.4f} % ({:+.1f}) |\n",
             name, a, b, a / b, sums, slower, a / b / slower,
             100 * (sum_of(now.mean) / sum_of(before.mean) - 1), apart);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Variance and time of the reference's ways of sampling polygon lights"};
  app.add_option("--scene", options.scenes, "glTF files with polygon lights");
  app.add_option("--samples", options.samples, "per pixel");
  app.add_option("--seeds", options.seeds, "pictures of each way");
  app.add_option("--shadow-samples", options.shadow_samples, "0: no shadows");
  app.add_flag("--two-lobes", options.two_lobes, "of the built-in table of two the first");
  CLI11_PARSE(app, argc, argv);
  if (options.scenes.empty()) {
    const std::string folder = OPENLTC_SOURCE_DIR "/scenes/";
    options.scenes = {folder + "demo.glb"};
    for (const char* name : {"lamps_dielectric", "lamps_metal", "rims", "floor_end_wall_35",
                             "floor_side_wall_60", "floor_star_35", "floor_star_60"})
      options.scenes.push_back(folder + "hard/" + name + ".glb");
  }
  fmt::print(
      "{} samples, {} seeds, {} shadow samples; variance relative to the squared mean\n"
      "| scene | by solid angle | by the lobe | ratio | ratio of sums | time | ratio in equal "
      "time | mean |\n|---|---|---|---|---|---|---|---|\n",
      options.samples, options.seeds, options.shadow_samples);
  for (const std::string& scene : options.scenes)
    compare(scene, options);
}
