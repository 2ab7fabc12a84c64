// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

using namespace openltc::test;

TEST_CASE("ctrl_c_ends_a_long_render_soon_and_leaves_older_files_as_they_were") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr"), older = "an older picture";
  // Many tiles, and few tiles that would each take minutes.
  for (const char* size : {"1280x720", "16x16"}) {
    CAPTURE(size);
    write_text(exr, older);
    const Run run = run_tool({"render", demo_scene(), "--quiet", "--size", size, "--integrator",
                              "reference", "--samples", "1000000", "-o", exr},
                             {"", 0.7, 20});
    CHECK(run.exit_code > 0);
    CHECK(run.seconds < 5);
    CHECK(contains(run.err, "interrupted"));
    const auto kept = bytes_of(exr);
    CHECK(std::string(kept.begin(), kept.end()) == older);
    CHECK(folder.file_count() == 1);
  }
}
