// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What keys of figures of solids are made of.

#pragma once

#include "openltc/plot/sketch.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::plot {

/// A line as the figure draws it, 24 units long, from `at`; and the text behind it.
void draw_line_sign(Sketch& sketch, Vec2d at, const Pen& pen, std::string_view text);

/// The text of a sign, for signs that draw themselves.
void draw_sign_text(Sketch& sketch, Vec2d at, std::string_view text);

/// A bar of the colours of density_color from 0 to 1, ticks with labels at shares of its width, and
/// what it shows behind it.
Status draw_density_bar(Sketch& sketch, Vec2d corner, double width,
                        const std::vector<std::pair<double, std::string>>& ticks,
                        std::string_view label);

} // namespace openltc::plot
