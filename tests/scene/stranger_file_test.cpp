// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a file of a stranger may do: docs/security.md.

#include "gltf_builder.h"
#include "openltc/base/memory_budget.h"
#include "openltc/scene/gltf/export.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace openltc;
using namespace openltc::test;
using image::test::TemporaryFolder;
using image::test::write_bytes;
namespace fs = std::filesystem;

namespace {

// Sets a limit and takes it back.
struct Limit {
  explicit Limit(std::uint64_t bytes) : before(memory_budget().limit()) {
    memory_budget().set_limit(bytes);
  }
  ~Limit() { memory_budget().set_limit(before); }
  std::uint64_t before;
};

void write_text(const std::string& path, const std::string& text) {
  write_bytes(path, {text.begin(), text.end()});
}

// A scene in FOLDER/scene, and beside that folder what it must not see.
struct Folders {
  Folders() {
    fs::create_directories(folder.file("scene/inside"));
    fs::create_directories(folder.file("scene-other"));
    const auto png = make_png(1, 1, {255, 0, 0, 255});
    for (const char* path : {"secret.png", "scene/inside/own.png", "scene-other/secret.png"})
      write_bytes(folder.file(path), png);
    fs::create_symlink(folder.file("secret.png"), folder.file("scene/link.png"));
    fs::create_symlink(folder.file("scene/inside"), folder.file("scene/way_in"));
  }
  std::string write_scene(const GltfBuilder& file) const {
    write_text(folder.file("scene/scene.gltf"), file.to_text());
    return folder.file("scene/scene.gltf");
  }
  TemporaryFolder folder;
};

GltfBuilder pictured(const std::string& uri) {
  GltfBuilder file;
  const int texture = file.add("textures", {{"source", file.add("images", json{{"uri", uri}})}});
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add_mesh_node(primitive);
  return file;
}

TEST_CASE("nothing_outside_the_scenes_folder_is_read_unless_it_is_allowed") {
  const Folders folders;
  const auto texture_count = [&](const std::string& uri, bool allow) {
    const std::string path = folders.write_scene(pictured(uri));
    const auto loaded = scene::load_gltf(path, {}, {allow});
    if (!loaded.ok()) FAIL(loaded.error().message);
    if (loaded->textures.empty() && !allow) CHECK(warns_about(*loaded, "--allow-outside"));
    return loaded->textures.size();
  };
  for (const std::string& uri :
       {std::string("../secret.png"), std::string("inside/../../secret.png"),
        std::string("..\\secret.png"), std::string("%2E%2E/secret.png"), std::string("link.png"),
        std::string("../scene-other/secret.png"), folders.folder.file("secret.png"),
        std::string("way_in/../../../secret.png")}) {
    CAPTURE(uri);
    CHECK(texture_count(uri, false) == 0);
    // way_in leads to inside, whose parents are those of the folder itself.
    if (uri.rfind("way_in", 0) != 0) CHECK(texture_count(uri, true) == 1);
  }
  for (const char* uri : {"inside/own.png", "./inside/own.png", "way_in/own.png",
                          "inside/../inside/own.png", "../scene/inside/own.png"}) {
    CAPTURE(uri);
    CHECK(texture_count(uri, false) == 1);
  }
}

TEST_CASE("whether_a_file_outside_exists_is_not_told") {
  const Folders folders;
  const auto message = [&](const char* uri) {
    GltfBuilder file = pictured("inside/own.png");
    file.root["buffers"] = json::array({{{"uri", uri}, {"byteLength", 4}}});
    write_text(folders.folder.file("scene/scene.gltf"), file.root.dump());
    const auto loaded = scene::load_gltf(folders.folder.file("scene/scene.gltf"));
    REQUIRE(!loaded.ok());
    CHECK(loaded.error().message.find("--allow-outside") != std::string::npos);
    std::string text = loaded.error().message;
    return text.replace(text.find(uri), std::string(uri).size(), "");
  };
  CHECK(message("../secret.png") == message("../nothing.png"));
}

TEST_CASE("a_converted_scene_holds_no_file_from_outside") {
  const Folders folders;
  const std::string out = folders.folder.file("out.glb");
  const std::string marker = "the content of a secret";
  write_text(folders.folder.file("secret.txt"), marker);
  GltfBuilder file = pictured("inside/own.png");
  file.root["buffers"] =
      json::array({{{"byteLength", file.buffer.size()},
                    {"uri", "data:application/octet-stream;base64," + base64(file.buffer)}},
                   {{"uri", "../secret.txt"}, {"byteLength", marker.size()}}});
  const std::string path = folders.write_scene(file);
  CHECK(!scene::export_area_lights(path, out).ok());
  CHECK(!fs::exists(out));
  REQUIRE(scene::export_area_lights(path, out, {}, {true}).ok());
  std::ifstream allowed(out, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(allowed), {}};
  CHECK(bytes.find(marker) != std::string::npos);

  // A picture that is refused keeps its reference, and its bytes stay where they are.
  REQUIRE(scene::export_area_lights(folders.write_scene(pictured("../secret.png")), out).ok());
  std::ifstream refused(out, std::ios::binary);
  const std::string glb{std::istreambuf_iterator<char>(refused), {}};
  CHECK(glb.find("../secret.png") != std::string::npos);
  CHECK(glb.find("\x89PNG") == std::string::npos);
}

// --- memory ----------------------------------------------------------------------------------

TEST_CASE("memory_is_given_back_with_the_scene") {
  const std::uint64_t before = memory_budget().in_use();
  {
    GltfBuilder file;
    file.add_mesh_node(file.square_primitive());
    const auto loaded = file.load();
    REQUIRE(loaded.ok());
    CHECK(memory_budget().in_use() > before);
    const scene::Scene copy = *loaded;
    CHECK(copy.memory->bytes() == memory_budget().in_use() - before);
  }
  CHECK(memory_budget().in_use() == before);
}

TEST_CASE("a_file_is_read_once_and_as_far_as_it_is_asked_for") {
  const Folders folders;
  // A sparse file of 9 GiB, of which the first bytes are named 200 times by various spellings.
  const std::string big = folders.folder.file("scene/big.bin");
  write_bytes(big, std::vector<std::uint8_t>(64, 0));
  fs::resize_file(big, std::uint64_t(9) << 30);
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  const char* spellings[] = {"big.bin", "./big.bin", "inside/../big.bin", "%62ig.bin"};
  file.to_text();
  json buffers =
      json::array({{{"byteLength", file.buffer.size()},
                    {"uri", "data:application/octet-stream;base64," + base64(file.buffer)}}});
  for (int i = 0; i < 200; ++i)
    buffers.push_back({{"uri", spellings[i % 4]}, {"byteLength", 16000000}});
  file.root["buffers"] = buffers;
  write_text(folders.folder.file("scene/scene.gltf"), file.root.dump());
  const Limit limit(memory_budget().in_use() + (std::uint64_t(64) << 20));
  const auto loaded = scene::load_gltf(folders.folder.file("scene/scene.gltf"));
  if (!loaded.ok()) FAIL(loaded.error().message);
  const auto exported = scene::export_area_lights(folders.folder.file("scene/scene.gltf"),
                                                  folders.folder.file("out.glb"));
  if (!exported.ok()) FAIL(exported.error().message);
  CHECK(fs::file_size(folders.folder.file("out.glb")) < 20000000);
}

TEST_CASE("a_scene_file_beyond_4_gib_is_refused_by_its_size") {
  const TemporaryFolder folder;
  write_text(folder.file("big.glb"), "glTF");
  fs::resize_file(folder.file("big.glb"), std::uint64_t(9) << 30);
  const auto loaded = scene::load_gltf(folder.file("big.glb"));
  REQUIRE(!loaded.ok());
  CHECK(loaded.error().message.find("9 GiB") != std::string::npos);
}

TEST_CASE("a_buffer_beyond_the_budget_is_refused_with_the_limit_and_the_option") {
  const Folders folders;
  const std::string big = folders.folder.file("scene/big.bin");
  write_bytes(big, {0});
  fs::resize_file(big, std::uint64_t(1) << 30);
  GltfBuilder file;
  file.root["buffers"] =
      json::array({{{"uri", "big.bin"}, {"byteLength", std::uint64_t(1) << 30}}});
  write_text(folders.folder.file("scene/scene.gltf"), file.root.dump());
  const Limit limit(std::uint64_t(100) << 20);
  const auto loaded = scene::load_gltf(folders.folder.file("scene/scene.gltf"));
  REQUIRE(!loaded.ok());
  for (const char* part : {"buffers[0].uri", "big.bin", "asks for 1 GiB", "100 MiB", "--memory"}) {
    CAPTURE(part);
    CHECK(loaded.error().message.find(part) != std::string::npos);
  }
}

TEST_CASE("instances_count_before_they_are_made") {
  // 20,000 triangles of 12 bytes for the corners and 128 for the tree are 2.8 MB.
  constexpr int k_side = 100;
  std::vector<float> positions;
  std::vector<std::uint16_t> corners;
  for (int y = 0; y <= k_side; ++y)
    for (int x = 0; x <= k_side; ++x)
      positions.insert(positions.end(), {float(x), float(y), 0});
  for (int y = 0; y < k_side; ++y)
    for (int x = 0; x < k_side; ++x) {
      const int a = y * (k_side + 1) + x;
      for (const int corner : {a, a + 1, a + k_side + 1, a + 1, a + k_side + 2, a + k_side + 1})
        corners.push_back(std::uint16_t(corner));
    }
  GltfBuilder file;
  file.add_mesh_node({{"attributes", {{"POSITION", file.add_vec3(positions)}}},
                      {"indices", file.add_indices(corners)}});
  const auto with_nodes = [&](int count) {
    while (int(file.root["nodes"].size()) < count)
      file.root["scenes"][0]["nodes"].push_back(file.add("nodes", {{"mesh", 0}}));
    const Limit limit(memory_budget().in_use() + (std::uint64_t(100) << 20));
    return file.load_glb();
  };
  CHECK(with_nodes(20).ok());
  const auto refused = with_nodes(50);
  CHECK(fails_naming(refused, ".mesh: asks for"));
  CHECK(fails_naming(refused, "--memory"));
}

TEST_CASE("the_places_of_instances_count_before_they_are_made") {
  // An accessor without data is all zeros: 4 million places for a few bytes of text.
  GltfBuilder file;
  file.use("EXT_mesh_gpu_instancing", true);
  const int places =
      file.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1 << 22}});
  file.add_mesh_node(
      file.square_primitive(),
      {{"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}});
  const auto with_limit = [&](std::uint64_t mib) {
    const Limit limit(memory_budget().in_use() + (mib << 20));
    return file.load_glb();
  };
  CHECK(fails_naming(with_limit(40), "accessors")); // 12 bytes each are 48 MiB
  const auto refused = with_limit(100);
  CHECK(fails_naming(refused, "4194304 instances"));
  CHECK(fails_naming(refused, "--memory"));
}

TEST_CASE("what_a_draco_stream_says_it_holds_counts_before_it_is_decoded") {
  // Draco bitstream specification, sections 2.2 and 2.5: version 2.2, a triangular mesh,
  // sequential, no flags, 100 million triangles of 3 points as variable-length numbers, and no
  // more.
  std::vector<std::uint8_t> stream = {'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0};
  for (std::uint32_t count : {100000000u, 3u}) {
    for (; count > 127; count >>= 7)
      stream.push_back(std::uint8_t(count & 127) | 128);
    stream.push_back(std::uint8_t(count));
  }
  stream.resize(64);
  GltfBuilder file;
  file.use("KHR_draco_mesh_compression", true);
  json primitive = file.square_primitive();
  primitive["extensions"] = {{"KHR_draco_mesh_compression",
                              {{"bufferView", file.add_view(stream.data(), stream.size())},
                               {"attributes", {{"POSITION", 0}}}}}};
  file.add_mesh_node(primitive);
  const Limit limit(memory_budget().in_use() + (std::uint64_t(64) << 20));
  const auto refused = file.load_glb();
  CHECK(fails_naming(refused, "100000000 compressed triangles"));
  CHECK(fails_naming(refused, "--memory"));
}

TEST_CASE("samplers_and_images_of_one_picture_share_its_memory") {
  GltfBuilder file;
  const auto png = make_png(256, 256, std::vector<std::uint8_t>(256 * 256 * 4, 200));
  const int view = file.add_view(png.data(), png.size());
  json primitive = file.square_primitive();
  for (int i = 0; i < 50; ++i) {
    const int image = file.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    const int sampler = file.add("samplers", {{"wrapS", i % 2 ? 10497 : 33071}});
    const int texture = file.add("textures", {{"source", image}, {"sampler", sampler}});
    primitive["material"] =
        file.add("materials", {{"pbrMetallicRoughness",
                                {{"baseColorTexture", {{"index", texture}}},
                                 {"metallicRoughnessTexture", {{"index", texture}}}}}});
  }
  file.add_mesh_node(primitive);
  const auto loaded = file.load_glb();
  if (!loaded.ok()) FAIL(loaded.error().message);
  CHECK(loaded->textures.size() > 2);
  // 8-bit RGBA and its smaller copies as floats, of colours and of data: 4 + 2 * 16 / 3 bytes a
  // pixel.
  CHECK(loaded->memory->bytes() < 256 * 256 * 15 + 10000);
}

TEST_CASE("one_light_picture_by_many_spellings_is_read_once") {
  const Folders folders;
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  for (const char* uri : {"inside/own.png", "./inside/own.png", "inside/../inside/own.png",
                          "way_in/own.png", "inside//own.png"})
    file.root["scenes"][0]["nodes"].push_back(file.add("nodes", {{"extras",
                                                                  {{"openltc_light",
                                                                    {{"type", "rect"},
                                                                     {"width", 1},
                                                                     {"height", 1},
                                                                     {"luminance_nits", 10},
                                                                     {"texture", uri}}}}}}));
  const auto loaded = scene::load_gltf(folders.write_scene(file));
  REQUIRE(loaded.ok());
  CHECK(loaded->warnings.empty());
  CHECK(loaded->lights.polygons.size() == 5);
  CHECK(loaded->lights.textures.size() == 1);
}

// --- messages --------------------------------------------------------------------------------

TEST_CASE("names_in_messages_are_cut_and_on_one_line") {
  const std::string evil = "a\nopenltc render: all is well\x1b[31m" + std::string(100000, 'x');
  const auto check = [](const std::string& text) {
    CAPTURE(text.substr(0, 300));
    CHECK(text.size() < 600);
    for (const char c : text)
      REQUIRE(static_cast<unsigned char>(c) >= 32);
  };
  const auto error_of = [&](const char* pointer, const json& value) {
    GltfBuilder file = pictured("x.png");
    file.root[json::json_pointer(pointer)] = value;
    const auto loaded = file.load();
    REQUIRE(!loaded.ok());
    check(loaded.error().message);
  };
  error_of("/accessors/0/type", evil);
  error_of("/asset/version", evil);
  error_of("/extensionsRequired", {evil});
  error_of("/materials/0/alphaMode", evil);
  error_of("/meshes/0/primitives/0/attributes", {{"POSITION", 0}, {evil, 99}});
  error_of("/buffers", {{{"uri", evil}, {"byteLength", 9}}});
  error_of("/buffers", {{{"uri", "https://" + evil}, {"byteLength", 9}}});
  const std::string text =
      "{\"asset\": {\"version\": \"2.0\"}, \"" + std::string(100000, 'y') + "\n";
  const auto broken = load_bytes({text.begin(), text.end()});
  REQUIRE(!broken.ok());
  check(broken.error().message);

  GltfBuilder file = pictured(evil);
  file.root["nodes"][0]["name"] = evil;
  file.root["meshes"][0]["name"] = evil;
  file.root["extensionsUsed"] = {evil};
  file.root["nodes"][0]["extras"] = {{"openltc_light", {{"type", evil}}}, {"openltc_" + evil, 1}};
  file.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
  const TemporaryFolder folder;
  const std::string json_text = file.to_text();
  const auto loaded = scene::load_gltf_memory(
      std::vector<std::uint8_t>(json_text.begin(), json_text.end()), "test.gltf", folder.file(""));
  if (!loaded.ok()) FAIL(loaded.error().message.substr(0, 400));
  CHECK(loaded->warnings.size() >= 3);
  for (const std::string& warning : loaded->warnings)
    check(warning);
}

} // namespace
