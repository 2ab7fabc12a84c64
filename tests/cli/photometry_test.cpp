// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Photometric files at the command line: inspect, plot photometry, convert, and a picture lit by
// one.

#include "openltc/image/file.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <sys/stat.h>

using namespace openltc;
using namespace openltc::test;

namespace {

constexpr double k_pi = std::numbers::pi;

// A cosine lobe of 1000 cd in steps of 1 degree: 1000 pi lm.
std::string cosine_lamp(const std::string& behind = "") {
  std::string vertical, candela;
  for (int v = 0; v <= 90; ++v) {
    vertical += std::to_string(v) + (v % 20 == 19 ? "\n" : " ");
    candela += std::to_string(1000 * std::cos(v * k_pi / 180)) + (v % 10 == 9 ? "\n" : " ");
  }
  return "IESNA:LM-63-2002\n[TEST] x\n[LUMINAIRE] Cosine\nTILT=NONE\n1 4000 1 91 1 1 2 -0.2 -0.2 "
         "0\n"
         "1 1 20\n" +
         vertical + "\n0\n" + candela + "\n" + behind;
}

} // namespace

TEST_CASE("inspect_of_a_photometric_file_gives_its_numbers") {
  const TemporaryFolder folder;
  const std::string ies = folder.file("lamp.ies");
  write_text(ies, cosine_lamp("END\n"));
  const Run run = run_tool({"inspect", ies, "--json"});
  REQUIRE(run.exit_code == 0);
  const json values = json::parse(run.out);
  CHECK(values["kind"] == "photometry");
  CHECK(values["type"] == "C");
  CHECK(double(values["flux_lumens"]) == doctest::Approx(1000 * k_pi).epsilon(1e-3));
  CHECK(double(values["lamp_lumens"]) == 4000);
  CHECK(double(values["peak_candela"]) == doctest::Approx(1000));
  CHECK(double(values["peak_gamma_degrees"]) == 0);
  CHECK(double(values["beam_degrees"][0]) == doctest::Approx(120).epsilon(1e-3));
  CHECK(double(values["field_degrees"][1]) ==
        doctest::Approx(2 * std::acos(0.1) * 180 / k_pi).epsilon(1e-3));
  CHECK(values["symmetry"] == "about the axis");
  CHECK(values["stated_output_ratio"].is_null());
  CHECK(values["warnings"].size() == 1);
  const Run text = run_tool({"inspect", ies});
  CHECK(text.exit_code == 0);
  for (const char* word : {"type C, \"Cosine\"", "3141", "78.5 % leave", "1000 cd", "120.0 degrees",
                           "a disk, 0.2 m across", "warning    "})
    CHECK(contains(text.out, word));
  CHECK(fails_naming(run_tool({"inspect", folder.file("none.ldt")}), "none.ldt"));
  write_text(folder.file("bad.ldt"), "x\n");
  CHECK(fails_naming(run_tool({"inspect", folder.file("bad.ldt")}), "bad.ldt:"));
}

TEST_CASE("a_pipe_as_photometric_file_is_refused_at_once") {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("lamp.ies");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"inspect", pipe},
        {"convert", pipe, folder.file("x.ies")},
        {"plot", "photometry", pipe, "-o", folder.file("x.svg")}})
    CHECK(fails_naming(run_tool(command), "only regular files are read"));
}

TEST_CASE("convert_writes_lm_63_and_plot_draws_the_diagram") {
  const TemporaryFolder folder;
  const std::string ies = folder.file("lamp.ies"), out = folder.file("out.ies");
  write_text(ies, cosine_lamp());
  const Run run = run_tool({"convert", ies, out});
  CHECK(run.exit_code == 0);
  CHECK(contains(run.err, "wrote " + out));
  const json before = json::parse(run_tool({"inspect", ies, "--json"}).out);
  const json after = json::parse(run_tool({"inspect", out, "--json"}).out);
  CHECK(after["flux_lumens"] == before["flux_lumens"]);
  CHECK(after["name"] == "Cosine");
  CHECK(fails_naming(run_tool({"convert", ies, folder.file("x.dds")}), ".ies"));
  CHECK(fails_naming(run_tool({"convert", ies, out, "--size", "8"}), "photometry"));

  const std::string svg = folder.file("x.svg");
  REQUIRE(run_tool({"plot", "photometry", ies, "-o", svg, "--quiet"}).exit_code == 0);
  const auto bytes = bytes_of(svg);
  const std::string drawing(bytes.begin(), bytes.end());
  for (const char* word : {"Cosine", "3141", "1000 cd", "120.0°", "about the axis", "1000 cd<"})
    CHECK(contains(drawing, word));
  CHECK(!contains(drawing, "nan"));
  REQUIRE(run_tool({"plot", "photometry", ies, "--per-klm", "-o", svg, "--quiet"}).exit_code == 0);
  CHECK(fails_naming(run_tool({"plot", "photometry", folder.file("no.ies"), "-o", svg}), "no.ies"));
}

TEST_CASE("a_floor_under_ext_lights_ies_has_the_lamps_luminance") {
  // 1000 cd at 1.5 m: 444 lx on the floor, of albedo .5 and Lambertian 444 .5 / pi nits.
  const TemporaryFolder folder;
  GltfBuilder file;
  const int material = file.add(
      "materials",
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
       {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}});
  json square = file.square_primitive();
  square["material"] = material;
  const json down = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}; // +z goes to +y, -z to -y
  file.add_mesh_node(square,
                     {{"rotation", down}, {"scale", {4, 4, 4}}, {"translation", {-2, 0, 2}}});
  const int camera = file.add(
      "cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.002}, {"znear", 0.1}}}});
  file.root["scenes"][0]["nodes"].push_back(
      file.add("nodes", {{"camera", camera}, {"rotation", down}, {"translation", {0, 3, 0}}}));
  file.root["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "lamp.ies"}}});
  file.root["scenes"][0]["nodes"].push_back(
      file.add("nodes", {{"rotation", down},
                         {"translation", {0, 1.5, 0}},
                         {"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}}));
  file.use("EXT_lights_ies");
  write_scene(folder.file("room.gltf"), file);
  const std::string flood = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 5 3 2 2 0 0 0\n1 1 10\n"
                            "-90 -45 0 45 90\n0 45 90\n0 300 1000 300 0\n0 200 500 200 0\n"
                            "0 0 0 0 0\n";
  for (const std::string& lamp : {cosine_lamp(), flood}) {
    write_text(folder.file("lamp.ies"), lamp);
    const std::string picture = folder.file("x.exr");
    const Run run = run_tool(
        {"render", folder.file("room.gltf"), "-o", picture, "--size", "9x9", "--samples", "4"});
    REQUIRE(run.exit_code == 0);
    const auto image = image::read(picture);
    REQUIRE(image.ok());
    CHECK(double(image->pixel(4, 4)[0]) == doctest::Approx(1000 / 2.25 * 0.5 / k_pi).epsilon(2e-3));
  }
}
