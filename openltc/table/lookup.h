// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where a table is read: coordinates and interpolation. Private to this folder.

#pragma once

#include "openltc/table/layout.h"

#include <span>

namespace openltc::table {

/// What the native packing factors out at a roughness.
double factored_width(brdf::LobeWidth width, double roughness);

/// The coordinate 0..1 of a view angle on an axis.
double angle_coordinate(AngleAxis axis, double cos_theta);

/// The coordinate that a layout's shader computes for a view angle, and its inverse. Only Godot's
/// is not angle_coordinate: its arc cosine is a polynomial that is off by up to .5 degrees, so the
/// rows of its tables lie where the shader reads them and not where theta / (pi/2) says.
double look_up_coordinate(Layout layout, AngleAxis axis, double cos_theta);
double cosine_of_coordinate(Layout layout, AngleAxis axis, double y);

/// The table read at the columns `across` and the rows `from`, coordinates 0..1 on its own axes.
LobeTable interpolate(const LobeTable& table, std::span<const double> across,
                      std::span<const double> from);

/// The coordinate 0..1 that a layout's shader computes for a roughness; column_roughness is the
/// inverse.
double roughness_coordinate(Layout layout, double roughness);

} // namespace openltc::table
