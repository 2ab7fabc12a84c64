// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc fit --report: the page and its figures, for the fit and for what it is compared with.

#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

using namespace openltc;
using namespace openltc::test;

TEST_CASE("reports_compare_with_tables_polynomials_and_bare_textures") {
  const TemporaryFolder folder;
  // Four nodes an axis: the subject must come out worse than what it is compared with.
  const std::string table = folder.file("table.ktx2"), polynomial = folder.file("polynomial.json"),
                    published = OPENLTC_SHARED_DIR "/tables/ltc_code_1.dds",
                    page = folder.file("report.html"), data = folder.file("report.json");
  const Result<table::PackedTable> packed =
      table::pack(table::builtin_ggx_table(), table::Layout::ltc_code, table::Precision::float16);
  REQUIRE(packed);
  REQUIRE(table::write_packed(*packed, table));
  REQUIRE(table::write_polynomial(table::builtin_ggx_polynomial(), polynomial).ok());
  std::vector<std::string> arguments = {
      "fit",      "--size", "4",         "--refine", "off",       "--report", page,
      "--report", data,     "--against", table,      "--against", polynomial};
  std::vector<std::string> labels = {"balanced, 4", "table.ktx2", "polynomial.json"};
  if (std::filesystem::exists(published)) {
    arguments.insert(arguments.end(), {"--against", published});
    labels.emplace_back("ltc_code_1.dds");
  } else {
    MESSAGE("skipped the published table: it is not there, see tests/CMakeLists.txt");
  }
  labels.emplace_back("limit");
  const Run run = run_tool(arguments);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(contains(run.err, "ltc_code_1.dds: does not say what it is; read as ltc_code") ==
        (labels.size() == 5));

  const json report = json::parse(text_of(data));
  REQUIRE(report["candidates"].size() == labels.size());
  REQUIRE(report["regions"].size() == 2);
  CHECK_FALSE(report.contains("fit_seconds")); // the same bytes on every run
  CHECK(contains(report["command"], "--size 4 --refine off --against"));
  std::vector<double> mean_tv;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    CAPTURE(labels[i]);
    const json& candidate = report["candidates"][i];
    CHECK(candidate["label"] == labels[i]);
    CHECK(contains(run.out, labels[i]));
    CHECK(candidate["lights"]["bound_violations"] == 0);
    CHECK(double(candidate["lights"]["rmse"]) > 0);
    for (const json& region : report["regions"]) {
      const json& between = region["candidates"][i]["between_nodes"];
      for (const char* statistic : {"mean", "p95", "max"})
        for (const char* figure : {"tv", "l1", "l2", "l3", "peak", "leak"})
          CHECK(std::isfinite(double(between[statistic][figure])));
    }
    mean_tv.push_back(report["regions"][0]["candidates"][i]["between_nodes"]["mean"]["tv"]);
  }
  const double limit = mean_tv.back(), subject = mean_tv.front();
  for (std::size_t i = 1; i + 1 < labels.size(); ++i) // those of other objectives may be below
    CHECK(mean_tv[i] > 0.85 * limit);
  CHECK(subject > limit);
  CHECK(subject > mean_tv[2]); // 60 constants beat 96
  if (labels.size() == 5) CHECK(mean_tv[3] == doctest::Approx(0.0617).epsilon(0.12));

  const std::string html = text_of(page);
  CHECK(html.rfind("<!DOCTYPE html>", 0) == 0);
  CHECK(contains(html, "</html>"));
  for (const char* outside : {"http://", "https://", "<link", "src=", "@import", "url("}) {
    CAPTURE(outside);
    CHECK_FALSE(contains(html, outside));
  }
  for (const std::string& label : labels)
    CHECK(contains(html, label));
}
