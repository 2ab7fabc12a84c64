// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fitted lobe table and what is known about it.

#pragma once

#include "openltc/target/resources.h"

#include <string>
#include <vector>

namespace openltc::table {

/// What a table says about itself. Travels with every file.
struct TableMetadata {
  std::string brdf;         ///< e.g. "ggx"
  std::string variant;      ///< e.g. "height-correlated Smith, F = 1"
  std::string objective;    ///< what the fit minimised
  std::string command;      ///< the command that made it
  std::string tool_version; ///< of OpenLTC
  double mean_tv = 0;       ///< mean total variation, interpolation included; see fit/report
  double max_tv = 0;
};

/// Coefficients of the lobe M^-1 and its amplitudes over roughness and view angle, native packing.
///
/// Axes, size nodes each, node i at i/(size-1): x = sqrt(alpha) = perceptual roughness, fast;
/// y = sqrt(1 - cos theta), slow; node (0, 0) is a mirror at normal incidence.
/// Each texel holds 8 floats: A B C D n1 n5 0 0. A B C D is M^-1 in the mirror frame with alpha
/// factored out (shade/lobe.glsl, lobe_from_mirror), middle element 1. n1 is the directional
/// albedo for F = 1, n5 its Schlick-weighted part (shade/table.glsl). Storage: 32-bit float.
struct LobeTable {
  static constexpr int k_channels = 8;

  int size = 0;
  std::vector<float> texels; ///< size * size * k_channels
  TableMetadata metadata;

  LobeTableView view() const { return {texels.data(), size}; }
  float* texel(int x, int y) { return texels.data() + (y * size + x) * k_channels; }
  const float* texel(int x, int y) const { return texels.data() + (y * size + x) * k_channels; }
};

/// The table that the product ships: GGX, height-correlated Smith, 64 x 64, fitted by
/// `openltc fit` with the command its metadata names.
const LobeTable& builtin_ggx_table();

} // namespace openltc::table
