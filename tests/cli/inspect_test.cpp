// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc inspect of pictures and scenes, against what was put into them.

#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"
#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace openltc;
using namespace openltc::test;

namespace {

json inspect(const std::string& path) {
  const Run run = run_tool({"inspect", path, "--json"});
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  return json::parse(run.out);
}

json area_light(const char* type, double size) {
  return {{"type", type}, {"intensity", 500.0}, {"size", size}, {"name", type}};
}

} // namespace

TEST_CASE("inspect_of_an_exr_gives_layers_ranges_and_exposure") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr");
  image::Image picture(4, 2, 3), error(4, 2, 1);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = float(i);
  picture.pixel(3, 1)[1] = std::numeric_limits<float>::quiet_NaN();
  picture.pixel(3, 1)[2] = std::numeric_limits<float>::infinity();
  picture.pixel(0, 1)[0] = -5;
  error.data[7] = 8;
  REQUIRE(image::write_exr(exr, std::vector<image::Layer>{{"", picture}, {"stderr", error}}).ok());
  const json values = inspect(exr);
  CHECK(values["kind"] == "picture");
  CHECK(values["width"] == 4);
  CHECK(values["height"] == 2);
  CHECK(values["encoding"] == "linear");
  REQUIRE(values["layers"].size() == 2);
  const json& first = values["layers"][0];
  CHECK(first["non_finite_pixels"] == 1);
  CHECK(first["channels"]["R"]["min"] == -5);
  CHECK(first["channels"]["R"]["max"] == 21);
  // 1 4 7 ... 19, without the NaN.
  CHECK(double(first["channels"]["G"]["mean"]) == doctest::Approx(10));
  CHECK(first["channels"]["B"]["max"] == 20);
  CHECK(values["layers"][1]["name"] == "stderr");
  CHECK(double(values["layers"][1]["channels"]["Y"]["mean"]) == doctest::Approx(1));
  CHECK(double(values["ev100"]) ==
        doctest::Approx(double(image::ev100_from_exposure(image::auto_exposure(picture)))));

  const Run text = run_tool({"inspect", exr});
  CHECK(text.exit_code == 0);
  for (const char* word : {"4x2", "stderr", "EV100", "1 of 8 pixels"})
    CHECK(contains(text.out, word));
}

