// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//

#include "cli/picture_output.h"

#include "cli/output_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace openltc::cli {

namespace fs = std::filesystem;

namespace {

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

} // namespace

std::string default_output(const std::string& scene) {
  return fs::path(scene).stem().string() + ".png";
}

Status check_output(const std::string& path) {
  if (!image::is_writable_extension(path))
    return Error{fmt::format("{}: unknown kind of picture; use .exr, .hdr or .png", path)};
  return check_place(path);
}

Result<float> resolve_exposure(const image::Image& radiance, const DisplayOptions& display) {
  if (!display.ev100) return image::auto_exposure(radiance);
  const float exposure = image::exposure_from_ev100(*display.ev100);
  if (!(exposure > 0) || !std::isfinite(exposure))
    return Error{fmt::format("--exposure {}: out of range", *display.ev100)};
  return exposure;
}

Result<std::vector<std::string>> write_picture(const std::string& path,
                                               const image::Image& radiance,
                                               const image::Image* standard_error, float exposure,
                                               image::Tonemap tonemap,
                                               image::ExrPrecision precision) {
  const std::string extension = extension_of(path);
  std::vector<std::string> written = {path};
  Status status = Success{};
  if (extension == ".exr") {
    std::vector<image::Layer> layers = {{"", radiance}};
    if (standard_error) layers.push_back({"stderr", *standard_error});
    status = image::write_exr(path, layers, precision);
  } else if (extension == ".hdr") {
    status = image::write_hdr(path, radiance);
    if (status.ok() && standard_error) {
      const fs::path whole(path);
      written.push_back(
          (whole.parent_path() / (whole.stem().string() + "_stderr" + whole.extension().string()))
              .string());
      status = image::write_hdr(written.back(), *standard_error);
    }
  } else {
    status = image::write_png(path, image::to_display(radiance, exposure, tonemap));
  }
  if (!status.ok()) return status.error();
  return written;
}

} // namespace openltc::cli
