// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc plot fit and plot point: their numbers are those of other commands; what they refuse.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::test;

TEST_CASE("plot_fit_prints_the_errors_of_the_report") {
  const TemporaryFolder folder;
  const std::string report = folder.file("r.json"), path = folder.file("fit.svg");
  REQUIRE(run_tool({"fit", "--brdf", "charlie", "--quiet", "--report", report}).exit_code == 0);
  const auto region = nlohmann::json::parse(text_of(report)).at("regions").at(0);
  const auto& axes = region.at("axes");
  // A cell of the report in the middle of both axes.
  const std::size_t column = axes.at("roughness").size() / 2,
                    row = axes.at("theta_degrees").size() / 2;
  const double roughness = axes.at("roughness").at(column),
               theta = axes.at("theta_degrees").at(row);
  const auto& cells = region.at("candidates").at(0).at("cells");
  const auto cell = [&](const char* name) {
    return double(cells.at(name).at(row * axes.at("roughness").size() + column));
  };
  REQUIRE(run_tool({"plot", "fit", "--brdf", "charlie", "--theta", fmt::format("{}", theta),
                    "--roughness", fmt::format("{}", roughness), "-o", path, "--quiet"})
              .exit_code == 0);
  const std::string wanted =
      fmt::format("TV {:.4f}, L2 {:.4f}, peak {:.4f}", cell("tv"), cell("l2"), cell("peak"));
  CAPTURE(wanted);
  CHECK(contains(text_of(path), wanted));
}

TEST_CASE("plot_point_draws_a_row_for_each_roughness_and_states_the_difference") {
  const TemporaryFolder folder;
  const std::string path = folder.file("point.svg"), again = folder.file("again.svg");
  for (const std::string& file : {path, again})
    REQUIRE(
        run_tool({"plot", "point", "--roughness", "0.3", "--metallic", "0", "-o", file, "--quiet"})
            .exit_code == 0);
  const std::string svg = text_of(path);
  CHECK(svg == text_of(again));
  CHECK(contains(svg, "% at the mirror direction"));
  CHECK(contains(svg, "openltc plot point --roughness 0.3 --metallic 0"));
  CHECK(contains(svg, "luminance (cd/m²)"));
}

TEST_CASE("plot_fit_and_point_name_what_is_wrong_and_draw_nothing") {
  struct Case {
    std::vector<std::string> arguments;
    std::string says;
    int exit_code;
  };
  const std::vector<Case> cases = {{{"fit", "--brdf", "nope"}, "charlie", 2},
                                   {{"fit", "--theta", "90"}, "--theta", 2},
                                   {{"fit", "--theta", "-1"}, "--theta", 2},
                                   {{"fit", "--roughness", "1.5"}, "--roughness", 2},
                                   {{"fit", "--roughness", ".1,.2,.3,.4,.5,.6,.7"}, "1 to 6", 2},
                                   {{"fit", "--table", "missing.json"}, "missing.json", 1},
                                   {{"point", "--theta", "90"}, "--theta", 2},
                                   {{"point", "--roughness", "0"}, "--roughness", 2},
                                   {{"point", "--f0", "0.1"}, "--f0", 2},
                                   {{"point", "--table", "missing.json"}, "missing.json", 1},
                                   {{"point", "--scan", "up"}, "--scan", 2}};
  for (const Case& c : cases) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {"plot"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    arguments.insert(arguments.end(), {"-o", folder.file("x.svg")});
    const Run run = run_tool(arguments);
    CAPTURE(run.err);
    CHECK(run.exit_code == c.exit_code);
    CHECK(contains(run.err, c.says));
    CHECK(folder.file_count() == 0);
  }
}
