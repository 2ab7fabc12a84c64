// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Accessors: glTF 2.0 specification, section 3.6.2; normalised integers: section 3.11 (Animations),
// equations of the table "normalized to float"; quantised ones: KHR_mesh_quantization.

#include "openltc/scene/gltf/file/accessor.h"

#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/tinygltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace openltc::scene::gltf {

namespace {

// An accessor without a buffer view is all zeros, so that a few bytes of text could ask for any
// amount of memory. No sensible file has more of those.
constexpr std::size_t k_max_count_without_data = std::size_t(1) << 22;

// `count` elements of `size` bytes, `stride` bytes apart.
struct Range {
  const std::uint8_t* data = nullptr;
  std::size_t stride = 0;
};

Range element_range(const Document& document, int view_index, std::size_t offset, std::size_t count,
                    std::size_t size, bool may_be_strided, const std::string& field) {
  const View& view = document.views[std::size_t(view_index)];
  const std::size_t stride = may_be_strided && view.stride != 0 ? view.stride : size;
  if (stride < size)
    fail(fmt::format("bufferViews[{}].byteStride", view_index),
         fmt::format("{} is less than the {} bytes of an element of {}; export the file again",
                     stride, size, field));
  // offset + (count - 1) * stride + size <= available, without overflow
  const std::size_t available = view.bytes.size();
  const bool fits = offset <= available && size <= available - offset &&
                    (count - 1) <= (available - offset - size) / stride;
  if (!fits)
    fail(field + ".count",
         fmt::format(
             "{} elements of {} bytes from byte {} do not fit into bufferViews[{}], which has "
             "{} bytes; the file is damaged, export it again",
             count, size, offset, view_index, available));
  return {view.bytes.data() + offset, stride};
}

template <class T> T load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

float load_component(const std::uint8_t* bytes, int component_type, bool normalized) {
  switch (component_type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE: {
    const float value = float(load<std::int8_t>(bytes));
    return normalized ? std::max(value / 127.0f, -1.0f) : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
    const float value = float(load<std::uint8_t>(bytes));
    return normalized ? value / 255.0f : value;
  }
  case TINYGLTF_COMPONENT_TYPE_SHORT: {
    const float value = float(load<std::int16_t>(bytes));
    return normalized ? std::max(value / 32767.0f, -1.0f) : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
    const float value = float(load<std::uint16_t>(bytes));
    return normalized ? value / 65535.0f : value;
  }
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: {
    const float value = float(load<std::uint32_t>(bytes));
    return normalized ? value / 4294967295.0f : value;
  }
  default:
    return load<float>(bytes);
  }
}

std::uint32_t load_index(const std::uint8_t* bytes, int component_type) {
  switch (component_type) {
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return load<std::uint8_t>(bytes);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return load<std::uint16_t>(bytes);
  default:
    return load<std::uint32_t>(bytes);
  }
}

std::size_t component_size(int component_type) {
  return std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type)));
}

// Calls store(element, bytes of the element) for each value that the accessor's own data and then
// its sparse part hold, of the elements from `first` to `end` - 1.
template <class Store>
void visit_elements(const Document& document, int index, std::size_t element_size,
                    std::size_t first, std::size_t end, const Store& store) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  const std::string field = accessor_field(index);
  if (accessor.bufferView >= 0) {
    const Range range = element_range(document, accessor.bufferView, accessor.byteOffset,
                                      accessor.count, element_size, true, field);
    for (std::size_t i = first; i < end; ++i)
      store(i, range.data + i * range.stride);
  }
  if (!accessor.sparse.isSparse) return;

  const std::size_t sparse_count = std::size_t(accessor.sparse.count);
  if (sparse_count == 0) return;
  if (sparse_count > accessor.count)
    fail(field + ".sparse.count",
         fmt::format("{} is more than the accessor's {} elements", sparse_count, accessor.count));
  const int index_type = accessor.sparse.indices.componentType;
  const std::size_t index_size = component_size(index_type);
  const Range indices = element_range(document, accessor.sparse.indices.bufferView,
                                      std::size_t(accessor.sparse.indices.byteOffset), sparse_count,
                                      index_size, false, field + ".sparse.indices");
  const Range values = element_range(document, accessor.sparse.values.bufferView,
                                     std::size_t(accessor.sparse.values.byteOffset), sparse_count,
                                     element_size, false, field + ".sparse.values");
  for (std::size_t i = 0; i < sparse_count; ++i) {
    const std::uint32_t element = load_index(indices.data + i * indices.stride, index_type);
    if (element >= accessor.count)
      fail(field + ".sparse.indices",
           fmt::format("element {} is out of range, there are {}", element, accessor.count));
    if (element >= first && element < end) store(element, values.data + i * values.stride);
  }
}

