// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/divided.h"

#include "openltc/table/half.h"

#include <algorithm>

namespace openltc::table {

double share_above(const f64::Lobe& lobe) {
  return std::max(f64::share_above_horizon(lobe), f64::k_min_share);
}

bool is_divided(const PackedTable& packed) {
  return packed.metadata.horizon == k_divided && facts_of(packed.layout).has_amplitudes;
}

void divide_amplitudes(PackedTable& packed) {
  if (!facts_of(packed.layout).has_amplitudes || is_divided(packed)) return;
  Texture& second = packed.textures[1];
  const int at = packed.layout == Layout::godot ? 1 : 0;
  for (int row = 0; row < packed.rows(); ++row)
    for (int column = 0; column < packed.columns(); ++column) {
      const double above = share_above(lobe_of_node(packed, column, row).lobe);
      float* texel = second.values.data() + (row * second.width + column) * second.channels + at;
      for (int k = 0; k < 2; ++k) {
        texel[k] = float(double(texel[k]) / above);
        if (packed.precision == Precision::float16) texel[k] = rounded_to_half(texel[k]);
      }
    }
  packed.metadata.horizon = k_divided;
}

f64::FittedLobe fetch_albedo(const PackedTable& packed, double roughness, double cos_theta) {
  f64::FittedLobe fitted = fetch_packed(packed, roughness, cos_theta);
  if (!is_divided(packed)) return fitted;
  const double above = share_above(fitted.lobe);
  fitted.n1 *= above;
  fitted.n5 *= above;
  return fitted;
}

} // namespace openltc::table
