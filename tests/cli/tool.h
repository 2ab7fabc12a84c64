// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The tool as a process, and small scenes for it.

#pragma once

#include "tests/image/make_picture.h"
#include "tests/scene/gltf_builder.h"

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace openltc::test {

using image::test::TemporaryFolder;

struct Run {
  int exit_code = -1; ///< -1 when a signal ended it
  int ended_by = 0;   ///< that signal
  double seconds = 0;
  std::uint64_t peak_bytes = 0; ///< most memory that was resident, as the system says
  std::string out, err;
};

struct RunOptions {
  std::string folder;           ///< working folder; empty = the test's
  double interrupt_after_s = 0; ///< > 0: SIGINT after so long
  double limit_s = 60;          ///< then it is killed, and ended_by is SIGKILL
  int signal = SIGINT;          ///< or another one
  /// What the tool's process does before it becomes the tool: limits, closed or other descriptors.
  std::function<void()> prepare = {};
};

/// Runs the tool with these arguments, without a shell.
Run run_tool(const std::vector<std::string>& arguments, const RunOptions& options = {});

int line_count(const std::string& text);
bool contains(const std::string& text, const std::string& part);

/// Whether the run failed as promised: exit code 1 and one line on stderr that contains `part`,
/// nothing on stdout. Otherwise prints what it did.
bool fails_naming(const Run& run, const std::string& part);

/// The same for exit code 2, wrong usage.
bool refuses_usage(const Run& run, const std::string& part);

std::vector<std::uint8_t> bytes_of(const std::string& path);
std::string text_of(const std::string& path);
void write_text(const std::string& path, const std::string& text);
void write_scene(const std::string& path, const GltfBuilder& scene);

/// A white floor under a small square of `nits` that hovers 1 m above it; no camera.
GltfBuilder lit_floor(double nits = 100);

/// Adds a camera that looks along -Z from (0, `height`, 4).
void add_camera(GltfBuilder& scene, const std::string& name, double height);

/// `text` as the contents of a file, to compare.
bool holds(const std::string& path, const std::string& text);

/// For RunOptions::prepare: descriptor `target` opened on `path`, which exists.
void redirect_to(int target, const std::string& path, int flags);

/// scenes/demo.glb of the repository.
std::string demo_scene();

} // namespace openltc::test
