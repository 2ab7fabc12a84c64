// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc plot literal: a well-formed SVG, the same each time, or one clear line.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

// Whether elements close in the order in which they open, and & stands for entities only.
bool is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  std::size_t roots = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '&') {
      const std::size_t end = text.find(';', at);
      if (end == std::string::npos || end - at > 6) return false;
    }
    if (text[at] == '>') return false;
    if (text[at] != '<') continue;
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return false;
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag[0] == '/') {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      if (open.empty()) ++roots;
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() && roots == 1;
}

} // namespace

TEST_CASE("plot_literal_writes_a_well_formed_figure_and_the_same_each_time") {
  CHECK(is_well_formed("<a b=\"c\"><d/>&lt;</a>"));
  CHECK_FALSE(is_well_formed("<a><b></a></b>"));
  CHECK_FALSE(is_well_formed("<a>b & c</a>"));
  CHECK_FALSE(is_well_formed("<a>"));

  const TemporaryFolder folder;
  const Run run = run_tool({"plot", "literal"}, {folder.file("."), 0, 60});
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "wrote literal.svg"));
  const std::string svg = text_of(folder.file("literal.svg"));
  CHECK(is_well_formed(svg));
  // What docs/source_document.md says, and the command.
  for (const char* stated : {"14.7", "0.886", "0.970", "0.070", "openltc plot literal"}) {
    CAPTURE(stated);
    CHECK(contains(svg, std::string(">") + stated + "</text>"));
  }

  const Run again = run_tool({"plot", "literal", "--quiet", "-o", folder.file("again.svg")});
  CHECK(again.exit_code == 0);
  CHECK(again.err.empty());
  CHECK(text_of(folder.file("again.svg")) == svg);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("plot_literal_refuses_what_it_cannot_write") {
  const TemporaryFolder folder;
  const std::string good = folder.file("good.svg");
  CHECK(refuses_usage(run_tool({"plot", "literal", "-o", good, "-o", folder.file("x.pdf")}),
                      "x.pdf"));
  CHECK(fails_naming(run_tool({"plot", "literal", "-o", folder.file("missing/x.svg")}),
                     "missing/x.svg"));
  CHECK(refuses_usage(run_tool({"plot", "literal", "--background", "pink", "-o", good}), "pink"));
  CHECK_FALSE(fs::exists(good));
  CHECK(folder.file_count() == 0);
}
