// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lists of lights.

#pragma once

#include "openltc/light/light.h"

namespace openltc::light {

/// Appends copies of the lights `from` to `to`. Both have the same textures or `from` uses none.
void append_lights(const Lights& from, Lights& to);

} // namespace openltc::light
