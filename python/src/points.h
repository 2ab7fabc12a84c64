// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights, lobes and arrays of surface points, over the C API, which takes arrays as they lie.

#pragma once

#include <nanobind/nanobind.h>

namespace openltc::python {

/// Adds the lists of lights, lobes, and what is computed of points.
void bind_points(nanobind::module_& m);

} // namespace openltc::python
