// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "bench/counted.h"

#include "openltc/target/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace openltc::bench {

namespace counted {

static long long operations = 0;

struct Number {
  float v;
  constexpr Number() : v(0) {}
  constexpr Number(double x) : v(float(x)) {}
  constexpr explicit Number(float x) : v(x) {}
  constexpr explicit Number(int x) : v(float(x)) {}
  explicit operator float() const { return v; }
  explicit operator int() const { return int(v); }

  friend Number operator+(Number a, Number b) { return ++operations, Number(a.v + b.v); }
  friend Number operator-(Number a, Number b) { return ++operations, Number(a.v - b.v); }
  friend Number operator*(Number a, Number b) { return ++operations, Number(a.v * b.v); }
  friend Number operator/(Number a, Number b) { return ++operations, Number(a.v / b.v); }
  friend Number operator-(Number a) { return Number(-a.v); }
  friend bool operator<(Number a, Number b) { return a.v < b.v; }
  friend bool operator>(Number a, Number b) { return a.v > b.v; }
  friend bool operator<=(Number a, Number b) { return a.v <= b.v; }
  friend bool operator>=(Number a, Number b) { return a.v >= b.v; }
  friend bool operator==(Number a, Number b) { return a.v == b.v; }
  friend bool operator!=(Number a, Number b) { return a.v != b.v; }
};

// The scalar prelude asks std for its functions; from here it finds these.
namespace std {
using ::std::int32_t;
using ::std::ptrdiff_t;
using ::std::size_t;
inline Number abs(Number a) { return Number(::std::abs(a.v)); }
inline Number sqrt(Number a) { return ++operations, Number(::std::sqrt(a.v)); }
inline Number sin(Number a) { return ++operations, Number(::std::sin(a.v)); }
inline Number cos(Number a) { return ++operations, Number(::std::cos(a.v)); }
inline Number log(Number a) { return ++operations, Number(::std::log(a.v)); }
inline Number exp(Number a) { return ++operations, Number(::std::exp(a.v)); }
inline Number pow(Number a, Number b) { return ++operations, Number(::std::pow(a.v, b.v)); }
} // namespace std

inline Vec3T<Number> normalize(Vec3T<Number> v) { return v / std::sqrt(dot(v, v)); }

using Scalar = Number;
// Each builds on the one before.
// clang-format off
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"
#include "tests/shade/lights/light_batch_body.inc"
// clang-format on

} // namespace counted

double count_operations(const testing::LightBatch& batch, const LobeTableView& table) {
  float shaded[3][testing::k_batch];
  counted::operations = 0;
  counted::shade_batch(batch, table, shaded);
  return double(counted::operations) / testing::k_batch;
}

} // namespace openltc::bench
