// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The dialect in double, which tests/shade/lights compares with quadrature of the same lobes.

#include "openltc/base/parallel.h"
#include "openltc/target/shade_f64.h"
#include "tests/parity/case_set.h"

#include <algorithm>
#include <cmath>

namespace openltc::f64 {
#define FN inline
#define FN_CALL inline
#include "tests/parity/case_body.inc"
#undef FN_CALL
#undef FN
} // namespace openltc::f64

namespace openltc::testing {

namespace {

constexpr double k_input_error = 8 * 0x1p-24; // as in tests/shade/parity
constexpr int k_disturbances = 6;

// Every number off by k_input_error, up or down: of itself, or of 1 for coordinates of points and
// directions, which are differences of others as soon as they are used. Vectors that span a light
// are off by as much of their own length. Counts and choices stay.
void disturb(CaseShape shape, const double* in, Random& random, double* out) {
  const auto off = [&](double size) {
    return (random.integer(2) == 0 ? -1 : 1) * k_input_error * size;
  };
  const auto move = [&](int vector, bool spans) {
    const double* v = in + 4 * vector;
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; ++k)
      out[4 * vector + k] = v[k] + off(spans ? length : std::max(std::abs(v[k]), 1.0));
  };
  std::copy(in, in + k_case_numbers, out);
  const bool sides = shape == CaseShape::quad || shape == CaseShape::disk;
  for (const int vector : {0, 1, 2, 3, 4})
    move(vector, false);
  move(5, sides);
  move(6, sides);
  for (const int number : {3, 7, 11, 19})
    out[number] = std::max(in[number] + off(in[number]), 0.0);
}

} // namespace

static void shade_exactly(const CaseBlock& block, const double* in, double* out) {
  if (block.shape == CaseShape::quad)
    shade_exact_quad(in, out);
  else
    f64::shade_case(block.shape, int(in[15]), in, block.polygon, block.polynomial, out);
}

ExpectedLight expected_light(const CaseSet& cases) {
  ExpectedLight expected;
  expected.light.resize(std::size_t(k_case_count) * k_case_outputs);
  expected.uncertain.resize(expected.light.size());
  parallel_for(k_case_count / k_case_block, 0, [&](std::int64_t index) {
    const CaseBlock block = cases.block(int(index));
    Random random(std::uint64_t(index) + 71);
    for (int i = 0; i < k_case_block; ++i) {
      double in[k_case_numbers], moved[k_case_numbers], results[k_case_outputs];
      std::copy_n(block.numbers + i * k_case_numbers, k_case_numbers, in);
      const std::size_t first = std::size_t(index * k_case_block + i) * k_case_outputs;
      double* light = expected.light.data() + first;
      shade_exactly(block, in, light);
      for (int n = 0; n < k_disturbances; ++n) {
        disturb(block.shape, in, random, moved);
        shade_exactly(block, moved, results);
        for (int k = 0; k < k_case_outputs; ++k) {
          float& most = expected.uncertain[first + std::size_t(k)];
          most = std::max(most, float(std::abs(results[k] - light[k])));
        }
      }
    }
  });
  return expected;
}

} // namespace openltc::testing
