// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot error: its numbers are the report's, and what is wrong is said in a line.

#include "openltc/fit/measure/error.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace openltc;
using namespace openltc::test;

namespace {

Run plot_error(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"plot", "error"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_tool(words);
}

struct Shown {
  double mean, p95;
};

// Every "mean A, p95 B" of a figure.
std::vector<Shown> shown_in(const std::string& svg) {
  std::vector<Shown> found;
  const std::string mean = ">mean ", p95 = ", p95 ";
  for (std::size_t at = svg.find(mean); at != std::string::npos; at = svg.find(mean, at + 1)) {
    const std::size_t second = svg.find(p95, at);
    if (svg.compare(second + p95.size(), 2, "of") == 0) continue; // of a difference
    found.push_back({std::strtod(svg.c_str() + at + mean.size(), nullptr),
                     std::strtod(svg.c_str() + second + p95.size(), nullptr)});
  }
  return found;
}

} // namespace

TEST_CASE("plot_error_shows_the_numbers_of_the_report") {
  const TemporaryFolder folder;
  const std::string one = folder.file("one.json"), two = folder.file("two.json");
  const std::string report = folder.file("report.json"), svg = folder.file("error.svg");
  REQUIRE(run_tool({"fit", "--size", "6", "--layout", "ltc_code", "-o", two}).exit_code == 0);
  REQUIRE(
      run_tool({"fit", "--size", "8", "-o", one, "--report", report, "--against", two}).exit_code ==
      0);
  std::vector<std::string> arguments = {"--table", one, "--against", two, "-o", svg, "--quiet"};
  for (const fit::LobeErrorField& norm : fit::lobe_error_fields()) {
    arguments.emplace_back("--norm");
    arguments.emplace_back(norm.name);
  }
  REQUIRE(plot_error(arguments).exit_code == 0);
  const std::vector<Shown> shown = shown_in(text_of(svg));
  const json region = json::parse(text_of(report))["regions"][0];
  REQUIRE(shown.size() == 2 * fit::lobe_error_fields().size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const char* norm = fit::lobe_error_fields()[i / 2].name;
    const json& error = region["candidates"][i % 2]["between_nodes"];
    CAPTURE(norm);
    CAPTURE(i % 2);
    const auto close = [](double a, double b) {
      return std::abs(a - b) <= (b < 0.01 ? 0.51e-5 : 0.51e-4);
    };
    CHECK(close(shown[i].mean, error["mean"][norm].get<double>()));
    CHECK(close(shown[i].p95, error["p95"][norm].get<double>()));
  }
}

TEST_CASE("plot_error_of_a_table_with_itself_is_no_difference") {
  const TemporaryFolder folder;
  const std::string svg = folder.file("same.svg");
  REQUIRE(plot_error({"--against", "table", "--points", "6", "-o", svg, "--quiet"}).exit_code == 0);
  const std::string text = text_of(svg);
  CHECK(contains(text, ">mean 0, p95 of size 0<"));
  CHECK(contains(text, "openltc plot error --against table --points 6<"));
  CHECK(contains(text, "view angle θ (degrees)"));
  CHECK(contains(text, "roughness"));
}

TEST_CASE("plot_error_shows_the_limit_of_single_lobes_which_a_coarse_table_does_not_reach") {
  const TemporaryFolder folder;
  const std::string coarse = folder.file("coarse.json"), svg = folder.file("limit.svg");
  REQUIRE(run_tool({"fit", "--size", "4", "-o", coarse}).exit_code == 0);
  REQUIRE(plot_error({"--table", coarse, "--against", "limit", "--norm", "tv", "--norm", "l2", "-o",
                      svg, "--quiet"})
              .exit_code == 0);
  const std::vector<Shown> shown = shown_in(text_of(svg));
  REQUIRE(shown.size() == 4);
  for (const std::size_t norm : {0, 2})
    CHECK(shown[norm].mean > shown[norm + 1].mean + 0.001);
  CHECK(fails_naming(plot_error({"--table", "limit", "-o", svg}), "limit"));
}

TEST_CASE("plot_error_says_what_is_wrong_and_writes_nothing") {
  const TemporaryFolder folder;
  const std::string svg = folder.file("none.svg");
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", svg});
    return plot_error(arguments);
  };
  CHECK(refuses_usage(with({"--norm", "l4"}), "tv, bound, l1, l2, l3, peak, leak, n1, n5"));
  CHECK(refuses_usage(with({"--brdf", "velvet"}), "velvet"));
  for (const char* range : {"1:0.06", "0.5:0.5", "-1:1", "0:2", "0.5", "a:b", ":", "0.1:nan"})
    CHECK(refuses_usage(with({"--roughness", range}), "FROM:TO"));
  for (const char* points : {"3", "257", "many"})
    CHECK(refuses_usage(with({"--points", points}), "--points"));
  CHECK(fails_naming(with({"--table", folder.file("missing.dds")}), "missing.dds"));
  CHECK(fails_naming(with({"--against", demo_scene()}), "demo.glb"));
  CHECK(fails_naming(with({"--brdf", "beckmann"}), "--table"));
  CHECK_FALSE(std::filesystem::exists(svg));
}
