// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The picture is cut into tiles that threads take as they come. A tile depends on nothing but the
// scene and the options, so the bytes are the same for any number of threads.

#include "openltc/render/renderer.h"

#include "openltc/base/parallel.h"
#include "openltc/base/progress.h"
#include "openltc/base/sampling.h"
#include "openltc/render/camera_rays.h"
#include "openltc/render/lights/light_chooser.h"
#include "openltc/render/lights/light_level.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/lights/light_tree.h"
#include "openltc/render/options_check.h"
#include "openltc/render/point_buffer.h"
#include "openltc/render/ray_scene.h"
#include "openltc/render/shadow_ratio.h"
#include "openltc/render/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>

namespace openltc::render {

namespace {

constexpr int k_tile = k_tile_side; // a row of a tile is one ray packet
constexpr int k_max_layers = 32;    // blended surfaces along one camera ray; the last is opaque
constexpr int k_max_clear_layers = 4096; // culled or fully clear ones, which do not count
constexpr int k_tile_pixels = k_tile * k_tile;
constexpr std::size_t k_batch = k_most_points;
constexpr std::uint32_t k_purpose_pixel = 0;
// Fewer lights than this are all shaded: choosing among them costs as much.
constexpr int k_min_lights_to_choose = 6;
/// The BRDF of the materials, by its name in files of lobes, whose ratio to the lobe is known.
constexpr const char* k_ratio_brdf = "ggx";
// From so many lights on the reference draws some for each sample instead of taking all.
constexpr int k_min_lights_to_draw = 128;
constexpr int k_drawn_lights = 96;
constexpr int k_most_tries = 8; // random numbers of any other purpose for one point

static_assert(k_tile == RayPacket::k_size);

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Job {
  const scene::Scene& scene;
  const RenderOptions& options;
  const CameraRays& camera;
  const TextureSet& textures;
  const RayScene& rays;
  Kernel kernel;
  KernelContext context;
  const LightTree* tree; ///< null: all lights shade all points
  LightErrorScale error_scale;
  PixelWindow window;
  ShadowPlan shadows; ///< of the LTC integrator
  bool diffuse_error; ///< whether neighbours share a sequence, see z_order
};

/// What shading took, over all tiles.
struct ShadingWork {
  std::atomic<std::int64_t> points{0};
  std::atomic<std::int64_t> exact{0}, far{0}; ///< pairs of a point and a light or a far group
  std::atomic<double> error_nits{0};          ///< the largest that a choice of lights allowed

  void add_error(double nits) {
    double largest = error_nits;
    while (nits > largest && !error_nits.compare_exchange_weak(largest, nits)) {
    }
  }
};

bool needs_ratio(const KernelContext& context) {
  return context.integrator == Integrator::ltc && context.trace && context.area_light_count > 0;
}

/// One tile's pixels and the samples of the chunk in work.
class Tile {
public:
  Tile(const Job& job, int x0, int y0)
      : job_(job), x0_(x0), y0_(y0), width_(std::min(k_tile, job.options.width - x0)),
        height_(std::min(k_tile, job.options.height - y0)), points_(k_batch) {
    if (job.tree) chooser_.emplace(job.kernel, job.context, *job.tree, job.error_scale);
  }

