// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What is known about the fitted lobes that come with the library.

#pragma once

namespace openltc {

/// \addtogroup surface
/// @{

/// How lobes were fitted, and how good they are: what a table file says about itself.
struct LobeMetadata {
  const char* brdf;         ///< "ggx"
  const char* variant;      ///< masking and Fresnel
  const char* objective;    ///< what the fit minimised
  const char* horizon;      ///< "clipped": a lobe is divided by its share above the surface
  const char* command;      ///< the command that made them
  const char* tool_version; ///< of OpenLTC
  double mean_tv;           ///< mean total variation between lobe and BRDF, 0..1
  double max_tv;            ///< and its largest value
};

/// @}

} // namespace openltc
