// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/picture_output.h"

#include "cli/output_place.h"
#include "openltc/image/display.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

namespace openltc::cli {

namespace fs = std::filesystem;

std::string default_output(const std::string& scene) {
  return fs::path(scene).stem().string() + ".png";
}

std::vector<std::string> all_output_files(const std::vector<std::string>& paths,
                                          bool with_standard_error) {
  std::vector<std::string> all;
  for (const std::string& path : paths)
    for (std::string& file : image::picture_files(path, with_standard_error))
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

} // namespace openltc::cli
