// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Figures as files.

#pragma once

#include "openltc/draw/figure.h"

#include <string>

namespace openltc::draw {

/// Whether a file with this extension can be written: ".svg", and ".png" where the build has
/// librsvg. The error names what is there, or the missing package.
Status check_extension(const std::string& path);

/// Writes a figure: .svg with the theme as it is; .png by librsvg, `scale` pixels to a unit, where
/// automatic is light. To a temporary name, then renamed. Errors name the file.
Status write_figure(const std::string& path, const Figure& figure, Theme theme, double scale = 2);

/// The pixels of an SVG, display-encoded, 4 channels. Fails without librsvg.
Result<image::Image> rasterise(const std::string& svg, double scale);

} // namespace openltc::draw
