// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The project's figures on its demo scene: time per frame, error against the reference, and how
// long the reference takes to be as accurate.

#include "openltc/image/metrics.h"
#include "openltc/render/camera_rays.h"
#include "openltc/render/ray_scene.h"
#include "openltc/render/renderer.h"
#include "openltc/render/surface_point.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/lobe_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

using namespace openltc;

namespace {

scene::Scene load(const std::string& name) {
  Result<scene::Scene> scene = scene::load_gltf(std::string(OPENLTC_SOURCE_DIR) + "/scenes/" + name);
  if (!scene.ok()) {
    fmt::print(stderr, "{}\n", scene.error().message);
    std::exit(1);
  }
  return std::move(*scene);
}

render::Picture rendered(const scene::Scene& scene, const render::RenderOptions& options) {
  Result<render::Picture> picture =
      render::render(scene, scene.cameras.at(0), table::builtin_ggx_table(), options);
  if (!picture.ok()) {
    fmt::print(stderr, "{}\n", picture.error().message);
    std::exit(1);
  }
  return std::move(*picture);
}

// The fastest of a few runs: what the machine can do when nothing else asks for it.
double best_seconds(const scene::Scene& scene, const render::RenderOptions& options, int runs) {
  double best = 1e300;
  for (int i = 0; i < runs; ++i) best = std::min(best, rendered(scene, options).render_seconds);
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
    fmt::print("  unshadowed, {:<7} {:7.3f} s   {:.2f} x\n",
               render::kernel_by_name(kernel).name, seconds, scalar / seconds);
  }
  options.shadow_samples = 16;
  fmt::print("  16 shadow samples  {:7.3f} s\n", best_seconds(scene, options, 2));
}

// What the middle of each pixel shows: "metal, roughness 0.2-0.4", "emitter" or "background".
std::vector<std::string> pixel_kinds(const scene::Scene& scene, int width, int height) {
  const render::TextureSet textures(scene);
  auto rays = render::RayScene::create(scene, textures);
  if (!rays.ok()) std::exit(1);
  const render::CameraRays camera(scene.cameras.at(0), width, height);
  std::vector<std::string> kinds;
  for (int i = 0; i < width * height; ++i) {
    const render::CameraRay ray = camera.ray(float(i % width) + 0.5f, float(i / width) + 0.5f);
    render::RayPacket packet{};
    packet.active[0] = -1;
    packet.near[0] = ray.near;
    packet.far[0] = ray.far;
    for (int axis = 0; axis < 3; ++axis) {
      packet.origin[axis][0] = (&ray.origin.x)[axis];
      packet.direction[axis][0] = (&ray.direction.x)[axis];
    }
    const render::HitPacket hits = (*rays)->intersect(packet);
    if (hits.mesh[0] < 0) {
      kinds.push_back("background");
      continue;
    }
    const render::SurfacePoint p = render::evaluate_surface(
        scene, textures, std::uint32_t(hits.mesh[0]), hits.triangle[0], hits.u[0], hits.v[0],
        ray.direction, hits.distance[0], camera.footprint(hits.distance[0]));
    if (dot(p.emission, p.emission) > 0) {
      kinds.push_back("emitter");
      continue;
    }
    const bool metal = dot(p.albedo, p.albedo) == 0;
    const int bin = std::min(int(p.roughness * 5), 4);
    const float cosine = dot(p.normal, p.view);
    kinds.push_back(fmt::format("{}, roughness {:.1f}-{:.1f}, {}", metal ? "metal     " : "dielectric",
                                bin * 0.2, bin * 0.2 + 0.2,
                                cosine < 0.26f ? "grazing (> 75 degrees)" : "facing"));
  }
  return kinds;
}

// Where the error lies: by what the pixels show.
void error_by_surface(const scene::Scene& scene, const image::Image& a, const image::Image& truth) {
  struct Sum {
    double error = 0, worst = 0;
    int pixels = 0;
  };
  std::map<std::string, Sum> sums;
  const double eps = image::compare(a, truth).eps;
  const std::vector<std::string> kinds = pixel_kinds(scene, a.width, a.height);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = double(a.data[3 * i + c]), y = double(truth.data[3 * i + c]);
      error += std::abs(x - y) / (std::abs(y) + eps) / 3;
    }
    Sum& sum = sums[kinds[i]];
    sum.error += error;
    sum.worst = std::max(sum.worst, error);
    ++sum.pixels;
  }
  fmt::print("\nWhere that error lies, by what the middle of a pixel shows\n"
             "  {:<52} {:>8} {:>9} {:>9} {:>9}\n",
             "", "pixels", "mean", "largest", "share");
  double total = 0;
  for (const auto& [kind, sum] : sums) total += sum.error;
  for (const auto& [kind, sum] : sums)
    fmt::print("  {:<52} {:>8} {:>7.2f} % {:>7.1f} % {:>7.1f} %\n", kind, sum.pixels,
               100 * sum.error / sum.pixels, 100 * sum.worst, 100 * sum.error / total);
}

void errors(const scene::Scene& scene) {
  // Through the middle of each pixel only: what is compared is the light, not how edges are drawn.
  render::RenderOptions options;
  options.width = 640;
  options.height = 360;
  options.filter = render::PixelFilter::none;
  options.shadow_samples = 0;
  options.integrator = render::Integrator::reference;
  options.samples = 2048;
  options.seed = 99;
  const render::Picture truth = rendered(scene, options);

  options.integrator = render::Integrator::ltc;
  options.samples = 1;
  options.seed = 1;
  const render::Picture ltc = rendered(scene, options);
  const double ltc_seconds = best_seconds(scene, options, 5);
  const double ltc_error = error_of(ltc, truth).mean_relative;
  fmt::print("\n640x360, unshadowed, no pixel filter: mean relative error against {} samples of the "
             "reference\n", 2048);
  fmt::print("  LTC, 1 sample per pixel      {:6.2f} %  {:8.3f} s\n", 100 * ltc_error, ltc_seconds);

  options.integrator = render::Integrator::reference;
  for (int samples = 1; samples <= 1024; samples *= 2) {
    options.samples = samples;
    const render::Picture reference = rendered(scene, options);
    const double error = error_of(reference, truth).mean_relative;
    fmt::print("  reference, {:4} samples      {:6.2f} %  {:8.3f} s   {:6.1f} x the time\n", samples,
               100 * error, reference.render_seconds, reference.render_seconds / ltc_seconds);
    if (error <= ltc_error) break;
  }
  error_by_surface(scene, ltc.radiance, truth.radiance);
}

} // namespace

int main() {
  const scene::Scene scene = load("demo.glb");
  frame_times(scene);
  errors(scene);
}
