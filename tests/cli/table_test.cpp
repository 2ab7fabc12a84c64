// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Tables as files: fitted, looked at, used, and refused when broken.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

using namespace openltc::test;

namespace {

// One small table for all tests of this file; fitting it takes seconds.
const std::string& table_text() {
  static const std::string text = [] {
    const TemporaryFolder folder;
    const Run run = run_tool({"fit", "--size", "8", "-o", folder.file("x.json"), "--report",
                              folder.file("report.json"), "--quiet"});
    REQUIRE(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK(contains(run.out, "\ntv "));
    const auto report = bytes_of(folder.file("report.json"));
    CHECK(json::parse(report.begin(), report.end())["regions"].size() == 2);
    CHECK(folder.file_count() == 2);
    const auto bytes = bytes_of(folder.file("x.json"));
    return std::string(bytes.begin(), bytes.end());
  }();
  return text;
}

} // namespace

TEST_CASE("a_fitted_table_can_be_looked_at_and_rendered_with") {
  const TemporaryFolder folder;
  const std::string table = folder.file("x.json"), exr = folder.file("x.exr");
  write_text(table, table_text());
  const Run text = run_tool({"inspect", table});
  CHECK(text.exit_code == 0);
  CHECK(contains(text.out, "8 x 8"));
  CHECK(contains(text.out, "ggx"));
  const Run run = run_tool({"inspect", table, "--json"});
  REQUIRE(run.exit_code == 0);
  const auto values = json::parse(run.out);
  CHECK(values["kind"] == "table");
  CHECK(values["size"] == 8);
  CHECK(values["brdf"] == "ggx");
  CHECK(double(values["mean_tv"]) > 0);
  CHECK(double(values["channels"]["n1"]["max"]) <= 1.001);

  const std::vector<std::string> render = {"render",    demo_scene(), "--quiet", "--size", "48x27",
                                           "--samples", "1",          "-o",      exr};
  REQUIRE(run_tool(render).exit_code == 0);
  const auto builtin = bytes_of(exr);
  std::vector<std::string> with_table = render;
  with_table.insert(with_table.end(), {"--table", table});
  REQUIRE(run_tool(with_table).exit_code == 0);
  CHECK(bytes_of(exr) != builtin);
}

TEST_CASE("broken_tables_are_refused_by_name") {
  const TemporaryFolder folder;
  const json good = json::parse(table_text());
  const auto changed = [&](const char* key, const json& value) {
    json copy = good;
    copy[key] = value;
    return copy.dump();
  };
  json texels = good["texels"];
  texels[5] = "five";
  std::vector<std::string> broken = {"",
                                     "[]",
                                     "{}",
                                     table_text().substr(0, table_text().size() / 2),
                                     changed("format", "other"),
                                     changed("version", 99),
                                     changed("columns", 9),
                                     changed("rows", -1),
                                     changed("rows", 1e9),
                                     changed("texels", json::array()),
                                     changed("texels", texels),
                                     changed("metadata", nullptr)};
  const std::string table = folder.file("broken.json"), png = folder.file("x.png");
  for (const std::string& text : broken) {
    CAPTURE(text.substr(0, 100));
    write_text(table, text);
    CHECK(fails_naming(run_tool({"inspect", table}), table));
    CHECK(fails_naming(run_tool({"render", demo_scene(), "--quiet", "--size", "16x16", "--table",
                                 table, "-o", png}),
                       table));
  }
  CHECK(folder.file_count() == 1);
  CHECK(fails_naming(run_tool({"inspect", folder.file("missing.json")}), "missing.json"));
}

TEST_CASE("fit_refuses_outputs_that_it_cannot_write") {
  const TemporaryFolder folder;
  for (const std::string& bad : {folder.file("missing/x.json"), folder.file("x.txt")}) {
    CAPTURE(bad);
    const Run run = run_tool({"fit", "--size", "64", "--quiet", "-o", bad}, {"", 0, 30});
    CHECK((contains(bad, ".txt") ? refuses_usage(run, bad) : fails_naming(run, bad)));
    CHECK(run.seconds < 2); // before the work
  }
  CHECK(folder.file_count() == 0);
}
