// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What the options of a picture may be.

#pragma once

#include "openltc/base/result.h"
#include "openltc/render/renderer.h"

namespace openltc::render {

/// One line about the first that is out of range.
Status check_options(const RenderOptions& options);

/// The pixels that are asked for.
PixelWindow window_of(const RenderOptions& options);

} // namespace openltc::render
