// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Tables of two lobes: how they are read, and as files.

#include "openltc/table/layout.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/shading_lobes.h"
#include "openltc/table/table_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace openltc;
using namespace openltc::table;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
  Folder() : path_(fs::temp_directory_path() / "openltc_test_two_lobes") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

LobeTable small_table() {
  const Result<LobeTable> table =
      resample(builtin_ggx_two_lobe_table(), 5, 4, AngleAxis::sqrt_one_minus_cos);
  REQUIRE(table);
  return *table;
}

PackedTable small_packed(Precision precision) {
  const Result<PackedTable> packed = pack(small_table(), Layout::native_two, precision);
  REQUIRE(packed);
  return *packed;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("a second lobe is read between the nodes, coefficients and weight bilinear") {
  LobeTable t;
  t.columns = 3;
  t.rows = 2;
  // Values that are bilinear in the node's place.
  const auto value = [](int channel, double x, double y) {
    constexpr double corner[5] = {0, 40, 1, 2, 50};
    return corner[channel] + x + 2 * y + 3 * x * y;
  };
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column) {
      const double x = column / 2.0, y = row;
      const float texel[8] = {1, 0, 0, 1, 1, 0, float(0.1 * value(0, x, y)), 0};
      t.texels.insert(t.texels.end(), texel, texel + 8);
      for (int k = 1; k <= 4; ++k)
        t.second.push_back(float(value(k, x, y)));
    }
  const Result<PackedTable> packed = pack(t, Layout::native_two, Precision::float32);
  REQUIRE(packed);
  for (const double x : {0.3, 0.7})
    for (const double y : {0.2, 0.9}) {
      const double c = 1 - y * y, alpha = x * x, s = std::sqrt(1 - c * c);
      const double a = value(1, x, y), b = value(2, x, y), m = value(3, x, y), d = value(4, x, y);
      const f64::SecondLobe native = fetch_native_second(t, x, c);
      const f64::SecondLobe stored = fetch_packed_second(*packed, x, c);
      const f64::SecondLobe shaded = f64::fetch_second_lobe_of_roughness(t.view(), x, c);
      for (const f64::SecondLobe& second : {native, stored, shaded}) {
        CHECK(second.weight == doctest::Approx(0.1 * value(0, x, y)).epsilon(1e-6));
        CHECK(second.lobe.m00 == doctest::Approx(a * c - alpha * b * s).epsilon(1e-5));
        CHECK(second.lobe.m22 == doctest::Approx(alpha * (m * s + d * c)).epsilon(1e-5));
        CHECK(second.lobe.det == doctest::Approx(alpha * (a * d - alpha * b * m)).epsilon(1e-5));
      }
    }
  CHECK(f64::lobe_table_has_second(t.view()));
  CHECK_FALSE(f64::lobe_table_has_second(builtin_ggx_table().view()));
  CHECK(fetch_native_second(builtin_ggx_table(), 0.5, 0.5).weight == 0);
}

TEST_CASE("two lobes in every container and precision: what is written is read to the bit") {
  const Folder folder;
  for (const Precision precision : {Precision::float32, Precision::float16}) {
    const PackedTable packed = small_packed(precision);
    for (const char* extension : {".dds", ".ktx2", ".exr", ".npy", ".json"}) {
      CAPTURE(std::string(extension));
      const std::string path = folder.file(std::string("t") + extension);
      const auto written = write_packed(packed, path);
      REQUIRE(written);
      const bool one_file = std::string(extension) == ".json";
      const auto read = read_packed(one_file ? path : folder.file(std::string("t_3") + extension));
      REQUIRE(read);
      CHECK(read->layout == Layout::native_two);
      CHECK(read->precision == precision);
      REQUIRE(read->textures.size() == 3);
      for (std::size_t t = 0; t < 3; ++t)
        CHECK(read->textures[t].values == packed.textures[t].values);
      CHECK(read->metadata.objective == packed.metadata.objective);
      std::vector<std::string> notes;
      const Result<ShadingLobes> lobes = read_shading_lobes(path, notes);
      REQUIRE(lobes);
      CHECK(std::get<LobeTable>(*lobes).two_lobes());
      CHECK(notes.empty());
      for (const std::string& file : *written)
        fs::remove(file);
    }
    for (const char* extension : {".h", ".glsl", ".hlsl", ".wgsl", ".js"}) {
      const std::string path = folder.file(std::string("t") + extension);
      REQUIRE(write_packed(packed, path));
      CHECK(has(text_of(path), "t_3"));
    }
  }
}

