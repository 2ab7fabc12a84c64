// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The arithmetic that an instruction set can do at best, measured: independent multiply-adds.

#pragma once

namespace openltc::bench {

/// Does `rounds` rounds of multiply-adds that wait for nothing but themselves, and returns how many
/// floating-point operations that were, two per multiply-add and lane. `sink` keeps them alive.
using FmaPeak = double (*)(int rounds, float* sink);

double fma_peak_baseline(int rounds, float* sink);
double fma_peak_sse4(int rounds, float* sink);
double fma_peak_avx2(int rounds, float* sink);
double fma_peak_avx512(int rounds, float* sink);

} // namespace openltc::bench
