// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of the public API go through the kernel a block at a time: what make_surface asks of them
// is asked here, point by point, into the kernel's own arrays.

#include "openltc/batch.h"

#include "openltc/api/surface.h"
#include "openltc/base/parallel.h"
#include "openltc/kernel/batch_lights.h"
#include "openltc/kernel/shading_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc {

namespace {

constexpr std::size_t k_block = 512; // points; their fields fit in a core's own cache
static_assert(k_block % kernel::k_batch_padding == 0);

/// The kernel's arrays of a block.
struct Block {
  std::array<std::array<float, k_block>, kernel::k_point_field_count> fields;
  std::array<std::array<float, k_block>, 3> radiance;
  std::array<bool, k_block> usable;

  void put3(kernel::PointField field, std::size_t i, Vec3f v) {
    fields[field][i] = v.x;
    fields[std::size_t(field) + 1][i] = v.y;
    fields[std::size_t(field) + 2][i] = v.z;
  }
};

Vec3f get3(const float* const (&arrays)[3], std::size_t i) {
  return {arrays[0][i], arrays[1][i], arrays[2][i]};
}

bool has3(const float* const (&arrays)[3]) { return arrays[0] && arrays[1] && arrays[2]; }
bool has_some(const float* const (&arrays)[3]) { return arrays[0] || arrays[1] || arrays[2]; }

bool has_materials(const PointBatch& points) {
  return points.base_color[0] || points.metallic || points.roughness || points.specular ||
         points.specular_color[0] || points.ior;
}

Material material_of(const PointBatch& points, std::size_t i) {
  Material m = points.material;
  if (points.base_color[0]) m.base_color = get3(points.base_color, i);
  if (points.metallic) m.metallic = points.metallic[i];
  if (points.roughness) m.roughness = points.roughness[i];
  if (points.specular) m.specular = points.specular[i];
  if (points.specular_color[0]) m.specular_color = get3(points.specular_color, i);
  if (points.ior) m.ior = points.ior[i];
  return m;
}

void gather(const PointBatch& points, const Reflectance& r, std::size_t from, std::size_t i,
            Block& block) {
  const Vec3f position = get3(points.position, from);
  const bool has_triangle = points.geometric_normal[0] != nullptr;
  const detail::OrientedPoint oriented =
      has_triangle ? detail::orient(position, get3(points.normal, from), get3(points.view, from),
                                    get3(points.geometric_normal, from))
                   : detail::orient(position, get3(points.normal, from), get3(points.view, from));
  const bool usable = oriented.usable;
  block.usable[i] = usable;
  const Vec3f up(0, 0, 1);
  block.put3(kernel::k_position_x, i, usable ? position : Vec3f(0.0f));
  block.put3(kernel::k_normal_x, i, usable ? oriented.normal : up);
  block.put3(kernel::k_geometric_x, i, usable ? oriented.geometric : up);
  block.put3(kernel::k_view_x, i, usable ? oriented.view : up);
  block.put3(kernel::k_albedo_r, i, r.albedo);
  block.put3(kernel::k_f0_r, i, r.f0);
  block.fields[kernel::k_f90][i] = r.f90;
  block.fields[kernel::k_roughness][i] = r.roughness;
  // The kernel knows a position within half of this.
  float error = f32::k_position_rounding * length(usable ? position : Vec3f(0.0f));
  if (points.position_error && points.position_error[from] > error)
    error = std::min(points.position_error[from], k_max_coordinate);
  block.fields[kernel::k_offset][i] = 2 * error;
}

void shade_block(const PointBatch& points, const kernel::Kernel& kernel,
                 const kernel::KernelContext& context, std::size_t begin, std::size_t count,
                 float* const radiance[3]) {
  Block block;
  const std::size_t padded =
      (count + kernel::k_batch_padding - 1) / kernel::k_batch_padding * kernel::k_batch_padding;
  const bool differ = has_materials(points);
  Reflectance reflectance = reflectance_of(points.material);
  for (std::size_t i = 0; i < padded; ++i) {
    const std::size_t from = begin + std::min(i, count - 1); // the last point fills its register
    if (differ) reflectance = reflectance_of(material_of(points, from));
    gather(points, reflectance, from, i, block);
  }
  kernel::ShadingBatch batch;
  batch.count = int(count);
  for (std::size_t f = 0; f < block.fields.size(); ++f)
    batch.in[f] = block.fields[f].data();
  for (std::size_t c = 0; c < 3; ++c)
    batch.out[c] = block.radiance[c].data();
  kernel.shade(context, batch);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < count; ++i)
      radiance[c][begin + i] = block.usable[i] ? block.radiance[c][i] : 0.0f;
}

} // namespace

const char* shade_batch(const PointBatch& points, const BatchLights& lights, const Lobes& lobes,
                        float* const radiance[3], const BatchOptions& options) {
  if (!radiance) return "there is no array for the radiance";
  if (points.count == 0) return nullptr;
  if (!radiance[0] || !radiance[1] || !radiance[2])
    return "an array for the radiance is missing: r, g and b are wanted";
  if (!has3(points.position) || !has3(points.normal) || !has3(points.view))
    return "an array of positions, normals or views is missing: x, y and z are wanted of each";
  for (const auto* arrays : {&points.geometric_normal, &points.base_color, &points.specular_color})
    if (has_some(*arrays) && !has3(*arrays))
      return "geometric_normal, base_color and specular_color have three arrays each, or none";
  if (!detail::has_lobes(lobes)) return "there are no lobes";
  const kernel::Kernel kernel = kernel::kernel_by_name(options.kernel ? options.kernel : "auto");
  if (!kernel.shade) return "this machine has no kernel of that name";

  const BatchLights::Packed& packed = lights.packed();
  kernel::KernelContext context;
  if (options.correct_at_mean) context.specular_form = kernel::SpecularForm::ratio;
  if (options.adaptive) context.specular_form = kernel::SpecularForm::adaptive;
  if (options.exact) context.specular_form = kernel::SpecularForm::exact;
  context.table = lobes.table;
  context.polynomial = lobes.polynomial;
  context.area_lights = packed.area_lights.data();
  context.area_light_count = int(packed.area_lights.size());
  context.punctual = packed.punctual.data();
  context.punctual_count = int(packed.punctual.size());
  const std::size_t blocks = (points.count + k_block - 1) / k_block;
  parallel_for(std::int64_t(blocks), options.threads, [&](std::int64_t b) {
    const std::size_t begin = std::size_t(b) * k_block;
    shade_block(points, kernel, context, begin, std::min(k_block, points.count - begin), radiance);
  });
  return nullptr;
}

const char* batch_kernel() { return kernel::best_kernel().name; }

} // namespace openltc
