// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc fit --form two-lobe, and what becomes of its files.

#include "openltc/table/table_file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::test;

namespace {

Run run_fit(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"fit"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_tool(words);
}

} // namespace

TEST_CASE("two_lobes_are_fitted_inspected_converted_and_rendered_and_refused_elsewhere") {
  const TemporaryFolder folder;
  const std::string out = folder.file("two.dds"), json_file = folder.file("two.json");
  const Run run = run_fit({"--form", "two-lobe", "--size", "8", "-o", out, "-o", json_file});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(folder.file_count() == 5); // three textures, their description, and the other
  const std::string said_bound = "certified: A D - w B C >= ";
  const std::size_t at = run.err.find(said_bound);
  REQUIRE(at != std::string::npos);
  CHECK(std::strtod(run.err.c_str() + at + said_bound.size(), nullptr) > 0);
  const Result<table::LobeTable> table = table::read_table(out);
  REQUIRE(table);
  CHECK(table->two_lobes());
  CHECK(table->metadata.command == "openltc fit --brdf ggx --form two-lobe --size 8");
  CHECK(table->metadata.mean_tv < 0.02); // one lobe has 0.037

  const json said = json::parse(run_tool({"inspect", folder.file("two_3.dds"), "--json"}).out);
  CHECK(said["layout"] == "native_two");
  CHECK(double(said["measured"]["mean_tv"]) < 0.02);
  CHECK(double(said["channels"]["weight"]["max"]) <= 1);
  CHECK(contains(run_tool({"inspect", json_file}).out, "lobe table of two lobes, 8 x 8"));
  const std::string back = folder.file("back.json");
  REQUIRE(run_tool({"convert", out, back, "--quiet"}).exit_code == 0);
  CHECK(text_of(back) == text_of(json_file));
  CHECK(fails_naming(run_tool({"convert", out, folder.file("x.dds"), "--layout", "ltc_code"}),
                     "holds one lobe"));
  CHECK(refuses_usage(run_fit({"--form", "two-lobe", "--layout", "unity"}), "--layout"));
  CHECK(refuses_usage(run_fit({"--form", "two-lobe", "--degree", "4"}), "--degree"));
  // A report holds it against tables of one lobe.
  const std::string data = folder.file("report.json");
  REQUIRE(run_fit({"--size", "6", "--against", out, "--report", data}).exit_code == 0);
  const json report = json::parse(text_of(data));
  const auto mean_tv = [&](std::size_t which) {
    return double(report["regions"][0]["candidates"][which]["between_nodes"]["mean"]["tv"]);
  };
  CHECK(mean_tv(1) < 0.6 * mean_tv(0));
  CHECK(report["candidates"][1]["lights"]["bound_violations"] == 0);

  const std::string scene = demo_scene();
  const auto rendered = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words = {"render",    scene, "--size",           "32x18",
                                      "--samples", "1",   "--shadow-samples", "0",
                                      "--quiet",   "-o",  folder.file(name)};
    words.insert(words.end(), more.begin(), more.end());
    return run_tool(words);
  };
  REQUIRE(rendered("a.exr", {"--lobes", "two-lobe"}).exit_code == 0);
  REQUIRE(rendered("b.exr", {"--table", out, "--lobes", "two-lobe"}).exit_code == 0);
  REQUIRE(rendered("c.exr", {"--lobes", "table"}).exit_code == 0);
  CHECK(text_of(folder.file("a.exr")) != text_of(folder.file("c.exr")));
  CHECK(fails_naming(rendered("d.exr", {"--table", out, "--lobes", "polynomial"}),
                     "holds a lobe table of two lobes"));
}

TEST_CASE("polynomials_of_two_lobes_are_fitted_inspected_converted_and_rendered") {
  const TemporaryFolder folder;
  const std::string out = folder.file("p.json"), source = folder.file("p.glsl");
  const Run run =
      run_fit({"--form", "two-lobe-polynomial", "--degree", "3", "-o", out, "-o", source});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, " of both lobes over the whole domain"));
  CHECK(contains(run.out, "balanced, two lobes, degree 3"));
  CHECK(contains(text_of(source), "openltc fit --brdf ggx --form two-lobe-polynomial --degree 3"));
  const json said = json::parse(run_tool({"inspect", out, "--json"}).out);
  CHECK(said["kind"] == "polynomial");
  CHECK(said["lobes"] == 2);
  CHECK(said["certified"] == true);
  CHECK(double(said["measured"]["mean_tv"]) < 0.023); // one lobe has 0.042
  CHECK(contains(run_tool({"inspect", out}).out, "lobe polynomial of two lobes of degree 3"));
  const std::string again = folder.file("again.glsl");
  REQUIRE(run_tool({"convert", out, again, "--quiet"}).exit_code == 0);
  CHECK(text_of(again) == text_of(source));

  const std::string scene = demo_scene();
  const auto rendered = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words = {"render",    scene, "--size",           "32x18",
                                      "--samples", "1",   "--shadow-samples", "0",
                                      "--quiet",   "-o",  folder.file(name)};
    words.insert(words.end(), more.begin(), more.end());
    return run_tool(words);
  };
  REQUIRE(rendered("a.exr", {"--table", out, "--lobes", "two-lobe-polynomial"}).exit_code == 0);
  REQUIRE(rendered("b.exr", {"--lobes", "two-lobe-polynomial"}).exit_code == 0);
  REQUIRE(rendered("c.exr", {"--lobes", "polynomial"}).exit_code == 0);
  CHECK(text_of(folder.file("a.exr")) != text_of(folder.file("b.exr"))); // degrees 3 and 4
  CHECK(text_of(folder.file("b.exr")) != text_of(folder.file("c.exr")));
  CHECK(fails_naming(rendered("d.exr", {"--table", out, "--lobes", "polynomial"}),
                     "holds a lobe polynomial of two lobes"));
}
