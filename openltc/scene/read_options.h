// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What reading a scene is allowed to do.

#pragma once

#include "openltc/scene/pose.h"

namespace openltc::scene {

struct ReadOptions {
  /// Files outside the scene's own folder may be read: "../x.png", absolute paths, links that lead
  /// out. Off, because a scene of a stranger could otherwise have any file of this machine shown,
  /// or carried into what is made of it.
  bool allow_outside = false;
  PoseOptions pose = {}; ///< at which moment
};

} // namespace openltc::scene
