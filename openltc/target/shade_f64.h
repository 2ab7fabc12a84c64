// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading maths for one double per variable: namespace openltc::f64.

#pragma once

#include "openltc/target/resources.h"
#include "openltc/target/vec.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace openltc::f64 {

using Scalar = double;
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"

} // namespace openltc::f64

#include "openltc/target/names_back.inc"
