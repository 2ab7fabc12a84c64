// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// EXT_lights_ies, read as its specification says and written by export.

#include "gltf_builder.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/scene/gltf/export.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using namespace openltc;
using namespace openltc::test;
using image::test::TemporaryFolder;

constexpr const char* k_extension = "EXT_lights_ies";
const std::string k_lamp = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 5 1 1 2 0 0 0\n1 1 10\n"
                           "0 22.5 45 67.5 90\n0\n1000 800 500 200 0\n";
// 300 cd upwards, V > 0, and 200 to the right, H > 0, of the aim's 1000.
const std::string k_headlamp = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 3 3 2 0 0 0\n1 1 10\n"
                               "-90 0 90\n-90 0 90\n0 0 300\n0 1000 300\n0 200 300\n";
const json k_quarter_turn_about_x = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}; // -z goes to -y

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string data_uri(const std::string& text) {
  return "data:application/x-ies-lm-63;base64," + base64({text.begin(), text.end()});
}

struct IesScene {
  GltfBuilder file;

  IesScene() { file.use(k_extension); }

  int add_light(const json& light) {
    json& lights = file.root["extensions"][k_extension]["lights"];
    lights.push_back(light);
    return int(lights.size()) - 1;
  }
  void add_node(const json& reference, json node = json::object()) {
    node["extensions"][k_extension] = reference;
    file.root["scenes"][0]["nodes"].push_back(file.add("nodes", node));
  }
};

