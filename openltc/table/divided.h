// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Tables for renderers that clip lights at the surface's horizon but do not divide by the lobe's
// share above it: their n1 and n5 hold the albedo over that share.

#pragma once

#include "openltc/table/layout.h"

namespace openltc::table {

/// TableMetadata::horizon of such a table, and of one whose reader divides.
inline constexpr const char* k_divided = "divided";
inline constexpr const char* k_clipped = "clipped";

/// Whether n1 and n5 are divided. Never for a layout without amplitudes.
bool is_divided(const PackedTable& packed);

/// Divides n1 and n5 of every texel by the share of its lobe above the horizon, no less than
/// k_min_share as in shading, and says so in the metadata. A table that is divided already stays
/// as it is; a layout without amplitudes has nothing to divide. unpack undoes it. In half precision
/// the quotients are rounded to the nearest half.
void divide_amplitudes(PackedTable& packed);

/// fetch_packed with n1 the albedo and n5 its Schlick-weighted part, whatever the table holds: what
/// is measured against a BRDF.
f64::FittedLobe fetch_albedo(const PackedTable& packed, double roughness, double cos_theta);

/// What they are divided by: the share of the lobe above the horizon, k_min_share at least.
double share_above(const f64::Lobe& lobe);

/// The lobe and amplitudes of the texel at node (column, row), as they are stored.
f64::FittedLobe lobe_of_node(const PackedTable& packed, int column, int row);

} // namespace openltc::table
