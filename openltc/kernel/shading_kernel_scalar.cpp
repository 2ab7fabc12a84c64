// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The kernel without SIMD: the plain formulation, for machines without lanes and for comparison.

#include "openltc/base/sampling.h"
#include "openltc/kernel/shading_kernel_variants.h"
#include "openltc/target/vec.h"

#include <cmath>
#include <type_traits>

namespace openltc::kernel::scalar {

using Scalar = float;
// Each builds on the one before.
// clang-format off
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"
#include "openltc/kernel/shading_kernel.inc"
// clang-format on

Kernel kernel() { return {"scalar", k_lanes, shade_batch, measure_batch}; }

} // namespace openltc::kernel::scalar