  void render(Picture& picture, ShadingWork& work) {
    const int samples = job_.options.samples;
    const int pixels = k_tile_pixels;
    std::vector<Vec3d> sum(std::size_t(pixels), Vec3d(0.0)), sum2 = sum;
    if (needs_ratio(job_.context))
      shadows_.emplace(job_.kernel, job_.context, job_.shadows, k_tile);
    if (!job_.tree) {
      all_lights_.exact.resize(std::size_t(job_.context.area_light_count));
      std::iota(all_lights_.exact.begin(), all_lights_.exact.end(), 0);
    }
    const int chunk = std::clamp(int(k_batch) / pixels, 1, samples);
    for (int first = 0; first < samples; first += chunk) {
      const int count = std::min(chunk, samples - first);
      samples_.assign(std::size_t(pixels * count), Vec3f(0.0f));
      if (shadows_) shadows_->begin(first, count);
      for (int s = 0; s < count; ++s)
        for (int row = 0; row < height_; ++row)
          trace_row(row, first + s, s * pixels);
      shade_points();
      for (int i = 0; i < pixels * count; ++i) {
        const Vec3f& v = samples_[std::size_t(i)];
        const Vec3d d(v.x, v.y, v.z);
        sum[std::size_t(i % pixels)] += d;
        sum2[std::size_t(i % pixels)] += d * d;
      }
    }
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column) {
        const std::size_t i = std::size_t(row * k_tile + column);
        const int x = x0_ - job_.window.x0 + column, y = y0_ - job_.window.y0 + row;
        const double n = samples;
        const Vec3d mean = sum[i] / n;
        const Vec3d areas = shadows_ ? shadows_->light(i) / n : Vec3d(0.0);
        const auto error = [&](double m, double s2) {
          return n > 1 ? float(std::sqrt(std::max(s2 / n - m * m, 0.0) / (n - 1))) : 0.0f;
        };
        float* out = picture.radiance.pixel(x, y);
        out[0] = float(mean.x + areas.x);
        out[1] = float(mean.y + areas.y);
        out[2] = float(mean.z + areas.z);
        if (picture.standard_error.data.empty()) continue;
        float* e = picture.standard_error.pixel(x, y);
        e[0] = error(mean.x, sum2[i].x);
        e[1] = error(mean.y, sum2[i].y);
        e[2] = error(mean.z, sum2[i].z);
      }
    work.points += points_shaded_;
    work.exact += exact_;
    work.far += far_;
    work.add_error(error_nits_);
  }

private:
  void shade_points() {
    if (points_.empty()) return;
    const auto shade = [&](PointBuffer::Range range, const LightChoice& choice) {
      shade_range(range, choice);
    };
    if (chooser_)
      chooser_->light(points_, points_.all(), shade);
    else
      shade(points_.all(), all_lights_);
    if (shadows_) shadows_->finish(points_, samples_);
    points_.clear();
  }

  void shade_range(PointBuffer::Range range, const LightChoice& choice) {
    const std::int64_t count = std::int64_t(range.size());
    points_shaded_ += count;
    exact_ += count * std::int64_t(choice.exact.size());
    far_ += count * std::int64_t(choice.far.size());
    error_nits_ = std::max(error_nits_, choice.error_nits);
    if (shadows_) {
      shadows_->shade(points_, range, choice, samples_);
      return;
    }
    std::vector<float> no_ratio;
    points_.shade(job_.kernel, job_.context, range, lighting_of(choice), samples_, {no_ratio, 0});
  }

  // Where the samples of a pixel are from: sample i is index + i of the sequence of the seed.
  struct PixelSequence {
    std::uint32_t seed, index;
  };
  PixelSequence pixel_sequence(int x, int y) const {
    if (!job_.diffuse_error)
      return {hash_combine(hash_combine(std::uint32_t(x), std::uint32_t(y)), job_.options.seed), 0};
    const std::uint32_t block_x = std::uint32_t(x) >> k_block_bits,
                        block_y = std::uint32_t(y) >> k_block_bits;
    return {hash_combine(hash_combine(block_x, block_y), job_.options.seed),
            z_order(std::uint32_t(x), std::uint32_t(y))
                << bits_below(std::uint32_t(job_.options.samples))};
  }

