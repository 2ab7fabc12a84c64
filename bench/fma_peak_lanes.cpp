// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Compiled once per instruction set, OPENLTC_ISA naming it, with the flags of the shading kernels.
// SSE4 has no fused form: there a multiply-add is two instructions.

#include "bench/fma_peak.h"

#include <hwy/highway.h>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)

namespace openltc::bench {

namespace hn = hwy::HWY_NAMESPACE;

double OPENLTC_PASTE(fma_peak_, OPENLTC_ISA)(int rounds, float* sink) {
  const HWY_FULL(float) d;
  // Ten chains: a multiply-add takes about four cycles, and two start in each. Each begins with a
  // number of its own, or the compiler would find them all the same and run one.
  const auto a = hn::Set(d, 0.999f), b = hn::Set(d, sink[0]);
  const auto start = [&](float k) { return hn::Set(d, k * sink[0]); };
  auto x0 = start(0), x1 = start(1), x2 = start(2), x3 = start(3), x4 = start(4), x5 = start(5),
       x6 = start(6), x7 = start(7), x8 = start(8), x9 = start(9);
  for (int i = 0; i < rounds; ++i) {
    x0 = hn::MulAdd(x0, a, b);
    x1 = hn::MulAdd(x1, a, b);
    x2 = hn::MulAdd(x2, a, b);
    x3 = hn::MulAdd(x3, a, b);
    x4 = hn::MulAdd(x4, a, b);
    x5 = hn::MulAdd(x5, a, b);
    x6 = hn::MulAdd(x6, a, b);
    x7 = hn::MulAdd(x7, a, b);
    x8 = hn::MulAdd(x8, a, b);
    x9 = hn::MulAdd(x9, a, b);
  }
  const auto low = hn::Add(hn::Add(hn::Add(x0, x1), hn::Add(x2, x3)), x4);
  const auto high = hn::Add(hn::Add(hn::Add(x5, x6), hn::Add(x7, x8)), x9);
  HWY_ALIGN float lanes[HWY_LANES(float)];
  hn::Store(hn::Add(low, high), d, lanes);
  sink[1] = lanes[0];
  return 2.0 * 10 * rounds * double(HWY_LANES(float));
}

} // namespace openltc::bench
