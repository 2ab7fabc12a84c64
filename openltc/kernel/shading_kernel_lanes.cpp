// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The kernel in SIMD lanes. Compiled once per instruction set (cmake/instruction_sets.cmake): the
// build defines OPENLTC_ISA as its name, OPENLTC_LANES as its width, and gives the compiler its
// flags.

#include "openltc/base/sampling.h"
#include "openltc/kernel/shading_kernel_variants.h"
#include "openltc/target/vec.h"

#include <hwy/highway.h>

#include <type_traits>
// Highway's math comes after the core.
#include <hwy/contrib/math/math-inl.h>

#define OPENLTC_STRINGIFY_(x) #x
#define OPENLTC_STRINGIFY(x) OPENLTC_STRINGIFY_(x)

namespace openltc::kernel::OPENLTC_ISA {

// Each builds on the one before.
// clang-format off
#include "openltc/target/lanes.inc"
#include "openltc/target/shade_all.inc"
#include "openltc/kernel/shading_kernel.inc"
// clang-format on

static_assert(k_batch_padding % k_lanes == 0);
static_assert(k_lanes == OPENLTC_LANES, "Highway did not choose the instruction set asked for");

Kernel kernel() { return {OPENLTC_STRINGIFY(OPENLTC_ISA), k_lanes, shade_batch, measure_batch}; }

} // namespace openltc::kernel::OPENLTC_ISA
