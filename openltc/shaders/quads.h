// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Functions over polygons, written once more for four corners that a shader has in a struct.

#pragma once

#include "openltc/shaders/syntax.h"

#include <vector>

namespace openltc::shaders {

/// Adds to each function of a Polygon the same of a Quad, under a name that says so: shade_polygon
/// becomes shade_quad, lit_side quad_lit_side. There, loops over the corners know how many there
/// are and that there is one ring.
void add_quad_functions(std::vector<SourceFile>& files);

/// Says in functions of a Polygon that it may have any number of corners: that of four need not be
/// there as well.
void drop_quad_case(std::vector<SourceFile>& files);

} // namespace openltc::shaders
