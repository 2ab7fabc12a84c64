// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the registry lists, one function per entry. Private to brdf/: others go through brdf.h.

#pragma once

#include "openltc/brdf/brdf.h"

namespace openltc::brdf {

Brdf make_ggx();
Brdf make_ggx_separable();
Brdf make_ggx_ms();
Brdf make_beckmann();
Brdf make_blinn();
Brdf make_phong();
Brdf make_burley();
Brdf make_oren_nayar();
Brdf make_eon();
Brdf make_charlie();

} // namespace openltc::brdf
