// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Warnings for the user, the same one said once however many meshes it is about.

#pragma once

#include <string>
#include <vector>

namespace openltc::scene {

class Warnings {
public:
  /// A warning of its own; repeated ones count once.
  void add(const std::string& message);

  /// A warning about one mesh. Meshes with the same `what` share a line.
  void add_for_mesh(const std::string& mesh_name, const std::string& what);

  /// One line each, in the order in which they came first; long lists of meshes are cut.
  std::vector<std::string> lines() const;

private:
  struct Entry {
    std::string what;
    std::vector<std::string> meshes; ///< empty when it is not about meshes
  };
  std::vector<Entry> entries_;
};

} // namespace openltc::scene
