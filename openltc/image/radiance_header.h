// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The header of a Radiance picture. Private to this folder.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/primaries.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace openltc::image {

struct RadianceHeader {
  double exposure = 1.0;
  std::array<double, 3> color_correction{1.0, 1.0, 1.0};
  bool is_xyz = false;
  std::optional<Primaries> primaries;
  int width = 0, height = 0;
  // Lines of the file are columns of the picture when X comes first.
  bool columns = false, from_bottom = false, from_right = false;
};

/// Takes in a header line "NAME=VALUE"; what is not known is passed over, as the format says. The
/// error begins with `name`.
Status read_radiance_variable(std::string_view line, const std::string& name,
                              RadianceHeader& header);

/// Takes in the line behind the header: "-Y 480 +X 640", lines from top to bottom, each from left
/// to right; the other seven orders turn or mirror the picture. +Y goes up. False for anything
/// else.
bool parse_radiance_resolution(std::string_view text, RadianceHeader& header);

} // namespace openltc::image
