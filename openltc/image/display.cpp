// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace openltc::image {

namespace fs = std::filesystem;

namespace {

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

} // namespace

Result<float> resolve_exposure(const Image& radiance, const DisplayOptions& display) {
  AutoExposureOptions options;
  options.light = display.light_nits;
  if (!display.ev100 && display.usual_exposure > 0)
    return exposure_below_white(radiance, display.usual_exposure, options);
  if (!display.ev100) return auto_exposure(radiance, options);
  const float exposure = exposure_from_ev100(*display.ev100);
  if (exposure > 0 && std::isfinite(exposure)) return exposure;
  return Error{fmt::format("EV100 {}: out of range", *display.ev100)};
}

std::vector<std::string> picture_files(const std::string& path, bool with_standard_error) {
  std::vector<std::string> files = {path};
  if (with_standard_error && extension_of(path) == ".hdr") {
    const fs::path whole(path);
    files.push_back(
        (whole.parent_path() / (whole.stem().string() + "_stderr" + whole.extension().string()))
            .string());
  }
  return files;
}

Status write_picture(const std::string& path, const Image& radiance, const Image* standard_error,
                     float exposure, Tonemap tonemap, ExrPrecision precision) {
  const std::string extension = extension_of(path);
  if (extension == ".exr") {
    std::vector<LayerView> layers = {{"", &radiance}};
    if (standard_error) layers.push_back({"stderr", standard_error});
    return write_exr_views(path, layers, precision);
  }
  if (extension == ".hdr") {
    Status status = write_hdr(path, radiance);
    if (status.ok() && standard_error)
      status = write_hdr(picture_files(path, true).back(), *standard_error);
    return status;
  }
  return write_png(path, to_display(radiance, exposure, tonemap));
}

} // namespace openltc::image
