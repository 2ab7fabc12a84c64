// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One lobe in a figure: the sphere of directions coloured by its density, and beside it the lobe as
// a solid with the columns of its matrix.

#pragma once

#include "openltc/plot/matrix_lobe.h"
#include "openltc/plot/space_drawing.h"

namespace openltc::plot {

/// Size of a panel, figure units.
inline constexpr double k_lobe_panel_width = 234, k_lobe_panel_height = 146;

/// Draws the panel with its upper left corner at `corner`. `label_axes`: names at the arrows.
Status draw_lobe_panel(draw::Figure& figure, Vec2d corner, const LobeMatrix& matrix,
                       const LobeFacts& facts, bool label_axes);

/// Inks of the arrows M x, M y, M z.
inline constexpr const char* k_axis_inks[3] = {"series1", "series3", "series0"};

/// Linear colour of a share of the peak's density, for the meshes of solids.
Vec3f density_color(double share);

} // namespace openltc::plot
