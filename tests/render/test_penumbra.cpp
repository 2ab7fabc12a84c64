// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shadow rays in two parts: a few everywhere, many where those disagree. The light of a penumbra is
// that of the part of the light which is seen, by quadrature; and rays are not wasted on what is
// plain.

#include "openltc/render/camera_rays.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/shadow_ratio.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace openltc;

namespace {

constexpr double k_light = 0.2;  // half a side, metres; its plane is y = 1
constexpr double k_screen = 0.5; // height of what blocks it
constexpr int k_size = 32;       // pixels

// Irradiance over pi at a floor point from the part x0 < x < x1 of the light: midpoint rule of
// cos cos' / (pi d^2).
double from_part(double x0, double x1, double px, double pz) {
  constexpr int n = 64;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double qx = x0 + (x1 - x0) * (i + 0.5) / n - px;
      const double qz = -k_light + 2 * k_light * (j + 0.5) / n - pz;
      const double d2 = qx * qx + qz * qz + 1;
      sum += 1 / (std::numbers::pi * d2 * d2);
    }
  return sum * (x1 - x0) * 2 * k_light / (n * n);
}

/// A screen over the floor that covers x0 < x < x1.
struct Screen {
  double x0, x1;

  // A ray from the floor to (qx, 1) passes the screen's height half way.
  double seen(double px, double pz) const {
    const double a = std::clamp(2 * x0 - px, -k_light, k_light);
    const double b = std::clamp(2 * x1 - px, -k_light, k_light);
    return from_part(-k_light, a, px, pz) + from_part(b, k_light, px, pz);
  }
};

scene::Scene floor_under(const Screen& screen) {
  scene::Scene scene;
  test::add_floor(scene, 4, 0, test::diffuse_material(Vec3f(1)));
  test::add_floor(scene, 1, float(k_screen), test::diffuse_material(Vec3f(0)));
  scene.materials.back().double_sided = true;
  for (Vec3f& p : scene.meshes.back().positions) {
    p.x = p.x < 0 ? float(screen.x0) : float(screen.x1);
    p.z *= 4;
  }
  scene.lights.polygons.push_back(test::ceiling_rectangle(float(-k_light), float(-k_light),
                                                          float(k_light), float(k_light), 1, 1));
  scene::Camera camera = test::look_at({0, float(k_screen) - 0.01f, 0.0001f}, {0, 0, 0}, 0.5f);
  camera.projection = scene::Projection::orthographic;
  camera.height = 1;
  scene.cameras.push_back(camera);
  return scene;
}

} // namespace

TEST_CASE("a penumbra has the light of what is seen of the light, on average over seeds") {
  // What stops early where its first rays agree errs by chance towards that. Of n rays that all
  // agree where a share p of them should not, the error is p (1 - p)^n, at most 1 / (e (n + 1)); at
  // a tile's corner n is that of 3 x 3 pixels of 6 rays, elsewhere 150.
  constexpr double bound = 1 / (std::numbers::e * 55);
  constexpr int seeds = 48;
  for (const Screen& screen : {Screen{-3, 0}, Screen{-0.002, 0.002}, Screen{-0.02, 0.03}})
    for (const int samples : {1, 4}) {
      CAPTURE(screen.x0);
      CAPTURE(screen.x1);
      CAPTURE(samples);
      const scene::Scene scene = floor_under(screen);
      std::vector<double> sum(k_size * k_size), columns(k_size), columns2(k_size);
      const render::CameraRays rays(scene.cameras[0], k_size, k_size);
      std::vector<double> expected(sum.size()), unshadowed(sum.size());
      for (int y = 0; y < k_size; ++y)
        for (int x = 0; x < k_size; ++x) {
          const Vec3f p = rays.ray(float(x) + 0.5f, float(y) + 0.5f).origin;
          expected[std::size_t(y * k_size + x)] = screen.seen(double(p.x), double(p.z));
          unshadowed[std::size_t(y * k_size + x)] =
              from_part(-k_light, k_light, double(p.x), double(p.z));
        }
      for (int seed = 0; seed < seeds; ++seed) {
        render::RenderOptions options;
        options.width = options.height = k_size;
        options.samples = samples;
        options.filter = render::PixelFilter::none;
        options.seed = std::uint32_t(seed);
        const render::Picture picture = test::rendered(scene, options);
        for (int x = 0; x < k_size; ++x) {
          double mean = 0;
          for (int y = 0; y < k_size; ++y) {
            const std::size_t i = std::size_t(y * k_size + x);
            mean += (double(picture.radiance.data[3 * i]) - expected[i]) / unshadowed[i] / k_size;
          }
          columns[std::size_t(x)] += mean;
          columns2[std::size_t(x)] += mean * mean;
        }
      }
      double worst = 0;
      for (std::size_t x = 0; x < k_size; ++x) {
        const double bias = columns[x] / seeds;
        const double error =
            std::sqrt(std::max(columns2[x] / seeds - bias * bias, 0.0) / (seeds - 1));
        worst = std::max(worst, std::abs(bias));
        CHECK(std::abs(bias) < bound + 4 * error);
      }
      MESSAGE("largest bias of a column: " << worst);
      CHECK(worst < 2 * bound);
    }
}

