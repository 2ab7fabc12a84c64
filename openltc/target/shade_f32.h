// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading maths for one float per variable: namespace openltc::f32.

#pragma once

#include "openltc/target/resources.h"
#include "openltc/target/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

// The dialect's constants are written with all their digits, as literals without a suffix, and
// round to float here.
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wimplicit-float-conversion"
#elif defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#elif defined(_MSC_VER)
#pragma warning(push)
#pragma warning(disable : 4244 4305)
#endif

namespace openltc::f32 {

using Scalar = float;
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"

} // namespace openltc::f32

#if defined(__clang__)
#pragma clang diagnostic pop
#elif defined(__GNUC__)
#pragma GCC diagnostic pop
#elif defined(_MSC_VER)
#pragma warning(pop)
#endif

#include "openltc/target/names_back.inc"
