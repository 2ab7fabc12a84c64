// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What cannot be read but can be spared costs a warning, not the file; and whether a file describes
// lights.

#include "openltc/image/file.h"
#include "tests/image/make_picture.h"
#include "tests/scene/gltf_builder.h"

#include <doctest/doctest.h>

#include <filesystem>

#ifdef OPENLTC_HAVE_WEBP
#include <webp/encode.h>
#endif

using namespace openltc;
using namespace openltc::test;
using image::test::TemporaryFolder;
using image::test::write_bytes;

namespace {

std::vector<std::uint8_t> text_bytes(const std::string& text) { return {text.begin(), text.end()}; }

// A square whose base colour is `image`; the index of its texture is 0.
GltfBuilder pictured(const json& image) {
  GltfBuilder file;
  const int texture = file.add("textures", {{"source", file.add("images", image)}});
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add_mesh_node(primitive);
  return file;
}

Result<scene::Scene> load_in(const GltfBuilder& file, const TemporaryFolder& folder,
                             const scene::ReadOptions& reading = {}) {
  return scene::load_gltf_memory(text_bytes(file.to_text()), "test.gltf", folder.file(""), {},
                                 reading);
}

// Loads, without textures, with a warning that has all of `parts`.
void check_spared(const Result<scene::Scene>& loaded, const std::vector<std::string>& parts) {
  if (!loaded.ok()) FAIL(loaded.error().message);
  CHECK(loaded->meshes.size() == 1);
  CHECK(loaded->textures.empty());
  REQUIRE(loaded->warnings.size() == 1);
  for (const std::string& part : parts) {
    CAPTURE(loaded->warnings[0]);
    CHECK(loaded->warnings[0].find(part) != std::string::npos);
  }
}

// The first bytes of formats that are not read, by their specifications.
const std::vector<std::pair<std::string, std::string>> k_foreign = {
    {"KTX2", std::string("\xABKTX 20\xBB\r\n\x1A\n", 12)},
    {"DDS", "DDS |"},
    {"GIF", "GIF89a"},
    {"AVIF", std::string("\0\0\0\x1C", 4) + "ftypavif"},
    {"TIFF", std::string("II*\0", 4)},
    {"HTML", "<!DOCTYPE html><p>404"}};

TEST_CASE("a_missing_or_unreadable_texture_costs_a_warning_that_names_it") {
  const TemporaryFolder folder;
  check_spared(load_in(pictured({{"uri", "gone.png"}}), folder), {"images[0].uri", "gone.png"});
  check_spared(load_in(pictured(json::object()), folder), {"images[0]", "neither uri"});
  check_spared(load_in(pictured({{"uri", "https://a.b/c.png"}}), folder), {"https://a.b/c.png"});
  check_spared(load_in(pictured({{"uri", "data:image/png;base64,!!"}}), folder), {"images[0]"});
  write_bytes(folder.file("cut.png"), {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0});
  check_spared(load_in(pictured({{"uri", "cut.png"}}), folder), {"cut.png", "PNG"});
  for (const auto& [name, head] : k_foreign) {
    write_bytes(folder.file("x.tex"), text_bytes(head + std::string(40, 'x')));
    check_spared(load_in(pictured({{"uri", "x.tex"}}), folder), {"x.tex", name});
  }
}

TEST_CASE("a_texture_without_source_costs_a_warning_that_names_its_extension") {
  GltfBuilder file = pictured(json::object());
  file.root["textures"][0] = json::object();
  check_spared(file.load(), {"textures[0]: has no source"});
  file.root["textures"][0]["extensions"]["MSFT_texture_dds"] = {{"source", 0}};
  check_spared(file.load(), {"textures[0]", "MSFT_texture_dds"});
}

TEST_CASE("a_required_extension_of_textures_alone_still_shows_shapes") {
  GltfBuilder file = pictured(json::object());
  file.root["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
  file.use("KHR_texture_basisu", true);
  const auto loaded = file.load();
  if (!loaded.ok()) FAIL(loaded.error().message);
  CHECK(loaded->meshes.size() == 1);
  CHECK(warns_about(*loaded, "KHR_texture_basisu is not supported yet"));
  CHECK(warns_about(*loaded, "textures[0]"));
}

TEST_CASE("one_texture_that_is_used_often_is_warned_of_once") {
  GltfBuilder file = pictured({{"uri", "gone.png"}});
  for (int i = 0; i < 3; ++i)
    file.root["materials"].push_back(file.root["materials"][0]);
  const TemporaryFolder folder;
  const auto loaded = load_in(file, folder);
  REQUIRE(loaded.ok());
  CHECK(loaded->warnings.size() == 1);
}

TEST_CASE("without_its_texture_a_material_does_not_shine") {
  GltfBuilder file = pictured({{"uri", "gone.png"}});
  file.root["materials"][0] = {{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}};
  const TemporaryFolder folder;
  const auto loaded = load_in(file, folder);
  REQUIRE(loaded.ok());
  CHECK(loaded->materials[0].emission.x == 0);
  CHECK(loaded->lights.empty());
  CHECK(warns_about(*loaded, "does not shine"));
  CHECK(!loaded->describes_lights); // a plain factor
}

TEST_CASE("backslashes_of_windows_are_slashes") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("textures"));
  write_bytes(folder.file("textures/red.png"), make_png(1, 1, {255, 0, 0, 255}));
  for (const char* uri : {"textures\\red.png", "textures%5Cred.png", ".\\textures\\red.png"}) {
    CAPTURE(uri);
    const auto loaded = load_in(pictured({{"uri", uri}}), folder);
    REQUIRE(loaded.ok());
    CHECK(loaded->warnings.empty());
    REQUIRE(loaded->textures.size() == 1);
    CHECK(loaded->textures[0].image.rgb(0, 0).x == 1.0f);
  }
  // A file that has one in its name is that file.
  write_bytes(folder.file("a\\b.png"), make_png(1, 1, {0, 255, 0, 255}));
  const auto loaded = load_in(pictured({{"uri", "a\\b.png"}}), folder);
  REQUIRE(loaded.ok());
  CHECK(loaded->textures.at(0).image.rgb(0, 0).y == 1.0f);
}

