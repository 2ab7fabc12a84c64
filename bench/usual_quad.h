// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A quad light the way renderers usually shade it: one point after the other in scalar code.

#pragma once

#include "tests/shade/lights/light_batch.h"

#include <vector>

namespace openltc::bench {

/// The lobes as renderers keep them: two textures of four floats, M^-1 (m00, m02, m20, m22 with the
/// middle element 1) and (n1, n5, 0, 0), columns by roughness and rows by sqrt(1 - cos).
struct UsualTable {
  int size = 64;
  std::vector<float> matrix, amplitude; ///< size * size * 4
};
UsualTable usual_table();

/// Diffuse and specular light of radiance 1, RGB, of points first .. first + count - 1.
void usual_quad(const testing::LightBatch& batch, const UsualTable& table, int first, int count,
                float (*out)[testing::k_batch]);

} // namespace openltc::bench
