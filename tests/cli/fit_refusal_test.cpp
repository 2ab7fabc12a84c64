// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc fit, and lobes to render with, when something is wrong: one line, before the work, and no
// file is touched.

#include "openltc/brdf/brdf.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"
#include "tests/brdf/merl_file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace openltc;
using namespace openltc::test;

namespace {

const std::string k_older = "an older file";

table::LobeTable small_table(int columns, int rows) {
  const Result<table::LobeTable> table = table::resample(table::builtin_ggx_table(), columns, rows,
                                                         table::AngleAxis::sqrt_one_minus_cos);
  REQUIRE(table);
  return *table;
}

std::vector<std::string> render(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"render",    demo_scene(), "--quiet", "--size", "48x27",
                                        "--samples", "1",          "-o",      out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

} // namespace

TEST_CASE("fit_names_what_is_wrong_usage") {
  struct Case {
    std::vector<std::string> arguments;
    std::string named;
  };
  const std::vector<Case> cases = {
      {{"--brdf", "velvet"}, "velvet"},
      {{"--brdf", ""}, "must not be empty"},
      {{"--size", "1"}, "--size"},
      {{"--size", "513"}, "--size"},
      {{"--size", "-8"}, "--size"},
      {{"--size", "8.5"}, "--size"},
      {{"--size", "many"}, "--size"},
      {{"--form", "polynomial", "--degree", "2"}, "--degree"},
      {{"--form", "polynomial", "--degree", "7"}, "--degree"},
      {{"--form", "spline"}, "polynomial, two-lobe or two-lobe-polynomial, not 'spline'"},
      {{"--layout", "unreal"}, "godot or o3de, not 'unreal'"},
      {{"--layout", "1"}, "'1'"},
      {{"--precision", "float8"}, "float32 or float16"},
      {{"--objective", "sup"}, "balanced"},
      {{"--refine", "maybe"}, "auto, on or off"},
      {{"--form", "polynomial", "--layout", "unity"}, "--layout is for tables"},
      {{"--form", "two-lobe-polynomial", "--size", "8"}, "not for --form two-lobe-polynomial"},
      {{"--form", "polynomial", "--precision", "float16"}, "--precision is for tables"},
      {{"--form", "polynomial", "--size", "64"}, "--size is for tables"},
      {{"--form", "polynomial", "--refine", "on"}, "--refine is for tables"},
      {{"--form", "polynomial", "--clip-aware"}, "--clip-aware is for tables"},
      {{"--degree", "4"}, "--degree is for --form polynomial"},
      {{"ggx"}, "ggx"},
      {{"-o"}, "output"},
      {{"-o", "/tmp/x.txt"}, "x.txt: unknown extension"},
      {{"-o", "/tmp/x"}, "x: unknown extension"},
      {{"--form", "polynomial", "-o", "/tmp/x.ktx2"}, "x.ktx2: a polynomial is written as"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.named);
    std::vector<std::string> arguments = {"fit", "--quiet"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    CHECK(refuses_usage(run_tool(arguments), c.named));
  }
  // The line lists all the names.
  const Run run = run_tool({"fit", "--brdf", "velvet"});
  for (const brdf::Brdf& brdf : brdf::all_brdfs())
    CHECK(contains(run.err, brdf.name));
}

TEST_CASE("fit_refuses_broken_materials") {
  const TemporaryFolder folder;
  const std::array<std::int32_t, 3> counts = {4, 3, 6};
  const auto good = merl_bytes(counts, std::vector<double>(3 * 4 * 3 * 6, 0.3));
  const std::string out = folder.file("x.json"), file = folder.file("m.binary");
  write_text(out, k_older);
  const auto refuses = [&](const std::vector<std::uint8_t>& bytes, const std::string& part) {
    image::test::write_bytes(file, bytes);
    const Run run = run_tool({"fit", "--brdf", file, "-o", out});
    return fails_naming(run, file + ": ") && fails_naming(run, part);
  };
  CHECK(refuses({}, "too few for the header"));
  CHECK(refuses({good.begin(), good.end() - 1}, "cut off"));
  auto longer = good;
  longer.push_back(0);
  CHECK(refuses(longer, "bytes"));
  CHECK(refuses(merl_bytes({90, 90, 180}, std::vector<double>(216, 0.3)), "90 x 90 x 180"));
  CHECK(refuses(merl_bytes({0, 3, 6}, {}), "0"));
  CHECK(refuses(merl_bytes({-4, 3, 6}, std::vector<double>(216, 0.3)), "-4"));
  CHECK(refuses(merl_bytes(counts, std::vector<double>(216, 0.0)), "no sample has any light"));
  CHECK(fails_naming(run_tool({"fit", "--brdf", folder.file("no.binary"), "-o", out}),
                     "no.binary: cannot open"));
  std::filesystem::create_directory(folder.file("d.binary"));
  CHECK(fails_naming(run_tool({"fit", "--brdf", folder.file("d.binary"), "-o", out}),
                     "is a directory"));
  CHECK(text_of(out) == k_older);
  CHECK(folder.file_count() == 3);
}

TEST_CASE("fit_refuses_what_it_cannot_write_or_read_before_the_work") {
  const TemporaryFolder folder;
  const std::string old = folder.file("old.json"), broken = folder.file("broken.json"),
                    cut = folder.file("cut.json"), dds = folder.file("cut.dds");
  write_text(old, k_older);
  write_text(broken, "{\"format\": \"other\"}");
  const std::string whole = table::to_json(table::builtin_ggx_polynomial());
  write_text(cut, whole.substr(0, whole.size() / 2));
  write_text(dds, "DDS |");
  std::filesystem::create_directory(folder.file("folder.json"));
  const int files = folder.file_count();

  struct Case {
    std::vector<std::string> arguments;
    std::string named;
  };
  const auto in = [&](const char* name) { return folder.file(name); };
  const std::vector<Case> cases = {
      {{"-o", in("missing/x.dds")}, "missing does not exist"},
      {{"-o", in("folder.json")}, "folder.json: is a directory"},
      {{"-o", "/proc/x.json"}, "/proc/x.json: cannot write"},
      {{"-o", "/proc/x.dds", "--layout", "ltc_code"}, "/proc/x_1.dds: cannot write"},
      {{"--layout", "unity", "-o", in("x.cpp")}, "x.cpp: C++ source of the built-in"},
      {{"--brdf", "eon", "-o", in("x.cpp")}, "not for eon"},
      {{"--brdf", "eon", "--form", "polynomial", "-o", in("x.inc")}, "not for eon"},
      {{"--report", in("x.txt")}, "x.txt: a report is written as .json or .html"},
      {{"--report", in("missing/x.html")}, "missing does not exist"},
      {{"-o", in("x.json"), "--report", in("x.json")}, "x.json: would be written twice"},
      {{"-o", in("x.dds"), "--report", in("x.dds.json")}, "x.dds.json: would be written twice"},
      {{"-o", in("x.json"), "-o", in("folder.json/../x.json")}, "x.json: would be written twice"},
      {{"--against", in("no.dds")}, "no.dds: cannot open"},
      {{"--against", in("no.json")}, "no.json: cannot open"},
      {{"--against", dds}, "cut.dds: "},
      {{"--against", broken}, "broken.json: format"},
      {{"--against", cut}, "cut.json: not a complete JSON file"},
      {{"--against", demo_scene()}, "demo.glb: cannot be read as a table"},
      {{"--against", in("folder.json")}, "folder.json: is a directory"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.named);
    std::vector<std::string> arguments = {"fit", "--quiet", "-o", old};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    const Run run = run_tool(arguments);
    CHECK(fails_naming(run, c.named));
    CHECK(text_of(old) == k_older);
    CHECK(folder.file_count() == files); // no temporary file either
  }
}

TEST_CASE("one_texture_of_two_is_told_which_one_must_lie_beside_it") {
  const TemporaryFolder folder;
  const Result<table::PackedTable> packed =
      table::pack(small_table(16, 16), table::Layout::ltc_code, table::Precision::float32);
  REQUIRE(packed);
  REQUIRE(table::write_packed(*packed, folder.file("x.dds")));
  std::filesystem::remove(folder.file("x.dds.json"));
  std::filesystem::remove(folder.file("x_2.dds"));
  const std::string lone = folder.file("x_1.dds"), named = folder.file("y.dds");
  CHECK(fails_naming(run_tool({"fit", "--quiet", "--against", lone}),
                     folder.file("x_2.dds") + " must lie beside it"));
  std::filesystem::rename(lone, named);
  CHECK(fails_naming(run_tool({"fit", "--quiet", "--against", named}), "y_1.dds and "));
}

TEST_CASE("a_layout_that_half_precision_cannot_hold_leaves_older_files") {
  const TemporaryFolder folder;
  const std::string out = folder.file("x.dds"), first = folder.file("x_1.dds");
  write_text(first, k_older);
  CHECK(fails_naming(run_tool({"fit", "--quiet", "--size", "8", "--refine", "on", "--layout",
                               "o3de", "--precision", "float16", "-o", out}),
                     "beyond the 65504 of half precision"));
  CHECK(text_of(first) == k_older);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("render_takes_its_lobes_from_tables_and_polynomials") {
  const TemporaryFolder folder;
  const std::string table = folder.file("t.ktx2"), polynomial = folder.file("p.json"),
                    out = folder.file("x.exr");
  const Result<table::PackedTable> packed =
      table::pack(small_table(8, 8), table::Layout::native, table::Precision::float32);
  REQUIRE(packed);
  REQUIRE(table::write_packed(*packed, table));
  REQUIRE(table::write_polynomial(table::builtin_ggx_polynomial(), polynomial).ok());
  const auto picture = [&](const std::vector<std::string>& more) {
    const Run run = run_tool(render(out, more));
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    return bytes_of(out);
  };
  const auto standard = picture({}), by_polynomial = picture({"--lobes", "polynomial"});
  CHECK(picture({"--lobes", "two-lobe"}) == standard);
  CHECK(picture({"--lobes", "table"}) != standard);
  CHECK(by_polynomial != standard);
  const auto by_table = picture({"--table", table});
  CHECK(by_table != standard);
  CHECK(by_table != by_polynomial);
  CHECK(picture({"--lobes", "table", "--table", table}) == by_table);
  // A file says itself what it holds.
  CHECK(picture({"--table", polynomial}) == by_polynomial);
  CHECK(picture({"--lobes", "polynomial", "--table", polynomial}) == by_polynomial);

  // What a table lacks, or is of another BRDF, is said.
  const auto warned = [&](table::Layout layout, const std::string& brdf) {
    table::LobeTable other = small_table(8, 8);
    other.metadata.brdf = brdf;
    const Result<table::PackedTable> written =
        table::pack(other, layout, table::Precision::float32);
    REQUIRE(written);
    const std::string file = folder.file("w.ktx2");
    REQUIRE(table::write_packed(*written, file));
    std::vector<std::string> arguments = render(out, {"--table", file});
    arguments.erase(arguments.begin() + 2); // --quiet
    const Run run = run_tool(arguments);
    REQUIRE(run.exit_code == 0);
    for (const char* written_file : {"w.ktx2", "w_1.ktx2", "w_2.ktx2"})
      std::filesystem::remove(folder.file(written_file));
    return run.err;
  };
  CHECK(contains(warned(table::Layout::unity, "ggx"), "n1 = 1 and n5 = 0 are used"));
  CHECK(contains(warned(table::Layout::native, "beckmann"), "w.ktx2: fitted to beckmann"));
  const std::string usual = warned(table::Layout::native, "ggx");
  CHECK_FALSE(contains(usual, "fitted to"));
  CHECK_FALSE(contains(usual, "n1 = 1"));
}

TEST_CASE("render_refuses_lobes_that_are_broken_or_not_for_shading") {
  const TemporaryFolder folder;
  const std::string table = folder.file("t.ktx2"), polynomial = folder.file("p.json"),
                    bad = folder.file("bad.json"), out = folder.file("x.png");
  const auto refuses = [&](const std::vector<std::string>& more, const std::string& named) {
    return fails_naming(run_tool(render(out, more)), named);
  };
  REQUIRE(table::write_polynomial(table::builtin_ggx_polynomial(), polynomial).ok());
  const Result<table::PackedTable> packed =
      table::pack(small_table(8, 8), table::Layout::native, table::Precision::float32);
  REQUIRE(packed);
  REQUIRE(table::write_packed(*packed, table));
  CHECK(refuses({"--lobes", "table", "--table", polynomial}, "p.json: holds a lobe polynomial"));
  CHECK(refuses({"--lobes", "polynomial", "--table", table}, "t.ktx2: holds a lobe table"));
  CHECK(refuses({"--table", folder.file("no.ktx2")}, "no.ktx2: cannot open"));

  const json good = json::parse(text_of(polynomial));
  const auto changed = [&](const char* key, const json& value) {
    json copy = good;
    copy[key] = value;
    write_text(bad, copy.dump());
    return bad;
  };
  CHECK(refuses({"--table", changed("version", 9)}, "bad.json: version"));
  CHECK(refuses({"--table", changed("degree", 9)}, "bad.json: degree"));
  CHECK(refuses({"--table", changed("coefficients", json::array())}, "bad.json: coefficients"));
  CHECK(refuses({"--table", changed("width", "narrow")}, "bad.json: width"));
  CHECK(refuses({"--table", changed("metadata", nullptr)}, "bad.json: metadata"));
  write_text(bad, text_of(polynomial).substr(0, 900));
  CHECK(refuses({"--table", bad}, "bad.json: not a complete JSON file"));

  // Whole, but of lobes that do not narrow with roughness, or of one roughness.
  json wide = good;
  wide["width"] = "one";
  wide["coefficients"] = json::array();
  for (std::size_t i = 0; i < good["coefficients"].size(); ++i) // A = D = n1 = 1, the cosine itself
    wide["coefficients"].push_back(i == 0 || i == 3 || i == 4 ? 1.0 : 0.0);
  write_text(bad, wide.dump());
  CHECK(refuses({"--table", bad}, "bad.json: holds lobes of width one, those of ggx"));
  table::LobeTable diffuse = small_table(4, 4);
  diffuse.width = brdf::LobeWidth::one;
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 6; ++k)
      diffuse.texel(i % 4, i / 4)[k] = k == 0 || k == 3 || k == 4 ? 1.0f : 0.0f;
  REQUIRE(table::write_table(diffuse, bad).ok());
  CHECK(refuses({"--table", bad}, "bad.json: holds lobes of width one, those of ggx"));
  REQUIRE(table::write_table(small_table(1, 8), bad).ok());
  CHECK(refuses({"--table", bad}, "bad.json: has one column"));

  CHECK(refuses_usage(run_tool(render(out, {"--lobes", "spline"})),
                      "two-lobe or two-lobe-polynomial"));
  CHECK_FALSE(std::filesystem::exists(out));
  CHECK(folder.file_count() == 4); // t_1, t_2, p, bad
}