#ifdef OPENLTC_HAVE_WEBP
TEST_CASE("webp_is_read_as_extension_as_requirement_and_by_its_bytes") {
  REQUIRE(image::can_read_webp());
  // Lossless, so that the values are known: sRGB 188 is .5029 linear.
  const std::uint8_t pixels[8] = {188, 0, 255, 255, 0, 255, 0, 51};
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(pixels, 2, 1, 8, &encoded);
  REQUIRE(size > 0);
  std::vector<std::uint8_t> webp(encoded, encoded + size);
  WebPFree(encoded);
  const std::string uri = "data:image/webp;base64," + base64(webp);

  GltfBuilder file = pictured({{"uri", uri}});
  file.root["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  file.use("EXT_texture_webp", true);
  for (const auto& loaded : {file.load(), pictured({{"uri", uri}}).load()}) {
    if (!loaded.ok()) FAIL(loaded.error().message);
    CHECK(loaded->warnings.empty());
    REQUIRE(loaded->textures.size() == 1);
    const image::Texels& texels = loaded->textures[0].image;
    CHECK(texels.rgba(0, 0).x == doctest::Approx(0.5029).epsilon(1e-3));
    CHECK(texels.rgba(0, 0).z == 1.0f);
    CHECK(texels.rgba(0, 0).w == 1.0f);
    CHECK(texels.rgba(1, 0).w == doctest::Approx(0.2));
  }
  // Cut short anywhere it is spared, never a crash.
  for (std::size_t length = 0; length < webp.size(); ++length) {
    const std::vector<std::uint8_t> cut(webp.begin(), webp.begin() + std::ptrdiff_t(length));
    const auto loaded = pictured({{"uri", "data:image/webp;base64," + base64(cut)}}).load();
    REQUIRE(loaded.ok());
  }
  // A plain picture stands in for one that cannot be read.
  GltfBuilder both = pictured({{"uri", "data:image/webp;base64,UklGRg=="}});
  both.add_texture(1, 1, {255, 255, 255, 255});
  both.root["textures"][0] = {{"source", 1},
                              {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  both.use("EXT_texture_webp");
  const auto loaded = both.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->textures.size() == 1);
  CHECK(warns_about(*loaded, "the plain picture is used"));
}
#endif

TEST_CASE("gltf_1_0_is_named_as_such") {
  const char* versions[] = {R"({"asset": {"version": "1.0"}, "scenes": {"s": {}}})",
                            R"({"asset": {"version": 1}, "scenes": {}})",
                            R"({"scenes": {"s": {"nodes": []}}})"};
  for (const char* text : versions) {
    CAPTURE(text);
    CHECK(fails_naming(load_bytes(text_bytes(text)), "glTF 1.0"));
  }
}

// --- lights ----------------------------------------------------------------------------------

// A square, and a node with this extension or extras.
GltfBuilder lit(const json& node, const json& extensions = json::object()) {
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  if (!extensions.empty()) file.root["extensions"] = extensions;
  const int index = file.add("nodes", node);
  file.root["scenes"][0]["nodes"].push_back(index);
  return file;
}

TEST_CASE("a_broken_light_object_loses_that_light_only") {
  for (const char* extension : {"KHR_lights_punctual", "EXT_lights_area"}) {
    const bool is_area = std::string(extension) == "EXT_lights_area";
    const json good = {{"type", is_area ? "disk" : "point"}};
    for (const json& broken : {json::object(), json{{"type", "lava"}}, json{{"type", 3}},
                               json("point"), json{{"type", good["type"]}, {"intensity", "bright"}},
                               json{{"type", good["type"]}, {"color", {1, 1}}}}) {
      CAPTURE(broken.dump());
      GltfBuilder file = lit({{"extensions", {{extension, {{"light", 0}}}}}},
                             {{extension, {{"lights", {broken, good}}}}});
      const auto dark = file.load();
      if (!dark.ok()) FAIL(dark.error().message);
      CHECK(dark->lights.empty());
      CHECK(dark->describes_lights);
      CHECK(warns_about(*dark, std::string("extensions.") + extension + ".lights[0]"));
      CHECK(warns_about(*dark, "the light is left out"));
      // The other one keeps its number.
      file.root["scenes"][0]["nodes"].push_back(
          file.add("nodes", {{"extensions", {{extension, {{"light", 1}}}}}}));
      const auto loaded = file.load();
      REQUIRE(loaded.ok());
      CHECK(loaded->lights.punctual.size() + loaded->lights.ellipses.size() == 1);
    }
    const auto without = lit({{"extensions", {{extension, json::object()}}}},
                             {{extension, {{"lights", json::array({good})}}}})
                             .load();
    REQUIRE(without.ok());
    CHECK(without->lights.empty());
    CHECK(without->describes_lights);
    CHECK(warns_about(*without, "nodes[1].extensions"));
  }
}

TEST_CASE("a_file_describes_lights_when_it_says_so_readable_or_not") {
  const auto describes = [](const GltfBuilder& file) {
    const auto loaded = file.load();
    if (!loaded.ok()) FAIL(loaded.error().message);
    return loaded->describes_lights;
  };
  CHECK(!describes(lit(json::object())));
  CHECK(describes(lit({{"extras", {{"openltc_light", {{"type", "rect"}}}}}}))); // no size
  CHECK(describes(lit({{"extras", {{"openltc_light", "{broken"}}}})));
  CHECK(describes(lit({{"extensions", {{"ACME_lights_laser", {{"light", 0}}}}}}))); // unknown
  const json point = {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}}}}}}};
  const json reference = {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
  CHECK(describes(lit(reference, point)));
  CHECK(!describes(lit(json::object(), point))); // defined, but nowhere in the scene
  GltfBuilder environment = lit(json::object());
  environment.root["scenes"][0]["extensions"]["EXT_lights_image_based"] = {{"light", 0}};
  CHECK(describes(environment));

  GltfBuilder glowing = lit(json::object());
  glowing.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  glowing.root["meshes"][0]["primitives"][0]["material"] = 0;
  CHECK(!describes(glowing)); // a plain factor
  json& strength = glowing.root["materials"][0]["extensions"]["KHR_materials_emissive_strength"];
  strength["emissiveStrength"] = 0.5;
  CHECK(describes(glowing));
  strength["emissiveStrength"] = 0;
  CHECK(!describes(glowing)); // says that it is dark
}

} // namespace
