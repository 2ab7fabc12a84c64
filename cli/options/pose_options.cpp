// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/options/pose_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace openltc::cli {

void add_pose_options(CLI::App& command, scene::PoseOptions& options) {
  command
      .add_option("--time", options.time_seconds,
                  "Moment of the animation, in seconds; before its first and behind its last key "
                  "everything stands still [none: the rest pose]")
      ->check(CLI::Validator(
          [](std::string& text) {
            double seconds = 0;
            const char* const end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, seconds);
            const bool is_usable =
                read.ec == std::errc() && read.ptr == end && std::isfinite(seconds);
            return is_usable ? std::string() : "write a number of seconds, such as 1.25";
          },
          "", "seconds"))
      ->type_name("SECONDS");
  command
      .add_option("--animation", options.animation,
                  "Animation by name or number from 0; openltc inspect lists them [the first]")
      ->type_name("NAME|N");
}

Error wrong_camera(const std::string& file, const std::string& camera, const Error& error) {
  if (camera.empty() || camera == "frame") return error; // the view failed, not the name
  return Error{fmt::format("{}: --camera {}: {}", file, camera, error.message)};
}

} // namespace openltc::cli