  // One camera sample of each pixel in a row; entry `target` + pixel of samples_ receives it.
  void trace_row(int row, int sample, int target) {
    RayPacket packet{};
    float throughput[k_tile];
    PixelSequence sequence[k_tile];
    for (int i = 0; i < k_tile; ++i) {
      const int x = x0_ + std::min(i, width_ - 1), y = y0_ + row;
      sequence[i] = pixel_sequence(x, y);
      float dx = 0, dy = 0;
      if (job_.options.samples > 1 && job_.options.filter != PixelFilter::none) {
        const Sample2 u = owen_sobol(sequence[i].index + std::uint32_t(sample),
                                     hash_combine(sequence[i].seed, k_purpose_pixel));
        dx = filter_offset(u.u);
        dy = filter_offset(u.v);
      }
      const CameraRay ray = job_.camera.ray(float(x) + 0.5f + dx, float(y) + 0.5f + dy);
      packet.origin[0][i] = ray.origin.x;
      packet.origin[1][i] = ray.origin.y;
      packet.origin[2][i] = ray.origin.z;
      packet.direction[0][i] = ray.direction.x;
      packet.direction[1][i] = ray.direction.y;
      packet.direction[2][i] = ray.direction.z;
      packet.near[i] = ray.near;
      packet.far[i] = ray.far;
      packet.active[i] = i < width_ ? -1 : 0;
      throughput[i] = 1;
    }

    const int base = target + row * k_tile;
    int layers[k_tile] = {};
    for (int pass = 0; pass < k_max_layers + k_max_clear_layers; ++pass) {
      const HitPacket hits = job_.rays.intersect(packet);
      bool more = false;
      for (int i = 0; i < width_; ++i) {
        if (!packet.active[i]) continue;
        packet.active[i] = 0;
        Vec3f& radiance = samples_[std::size_t(base + i)];
        if (hits.mesh[i] < 0) {
          radiance += job_.options.background * throughput[i];
          continue;
        }
        SurfacePoint point = evaluate_surface(
            job_.scene, job_.textures, std::uint32_t(hits.mesh[i]), hits.triangle[i], hits.u[i],
            hits.v[i],
            Vec3f(packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]),
            job_.camera.footprint(hits.distance[i]));
        if (point.alpha > 0 && ++layers[i] == k_max_layers) point.alpha = 1;
        const float weight = throughput[i] * point.alpha;
        radiance += point.emission * weight;
        if (point.lit && weight > 0) {
          points_.add(point, {std::uint32_t(base + i), std::uint32_t(row * k_tile + i),
                              sequence[i].seed, sequence[i].index + std::uint32_t(sample), weight});
          if (points_.full()) shade_points();
        }
        throughput[i] *= 1 - point.alpha;
        if (throughput[i] > 1.0e-3f) {
          // Go on behind the blended surface.
          packet.near[i] = hits.distance[i] * (1 + 2.0e-6f) + 1.0e-6f * point.offset;
          packet.active[i] = -1;
          more = true;
        }
      }
      if (!more) break;
    }
  }

  const Job& job_;
  int x0_, y0_, width_, height_;
  PointBuffer points_;
  std::vector<Vec3f> samples_;
  std::optional<LightChooser> chooser_;
  LightChoice all_lights_;             // without one
  std::optional<ShadowRatio> shadows_; // where lights cast any
  std::int64_t points_shaded_ = 0, exact_ = 0, far_ = 0;
  double error_nits_ = 0;
};

} // namespace

LobeSource builtin_lobes_for(const light::Lights& lights) {
  const std::size_t count = lights.area_light_count();
  return count > 0 && count < k_many_lights ? table::builtin_ggx_two_lobe_table()
                                            : table::builtin_ggx_table();
}

