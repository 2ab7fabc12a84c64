// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where rendered pictures go: by the extension of the path.

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/base/result.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace openltc::cli {

struct DisplayOptions {
  std::optional<float> ev100; ///< none = chosen from the picture
  /// Without ev100: the factor from nits that suits the light, lowered where highlights would be
  /// above white; 0 = not known, all is chosen from the picture.
  float usual_exposure = 0;
  /// Nits from which a pixel shows a light; infinity = not known.
  float light_nits = std::numeric_limits<float>::infinity();
  image::Tonemap tonemap = image::Tonemap::neutral;
};

/// "SCENE.png" in the current folder.
std::string default_output(const std::string& scene);

/// The files that writing a picture to `path` makes: itself, and NAME_stderr.hdr beside an .hdr
/// when there is a standard error.
std::vector<std::string> output_files(const std::string& path, bool with_standard_error);

/// Those of several.
std::vector<std::string> all_output_files(const std::vector<std::string>& paths,
                                          bool with_standard_error);

/// Counts what a picture of this size takes until it is written, or says that there is no room.
Status take_picture_memory(MemoryShare& memory, int width, int height, bool with_standard_error);

/// Whether pictures can be written to these paths: known extensions, and check_places.
Status check_outputs(const std::vector<std::string>& paths, bool with_standard_error);

/// Whether an exposure has a factor that is a number; to be asked before the work.
Status check_ev100(float ev100);

/// Factor from nits to display-linear values.
Result<float> resolve_exposure(const image::Image& radiance, const DisplayOptions& display);

/// Writes .exr and .hdr as radiance, .png as display values. A standard error becomes the layer
/// "stderr" of an .exr and a file NAME_stderr.hdr beside an .hdr.
Status write_picture(const std::string& path, const image::Image& radiance,
                     const image::Image* standard_error, float exposure, image::Tonemap tonemap,
                     image::ExrPrecision precision);

} // namespace openltc::cli