namespace {

/// Says of each ray whether it passes a half plane, and counts.
struct HalfPlane {
  double edge; // x; no further than it the light is blocked
  mutable long rays = 0;
};

void trace_half_plane(const void* tracer, const render::ShadowRays& rays) {
  const auto& plane = *static_cast<const HalfPlane*>(tracer);
  for (int i = 0; i < rays.count; ++i) {
    if (!rays.active[i]) continue;
    ++plane.rays;
    const float at = float(k_screen) / rays.direction[1][i];
    const float x = rays.origin[0][i] + at * rays.direction[0][i];
    rays.transmittance[i] = x > float(plane.edge) ? 1.0f : 0.0f;
  }
}

} // namespace

TEST_CASE("few shadow rays where all agree, many where they do not") {
  constexpr int tile = 16, camera_samples = 8, shadow_samples = 16;
  const render::ShadowPlan plan = render::plan_shadows(shadow_samples, camera_samples);
  light::Lights lights;
  lights.polygons.push_back(test::ceiling_rectangle(float(-k_light), float(-k_light),
                                                    float(k_light), float(k_light), 1, 1));
  const render::LightSet set = render::pack_lights(lights);
  const render::Kernel kernel = render::best_kernel();
  // Rays per pixel of a tile of `metres` a side under a half plane.
  const auto rays_per_pixel = [&](double edge, float metres) {
    HalfPlane plane{edge};
    render::KernelContext context;
    context.table = table::builtin_ggx_table().view();
    context.area_lights = set.area_lights.data();
    context.area_light_count = 1;
    context.trace = trace_half_plane;
    context.tracer = &plane;
    render::PointBuffer points(render::k_most_points);
    std::vector<Vec3f> samples(std::size_t(tile * tile * camera_samples), Vec3f(0));
    for (std::uint32_t s = 0; s < camera_samples; ++s)
      for (std::uint32_t p = 0; p < tile * tile; ++p) {
        render::SurfacePoint point;
        point.position = {metres * (float(p % tile) / tile - 0.5f), 0,
                          metres * (float(p / tile) / tile - 0.5f)};
        point.normal = point.geometric = {0, 1, 0};
        point.view = normalize(Vec3f(0.1f, 1, 0.3f));
        point.albedo = Vec3f(0.5f);
        points.add(point, {s * tile * tile + p, p, 7, p * camera_samples + s, 1.0f});
      }
    render::ShadowRatio ratio(kernel, context, plan, tile);
    render::LightChoice all;
    all.exact = {0};
    ratio.begin(0, camera_samples);
    ratio.shade(points, points.all(), all, samples);
    ratio.finish(points, samples);
    return double(plane.rays) / (tile * tile);
  };
  // Its penumbra is 0.4 m wide.
  const double lit = rays_per_pixel(-5, 1), dark = rays_per_pixel(5, 1),
               all_penumbra = rays_per_pixel(0, 0.2f), across = rays_per_pixel(0, 4);
  MESSAGE("rays per pixel: lit " << lit << ", dark " << dark << ", penumbra " << all_penumbra
                                 << ", across " << across);
  CHECK(lit <= 8);
  CHECK(dark <= 8);
  CHECK(all_penumbra > 2 * shadow_samples);
  CHECK(across < 24); // a tenth of it and two pixels to each side are penumbra
  CHECK(across > lit);
}
