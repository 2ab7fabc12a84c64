// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The project's figures on its demo scene: time per frame, error against the reference, and how
// long the reference takes to be as accurate. By the lobes that openltc render takes; beside them
// by the fastest form, one lobe by itself.

#include "openltc/image/compare/metrics.h"
#include "openltc/render/error_by_surface.h"
#include "openltc/render/renderer.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/lobe_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace openltc;

namespace {

// By lobes, which leave as much noise as eighty times as many by solid angle (bench_reference).
constexpr int k_truth_samples = 256;

scene::Scene load(const std::string& name) {
  Result<scene::Scene> scene =
      scene::load_gltf(std::string(OPENLTC_SOURCE_DIR) + "/scenes/" + name);
  if (!scene.ok()) {
    fmt::print(stderr, "{}\n", scene.error().message);
    std::exit(1);
  }
  return std::move(*scene);
}

render::LobeSource lobes_of(const scene::Scene& scene, const render::RenderOptions& options) {
  const bool fastest = options.specular_form == render::SpecularForm::lobe;
  return fastest || options.integrator == render::Integrator::reference
             ? render::LobeSource(table::builtin_ggx_table())
             : render::builtin_lobes_for(scene.lights);
}

render::Picture rendered(const scene::Scene& scene, const render::RenderOptions& options) {
  Result<render::Picture> picture =
      render::render(scene, scene.cameras.at(0), lobes_of(scene, options), options);
  if (!picture.ok()) {
    fmt::print(stderr, "{}\n", picture.error().message);
    std::exit(1);
  }
  return std::move(*picture);
}

// A figure beside the one that the project set itself.
void target(const char* what, double value, const char* unit, double wanted, bool at_least) {
  const bool met = at_least ? value >= wanted : value <= wanted;
  fmt::print("  {:<44} {:9.3g} {:<3} target {} {:g} {}: {}\n", what, value, unit,
             at_least ? "at least" : "at most ", wanted, unit, met ? "met" : "NOT MET");
}

// The fastest of a few runs: what the machine can do when nothing else asks for it.
double best_seconds(const scene::Scene& scene, const render::RenderOptions& options, int runs) {
  double best = 1e300;
  for (int i = 0; i < runs; ++i)
    best = std::min(best, rendered(scene, options).render_seconds);
  return best;
}

image::Metrics error_of(const render::Picture& a, const render::Picture& truth) {
  return image::compare(a.radiance, truth.radiance);
}

void frame_times(const scene::Scene& scene) {
  render::RenderOptions options;
  options.samples = 1;
  fmt::print("1280x720, {} polygon and {} point lights, 1 sample per pixel, best of 5\n",
             scene.lights.polygons.size(), scene.lights.punctual.size());
  double scalar = 0;
  for (const char* kernel : {"scalar", "auto"}) {
    options.kernel = kernel;
    options.shadow_samples = 0;
    const double seconds = best_seconds(scene, options, 5);
    if (scalar == 0) scalar = seconds;
    fmt::print("  unshadowed, {:<7} {:7.3f} s   {:.2f} x\n", render::kernel_by_name(kernel).name,
               seconds, scalar / seconds);
  }
  target("unshadowed, best kernel", best_seconds(scene, options, 3), "s", 0.3, false);
  options.shadow_samples = 16;
  target("16 shadow samples", best_seconds(scene, options, 2), "s", 8, false);
  options.specular_form = render::SpecularForm::lobe;
  const double shadowed = best_seconds(scene, options, 2);
  options.shadow_samples = 0;
  fmt::print("  by one lobe alone: unshadowed {:.3f} s, 16 shadow samples {:.3g} s\n",
             best_seconds(scene, options, 3), shadowed);
}

// Where the error lies: by what the pixels show.
void print_error_by_surface(const scene::Scene& scene, const image::Image& a,
                            const image::Image& truth) {
  const auto errors =
      render::error_by_surface(scene, scene.cameras.at(0), a, truth, image::compare(a, truth).eps);
  if (!errors.ok()) std::exit(1);
  fmt::print("\nWhere that error lies\n  {:<36} {:>8} {:>9} {:>9} {:>9}\n", "", "pixels", "mean",
             "largest", "share");
  for (const render::SurfaceError& e : *errors)
    fmt::print("  {:<36} {:>8} {:>7.2f} % {:>7.1f} % {:>7.1f} %\n", e.surface, e.pixels,
               100 * e.mean_relative, 100 * e.max_relative, 100 * e.share);
}

void errors(const scene::Scene& scene) {
  // Through the middle of each pixel only: what is compared is the light, not how edges are drawn.
  render::RenderOptions options;
  options.width = 640;
  options.height = 360;
  options.filter = render::PixelFilter::none;
  options.shadow_samples = 0;
  options.integrator = render::Integrator::reference;
  options.samples = k_truth_samples;
  options.seed = 99;
  const render::Picture truth = rendered(scene, options);

  options.integrator = render::Integrator::ltc;
  options.samples = 1;
  options.seed = 1;
  const render::Picture ltc = rendered(scene, options);
  const double ltc_seconds = best_seconds(scene, options, 5);
  const double ltc_error = error_of(ltc, truth).mean_relative;
  fmt::print(
      "\n640x360, unshadowed, no pixel filter: mean relative error against {} samples of the "
      "reference\n",
      k_truth_samples);
  fmt::print("  LTC, 1 sample per pixel      {:6.2f} %  {:8.3f} s\n", 100 * ltc_error, ltc_seconds);
  target("mean relative error", 100 * ltc_error, "%", 3, false);
  options.specular_form = render::SpecularForm::lobe;
  fmt::print("  by one lobe alone            {:6.2f} %\n",
             100 * error_of(rendered(scene, options), truth).mean_relative);
  options.specular_form.reset();

  options.integrator = render::Integrator::reference;
  for (const bool by_lobes : {false, true}) {
    options.lobe_samples = by_lobes;
    const char* way = by_lobes ? "by lobes" : "by solid angle and BRDF";
    // Steps of a half, so that the factor is not rounded up to the next power of two.
    for (int samples = 1; samples <= 2048; samples = samples < 2 ? 2 : samples + samples / 2) {
      options.samples = samples;
      const render::Picture reference = rendered(scene, options);
      const double error = error_of(reference, truth).mean_relative;
      fmt::print("  reference {}, {:4} samples {:6.2f} %  {:8.3f} s   {:6.1f} x the time\n", way,
                 samples, 100 * error, reference.render_seconds,
                 reference.render_seconds / ltc_seconds);
      if (error > ltc_error) continue;
      if (!by_lobes)
        target("reference time over LTC time at equal error",
               reference.render_seconds / ltc_seconds, "x", 50, true);
      break;
    }
  }
  print_error_by_surface(scene, ltc.radiance, truth.radiance);
}

} // namespace

int main() {
  const scene::Scene scene = load("demo.glb");
  frame_times(scene);
  errors(scene);
}
