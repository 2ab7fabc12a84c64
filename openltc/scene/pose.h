// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// At which moment a file that moves is read.

#pragma once

#include <optional>
#include <string>

namespace openltc::scene {

/// Neither: the rest pose, as the file's nodes say it.
struct PoseOptions {
  /// Of the animation. Before its first key and behind its last everything stands still.
  std::optional<double> time_seconds;
  /// Name of the animation, or its number from 0; empty: the first. Alone it means time 0.
  std::string animation;

  bool is_rest() const { return !time_seconds && animation.empty(); }
};

} // namespace openltc::scene
