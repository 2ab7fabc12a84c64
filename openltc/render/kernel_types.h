// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The kernel's points, lights and batches are rendering's own words.

#pragma once

#include "openltc/kernel/batch_bounds.h"
#include "openltc/kernel/shading_kernel.h"

namespace openltc::render {
using namespace kernel;
} // namespace openltc::render
