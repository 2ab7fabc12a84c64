// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/form_trade.h"

#include "openltc/base/sampling.h"
#include "openltc/render/lights/light_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace openltc::render {

namespace {

constexpr std::size_t k_timed_points = 2048;
constexpr int k_quads = 9, k_rounds = 40;

LobeSource lobes_of(const TradeForm& form) {
  return form.two_lobes ? table::builtin_ggx_two_lobe_table() : table::builtin_ggx_table();
}

/// Points of a floor, 4 m square, as a renderer shades them: sixteen neighbours are of one material
/// and seen from nearly the same direction, any above the floor.
struct Floor {
  std::array<std::vector<float>, k_point_field_count> fields;
  std::array<std::vector<float>, 3> radiance;

  Floor() {
    for (auto& field : fields)
      field.assign(k_timed_points, 0.0f);
    for (auto& channel : radiance)
      channel.resize(k_timed_points);
    for (std::uint32_t i = 0; i < k_timed_points; ++i) {
      const std::uint32_t group = i / k_batch_padding, neighbour = i % k_batch_padding;
      const Sample2 place = owen_sobol(group, hash_combine(1, 0));
      const Sample2 view = owen_sobol(group, hash_combine(2, 0));
      const float up = 0.1f + 0.9f * view.u, along = std::sqrt(1 - up * up);
      const float turn = 6.2831853f * (view.v + 0.001f * float(neighbour));
      const auto put = [&](PointField field, float value) { fields[field][i] = value; };
      put(k_position_x, 4 * place.u - 2 + 0.01f * float(neighbour));
      put(k_position_y, 4 * place.v - 2);
      put(k_normal_z, 1);
      put(k_geometric_z, 1);
      put(k_view_x, along * std::cos(turn));
      put(k_view_y, along * std::sin(turn));
      put(k_view_z, up);
      for (const PointField field : {k_albedo_r, k_albedo_g, k_albedo_b})
        put(field, 0.5f);
      for (const PointField field : {k_f0_r, k_f0_g, k_f0_b})
        put(field, 0.04f);
      put(k_f90, 1);
      put(k_roughness, owen_sobol(group, hash_combine(3, 0)).u);
      put(k_offset, 1e-6f);
    }
  }

  ShadingBatch batch() {
    ShadingBatch batch;
    batch.count = int(k_timed_points);
    for (std::size_t f = 0; f < fields.size(); ++f)
      batch.in[f] = fields[f].data();
    for (std::size_t c = 0; c < radiance.size(); ++c)
      batch.out[c] = radiance[c].data();
    return batch;
  }
};

/// Lamps of 2 m under a ceiling 4 m high, seen whole from every point of the floor.
light::Lights ceiling_lamps() {
  light::Lights lights;
  for (int i = 0; i < k_quads; ++i) {
    const float x = 3.0f * float(i % 3 - 1), y = 3.0f * float(i / 3 - 1);
    light::PolygonLight quad;
    quad.radiance = Vec3f(1);
    quad.normal = Vec3f(0, 0, -1);
    quad.vertices = {{x - 1, y - 1, 4}, {x - 1, y + 1, 4}, {x + 1, y + 1, 4}, {x + 1, y - 1, 4}};
    quad.ring_end = {4};
    lights.polygons.push_back(std::move(quad));
  }
  return lights;
}

double nanoseconds_of(const Kernel& kernel, const KernelContext& context,
                      const ShadingBatch& batch) {
  const auto start = std::chrono::steady_clock::now();
  kernel.shade(context, batch);
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

RenderOptions picture_options(const TradeOptions& options) {
  RenderOptions picture;
  picture.width = options.width;
  picture.height = options.height;
  picture.samples = 1;
  picture.shadow_samples = 0;
  picture.light_error = 0;
  picture.filter = PixelFilter::none;
  picture.threads = options.threads;
  return picture;
}

double sum_of_differences(const image::Image& a, const image::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    sum += std::abs(double(a.data[i]) - double(b.data[i]));
  return sum;
}

/// The mean of two references of half the samples each, and half of their differences' sum.
struct Reference {
  image::Image radiance;
  double light = 0, noise = 0; ///< sums over pixels and channels
};

Result<Reference> render_reference(const scene::Scene& scene, const scene::Camera& camera,
                                   const TradeOptions& options) {
  RenderOptions picture = picture_options(options);
  picture.integrator = Integrator::reference;
  picture.samples = options.samples / 2;
  std::array<image::Image, 2> halves;
  for (std::uint32_t i = 0; i < 2; ++i) {
    picture.seed = i;
    picture.progress = part_of(options.progress, 0.5 * i, 0.5 * i + 0.5);
    Result<Picture> rendered = render(scene, camera, table::builtin_ggx_table(), picture);
    if (!rendered) return rendered.error();
    halves[i] = std::move(rendered->radiance);
  }
  Reference reference;
  reference.noise = 0.5 * sum_of_differences(halves[0], halves[1]);
  reference.radiance = std::move(halves[0]);
  for (std::size_t i = 0; i < reference.radiance.data.size(); ++i) {
    float& value = reference.radiance.data[i];
    value = 0.5f * (value + halves[1].data[i]);
    reference.light += double(value);
  }
  return reference;
}

} // namespace

Result<TradeValues> time_of_quad(const std::string& kernel_name) {
  const Kernel kernel = kernel_by_name(kernel_name.c_str());
  if (!kernel.shade)
    return Error{fmt::format("this machine or build has no \"{}\" shading kernel", kernel_name)};
  const light::Lights lamps = ceiling_lamps();
  const LightSet lights = pack_lights(lamps);
  Floor floor;
  const ShadingBatch batch = floor.batch();
  constexpr double k_none = std::numeric_limits<double>::infinity();
  TradeValues of_one, of_all;
  of_one.fill(k_none);
  of_all.fill(k_none);
  for (int round = 0; round < k_rounds; ++round)
    for (std::size_t f = 0; f < k_trade_forms.size(); ++f) {
      KernelContext context;
      context.table = lobes_of(k_trade_forms[f]).table;
      context.specular_form = k_trade_forms[f].specular;
      context.area_lights = lights.area_lights.data();
      context.area_light_count = 1;
      of_one[f] = std::min(of_one[f], nanoseconds_of(kernel, context, batch));
      context.area_light_count = int(lights.area_lights.size());
      of_all[f] = std::min(of_all[f], nanoseconds_of(kernel, context, batch));
    }
  TradeValues times;
  for (std::size_t f = 0; f < times.size(); ++f)
    times[f] = (of_all[f] - of_one[f]) / double((k_quads - 1) * k_timed_points);
  return times;
}

Result<std::optional<TradeErrors>>
trade_errors(const scene::Scene& scene, const scene::Camera& camera, const TradeOptions& options) {
  if (options.samples < 2)
    return Error{fmt::format("samples of the reference: {} is not 2 or more", options.samples)};
  const Result<Reference> reference = render_reference(scene, camera, options);
  if (!reference) return reference.error();
  if (!(reference->light > 0)) return std::optional<TradeErrors>();
  TradeErrors errors;
  errors.noise = reference->noise / reference->light;
  for (std::size_t f = 0; f < k_trade_forms.size(); ++f) {
    RenderOptions picture = picture_options(options);
    picture.specular_form = k_trade_forms[f].specular;
    const Result<Picture> rendered = render(scene, camera, lobes_of(k_trade_forms[f]), picture);
    if (!rendered) return rendered.error();
    errors.of_light[f] =
        sum_of_differences(rendered->radiance, reference->radiance) / reference->light;
  }
  return std::optional(errors);
}

} // namespace openltc::render