TEST_CASE("inspect_of_other_pictures") {
  const TemporaryFolder folder;
  image::Image grey(8, 4, 3);
  for (float& v : grey.data)
    v = 0.5f;
  REQUIRE(image::write_png(folder.file("x.png"), grey).ok());
  REQUIRE(image::write_hdr(folder.file("x.hdr"), grey).ok());
  image::test::write_bytes(
      folder.file("x.jpg"),
      image::test::make_jpeg(8, 4, 3, std::vector<std::uint8_t>(8 * 4 * 3, 128)));
  const json png = inspect(folder.file("x.png")), hdr = inspect(folder.file("x.hdr")),
             jpg = inspect(folder.file("x.jpg"));
  CHECK(png["encoding"] == "srgb");
  CHECK_FALSE(png.contains("ev100"));
  CHECK(double(png["layers"][0]["channels"]["G"]["mean"]) == doctest::Approx(0.2159).epsilon(0.01));
  CHECK(double(jpg["layers"][0]["channels"]["G"]["mean"]) == doctest::Approx(0.2159).epsilon(0.03));
  CHECK(jpg["width"] == 8);
  CHECK(hdr["encoding"] == "linear");
  CHECK(hdr.contains("ev100"));
  CHECK(double(hdr["layers"][0]["channels"]["G"]["mean"]) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("inspect_of_a_scene_gives_geometry_cameras_and_photometry") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor(100);
  add_camera(scene, "front", 0.5);
  add_camera(scene, "above", 2.5);
  scene.use("VENDOR_paint");
  scene.use("EXT_lights_area");
  scene.use("KHR_lights_punctual");
  scene.root["extensions"]["EXT_lights_area"]["lights"] = json::array({area_light("disk", 2.0)});
  scene.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 10}, {"name", "bulb"}, {"range", 7}},
      {{"type", "spot"}, {"intensity", 20}, {"name", "beam"}, {"spot", {{"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"intensity", 30}, {"name", "sun"}}};
  const auto add_light = [&](const char* extension, int light, const char* name) {
    const int node =
        scene.add("nodes", {{"name", name}, {"extensions", {{extension, {{"light", light}}}}}});
    scene.root["scenes"][0]["nodes"].push_back(node);
  };
  add_light("EXT_lights_area", 0, "disk");
  add_light("KHR_lights_punctual", 0, "bulb");
  add_light("KHR_lights_punctual", 1, "beam");
  add_light("KHR_lights_punctual", 2, "sun");
  write_scene(folder.file("x.gltf"), scene);

  const json values = inspect(folder.file("x.gltf"));
  CHECK(values["kind"] == "scene");
  CHECK(values["triangles"] == 4);
  CHECK(values["meshes"] == 2);
  CHECK(values["materials"][0] == "white");
  CHECK(double(values["bounds_m"]["upper"][1]) == doctest::Approx(1));
  CHECK(double(values["bounds_m"]["lower"][0]) == doctest::Approx(-2));
  REQUIRE(values["cameras"].size() == 2);
  CHECK(values["cameras"][1]["number"] == 1);
  CHECK(values["cameras"][1]["name"] == "above");
  CHECK(values["warnings"].dump().find("VENDOR_paint") != std::string::npos);

  REQUIRE(values["lights"].size() == 5);
  const auto light = [&](const std::string& type, const std::string& part) -> json {
    for (const json& l : values["lights"])
      if (l["type"] == type && l["name"].get<std::string>().find(part) != std::string::npos)
        return l;
    FAIL("no light " << type << " " << part << " in " << values["lights"].dump());
    return {};
  };
  const double pi = std::numbers::pi;
  const json lamp = light("polygon", "lamp"), disk = light("disk", "disk");
  CHECK(double(lamp["luminance_nits"]) == doctest::Approx(100));
  CHECK(double(lamp["area_m2"]) == doctest::Approx(1));
  CHECK(double(lamp["size_m"][0]) == doctest::Approx(1));
  CHECK(double(lamp["size_m"][1]) == doctest::Approx(1));
  CHECK(double(lamp["flux_lumens"]) == doctest::Approx(100 * pi));
  CHECK(lamp["holes"] == 0);
  CHECK(double(disk["area_m2"]) == doctest::Approx(pi));
  CHECK(double(disk["flux_lumens"]) == doctest::Approx(500 * pi * pi));
  CHECK(double(light("point", "bulb")["flux_lumens"]) == doctest::Approx(40 * pi));
  CHECK(double(light("point", "bulb")["range_m"]) == doctest::Approx(7));
  CHECK(double(light("spot", "beam")["intensity_candela"]) == doctest::Approx(20));
  CHECK(double(light("spot", "beam")["outer_cone_degrees"]) == doctest::Approx(0.5 * 180 / pi));
  CHECK(double(light("directional", "sun")["illuminance_lux"]) == doctest::Approx(30));

  const Run text = run_tool({"inspect", folder.file("x.gltf")});
  CHECK(text.exit_code == 0);
  for (const char* word : {"4 triangles", "1 \"above\"", "nits", "lm", "cd", "lux", "VENDOR_paint"})
    CHECK(contains(text.out, word));
}

TEST_CASE("inspect_lists_every_shape_with_its_size_and_photometry") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor(0);
  const json lights[] = {
      {{"type", "rect"}, {"width", 2}, {"height", 1}, {"flux_lumens", 10}},
      {{"type", "disk"}, {"radius", 0.5}, {"flux_lumens", 10}},
      {{"type", "ellipse"}, {"radius_x", 0.5}, {"radius_y", 1}, {"flux_lumens", 10}},
      {{"type", "sphere"}, {"radius", 0.5}, {"flux_lumens", 10}, {"cosine_power", 2}},
      {{"type", "tube"}, {"radius", 0.5}, {"length", 2}, {"flux_lumens", 10}, {"caps", "flat"}},
      {{"type", "line"}, {"length", 2}, {"flux_lumens", 10}},
      {{"type", "point"}, {"flux_lumens", 10}},
      {{"type", "spot"}, {"flux_lumens", 10}, {"inner_cone_degrees", 10}},
  };
  for (const json& light : lights)
    scene.root["scenes"][0]["nodes"].push_back(
        scene.add("nodes", {{"name", light["type"]}, {"extras", {{"openltc_light", light}}}}));
  write_scene(folder.file("x.gltf"), scene);
  const json values = inspect(folder.file("x.gltf"));
  CHECK(values["warnings"].empty());
  REQUIRE(values["lights"].size() == 8);
  for (const json& light : values["lights"]) {
    CAPTURE(light.dump());
    CHECK(light["name"] == (light["type"] == "polygon" ? "rect" : light["type"]));
    CHECK(double(light["flux_lumens"]) == doctest::Approx(10));
  }
  const Run text = run_tool({"inspect", folder.file("x.gltf")});
  for (const char* word : {"2 x 1 m", "disk, 1 m across", "ellipse, 1 x 2 m", "sphere, 1 m across",
                           "tube, 2 m long, 1 m across, flat ends", "cos^2", "cd/m", "10 lm"})
    CHECK(contains(text.out, word));
}

TEST_CASE("inspect_of_a_light_with_a_hole_says_so") {
  const json values = inspect(demo_scene());
  int holes = 0;
  for (const json& light : values["lights"])
    holes += light.value("holes", 0);
  CHECK(holes == 1);
}

TEST_CASE("inspect_refuses_what_it_cannot_read") {
  const TemporaryFolder folder;
  write_text(folder.file("x.txt"), "text");
  write_text(folder.file("x.exr"), "text");
  write_text(folder.file("x.png"), "");
  write_text(folder.file("x.glb"), "glTF");
  for (const char* name : {"x.txt", "x.exr", "x.png", "x.glb", "missing.exr", "missing"})
    CHECK(fails_naming(run_tool({"inspect", folder.file(name)}), folder.file(name)));
  CHECK(fails_naming(run_tool({"inspect", folder.file(".")}), "directory"));
}

TEST_CASE("inspect_speaks_of_the_files_own_coordinates_and_lists_animations") {
  const TemporaryFolder folder;
  GltfBuilder scene = lit_floor(100);
  add_camera(scene, "front", 0.5);
  const json roots = scene.root["scenes"][0]["nodes"];
  const int top = scene.add("nodes", {{"children", roots}, {"translation", {5e5, 320.5, -6e6}}});
  scene.root["scenes"][0]["nodes"] = json::array({top});
  const std::vector<float> times = {0, 2.5};
  const int input = scene.add_accessor(times, "SCALAR", k_float, 1);
  const int output = scene.add_vec3({5e5, 320.5, -6e6, 5e5, 330.5, -6e6});
  scene.root["animations"].push_back(
      {{"name", "rise"},
       {"samplers", json::array({{{"input", input}, {"output", output}}})},
       {"channels",
        json::array({{{"sampler", 0}, {"target", {{"node", top}, {"path", "translation"}}}}})}});
  const std::string path = folder.file("far.gltf");
  write_scene(path, scene);
  const json values = inspect(path);
  CHECK(double(values["bounds_m"]["upper"][1]) == doctest::Approx(321.5).epsilon(1e-9));
  CHECK(double(values["bounds_m"]["lower"][0]) == doctest::Approx(5e5 - 2).epsilon(1e-12));
  CHECK(double(values["cameras"][0]["position_m"][2]) == doctest::Approx(-6e6 + 4).epsilon(1e-12));
  REQUIRE(values["animations"].size() == 1);
  CHECK(values["animations"][0]["name"] == "rise");
  CHECK(values["animations"][0]["duration_seconds"] == 2.5);
  const Run text = run_tool({"inspect", path});
  CHECK(contains(text.out, "499998.000"));
  CHECK(contains(text.out, "animation  0 \"rise\": 2.5 s"));

  const Run posed = run_tool({"inspect", path, "--json", "--time", "1.25"});
  REQUIRE(posed.exit_code == 0);
  CHECK(double(json::parse(posed.out)["bounds_m"]["upper"][1]) ==
        doctest::Approx(326.5).epsilon(1e-9));
  CHECK(fails_naming(run_tool({"inspect", path, "--animation", "fall"}), "\"rise\""));
  CHECK(refuses_usage(run_tool({"inspect", path, "--time", "soon"}), "--time"));
  CHECK(refuses_usage(run_tool({"inspect", path, "--time", "nan"}), "--time"));
}
