// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Native table files: nothing is lost, and nothing wrong is read.

#include "openltc/table/table_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace openltc;
using table::LobeTable;

namespace {

LobeTable small_table() {
  LobeTable t;
  t.columns = t.rows = 3;
  t.texels.assign(3 * 3 * LobeTable::k_channels, 0.0f);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      float* texel = t.texel(x, y);
      texel[0] = 1.0f / 3.0f + float(x);
      texel[1] = -0.1f * float(y);
      texel[2] = std::nextafter(0.7f, 1.0f);
      texel[3] = 1.9999999f;
      texel[4] = 1e-30f;
      texel[5] = 1.17549435e-38f; // the least normal float
    }
  }
  t.metadata = {
      "ggx", "a \"quoted\" variant", "objective", "clipped", "openltc fit", "0.1.0", 0.0406, 0.31};
  return t;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

// The message, "" when the text was accepted.
std::string refusal(const std::string& text) {
  const Result<LobeTable> read = table::from_json(text, "t.json");
  return read ? std::string() : read.error().message;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a table written and read is the same to the bit") {
  for (const LobeTable& t : {small_table(), table::builtin_ggx_table()}) {
    const Result<LobeTable> read = table::from_json(table::to_json(t), "t.json");
    REQUIRE(read);
    CHECK(read->columns == t.columns);
    CHECK(read->texels == t.texels);
    CHECK(read->metadata.variant == t.metadata.variant);
    CHECK(read->metadata.command == t.metadata.command);
    CHECK(read->metadata.mean_tv == t.metadata.mean_tv);
    CHECK((table::to_json(*read) == table::to_json(t))); // also tells -0 from 0
  }
}

TEST_CASE("shape, angle axis and width are kept") {
  LobeTable t = small_table();
  t.columns = 1;
  t.rows = 9;
  t.angle_axis = table::AngleAxis::theta;
  t.width = brdf::LobeWidth::one;
  const Result<LobeTable> read = table::from_json(table::to_json(t), "t.json");
  REQUIRE(read);
  CHECK(read->columns == 1);
  CHECK(read->rows == 9);
  CHECK(read->angle_axis == table::AngleAxis::theta);
  CHECK(read->width == brdf::LobeWidth::one);
  CHECK(read->texels == t.texels);
}

TEST_CASE("a file of version 1, square by definition, is still read") {
  std::string text = replaced(table::to_json(small_table()), "\"version\": 2", "\"version\": 1");
  text = replaced(text, "\"columns\": 3,\n\"rows\": 3", "\"size\": 3");
  text = replaced(text, "\"angle_axis\"", "\"other\"");
  const Result<LobeTable> read = table::from_json(text, "t.json");
  REQUIRE(read);
  CHECK(read->columns == 3);
  CHECK(read->rows == 3);
  CHECK(read->texels == small_table().texels);
}

TEST_CASE("metadata of any bytes makes a file that can be read") {
  LobeTable t = small_table();
  t.metadata.variant = "not UTF-8: \xff\xfe";
  CHECK(table::from_json(table::to_json(t), "t.json"));
}

TEST_CASE("table_rejects_truncated_file") {
  const std::string text = table::to_json(small_table());
  for (std::size_t n = 0; n + 3 < text.size(); n += 7) {
    const std::string message = refusal(text.substr(0, n));
    CHECK(has(message, "t.json"));
    CHECK(has(message, "cut off"));
  }
}

TEST_CASE("wrong contents are refused with the file and the field") {
  const std::string text = table::to_json(small_table());
  CHECK(refusal(text).empty());
  CHECK(has(refusal("{}"), "format"));
  CHECK(has(refusal("[1, 2]"), "format"));
  CHECK(has(refusal(replaced(text, "openltc-lobe-table", "something")), "format"));
  CHECK(has(refusal(replaced(text, "\"version\": 2", "\"version\": 4")), "version"));
  CHECK(has(refusal(replaced(text, "\"columns\": 3", "\"columns\": 4")), "54 numbers"));
  CHECK(has(refusal(replaced(text, "\"columns\": 3", "\"columns\": -3")), "columns"));
  CHECK(has(refusal(replaced(text, "\"rows\": 3", "\"rows\": 1e9")), "rows"));
  CHECK(has(refusal(replaced(text, "\"rows\": 3", "\"rows\": \"3\"")), "rows"));
  CHECK(has(refusal(replaced(text, "sqrt(1 - cos theta)\",", "phi\",")), "angle_axis"));
  CHECK(has(refusal(replaced(text, "\"width\": \"alpha\"", "\"width\": 3")), "width"));
  CHECK(has(refusal(replaced(text, "1.9999999", "null")), "texels[3]"));
  CHECK(has(refusal(replaced(text, "1.9999999", "\"NaN\"")), "texels[3]"));
  CHECK(has(refusal(replaced(text, "1.9999999", "1e39")), "texels[3]"));
  CHECK_FALSE(refusal(replaced(text, "1.9999999", "NaN")).empty());
  CHECK(has(refusal(replaced(text, "1.9999999", "-1.0")), "determinant"));
  CHECK(has(refusal(replaced(text, "\"metadata\"", "\"other\"")), "metadata"));
  CHECK(has(refusal(replaced(text, "\"texels\"", "\"other\"")), "texels"));
}

TEST_CASE("files: a missing one and an unknown extension are errors, an old one survives") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "openltc_test_table";
  fs::create_directories(folder);
  const std::string path = (folder / "t.json").string();
  REQUIRE(table::write_table(small_table(), path).ok());
  const Result<LobeTable> read = table::read_table(path);
  REQUIRE(read);
  CHECK(read->texels == small_table().texels);
  CHECK(has(table::read_table((folder / "none.json").string()).error().message, "none.json"));
  CHECK(
      has(table::write_table(small_table(), (folder / "t.dds").string()).error().message, ".json"));
  CHECK(has(table::write_table(small_table(), (folder / "no/t.json").string()).error().message,
            "does not exist"));
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  fs::remove_all(folder);
}
