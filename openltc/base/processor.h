// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Which instruction sets this machine has, of those that cmake/instruction_sets.cmake compiles for.
// Each asks for every extension that the compiler may use then; the two change together.

#pragma once

namespace openltc {

#if defined(__x86_64__)

inline bool has_sse4() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("aes") &&
         __builtin_cpu_supports("pclmul");
}

inline bool has_avx2() {
  return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}

inline bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
}

#endif

} // namespace openltc
