// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc plot lobes and plot polygon: what they draw and what they refuse.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::test;

namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

} // namespace

TEST_CASE("plot_lobes_draws_what_is_asked_for") {
  const TemporaryFolder folder;
  const std::string path = folder.file("lobes.svg");
  const Run run = run_tool({"plot", "lobes", "--matrix", "0.5,-0.6,0.4,0.1", "--sweep",
                            "c=0.6:0.2:3", "--row", "cosine", "-o", path, "--quiet"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  const std::string svg = text_of(path);
  CHECK(contains(svg, "c = 0.6"));
  CHECK(contains(svg, "c = 0.4"));
  CHECK(contains(svg, "c = 0.2"));
  CHECK(count(svg, "dω = 1.000000") == 4);
  CHECK(contains(svg,
                 "openltc plot lobes --row cosine --matrix 0.5,-0.6,0.4,0.1 --sweep c=0.6:0.2:3"));
  // The same again, byte for byte.
  const std::string again = folder.file("again.svg");
  CHECK(run_tool({"plot", "lobes", "--matrix", "0.5,-0.6,0.4,0.1", "--sweep", "c=0.6:0.2:3",
                  "--row", "cosine", "-o", again, "--quiet"})
            .exit_code == 0);
  CHECK(text_of(again) == svg);
}

TEST_CASE("plot_polygon_prints_both_integrals_and_both_counts") {
  const TemporaryFolder folder;
  const std::string path = folder.file("polygon.svg");
  const Run run =
      run_tool({"plot", "polygon", "--matrix", "1,0,1,0", "--points", "1,1,1 -1,1,1 -1,-1,1 1,-1,1",
                "--samples", "200", "-o", path, "--quiet"});
  CHECK(run.exit_code == 0);
  const std::string svg = text_of(path);
  // A square of half side h at distance d: 4 / pi * h / sqrt(d2 + h2) atan(h / sqrt(d2 + h2)).
  CHECK(count(svg, "0.5541264") == 2);
  CHECK(count(svg, "of 200 samples inside") == 2);
  CHECK(contains(svg, "--samples 200"));
}

TEST_CASE("plot_lobes_and_polygon_name_what_is_wrong_and_draw_nothing") {
  const TemporaryFolder folder;
  struct Case {
    std::vector<std::string> arguments;
    std::string named;
  };
  const std::vector<Case> cases = {
      {{"lobes", "--matrix", "1,1,1,1"}, "--matrix 1,1,1,1: det M"},
      {{"lobes", "--matrix", "nan,0,1,0"}, "--matrix nan,0,1,0"},
      {{"lobes", "--matrix", "-1,0,1,0"}, "det M = c (a - b d) = -1"},
      {{"lobes", "--matrix", "1,0,1"}, "four numbers"},
      {{"lobes", "--row", "metal"}, "--row"},
      {{"lobes", "--sweep", "c=1:-1:5"}, "at c = 0"},
      {{"lobes", "--sweep", "x=1:2:3"}, "NAME=FROM:TO:COUNT"},
      {{"lobes", "--brdf", "wood"}, "wood"},
      {{"lobes", "--brdf", "ggx", "--theta", "95"}, "--theta"},
      {{"lobes", "--brdf", "ggx", "--roughness", "0.001"}, "too narrow"},
      {{"lobes", "--theta", "30"}, "--brdf"},
      {{"lobes", "--brdf", ""}, "--brdf"},
      {{"lobes", "--matrix", ""}, "--matrix"},
      {{"polygon", "--points", ""}, "--points"},
      {{"polygon", "--points", "1,0,1 0,1,1"}, "three corners"},
      {{"polygon", "--points", "1,0,1 0,1,1 0,0"}, "'0,0' is not a corner"},
      {{"polygon", "--points", "1,0,1 0,1,1 nan,0,1"}, "corner 3 is not finite"},
      {{"polygon", "--points", "1,0,1 0,1,1 -1,0,1 0,-1,1.5"}, "plane of the others"},
      {{"polygon", "--points", "1,0,-1 0,1,-1 -1,0,-1"}, "below the surface's horizon"},
      {{"polygon", "--matrix", "0,0,1,0"}, "--matrix 0,0,1,0: det M"},
      {{"polygon", "--matrix", "1,0,1,0", "--brdf", "ggx"}, "--matrix"},
      {{"polygon", "--brdf", "wood"}, "wood"},
      {{"polygon", "--samples", "0"}, "--samples"},
  };
  for (const Case& c : cases) {
    std::vector<std::string> arguments = {"plot"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    arguments.insert(arguments.end(), {"-o", folder.file("x.svg")});
    CAPTURE(c.named);
    CHECK(refuses_usage(run_tool(arguments), c.named));
    CHECK(folder.file_count() == 0);
  }
  CHECK(fails_naming(
      run_tool({"plot", "polygon", "--brdf", folder.file("no.binary"), "-o", folder.file("x.svg")}),
      "no.binary"));
}
