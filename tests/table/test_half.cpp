// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Half precision: every half, the ties, the ends.

#include "openltc/table/half.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using openltc::table::float_from_half;
using openltc::table::half_from_float;

TEST_CASE("every finite half comes back from its float, and the floats go up with the halves") {
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
    REQUIRE(half_from_float(float_from_half(std::uint16_t(bits))) == bits);
    REQUIRE(half_from_float(-float_from_half(std::uint16_t(bits))) == (bits | 0x8000));
    if (bits > 0)
      REQUIRE(float_from_half(std::uint16_t(bits)) > float_from_half(std::uint16_t(bits - 1)));
  }
  CHECK(float_from_half(0x3c00) == 1.0f);
  CHECK(float_from_half(1) == 0x1p-24f); // the smallest subnormal
  CHECK(float_from_half(0x400) == 0x1p-14f);
  CHECK(float_from_half(0x7bff) == openltc::table::k_half_max);
}

TEST_CASE("between two halves the nearest is taken, and the even one of a tie") {
  for (std::uint32_t bits = 0; bits + 1 < 0x7c00; ++bits) {
    const float low = float_from_half(std::uint16_t(bits));
    const float high = float_from_half(std::uint16_t(bits + 1));
    const float middle = 0.5f * (low + high); // exact
    const std::uint32_t even = bits % 2 == 0 ? bits : bits + 1;
    REQUIRE(half_from_float(middle) == even);
    REQUIRE(half_from_float(std::nextafter(middle, 0.0f)) == bits);
    REQUIRE(half_from_float(std::nextafter(middle, high)) == bits + 1);
  }
}

TEST_CASE("beyond the largest half lies infinity, and NaN stays NaN") {
  CHECK(half_from_float(65519.0f) == 0x7bff);
  CHECK(half_from_float(65520.0f) == 0x7c00);
  CHECK(half_from_float(-1e38f) == 0xfc00);
  CHECK(half_from_float(std::numeric_limits<float>::infinity()) == 0x7c00);
  CHECK(std::isnan(float_from_half(half_from_float(std::numeric_limits<float>::quiet_NaN()))));
  CHECK(half_from_float(0x1p-25f) == 0); // a tie with 0
  CHECK(half_from_float(std::nextafter(0x1p-25f, 1.0f)) == 1);
  CHECK(half_from_float(1e-40f) == 0);
  CHECK(std::signbit(float_from_half(half_from_float(-0.0f))));
}
