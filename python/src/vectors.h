// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Vectors of the library as tuples of numbers, and any sequence of numbers as vectors.

#pragma once

#include "openltc/target/vec.h"

#include <array>
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>

namespace nanobind::detail {

template <> struct type_caster<openltc::Vec3f> {
  NB_TYPE_CASTER(openltc::Vec3f, const_name("tuple[float, float, float]"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    make_caster<std::array<float, 3>> numbers;
    if (!numbers.from_python(source, flags, cleanup)) return false;
    value = {numbers.value[0], numbers.value[1], numbers.value[2]};
    return true;
  }
  static handle from_cpp(const openltc::Vec3f& v, rv_policy, cleanup_list*) noexcept {
    return make_tuple(v.x, v.y, v.z).release();
  }
};

template <> struct type_caster<openltc::Vec4f> {
  NB_TYPE_CASTER(openltc::Vec4f, const_name("tuple[float, float, float, float]"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    make_caster<std::array<float, 4>> numbers;
    if (!numbers.from_python(source, flags, cleanup)) return false;
    value = {numbers.value[0], numbers.value[1], numbers.value[2], numbers.value[3]};
    return true;
  }
  static handle from_cpp(const openltc::Vec4f& v, rv_policy, cleanup_list*) noexcept {
    return make_tuple(v.x, v.y, v.z, v.w).release();
  }
};

} // namespace nanobind::detail
