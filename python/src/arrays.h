// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Numbers as NumPy arrays.

#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <utility>
#include <vector>

namespace openltc::python {

/// An array that owns what was in the vector; C order.
template <class T>
nanobind::ndarray<nanobind::numpy, T> array_of(std::vector<T> values,
                                               std::initializer_list<std::size_t> shape) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* data = owned->data();
  nanobind::capsule owner(owned.get(),
                          [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  return nanobind::ndarray<nanobind::numpy, T>(data, shape, owner);
}

} // namespace openltc::python
