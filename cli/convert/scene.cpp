// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/convert/scene.h"

#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/base/atomic_file.h"
#include "openltc/scene/gltf/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

namespace openltc::cli {

namespace {

// More lights that stay as they are than these are only counted.
constexpr std::size_t k_most_named = 12;

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

} // namespace

bool is_scene_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".gltf" || extension == ".glb";
}

Status convert_scene(const std::string& input, const std::string& output,
                     const scene::EmissiveOptions& emissive, const scene::ReadOptions& reading,
                     bool quiet) {
  if (extension_of(output) != ".glb")
    return Error{fmt::format("{}: a scene is written as .glb, not to {}", input, output)};
  if (Status status = check_places({output}); !status) return status.error();
  FileGroup held; // until it is known what was read
  const Result<scene::ExportReport> report =
      scene::export_area_lights(input, output, emissive, reading);
  if (!report) return report.error();
  if (Status status = check_not_read({output}); !status) return status.error();
  if (Status status = held.commit(); !status) return status.error();
  if (quiet) return Success{};
  for (const std::string& warning : report->warnings)
    say("warning: {}\n", warning);
  for (std::size_t i = 0; i < std::min(report->left.size(), k_most_named); ++i)
    say("note: {}\n", report->left[i]);
  if (report->left.size() > k_most_named)
    say("note: and {} more\n", report->left.size() - k_most_named);
  say("wrote {}, {} light{} as EXT_lights_area{}\n", output, report->written,
      report->written == 1 ? "" : "s",
      report->profiles_written == 0
          ? ""
          : fmt::format(", {} as EXT_lights_ies", report->profiles_written));
  return Success{};
}

} // namespace openltc::cli
