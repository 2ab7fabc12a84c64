// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/c_api/shade_points.h"

#include "openltc/c_api/points.h"

#include <array>
#include <stdexcept>

namespace openltc::c_api {

namespace {

using Column = std::array<float, k_points_per_part>;

/// A part of the caller's points, one array for each number, as PointBatch has them.
struct Columns {
  std::array<Column, 3> position, normal, view, geometric_normal, base_color, specular_color;
  Column position_error, metallic, roughness, specular, ior;

  static void put(std::array<Column, 3>& columns, std::size_t i, Vec3f v) {
    columns[0][i] = v.x;
    columns[1][i] = v.y;
    columns[2][i] = v.z;
  }
};

void point_to(const float* (&arrays)[3], const std::array<Column, 3>& columns) {
  for (std::size_t k = 0; k < 3; ++k)
    arrays[k] = columns[k].data();
}

void gather_materials(const openltc_materials& materials, std::size_t begin, std::size_t count,
                      Columns& columns, PointBatch& batch) {
  if (materials.stride == OPENLTC_SAME) {
    batch.material = read_material(materials, 0);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Material m = read_material(materials, begin + i);
    Columns::put(columns.base_color, i, m.base_color);
    Columns::put(columns.specular_color, i, m.specular_color);
    columns.metallic[i] = m.metallic;
    columns.roughness[i] = m.roughness;
    columns.specular[i] = m.specular;
    columns.ior[i] = m.ior;
  }
  point_to(batch.base_color, columns.base_color);
  point_to(batch.specular_color, columns.specular_color);
  batch.metallic = columns.metallic.data();
  batch.roughness = columns.roughness.data();
  batch.specular = columns.specular.data();
  batch.ior = columns.ior.data();
}

PointBatch gather(const openltc_points& points, std::size_t begin, std::size_t count,
                  Columns& columns) {
  PointBatch batch;
  batch.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    Columns::put(columns.position, i, read_vector(points.positions, begin + i));
    Columns::put(columns.normal, i, read_vector(points.normals, begin + i));
    Columns::put(columns.view, i, read_vector(points.views, begin + i));
  }
  point_to(batch.position, columns.position);
  point_to(batch.normal, columns.normal);
  point_to(batch.view, columns.view);
  if (points.geometric_normals.data) {
    for (std::size_t i = 0; i < count; ++i)
      Columns::put(columns.geometric_normal, i, read_vector(points.geometric_normals, begin + i));
    point_to(batch.geometric_normal, columns.geometric_normal);
  }
  if (points.position_errors.data) {
    for (std::size_t i = 0; i < count; ++i)
      columns.position_error[i] = read_number(points.position_errors, begin + i);
    batch.position_error = columns.position_error.data();
  }
  gather_materials(points.materials, begin, count, columns, batch);
  return batch;
}

void store(float* values, std::size_t i, Vec3f value) {
  values[3 * i] = value.x;
  values[3 * i + 1] = value.y;
  values[3 * i + 2] = value.z;
}

} // namespace

void shade_points(const openltc_lobes& lobes, const openltc_lights& lights,
                  const openltc_points& points, std::size_t begin, std::size_t end,
                  float* radiance) {
  const std::size_t count = end - begin;
  Columns columns; // left as they are where nothing is gathered
  const PointBatch batch = gather(points, begin, count, columns);
  std::array<Column, 3> out;
  float* const arrays[3] = {out[0].data(), out[1].data(), out[2].data()};
  // One block, which stays on this thread, however many there may be.
  if (const char* error = shade_batch(batch, lights.batch, lobes.view, arrays))
    throw std::logic_error(error);
  for (std::size_t i = 0; i < count; ++i)
    store(radiance, begin + i, {out[0][i], out[1][i], out[2][i]});
}

void shade_parts_of_points(const openltc_lobes& lobes, const openltc_lights& lights,
                           const openltc_points& points, std::size_t begin, std::size_t end,
                           float* diffuse, float* specular) {
  for (std::size_t i = begin; i < end; ++i) {
    const Surface surface = read_surface(lobes.view, points, i);
    ShadedParts sum;
    for (const ListedLight& listed : lights.lights) {
      const ShadedParts parts =
          std::visit([&](const auto& light) { return shade_parts(surface, light); }, listed.light);
      sum.diffuse += detail::finite_light(parts.diffuse * listed.radiance);
      sum.specular += detail::finite_light(parts.specular * listed.radiance);
    }
    store(diffuse, i, detail::finite_light(sum.diffuse));
    store(specular, i, detail::finite_light(sum.specular));
  }
}

} // namespace openltc::c_api
