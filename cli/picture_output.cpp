// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/picture_output.h"

#include "cli/output_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

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

std::vector<std::string> output_files(const std::string& path, bool with_standard_error) {
  std::vector<std::string> files = {path};
  if (with_standard_error && extension_of(path) == ".hdr") {
    const fs::path whole(path);
    files.push_back(
        (whole.parent_path() / (whole.stem().string() + "_stderr" + whole.extension().string()))
            .string());
  }
  return files;
}

std::vector<std::string> all_output_files(const std::vector<std::string>& paths,
                                          bool with_standard_error) {
  std::vector<std::string> all;
  for (const std::string& path : paths)
    for (std::string& file : output_files(path, with_standard_error))
      all.push_back(std::move(file));
  return all;
}

Status check_outputs(const std::vector<std::string>& paths, bool with_standard_error) {
  for (const std::string& path : paths)
    if (!image::is_writable_extension(path))
      return Error{fmt::format("{}: unknown kind of picture; use .exr, .hdr or .png", path)};
  return check_places(all_output_files(paths, with_standard_error));
}

Status take_picture_memory(MemoryShare& memory, int width, int height, bool with_standard_error) {
  // Radiance; what is written, or luminances for the exposure.
  const std::uint64_t pixel_bytes = (3 + 4 + (with_standard_error ? 3 : 0)) * sizeof(float);
  const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(height) * pixel_bytes;
  if (memory.take(bytes, "")) return Success{};
  return Error{fmt::format("a picture of {}x{} pixels takes {}, and {} of {} are left; give a "
                           "smaller --size or more --memory",
                           width, height, memory_size_text(bytes),
                           memory_size_text(memory.budget().left()),
                           memory_size_text(memory.budget().limit()))};
}

Status check_ev100(float ev100) {
  const float exposure = image::exposure_from_ev100(ev100);
  if (exposure > 0 && std::isfinite(exposure)) return Success{};
  return Error{fmt::format("--exposure {}: out of range", ev100)};
}

Result<float> resolve_exposure(const image::Image& radiance, const DisplayOptions& display) {
  image::AutoExposureOptions options;
  options.light = display.light_nits;
  if (!display.ev100 && display.usual_exposure > 0)
    return image::exposure_below_white(radiance, display.usual_exposure, options);
  if (!display.ev100) return image::auto_exposure(radiance, options);
  if (Status status = check_ev100(*display.ev100); !status) return status.error();
  return image::exposure_from_ev100(*display.ev100);
}

Status write_picture(const std::string& path, const image::Image& radiance,
                     const image::Image* standard_error, float exposure, image::Tonemap tonemap,
                     image::ExrPrecision precision) {
  const std::string extension = extension_of(path);
  if (extension == ".exr") {
    std::vector<image::LayerView> layers = {{"", &radiance}};
    if (standard_error) layers.push_back({"stderr", standard_error});
    return image::write_exr_views(path, layers, precision);
  }
  if (extension == ".hdr") {
    Status status = image::write_hdr(path, radiance);
    if (status.ok() && standard_error)
      status = image::write_hdr(output_files(path, true).back(), *standard_error);
    return status;
  }
  return image::write_png(path, image::to_display(radiance, exposure, tonemap));
}

} // namespace openltc::cli
