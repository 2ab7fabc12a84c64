// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A glTF file again, with its rectangular and round area lights as EXT_lights_area, and those with
// a photometric file as EXT_lights_ies.

#pragma once

#include "openltc/base/result.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/read_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace openltc::scene {

struct ExportReport {
  std::size_t written = 0;           ///< lights that became entries of EXT_lights_area
  std::size_t profiles_written = 0;  ///< lights that became nodes of EXT_lights_ies
  std::vector<std::string> left;     ///< what stays as it is and why, one line each
  std::vector<std::string> warnings; ///< of the import
};

/// Reads the glTF file `input` and writes it to `output`, a .glb, with every rectangle and disk
/// among its lights as EXT_lights_area: those that nodes' extras describe, and those of emissive
/// meshes, found as `emissive` says; and with the points of nodes' extras that have a photometric
/// file, and no cone or range, as EXT_lights_ies. Everything else stays as it is; buffers, pictures
/// and photometric files of EXT_lights_ies beside the file move into it.
///
/// A mesh whose lights were written stays visible and keeps its emission, but its node says
/// "openltc_emits_light": false, so that reading the file gives the same lights once. That happens
/// only when all lights of the node can be written. A light of two sides becomes two lights.
/// An Error names the file and the field; nothing is written then.
Result<ExportReport> export_area_lights(const std::string& input, const std::string& output,
                                        const EmissiveOptions& emissive = {},
                                        const ReadOptions& reading = {});

} // namespace openltc::scene
