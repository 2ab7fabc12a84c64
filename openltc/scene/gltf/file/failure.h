// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// How the importer's own parts report that a file cannot be used.

#pragma once

#include <string>

namespace openltc::scene::gltf {

/// Thrown inside the importer only; load_gltf turns it into an Error in front of which it puts the
/// name of the file.
struct Failure {
  std::string message; ///< "field: what is wrong; what to do"
};

[[noreturn]] inline void fail(const std::string& field, const std::string& what) {
  throw Failure{field.empty() ? what : field + ": " + what};
}

} // namespace openltc::scene::gltf