Result<Picture> render(const scene::Scene& scene, const scene::Camera& camera,
                       const LobeSource& lobes, const RenderOptions& options) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (options.specular_form == SpecularForm::ratio && !lobes.brdf.empty() &&
      lobes.brdf != k_ratio_brdf)
    return Error{fmt::format("these lobes were fitted to {}, and the ratio of the BRDF to its lobe "
                             "is that of {}: shade by the lobe alone",
                             lobes.brdf, k_ratio_brdf)};
  const bool by_ggx = options.specular_form == SpecularForm::exact ||
                      options.specular_form == SpecularForm::adaptive;
  if (by_ggx && !lobes.brdf.empty() && lobes.brdf != k_ratio_brdf)
    return Error{fmt::format("these lobes were fitted to {}, and exact specular light is that of "
                             "{}: shade by the lobe alone",
                             lobes.brdf, k_ratio_brdf)};
  const auto build_start = std::chrono::steady_clock::now();

  const Kernel kernel = kernel_by_name(options.kernel.c_str());
  if (!kernel.shade)
    return Error{fmt::format("this machine or build has no \"{}\" shading kernel", options.kernel)};
  const TextureSet textures(scene);
  auto rays = RayScene::create(scene, textures);
  if (!rays.ok()) return rays.error();
  const LightSet lights = pack_lights(scene.lights);
  const CameraRays camera_rays(camera, options.width, options.height);

  Job job{scene, options, camera_rays, textures,           **rays, kernel,
          {},    nullptr, {},          window_of(options), {},     false};
  KernelContext& context = job.context;
  context.table = lobes.table;
  context.polynomial = lobes.polynomial;
  context.area_lights = lights.area_lights.data();
  context.area_light_count = int(lights.area_lights.size());
  context.punctual = lights.punctual.data();
  context.punctual_count = int(lights.punctual.size());
  context.integrator = options.integrator;
  context.punctual_form = options.punctual_form;
  const bool corrects = lobes.brdf == k_ratio_brdf && lights.area_lights.size() < k_many_lights;
  context.specular_form =
      options.specular_form.value_or(corrects ? SpecularForm::adaptive : SpecularForm::lobe);
  const bool reference = options.integrator == Integrator::reference;
  context.lobe_samples = options.lobe_samples;
  context.light_samples = context.brdf_samples = 1; // the LTC integrator has its own plan
  job.shadows = plan_shadows(options.shadow_samples, options.samples);
  if (options.shadow_samples > 0) {
    context.trace = [](const void* tracer, const ShadowRays& shadow_rays) {
      static_cast<const RayScene*>(tracer)->trace_shadows(shadow_rays);
    };
    context.tracer = rays->get();
  }

  // The reference's pixels stay independent of each other. So do those whose samples are too many
  // for an index of 32 bits, where noise is no question any more.
  const int most_samples = std::max(k_far_light_samples * job.shadows.more.of_light, k_most_tries);
  job.diffuse_error = !reference && 2 * k_block_bits + bits_below(std::uint32_t(options.samples)) +
                                            bits_below(std::uint32_t(most_samples)) <=
                                        32;

  LightTree tree;
  const int count = context.area_light_count;
  if (reference ? count >= k_min_lights_to_draw
                : options.light_error > 0 && count >= k_min_lights_to_choose)
    tree = LightTree(lights.tree_lights);
  if (reference && !tree.nodes().empty()) {
    context.light_nodes = {tree.nodes().data(), k_drawn_lights};
  } else if (!tree.nodes().empty()) {
    context.far_lights.order = tree.order().data();
    context.far_lights.cdf = tree.cdf().data();
    for (const AreaLightView& light : lights.area_lights)
      context.far_lights.surface_deviation =
          std::max(context.far_lights.surface_deviation, 1.5f * light.surface_deviation);
    job.tree = &tree;
    job.error_scale = {double(options.light_error),
                       light_level_nits(scene, textures, **rays, camera_rays, options.width,
                                        options.height, kernel, context, options.threads)};
  }

  Picture picture;
  const PixelWindow& window = job.window;
  picture.radiance = image::Image(window.x1 - window.x0, window.y1 - window.y0, 3);
  if (reference && options.samples > 1)
    picture.standard_error = image::Image(picture.radiance.width, picture.radiance.height, 3);
  picture.kernel = kernel.name;
  picture.warnings = lights.warnings;
  picture.build_seconds = seconds_since(build_start);

  ShadingWork work;
  const auto render_start = std::chrono::steady_clock::now();
  const int columns = (picture.radiance.width + k_tile - 1) / k_tile;
  const int rows = (picture.radiance.height + k_tile - 1) / k_tile;
  ProgressCount done(std::int64_t(columns) * rows, options.progress);
  parallel_for(std::int64_t(columns) * rows, options.threads, [&](std::int64_t i) {
    if (done.is_cancelled()) return;
    Tile(job, window.x0 + int(i % columns) * k_tile, window.y0 + int(i / columns) * k_tile)
        .render(picture, work);
    done.add(1);
  });
  if (done.is_cancelled()) return cancelled();
  const double points = double(std::max<std::int64_t>(work.points, 1));
  picture.lights_per_point = double(work.exact) / points;
  picture.far_groups_per_point = double(work.far) / points;
  picture.light_error_nits = work.error_nits;
  picture.render_seconds = seconds_since(render_start);
  return picture;
}

} // namespace openltc::render