// Checks the range once before anything is allocated.
void check_count(const Document& document, int index, std::size_t element_size) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  const std::string field = accessor_field(index);
  if (accessor.count == 0) fail(field + ".count", "must be at least 1");
  if (accessor.bufferView >= 0) {
    element_range(document, accessor.bufferView, accessor.byteOffset, accessor.count, element_size,
                  true, field);
  } else if (accessor.count > k_max_count_without_data) {
    fail(field + ".count",
         fmt::format("{} elements without any data; the file is damaged, export it "
                     "again",
                     accessor.count));
  }
}

} // namespace

std::string accessor_field(int index) { return fmt::format("accessors[{}]", index); }

std::size_t accessor_count(const Document& document, int index) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  const int components = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
  if (components < 1) return 0;
  check_count(document, index, component_size(accessor.componentType) * std::size_t(components));
  return accessor.count;
}

Floats read_floats(const Document& document, int index) {
  return read_floats(document, index, 0, document.model->accessors[std::size_t(index)].count);
}

Floats read_floats(const Document& document, int index, std::size_t first, std::size_t count) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  const int type = accessor.componentType;
  const std::size_t size = component_size(type);
  const int components = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
  if (components < 1 || components > 4 || accessor.type == TINYGLTF_TYPE_MAT2)
    fail(accessor_field(index) + ".type", "a matrix cannot be a vertex attribute");
  Floats result;
  result.components = std::size_t(components);
  result.count = count;
  check_count(document, index, size * result.components);
  take_memory(result.memory, saturating_product(result.count, result.components * sizeof(float)),
              accessor_field(index));
  result.values.resize(result.count * result.components);
  visit_elements(document, index, size * result.components, first, first + count,
                 [&](std::size_t element, const std::uint8_t* bytes) {
                   for (std::size_t c = 0; c < result.components; ++c)
                     result.values[(element - first) * result.components + c] =
                         load_component(bytes + c * size, type, accessor.normalized);
                 });
  return result;
}

std::vector<std::array<float, 16>> read_matrices(const Document& document, int index) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  if (accessor.type != TINYGLTF_TYPE_MAT4 ||
      accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail(accessor_field(index) + ".type", "must be MAT4 of floats to hold matrices");
  constexpr std::size_t size = 16 * sizeof(float);
  check_count(document, index, size);
  MemoryShare memory;
  take_memory(memory, saturating_product(accessor.count, size), accessor_field(index));
  std::vector<std::array<float, 16>> matrices(accessor.count);
  visit_elements(document, index, size, 0, accessor.count,
                 [&](std::size_t element, const std::uint8_t* bytes) {
                   std::memcpy(matrices[element].data(), bytes, size);
                 });
  return matrices;
}

std::vector<std::uint32_t> read_indices(const Document& document, int index) {
  const tinygltf::Accessor& accessor = document.model->accessors[std::size_t(index)];
  const int type = accessor.componentType;
  if (accessor.type != TINYGLTF_TYPE_SCALAR)
    fail(accessor_field(index) + ".type", "must be SCALAR to be used as indices");
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    fail(accessor_field(index) + ".componentType",
         fmt::format("{} cannot be used as indices; it must be 5121, 5123 or 5125", type));
  const std::size_t size = component_size(type);
  check_count(document, index, size);
  MemoryShare memory;
  take_memory(memory, saturating_product(accessor.count, sizeof(std::uint32_t)),
              accessor_field(index));
  std::vector<std::uint32_t> indices(accessor.count);
  visit_elements(document, index, size, 0, accessor.count,
                 [&](std::size_t element, const std::uint8_t* bytes) {
                   indices[element] = load_index(bytes, type);
                 });
  return indices;
}

} // namespace openltc::scene::gltf
