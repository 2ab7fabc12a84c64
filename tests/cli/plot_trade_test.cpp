// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc plot trade: its errors are those of pictures that openltc render makes.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

using namespace openltc;
using namespace openltc::test;

namespace {

std::string hard_scene(const std::string& name) {
  return OPENLTC_SOURCE_DIR "/scenes/hard/" + name + ".glb";
}

std::vector<float> rendered(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  const std::string file = folder.file("picture.exr");
  std::vector<std::string> words = {"render", hard_scene("floor_star_60")};
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (const char* word :
       {"--size", "43x24", "--filter", "none", "--shadow-samples", "0", "--quiet", "-o"})
    words.emplace_back(word);
  words.push_back(file);
  REQUIRE(run_tool(words).exit_code == 0);
  const Result<image::Picture> picture = image::read_picture(file, "");
  REQUIRE(picture);
  return picture->image.data;
}

double sum_of_differences(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(double(a[i]) - double(b[i]));
  return sum;
}

// The numbers of the row that begins with this name.
std::vector<double> row_of(const std::string& table, const std::string& name) {
  std::vector<double> numbers;
  const std::size_t at = table.find("| " + name + " |");
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + name.size() + 5;
  std::istringstream row(table.substr(from, table.find('\n', at) - from));
  for (std::string cell; std::getline(row, cell, '|');)
    if (cell.find_first_of("0123456789") != std::string::npos)
      numbers.push_back(std::strtod(cell.c_str(), nullptr));
  return numbers;
}

} // namespace

TEST_CASE("plot_trade_has_the_errors_of_rendered_pictures") {
  const TemporaryFolder folder;
  const std::string svg = folder.file("trade.svg");
  const Run run = run_tool({"plot", "trade", hard_scene("floor_star_60"), "--height", "24",
                            "--samples", "32", "--quiet", "-o", svg});
  REQUIRE(run.exit_code == 0);
  const std::vector<double> shown = row_of(run.out, "floor_star_60");
  const std::vector<double> times = row_of(run.out, "time of a quad");
  REQUIRE(shown.size() == 7);
  REQUIRE(times.size() == 6);
  CHECK(times[0] == 1);
  for (const double time : times)
    CHECK(time > 0);
  CHECK(contains(text_of(svg), "two lobes, ratio"));

  std::vector<float> reference =
      rendered(folder, {"--integrator", "reference", "--samples", "16", "--seed", "0"});
  const std::vector<float> other =
      rendered(folder, {"--integrator", "reference", "--samples", "16", "--seed", "1"});
  const double noise = 0.5 * sum_of_differences(reference, other);
  double light = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    reference[i] = 0.5f * (reference[i] + other[i]);
    light += double(reference[i]);
  }
  const char* lobes[] = {"table", "table", "two-lobe", "two-lobe", "two-lobe", "two-lobe"};
  const char* forms[] = {"lobe", "ratio", "lobe", "ratio", "adaptive", "exact"};
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(forms[i]);
    const std::vector<float> picture =
        rendered(folder, {"--samples", "1", "--lobes", lobes[i], "--specular", forms[i]});
    CHECK(std::abs(shown[i] - 100 * sum_of_differences(picture, reference) / light) < 0.006);
  }
  CHECK(std::abs(shown[6] - 100 * noise / light) < 0.006);
}

TEST_CASE("plot_trade_refuses_what_has_no_error") {
  const TemporaryFolder folder;
  const std::string svg = folder.file("trade.svg");
  CHECK(fails_naming(run_tool({"plot", "trade", hard_scene("low_line_0mm"), "--height", "8",
                               "--samples", "2", "--quiet", "-o", svg}),
                     "every picture is black"));
  CHECK(fails_naming(run_tool({"plot", "trade", folder.file("none.glb"), "--quiet", "-o", svg}),
                     "none.glb"));
  CHECK(fails_naming(
      run_tool({"plot", "trade", hard_scene("rims"), "--kernel", "none", "--quiet", "-o", svg}),
      "none"));
  CHECK(refuses_usage(run_tool({"plot", "trade", hard_scene("rims"), "--samples", "1"}),
                      "--samples"));
}
