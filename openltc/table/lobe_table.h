// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A fitted lobe table and what is known about it.

#pragma once

#include "openltc/brdf/brdf.h"
#include "openltc/target/resources.h"

#include <string>
#include <vector>

namespace openltc::table {

/// What a table says about itself. Travels with every file.
struct TableMetadata {
  std::string brdf;      ///< e.g. "ggx"
  std::string variant;   ///< e.g. "height-correlated Smith, F = 1"
  std::string objective; ///< what the fit minimised
  /// How the lobe is meant to be read at the surface's horizon: "clipped", divided by its share
  /// above; "leaking", as it is; "divided", clipped, by a renderer that does not divide: n1 and n5
  /// are divided already (divided.h). Empty: not known.
  std::string horizon;
  std::string command;      ///< the command that made it
  std::string tool_version; ///< of OpenLTC
  double mean_tv = 0;       ///< mean total variation, interpolation included; see fit/report
  double max_tv = 0;
};

/// One field of TableMetadata by its name in files: text or number.
struct MetadataField {
  const char* name;
  std::string TableMetadata::*text;
  double TableMetadata::*number;
};

/// All fields, in the order in which files hold them.
inline constexpr MetadataField k_metadata_fields[] = {
    {"brdf", &TableMetadata::brdf, nullptr},
    {"variant", &TableMetadata::variant, nullptr},
    {"objective", &TableMetadata::objective, nullptr},
    {"horizon", &TableMetadata::horizon, nullptr},
    {"command", &TableMetadata::command, nullptr},
    {"tool_version", &TableMetadata::tool_version, nullptr},
    {"mean_tv", nullptr, &TableMetadata::mean_tv},
    {"max_tv", nullptr, &TableMetadata::max_tv},
};

/// What the rows of a table are equidistant in.
enum class AngleAxis {
  sqrt_one_minus_cos, ///< y = sqrt(1 - cos theta): the native one, and that of most engines
  theta               ///< y = theta / (pi/2)
};

/// Coefficients of the lobe M^-1 and its amplitudes over roughness and view angle, native packing.
///
/// Axes: x = sqrt(alpha) = perceptual roughness, fast, column i at i/(columns-1); y by angle_axis,
/// slow, row j at j/(rows-1); node (0, 0) is a mirror at normal incidence. A BRDF without
/// roughness has one column.
/// Each texel holds 8 floats: A B C D n1 n5 w 0. A B C D is M^-1 in the mirror frame with the
/// lobe's width factored out (shade/lobe.glsl, lobe_from_mirror), middle element 1; the width is
/// alpha or 1, by `width`. n1 is the directional albedo for F = 1, n5 its Schlick-weighted part
/// (shade/table.glsl). A table of two lobes has a second one at each node, packed as the first, and
/// its share w of n1, 0..1; without it w is 0. Storage: 32-bit float.
struct LobeTable {
  static constexpr int k_channels = 8;
  static constexpr int k_second_channels = 4;

  int columns = 0;
  int rows = 0;
  AngleAxis angle_axis = AngleAxis::sqrt_one_minus_cos;
  brdf::LobeWidth width = brdf::LobeWidth::alpha;
  std::vector<float> texels; ///< columns * rows * k_channels
  std::vector<float> second; ///< columns * rows * k_second_channels, A B C D; empty: one lobe
  TableMetadata metadata;

  bool two_lobes() const { return !second.empty(); }
  LobeTableView view() const {
    return {texels.data(), columns, rows, second.empty() ? nullptr : second.data()};
  }
  float* texel(int x, int y) { return texels.data() + (y * columns + x) * k_channels; }
  const float* texel(int x, int y) const { return texels.data() + (y * columns + x) * k_channels; }
  const float* second_texel(int x, int y) const {
    return second.data() + (y * columns + x) * k_second_channels;
  }
};

/// The table that the product ships: GGX, height-correlated Smith, 64 x 64, fitted by
/// `openltc fit` with the command its metadata names.
const LobeTable& builtin_ggx_table();

/// The table of two lobes that the product ships: the same BRDF, 32 x 32.
const LobeTable& builtin_ggx_two_lobe_table();

} // namespace openltc::table
