// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/options/shape_options.h"

#include "cli/options/number.h"

namespace openltc::cli {

void add_shape_options(CLI::App& command, scene::EmissiveOptions& options) {
  command.add_flag(
      "--recognise-shapes", options.recognise_shapes,
      "Emissive spheres, disks, ellipses and cylinders of meshes become such lights of "
      "the same area, not one polygon for each facet");
  command
      .add_option("--shape-tolerance", options.shape_tolerance,
                  "By how much their facets may leave the shape, relative to its diameter")
      ->check(number(0, 0.1))
      ->type_name("FRACTION")
      ->capture_default_str();
}

} // namespace openltc::cli