TEST_CASE("two lobes: native tables round through pack and JSON to the bit") {
  const LobeTable table = small_table();
  const Result<LobeTable> unpacked = unpack(small_packed(Precision::float32));
  REQUIRE(unpacked);
  CHECK(unpacked->texels == table.texels);
  CHECK(unpacked->second == table.second);
  const std::string json = to_json(table);
  CHECK(has(json, "\"version\": 3"));
  CHECK(has(to_json(builtin_ggx_table()), "\"version\": 2"));
  const Result<LobeTable> read = from_json(json, "t");
  REQUIRE(read);
  CHECK(read->texels == table.texels);
  CHECK(read->second == table.second);
  // A table of two lobes cut off after the first eleven numbers, or of weights that are none.
  std::string few = json;
  few.replace(few.find("\"rows\": 4"), 9, "\"rows\": 3");
  CHECK(has(from_json(few, "t").error().message, "needs 165")); // 5 x 3 x 11
  LobeTable heavy = table;
  heavy.texels[6] = 1.5f;
  CHECK(has(from_json(to_json(heavy), "t").error().message, "weight"));
  LobeTable inside_out = table;
  inside_out.second[0] = -1;
  CHECK(has(from_json(to_json(inside_out), "t").error().message, "second lobe of node (0, 0)"));
}

TEST_CASE("two lobes: files that do not belong together are refused") {
  const Folder folder;
  const std::string path = folder.file("t.dds");
  REQUIRE(write_packed(small_packed(Precision::float32), path));
  fs::remove(folder.file("t_3.dds"));
  CHECK(has(read_packed(path).error().message, "3 texture(s), not 2"));
  // A third texture of another size, and one of no sense.
  const Result<LobeTable> larger =
      resample(builtin_ggx_two_lobe_table(), 6, 4, AngleAxis::sqrt_one_minus_cos);
  REQUIRE(
      write_packed(*pack(*larger, Layout::native_two, Precision::float32), folder.file("u.dds")));
  fs::copy_file(folder.file("u_3.dds"), folder.file("t_3.dds"));
  CHECK(has(read_packed(path).error().message, "5 x 4 and 6 x 4"));
  std::ofstream(folder.file("t_3.dds"), std::ios::binary) << "none";
  CHECK(has(read_packed(path).error().message, "t_3.dds"));
  // It is of no account to a table of one lobe by the same name.
  const Result<LobeTable> one = resample(builtin_ggx_table(), 5, 4, AngleAxis::sqrt_one_minus_cos);
  REQUIRE(write_packed(*pack(*one, Layout::native, Precision::float32), path));
  const Result<PackedTable> read = read_packed(path);
  REQUIRE(read);
  CHECK(read->layout == Layout::native);
  // Weights and determinants of packed tables.
  PackedTable packed = small_packed(Precision::float32);
  packed.textures[1].values[2] = -0.1f;
  CHECK(has(unpack(packed).error().message, "weight of texel (0, 0)"));
  packed = small_packed(Precision::float32);
  packed.textures[2].values[4] = -2;
  CHECK(has(unpack(packed).error().message, "second lobe of texel (1, 0)"));
  CHECK(has(with_precision(packed, Precision::float16).error().message,
            "second lobe of node (1, 0)"));
}

TEST_CASE("two lobes: no layout of an engine takes them, nor theirs one lobe") {
  for (const Layout layout : all_layouts()) {
    const Result<PackedTable> packed = pack(small_table(), layout, Precision::float32);
    REQUIRE_FALSE(packed);
    CHECK(has(packed.error().message, std::string(name_of(layout)) + " holds one lobe"));
  }
  CHECK(has(pack(builtin_ggx_table(), Layout::native_two, Precision::float32).error().message,
            "holds two lobes"));
  REQUIRE(find_layout("native_two"));
  CHECK(*find_layout("native_two") == Layout::native_two);
}
