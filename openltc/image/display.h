// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A rendered picture on its way to a file: how bright it is shown, and what is written.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace openltc::image {

struct DisplayOptions {
  std::optional<float> ev100; ///< none = chosen from the picture
  /// Without ev100: the factor from nits that suits the light, lowered where highlights would be
  /// above white; 0 = not known, all is chosen from the picture.
  float usual_exposure = 0;
  /// Nits from which a pixel shows a light; infinity = not known.
  float light_nits = std::numeric_limits<float>::infinity();
  Tonemap tonemap = Tonemap::neutral;
};

/// Factor from nits to display-linear values. Fails when ev100 has no factor that is a number
/// greater than 0.
Result<float> resolve_exposure(const Image& radiance, const DisplayOptions& display);

/// The files that write_picture makes of `path`: itself, and NAME_stderr.hdr beside an .hdr when
/// there is a standard error.
std::vector<std::string> picture_files(const std::string& path, bool with_standard_error);

/// Writes .exr and .hdr as radiance, .png as display values. A standard error (may be null) becomes
/// the layer "stderr" of an .exr and a file NAME_stderr.hdr beside an .hdr.
Status write_picture(const std::string& path, const Image& radiance, const Image* standard_error,
                     float exposure, Tonemap tonemap, ExrPrecision precision);

} // namespace openltc::image
