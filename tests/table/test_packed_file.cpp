// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Packed tables as files: every layout in every container and precision, all or nothing.

#include "openltc/table/container/description.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/table_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace openltc;
using namespace openltc::table;
namespace fs = std::filesystem;

namespace {

constexpr const char* k_readable[] = {".dds", ".ktx2", ".exr", ".npy", ".json"};
constexpr const char* k_source[] = {".h", ".glsl", ".hlsl", ".wgsl", ".js"};

class Folder {
public:
  Folder() : path_(fs::temp_directory_path() / "openltc_test_packed") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t count() const {
    return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
  }

private:
  fs::path path_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

PackedTable small_packed(Layout layout, Precision precision) {
  const Result<LobeTable> table = resample(builtin_ggx_table(), 9, 6, angle_axis_of(layout));
  REQUIRE(table);
  Result<PackedTable> packed = pack(*table, layout, precision);
  REQUIRE(packed);
  return *packed;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("every layout, precision and container: what is written is read to the bit") {
  const Folder folder;
  for (const Layout layout : all_layouts())
    for (const Precision precision : {Precision::float32, Precision::float16}) {
      if (layout == Layout::o3de && precision == Precision::float16) continue; // does not fit
      const PackedTable packed = small_packed(layout, precision);
      for (const char* extension : k_readable) {
        CAPTURE(std::string(name_of(layout)));
        CAPTURE(std::string(extension));
        const std::string path = folder.file(std::string("t") + extension);
        const auto written = write_packed(packed, path);
        REQUIRE(written);
        CHECK(*written == packed_files(layout, path));
        for (const std::string& file : *written)
          CHECK(fs::exists(file));
        std::vector<std::string> names = {path};
        if (written->size() > 1 && packed.textures.size() > 1)
          names.insert(names.end(), written->begin(), written->begin() + 2);
        for (const std::string& name : names) { // by the name of the table and of either texture
          CAPTURE(name);
          const Result<PackedTable> read = read_packed(name);
          REQUIRE(read);
          CHECK(read->layout == layout);
          CHECK(read->precision == precision);
          CHECK(read->angle_axis == packed.angle_axis);
          CHECK(read->width == packed.width);
          REQUIRE(read->textures.size() == packed.textures.size());
          for (std::size_t t = 0; t < packed.textures.size(); ++t)
            CHECK(read->textures[t].values == packed.textures[t].values);
          CHECK(read->metadata.variant == packed.metadata.variant);
          CHECK(read->metadata.command == packed.metadata.command);
          CHECK(read->metadata.mean_tv == packed.metadata.mean_tv);
        }
        for (const std::string& file : *written)
          fs::remove(file);
        CHECK(folder.count() == 0);
      }
      for (const char* extension : k_source) {
        const std::string path = folder.file(std::string("t") + extension);
        REQUIRE(write_packed(packed, path));
        const std::string text = text_of(path);
        CHECK(has(text, "// layout: " + std::string(name_of(layout))));
        CHECK(has(text, "t_1"));
        CHECK(has(text, "t_2") == (packed.textures.size() == 2));
        fs::remove(path);
      }
    }
}

TEST_CASE("the names that the issue promises") {
  const Folder folder;
  const PackedTable packed = small_packed(Layout::ltc_code, Precision::float32);
  REQUIRE(write_packed(packed, folder.file("ggx.dds")));
  CHECK(fs::exists(folder.file("ggx_1.dds")));
  CHECK(fs::exists(folder.file("ggx_2.dds")));
  CHECK(fs::exists(folder.file("ggx.dds.json")));
  CHECK(folder.count() == 3);
  // A native table of the same name does not get in the way.
  REQUIRE(write_table(builtin_ggx_table(), folder.file("ggx.json")));
  CHECK(read_packed(folder.file("ggx_2.dds")));
}

TEST_CASE("read_table reads every layout for shading, on the native angle axis") {
  const Folder folder;
  for (const Layout layout : all_layouts()) {
    CAPTURE(std::string(name_of(layout)));
    const std::string path = folder.file("t.ktx2");
    REQUIRE(write_packed(small_packed(layout, Precision::float32), path));
    const Result<LobeTable> table = read_table(path);
    REQUIRE(table);
    CHECK(table->angle_axis == AngleAxis::sqrt_one_minus_cos);
    CHECK(table->metadata.brdf == "ggx");
  }
}

TEST_CASE("when one file cannot be written, none is, and older ones stay") {
  const Folder folder;
  const PackedTable packed = small_packed(Layout::ltc_code, Precision::float32);
  write_text(folder.file("ggx_1.dds"), "old");
  fs::create_directory(folder.file("ggx_2.dds")); // in the way
  const auto written = write_packed(packed, folder.file("ggx.dds"));
  REQUIRE_FALSE(written);
  CHECK(has(written.error().message, "ggx_2.dds"));
  CHECK(text_of(folder.file("ggx_1.dds")) == "old");
  CHECK(folder.count() == 2);
  CHECK_FALSE(write_packed(packed, folder.file("none/ggx.dds")));
  CHECK(has(write_packed(packed, folder.file("ggx.tga")).error().message, ".ktx2"));
}

TEST_CASE("bare textures need the name of their layout, and it must fit") {
  const Folder folder;
  const PackedTable packed = small_packed(Layout::ltc_code, Precision::float16);
  REQUIRE(write_packed(packed, folder.file("t.dds")));
  fs::remove(folder.file("t.dds.json"));
  CHECK(has(read_packed(folder.file("t.dds")).error().message, "--from-layout"));
  const Result<PackedTable> named = read_packed(folder.file("t.dds"), Layout::ltc_code);
  REQUIRE(named);
  CHECK(named->textures[1].values == packed.textures[1].values);
  CHECK(has(read_packed(folder.file("t.dds"), Layout::o3de).error().message, "channels"));
  fs::remove(folder.file("t_2.dds"));
  CHECK(has(read_packed(folder.file("t_1.dds"), Layout::ltc_code).error().message, "texture"));
  // A file that says what it is does not become another by being called so.
  REQUIRE(write_packed(packed, folder.file("t.exr")));
  CHECK(has(read_packed(folder.file("t.exr"), Layout::native).error().message, "ltc_code"));
}

TEST_CASE("textures and descriptions that do not belong together are refused") {
  const Folder folder;
  const std::string path = folder.file("t.npy"), json = path + ".json";
  REQUIRE(write_packed(small_packed(Layout::ltc_code, Precision::float32), path));
  const std::string good = text_of(json);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    REQUIRE(has(text, from));
    text.replace(text.find(from), from.size(), to);
    write_text(json, text);
    const Result<PackedTable> read = read_packed(path);
    CHECK_FALSE(read);
    if (read) return std::string();
    CHECK(has(read.error().message, "t.npy"));
    CHECK_FALSE(has(read.error().message, "\n"));
    return read.error().message;
  };
  CHECK(has(refusal("\"columns\": 9", "\"columns\": 8"), "8 x 6"));
  CHECK(has(refusal("ltc_code\"", "other\""), "layout"));
  CHECK(has(refusal("\"alpha\"", "\"beta\""), "width"));
  CHECK(has(refusal("sqrt(1 - cos theta)\"", "phi\""), "angle_axis"));
  CHECK(has(refusal("openltc-packed-table", "other"), "format"));
  CHECK(has(refusal("\"version\": 1", "\"version\": 7"), "version"));
  CHECK_FALSE(refusal("{", "").empty());
  write_text(json, good);
  REQUIRE(read_packed(path));
  // A later table of one texture by the same name: its description is not that of the older two.
  const std::string other = folder.file("v.npy");
  REQUIRE(write_packed(small_packed(Layout::ltc_code, Precision::float32), other));
  REQUIRE(write_packed(small_packed(Layout::unity, Precision::float32), other));
  CHECK(read_packed(other));
  CHECK_FALSE(read_packed(folder.file("v_1.npy")));
  REQUIRE(write_packed(small_packed(Layout::native, Precision::float16), folder.file("u.npy")));
  fs::rename(folder.file("u_2.npy"), folder.file("t_2.npy"));
  CHECK_FALSE(read_packed(path)); // one in half, one in single precision
}

TEST_CASE("packed JSON refuses what is no table") {
  const std::string good = packed_to_json(small_packed(Layout::godot, Precision::float32));
  REQUIRE(packed_from_json(good, "t.json"));
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    REQUIRE(has(text, from));
    text.replace(text.find(from), from.size(), to);
    const Result<PackedTable> read = packed_from_json(text, "t.json");
    if (read) return std::string();
    CHECK(has(read.error().message, "t.json"));
    return read.error().message;
  };
  CHECK(has(refusal("\"columns\": 9", "\"columns\": 1e9"), "columns"));
  CHECK(has(refusal("\"columns\": 9", "\"columns\": 8"), "numbers"));
  CHECK(has(refusal("\"rows\": 6", "\"rows\": -6"), "rows"));
  CHECK(has(refusal("\"channels\": 4", "\"channels\": 5"), "channels"));
  CHECK(has(refusal("\"channels\": 4", "\"channels\": -4"), "channels"));
  CHECK(has(refusal("\"values\": [", "\"values\": [1e39,"), "numbers"));
  CHECK(has(refusal("\"textures\": [", "\"textures\": [3,"), "texture"));
  for (std::size_t n = 0; n + 3 < good.size(); n += 97)
    REQUIRE_FALSE(packed_from_json(good.substr(0, n), "t.json"));
}
