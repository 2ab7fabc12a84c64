// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/c_api/points.h"

#include "openltc/base/parallel.h"
#include "openltc/c_api/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace openltc::c_api {

namespace {

/// Element i of an array of T with a stride in bytes, wherever it lies.
template <class T> T read(const void* data, std::size_t stride, std::size_t i) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t step = stride == OPENLTC_SAME ? 0 : stride == 0 ? sizeof(T) : stride;
  T value;
  std::memcpy(&value, static_cast<const unsigned char*>(data) + i * step, sizeof(T));
  return value;
}

struct Float3 {
  float x, y, z;
};
static_assert(sizeof(Float3) == 12 && sizeof(openltc_material) == 40);

openltc_status check_array(const char* name, const void* data, std::size_t stride,
                           std::size_t size) {
  if (!data) return fail(OPENLTC_INVALID_ARGUMENT, fmt::format("points: {} is null", name));
  if (stride != 0 && stride < size)
    return fail(OPENLTC_INVALID_ARGUMENT,
                fmt::format("points: the stride of {} is {}, less than the {} bytes of one; 0 "
                            "stands for one after the other",
                            name, stride, size));
  return OPENLTC_OK;
}

Vec3f vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

} // namespace

openltc_status check_points(const openltc_points* points) {
  if (!points) return fail(OPENLTC_INVALID_ARGUMENT, "points is null");
  if (points->count == 0) return OPENLTC_OK;
  if (points->count > std::numeric_limits<std::size_t>::max() / 64)
    return fail(OPENLTC_INVALID_ARGUMENT, "points: count is more than memory can hold");
  struct Array {
    const char* name;
    const void* data;
    std::size_t stride, size;
    bool may_be_null = false;
  };
  const Array arrays[] = {
      {"positions", points->positions.data, points->positions.stride, sizeof(Float3)},
      {"normals", points->normals.data, points->normals.stride, sizeof(Float3)},
      {"views", points->views.data, points->views.stride, sizeof(Float3)},
      {"materials", points->materials.data, points->materials.stride, sizeof(openltc_material)},
      {"geometric_normals", points->geometric_normals.data, points->geometric_normals.stride,
       sizeof(Float3), true},
      {"position_errors", points->position_errors.data, points->position_errors.stride,
       sizeof(float), true},
  };
  for (const Array& array : arrays) {
    if (array.may_be_null && !array.data) continue;
    if (const openltc_status status = check_array(array.name, array.data, array.stride, array.size))
      return status;
  }
  return OPENLTC_OK;
}

Vec3f read_vector(const openltc_vectors& vectors, std::size_t i) {
  const Float3 v = read<Float3>(vectors.data, vectors.stride, i);
  return {v.x, v.y, v.z};
}

float read_number(const openltc_numbers& numbers, std::size_t i) {
  return read<float>(numbers.data, numbers.stride, i);
}

Material read_material(const openltc_materials& materials, std::size_t i) {
  const auto given = read<openltc_material>(materials.data, materials.stride, i);
  Material material;
  material.base_color = vector_of(given.base_color);
  material.metallic = given.metallic;
  material.roughness = given.roughness;
  material.specular = given.specular;
  material.specular_color = vector_of(given.specular_color);
  material.ior = given.ior;
  return material;
}

Surface read_surface(const Lobes& lobes, const openltc_points& points, std::size_t i) {
  const Material material = read_material(points.materials, i);
  const Vec3f position = read_vector(points.positions, i), normal = read_vector(points.normals, i),
              view = read_vector(points.views, i);
  Surface surface = points.geometric_normals.data
                        ? make_surface(position, normal, view, material, lobes,
                                       read_vector(points.geometric_normals, i))
                        : make_surface(position, normal, view, material, lobes);
  if (points.position_errors.data)
    set_position_error(surface, read_number(points.position_errors, i));
  return surface;
}

openltc_status for_ranges(std::size_t count, std::int32_t threads,
                          const std::function<void(std::size_t, std::size_t)>& work) {
  if (threads < 0) return fail(OPENLTC_INVALID_ARGUMENT, "threads is negative");
  const std::size_t parts = count / k_points_per_part + (count % k_points_per_part != 0 ? 1 : 0);
  const auto work_on = [&](std::int64_t part) {
    const std::size_t begin = std::size_t(part) * k_points_per_part;
    work(begin, std::min(begin + k_points_per_part, count));
  };
  if (threads != 1 && parts > 1)
    parallel_for(std::int64_t(parts), threads, work_on);
  else
    for (std::size_t part = 0; part < parts; ++part)
      work_on(std::int64_t(part));
  return OPENLTC_OK;
}

} // namespace openltc::c_api

openltc_material openltc_material_default(void) { return {{1, 1, 1}, 0, 1, 1, {1, 1, 1}, 1.5f}; }