Result<scene::Scene> load_in(const GltfBuilder& file, const std::string& folder) {
  const std::string text = file.to_text();
  return scene::load_gltf_memory({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                                 "test.gltf", folder);
}

bool is_near(Vec3f a, Vec3f b) { return length(a - b) < 1e-5f; }

TEST_CASE("lights_ies_are_read_from_files_data_and_views") {
  const TemporaryFolder folder;
  write(folder.file("a lamp.ies"), k_lamp);
  IesScene scene;
  const int view = scene.file.add_view(k_lamp.data(), k_lamp.size());
  scene.add_light({{"uri", "a%20lamp.ies"}, {"name", "Profile"}});
  scene.add_light({{"uri", data_uri(k_lamp)}});
  scene.add_light({{"bufferView", view}, {"mimeType", "application/x-ies-lm-63"}});
  const json placed = {
      {"translation", {1, 2, 3}}, {"rotation", k_quarter_turn_about_x}, {"scale", {2, 2, 2}}};
  for (int i = 0; i < 3; ++i)
    scene.add_node({{"light", i}}, placed);
  scene.add_node({{"light", 0}, {"multiplier", 0.5}, {"color", {1, 0.5, 3}}}, {{"name", "Warm"}});
  const auto loaded = load_in(scene.file, folder.file(""));
  REQUIRE(loaded.ok());
  REQUIRE(loaded->lights.punctual.size() == 4);
  for (int i = 0; i < 3; ++i) {
    const light::PunctualLight& light = loaded->lights.punctual[std::size_t(i)];
    REQUIRE(light.profile);
    CHECK(light.type == light::PunctualType::point);
    // Intensity is that of the file, whatever the node's scale.
    CHECK(is_near(light.intensity, Vec3f(1000.0f)));
    CHECK(is_near(light.position, Vec3f(1, 2, 3)));
    CHECK(is_near(light.direction, Vec3f(0, -1, 0)));
    CHECK(is_near(light.right, Vec3f(1, 0, 0)));
  }
  CHECK(loaded->lights.punctual[0].profile == loaded->lights.punctual[3].profile);
  CHECK(loaded->lights.punctual[0].name == "Profile");
  CHECK(loaded->lights.punctual[3].name == "Warm");
  // Colour is clamped to 0 .. 1, and says so.
  CHECK(is_near(loaded->lights.punctual[3].intensity, Vec3f(500, 250, 500)));
  CHECK(std::any_of(loaded->warnings.begin(), loaded->warnings.end(), [](const std::string& w) {
    return w.find("nodes[3].extensions.EXT_lights_ies.color") == 0;
  }));
}

TEST_CASE("the_aim_of_every_photometric_type_is_minus_z_and_up_is_plus_x") {
  IesScene scene;
  scene.add_light({{"uri", data_uri(k_headlamp)}});
  scene.add_node({{"light", 0}});
  const auto loaded = scene.file.load();
  REQUIRE(loaded.ok());
  REQUIRE(loaded->lights.punctual.size() == 1);
  const light::PunctualLight& light = loaded->lights.punctual[0];
  const auto towards = [&](Vec3f world) {
    const Vec3f y = cross(light.right, light.direction);
    return light::eval_candela(
        *light.profile,
        to_double(Vec3f(dot(world, light.right), dot(world, y), dot(world, light.direction))));
  };
  CHECK(towards({0, 0, -1}) == doctest::Approx(1000));
  // Half way between the table's angles; X/Z is the vertical plane, V grows towards +X.
  CHECK(towards({1, 0, -1}) == doctest::Approx(650).epsilon(1e-5));
  CHECK(towards({-1, 0, -1}) == doctest::Approx(500).epsilon(1e-5));
  // Clockwise, against glTF's positive rotation: seen from +X, -Z turns to -Y.
  CHECK(towards({0, -1, -1}) == doctest::Approx(600).epsilon(1e-5));
  CHECK(towards({0, 1, -1}) == doctest::Approx(500).epsilon(1e-5));
}

TEST_CASE("a_light_ies_that_cannot_be_read_is_lost_alone") {
  IesScene scene;
  const int view = scene.file.add_view(k_lamp.data(), k_lamp.size());
  scene.add_light({{"uri", data_uri(k_lamp)}});
  scene.add_light(json::object());
  scene.add_light({{"bufferView", 99}, {"mimeType", "application/x-ies-lm-63"}});
  scene.add_light({{"uri", "none.ies"}});
  scene.add_light({{"uri", data_uri("no photometry")}});
  scene.add_light({{"bufferView", view}});
  scene.add_light("lamp.ies");
  scene.add_node({{"light", 0}});
  for (int i = 1; i <= 6; ++i)
    scene.add_node({{"light", i}});
  for (const json& wrong :
       {json{{"light", 7}}, json{{"light", -1}}, json{{"light", "0"}}, json::object(), json(5),
        json{{"light", 0}, {"multiplier", -1}}, json{{"light", 0}, {"color", {1, 1}}}})
    scene.add_node(wrong);
  const TemporaryFolder folder;
  const auto loaded = load_in(scene.file, folder.file(""));
  REQUIRE(loaded.ok());
  CHECK(loaded->lights.punctual.size() == 2); // the first, and the view without its type
  const auto says = [&](const std::string& part) {
    return std::any_of(loaded->warnings.begin(), loaded->warnings.end(),
                       [&](const std::string& w) { return w.find(part) != std::string::npos; });
  };
  for (const char* part :
       {"lights[1]: has neither uri nor bufferView", "lights[2].bufferView", "lights[3].uri",
        "lights[4]:1: no line begins with TILT", "lights[5].mimeType",
        "lights[6]: must be an object",
        "nodes[7].extensions.EXT_lights_ies.light: points at no light", "nodes[8]", "nodes[9]",
        "nodes[10].extensions.EXT_lights_ies.light: is missing", "nodes[11]",
        "nodes[12].extensions.EXT_lights_ies.multiplier",
        "nodes[13].extensions.EXT_lights_ies.color"}) {
    CAPTURE(part);
    CHECK(says(part));
  }
  scene.file.root["extensions"][k_extension]["lights"] = 3;
  const auto none = load_in(scene.file, folder.file(""));
  REQUIRE(none.ok());
  CHECK(none->lights.punctual.empty());
}

TEST_CASE("extras_take_eulumdat_and_what_was_put_right_is_a_warning") {
  const TemporaryFolder folder;
  write(folder.file("noisy.ies"), k_lamp.substr(0, k_lamp.size() - 2) + "-0.05\nEND\n");
  std::string ldt = "nobody\n1\n1\n1\n0\n2\n90\nr\nlamp\nn\nf\nd\n";
  for (int i = 0; i < 9; ++i)
    ldt += "0\n";
  ldt += "100\n100\n1\n0\n1\n1\nLED\n2000\n3000K\n80\n10\n";
  for (int i = 0; i < 10; ++i)
    ldt += "1\n";
  ldt += "0\n0\n90\n300\n0\n";
  write(folder.file("lamp.ldt"), ldt);
  GltfBuilder file;
  for (const char* name : {"noisy.ies", "./noisy.ies", "lamp.ldt"})
    file.root["scenes"][0]["nodes"].push_back(
        file.add("nodes", {{"extras", {{"openltc_light", {{"type", "point"}, {"ies", name}}}}}}));
  const auto loaded = load_in(file, folder.file(""));
  REQUIRE(loaded.ok());
  REQUIRE(loaded->lights.punctual.size() == 3);
  CHECK(is_near(loaded->lights.punctual[0].intensity, Vec3f(1000.0f)));
  CHECK(loaded->lights.punctual[0].profile == loaded->lights.punctual[1].profile);
  CHECK(is_near(loaded->lights.punctual[2].intensity, Vec3f(600.0f))); // 300 cd/klm, 2000 lm
  CHECK(std::count_if(loaded->warnings.begin(), loaded->warnings.end(), [](const std::string& w) {
          return w.find("noisy.ies") != std::string::npos;
        }) == 2);
}

TEST_CASE("export_writes_profiles_as_lights_ies_and_takes_their_files_along") {
  const TemporaryFolder folder;
  write(folder.file("lamp.ies"), k_lamp);
  write(folder.file("head.ies"), k_headlamp);
  IesScene scene;
  scene.add_light({{"uri", "lamp.ies"}, {"name", "kept"}});
  scene.add_node({{"light", 0}, {"multiplier", 2.0}}, {{"name", "First"}});
  const auto add = [&](const json& light, json node) {
    node["extras"]["openltc_light"] = light;
    scene.file.root["scenes"][0]["nodes"].push_back(scene.file.add("nodes", node));
  };
  const json turned = {{"rotation", k_quarter_turn_about_x}, {"translation", {0, 2, 0}}};
  add({{"type", "point"}, {"ies", "head.ies"}, {"color", {2, 1, 0}}}, turned);
  add({{"type", "point"}, {"ies", "head.ies"}, {"intensity_candela", 50}}, turned);
  add({{"type", "spot"}, {"ies", "lamp.ies"}, {"outer_cone_degrees", 30}}, turned);
  const std::string input = folder.file("in.gltf");
  write(input, scene.file.to_text());
  const auto before = scene::load_gltf(input);
  REQUIRE(before.ok());
  REQUIRE(before->lights.punctual.size() == 4);

  // To a folder of its own, where no file lies beside it.
  std::filesystem::create_directory(folder.file("out"));
  const std::string output = folder.file("out") + "/out.glb";
  const auto report = scene::export_area_lights(input, output);
  REQUIRE(report.ok());
  CHECK(report->profiles_written == 2);
  CHECK(report->left.size() == 1); // the cone
  const auto after = scene::load_gltf(output);
  REQUIRE(after.ok());
  REQUIRE(after->lights.punctual.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const light::PunctualLight &a = before->lights.punctual[i], &b = after->lights.punctual[i];
    CHECK(length(a.intensity - b.intensity) <= 1e-5f * length(a.intensity));
    CHECK(is_near(a.position, b.position));
    CHECK(is_near(a.direction, b.direction));
    CHECK(is_near(a.right, b.right));
    REQUIRE(b.profile);
    CHECK(b.profile->type == a.profile->type);
    CHECK(b.profile->candela == a.profile->candela);
  }
  // Both headlamps share one entry.
  CHECK(after->lights.punctual[1].profile == after->lights.punctual[2].profile);
}

} // namespace
