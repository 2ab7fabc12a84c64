// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc convert, and openltc inspect of what it writes.

#include "openltc/image/file.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/table_file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

using namespace openltc;
using namespace openltc::test;

namespace {

constexpr const char* k_layouts[] = {"native", "ltc_code", "unity", "godot", "o3de"};
const std::string k_published = OPENLTC_SHARED_DIR "/tables/ltc_code_1.dds";

bool published_is_there() {
  if (std::filesystem::exists(k_published)) return true;
  MESSAGE("skipped: the published table is not there, see tests/CMakeLists.txt");
  return false;
}

// The built-in as a file, with 16 nodes per axis.
std::string small_table(const TemporaryFolder& folder) {
  const Result<table::LobeTable> table =
      table::resample(table::builtin_ggx_table(), 16, 16, table::AngleAxis::sqrt_one_minus_cos);
  REQUIRE(table);
  const std::string path = folder.file("ggx.json");
  REQUIRE(table::write_table(*table, path).ok());
  return path;
}

json inspect(const std::string& path) {
  const Run run = run_tool({"inspect", path, "--json"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  return json::parse(run.out);
}

} // namespace

TEST_CASE("convert_writes_every_layout_and_inspect_measures_it") {
  const TemporaryFolder folder;
  const std::string in = small_table(folder);
  for (const std::string layout : k_layouts) {
    CAPTURE(layout);
    const std::string out = folder.file(layout + ".ktx2");
    const Run run = run_tool({"convert", in, out, "--layout", layout});
    CHECK(run.exit_code == 0);
    CHECK(run.out.empty());
    CHECK(contains(run.err, "wrote "));
    CHECK(contains(run.err, "note: ") == (layout != "native")); // 16 is not the engines' size
    const json values = inspect(out);
    CHECK(values["kind"] == "table");
    CHECK(values["layout"] == layout);
    CHECK(values["size"] == 16);
    CHECK(values["brdf"] == "ggx");
    CHECK(contains(values["command"], "openltc convert --layout " + layout) ==
          (layout != "native")); // the same texels in another container are the same table
    // Read as the layout's engines do: ours clips the lobe at the horizon.
    CHECK(values["horizon"] == (layout == "native" ? "clipped" : "leaking"));
    if (layout != "native") {
      const std::string back = folder.file(layout + ".json");
      REQUIRE(run_tool({"convert", out, back, "--layout", "native", "--quiet"}).exit_code == 0);
      CHECK(inspect(back)["horizon"] == "clipped");
    }
    // The error stated is that of the new layout's look-up.
    CHECK(double(values["mean_tv"]) > 0.03);
    CHECK(double(values["mean_tv"]) < 0.08);
    CHECK(double(values["measured"]["mean_tv"]) ==
          doctest::Approx(double(values["mean_tv"])).epsilon(0.1));
  }
}

TEST_CASE("convert_there_and_back_loses_nothing_but_roundings") {
  const TemporaryFolder folder;
  const std::string in = small_table(folder), back = folder.file("back.json");
  const Result<table::LobeTable> want = table::read_table(in);
  for (const char* extension : {".dds", ".ktx2", ".exr", ".npy", ".json"}) {
    const std::string there = folder.file(std::string("there") + extension);
    for (const std::string layout : {"native", "ltc_code"}) {
      CAPTURE(there);
      REQUIRE(run_tool({"convert", in, there, "--layout", layout, "--quiet"}).exit_code == 0);
      REQUIRE(run_tool({"convert", there, back, "--layout", "native", "--quiet"}).exit_code == 0);
      const Result<table::LobeTable> got = table::read_table(back);
      REQUIRE(got);
      for (int row = 0; row < 15; ++row) // the grazing row belongs to another cosine
        for (int i = 0; i < 16 * table::LobeTable::k_channels; ++i)
          REQUIRE(std::abs(got->texel(0, row)[i] - want->texel(0, row)[i]) <=
                  (layout == "native" ? 0.0f : 5e-4f));
    }
  }
}

TEST_CASE("convert_of_the_same_layout_keeps_every_bit_of_a_published_texture") {
  if (!published_is_there()) return;
  const TemporaryFolder folder;
  const std::string out = folder.file("p.ktx2");
  REQUIRE(run_tool({"convert", k_published, out, "--from-layout", "ltc_code", "--brdf", "ggx",
                    "--quiet"})
              .exit_code == 0);
  const auto original = table::read_packed(k_published, table::Layout::ltc_code);
  const auto copy = table::read_packed(out);
  REQUIRE(original);
  REQUIRE(copy);
  CHECK(copy->precision == table::Precision::float16);
  for (std::size_t t = 0; t < 2; ++t)
    CHECK(copy->textures[t].values == original->textures[t].values);
  CHECK(copy->metadata.brdf == "ggx");
  CHECK(copy->metadata.mean_tv > 0.05);
}

TEST_CASE("inspect_names_the_published_texture") {
  if (!published_is_there()) return;
  const json values = inspect(k_published);
  CHECK(values["kind"] == "bare texture");
  const json& best = values["readings"][0];
  CHECK(best["layout"] == "ltc_code");
  CHECK(contains(best["brdf"], "ggx"));
  CHECK(double(best["mean_tv"]) < 0.09);
  CHECK(double(best["mean_n1"]) < 0.01);
  CHECK(double(best["mean_n5"]) < 0.001);
  for (const json& other : values["readings"]) // another way to read it fits no BRDF as well
    if (other["reading"] != best["reading"])
      CHECK(double(other["mean_tv"]) > 1.5 * double(best["mean_tv"]));
  const Run text = run_tool({"inspect", k_published});
  CHECK(contains(text.out, "most probably a table of ggx"));
  CHECK(contains(text.out, "--from-layout ltc_code"));
}

TEST_CASE("inspect_names_bare_textures_of_every_layout") {
  const TemporaryFolder folder;
  const std::string in = small_table(folder);
  for (const std::string layout : k_layouts) {
    CAPTURE(layout);
    const std::string out = folder.file(layout + ".dds");
    REQUIRE(run_tool({"convert", in, out, "--layout", layout, "--quiet"}).exit_code == 0);
    std::filesystem::remove(out + ".json");
    const json values = inspect(out);
    CHECK(values["kind"] == "bare texture");
    CHECK(values["readings"][0]["layout"] == layout);
  }
}

TEST_CASE("inspect_tells_a_table_from_a_picture_by_its_attributes") {
  const TemporaryFolder folder;
  const std::string in = small_table(folder), out = folder.file("t.exr");
  REQUIRE(run_tool({"convert", in, out, "--layout", "unity", "--quiet"}).exit_code == 0);
  const json table = inspect(out);
  CHECK(table["kind"] == "table");
  CHECK(contains(table["taken_for_a_table"], "attributes"));
  image::Image picture(16, 16, 4);
  REQUIRE(image::write_exr(out, std::vector<image::Layer>{{"", picture}}).ok());
  CHECK(inspect(out)["kind"] == "picture");
}

TEST_CASE("convert_refuses_what_it_cannot_do_and_leaves_old_files") {
  const TemporaryFolder folder;
  const std::string in = small_table(folder), out = folder.file("out.dds");
  const auto old_files = folder.file_count();
  CHECK(fails_naming(run_tool({"convert", folder.file("no.json"), out}), "no.json"));
  CHECK(refuses_usage(run_tool({"convert", in, folder.file("x.tga")}), "x.tga"));
  CHECK(fails_naming(run_tool({"convert", in, folder.file("no/x.dds")}), "no/x"));
  CHECK(fails_naming(run_tool({"convert", demo_scene(), out}), "demo.glb"));
  CHECK(fails_naming(run_tool({"convert", in, out, "--layout", "o3de", "--precision", "float16"}),
                     "half"));
  CHECK(fails_naming(run_tool({"convert", in, out, "--from-layout", "unity"}), "native"));
  CHECK(refuses_usage(run_tool({"convert", in, out, "--layout", "unreal"}), "unreal"));
  CHECK(refuses_usage(run_tool({"convert", in, out, "--precision", "int8"}), "int8"));
  CHECK(refuses_usage(run_tool({"convert", in, out, "--size", "1"}), "size"));
  CHECK(refuses_usage(run_tool({"convert", in, out, "--size", "99999"}), "size"));
  CHECK(refuses_usage(run_tool({"convert", in}), "output"));
  CHECK(folder.file_count() == old_files);

  REQUIRE(run_tool({"convert", in, out, "--layout", "ltc_code", "--quiet"}).exit_code == 0);
  const auto first = bytes_of(folder.file("out_1.dds"));
  std::filesystem::remove(out + ".json");
  CHECK(fails_naming(run_tool({"convert", out, folder.file("x.json")}), "--from-layout"));
  write_text(folder.file("cut_1.dds"), std::string(first.begin(), first.begin() + 1000));
  CHECK(fails_naming(
      run_tool({"convert", folder.file("cut_1.dds"), out, "--from-layout", "ltc_code"}),
      "cut off"));
  CHECK(fails_naming(run_tool({"inspect", folder.file("cut_1.dds")}), "cut_1.dds"));
  write_text(folder.file("cut_1.ktx2"), "not one");
  CHECK(fails_naming(run_tool({"inspect", folder.file("cut_1.ktx2")}), "cut_1.ktx2"));
  CHECK(bytes_of(folder.file("out_1.dds")) == first);
}

TEST_CASE("convert_of_a_scene_writes_its_lights_and_names_those_it_cannot") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor(100);
  const auto add = [&](const char* name, const json& light) {
    scene.root["scenes"][0]["nodes"].push_back(
        scene.add("nodes", {{"name", name}, {"extras", {{"openltc_light", light}}}}));
  };
  add("Panel", {{"type", "rect"}, {"width", 2}, {"height", 1}, {"flux_lumens", 300}});
  add("Bulb", {{"type", "sphere"}, {"radius", 0.1}, {"luminance_nits", 30}});
  const std::string in = folder.file("in.gltf"), out = folder.file("out.glb");
  write_scene(in, scene);
  const Run run = run_tool({"convert", in, out});
  CHECK(run.exit_code == 0);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "\"Bulb\": a sphere"));
  CHECK(contains(run.err, "wrote " + out + ", 2 lights"));
  const json before = inspect(in)["lights"], after = inspect(out)["lights"];
  REQUIRE(before.size() == 3);
  REQUIRE(after.size() == 3);
  const auto lumens = [](const json& lights) {
    double sum = 0;
    for (const json& light : lights)
      sum += light["flux_lumens"].get<double>();
    return sum;
  };
  CHECK(lumens(after) == doctest::Approx(lumens(before)));
  const Run again = run_tool({"convert", out, folder.file("again.glb"), "--quiet"});
  CHECK(again.exit_code == 0);
  CHECK(again.err.empty());
  CHECK(inspect(folder.file("again.glb"))["lights"] == after); // nothing left to do
  CHECK(bytes_of(folder.file("again.glb")) == bytes_of(out));

  CHECK(fails_naming(run_tool({"convert", in, folder.file("x.gltf")}), ".glb"));
  CHECK(fails_naming(run_tool({"convert", in, out, "--layout", "unity"}), "holds a scene"));
  CHECK(fails_naming(run_tool({"convert", in, folder.file("no/x.glb")}), "no/x"));
  CHECK(fails_naming(run_tool({"convert", folder.file("no.glb"), out}), "no.glb"));
}
