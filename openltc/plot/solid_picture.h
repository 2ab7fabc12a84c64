// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Pictures of solids on nothing, by the project's own renderer, for figures.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/plot/view.h"

#include <span>

namespace openltc::plot {

/// How a solid shows the colours of its mesh.
enum class Finish {
  plain, ///< exactly: what a colour bar says can be read from it
  lit    ///< matte, under three soft boxes that go with the viewer
};

struct Solid {
  scene::Mesh mesh;
  Finish finish = Finish::plain;
};

struct SolidPictureOptions {
  int width = 256; ///< pixels; height follows from the window's sides
  int samples = 8;
  int threads = 0; ///< 0 = all cores; the picture does not depend on it
};

/// Display-encoded (sRGB) RGBA with straight alpha: transparent where there is no solid. Nothing
/// casts a shadow, so there is no noise.
/// Fails with one line when the renderer does.
Result<image::Image> render_solids(std::span<const Solid> solids, const View& view,
                                   const SolidPictureOptions& options = {});

} // namespace openltc::plot
