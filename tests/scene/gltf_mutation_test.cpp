// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A short, repeatable fuzzing pass; tests/fuzz has the long one. Whatever is done to a file,
// loading it ends, without a crash, in a scene or in one line.

#include "gltf_samples.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/scene/gltf/export.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace {

using namespace openltc;
using namespace openltc::test;

using Bytes = std::vector<std::uint8_t>;

// OPENLTC_FUZZ_ROUNDS=100 makes the passes a hundred times as long.
int rounds(int usual) {
  const char* factor = std::getenv("OPENLTC_FUZZ_ROUNDS");
  return usual * (factor ? std::max(1, std::atoi(factor)) : 1);
}

Bytes flip_bytes(Bytes bytes, std::mt19937& random) {
  const std::size_t flips = 1 + random() % 8;
  for (std::size_t i = 0; i < flips && !bytes.empty(); ++i)
    bytes[random() % bytes.size()] = std::uint8_t(random());
  return bytes;
}

Bytes cut(Bytes bytes, std::mt19937& random) {
  const std::size_t begin = random() % (bytes.size() + 1);
  const std::size_t end = begin + random() % (bytes.size() - begin + 1);
  bytes.erase(bytes.begin() + std::ptrdiff_t(begin), bytes.begin() + std::ptrdiff_t(end));
  return bytes;
}

// All values inside a JSON document.
void collect(json& value, std::vector<json*>& all) {
  all.push_back(&value);
  if (value.is_structured())
    for (auto& child : value)
      collect(child, all);
}

json random_value(std::mt19937& random) {
  static const json values[] = {nullptr,
                                true,
                                -1,
                                0,
                                1,
                                2,
                                3,
                                7,
                                255,
                                65536,
                                2147483647,
                                4294967295u,
                                1e18,
                                -1e30,
                                1e-30,
                                0.5,
                                "",
                                "SCALAR",
                                "MAT4",
                                json::array(),
                                json::object(),
                                {0, 0, 0},
                                {1, 2, 3, 4},
                                5121,
                                5125,
                                5126,
                                1e300};
  return values[random() % std::size(values)];
}

void mutate_json(json& root, std::mt19937& random) {
  const std::size_t changes = 1 + random() % 3;
  for (std::size_t i = 0; i < changes; ++i) {
    std::vector<json*> all;
    for (auto& child : root)
      collect(child, all);
    json& target = *all[random() % all.size()];
    switch (random() % 4) {
    case 0:
      target = random_value(random);
      break;
    case 1: { // what stands elsewhere
      const json copy = *all[random() % all.size()];
      if (copy.dump().size() < 100000) target = copy;
      break;
    }
    case 2:
      if (target.is_object() && !target.empty()) target.erase(target.begin());
      if (target.is_array() && !target.empty()) target.push_back(target[0]);
      break;
    default:
      if (target.is_number()) target = target.get<double>() + double(int(random() % 5) - 2);
      break;
    }
  }
}

void check_ends_well(const Bytes& bytes) {
  scene::EmissiveOptions emissive;
  emissive.recognise_shapes = bytes.size() % 2 == 0; // both ways
  const auto loaded = scene::load_gltf_memory(bytes, "test.gltf", "", emissive);
  if (loaded.ok()) {
    loaded->lights.for_each_area_light(
        [](const auto& light) { REQUIRE(light::validate(light).ok()); });
    for (const std::string& warning : loaded->warnings)
      REQUIRE(warning.find('\n') == std::string::npos);
    for (const auto& mesh : loaded->meshes) {
      REQUIRE(mesh.normals.size() == mesh.positions.size());
      for (const auto& t : mesh.triangles)
        for (const std::uint32_t c : t)
          REQUIRE(c < mesh.positions.size());
    }
    return;
  }
  const std::string& message = loaded.error().message;
  REQUIRE(message.rfind("test.gltf: ", 0) == 0);
  REQUIRE(message.find('\n') == std::string::npos);
  REQUIRE(message.size() < 1000);
}

TEST_CASE("the_samples_themselves_load") {
  for (const GltfBuilder& sample : make_samples()) {
    const auto loaded = sample.load_glb();
    if (!loaded.ok()) FAIL(loaded.error().message);
  }
}

TEST_CASE("damaged_bytes_never_crash_the_importer") {
  std::mt19937 random(20240501);
  const auto samples = make_samples();
  for (int i = 0; i < rounds(1000); ++i) {
    const GltfBuilder& sample = samples[random() % samples.size()];
    Bytes bytes = sample.to_glb();
    if (random() % 3 == 0) {
      const std::string text = sample.to_text();
      bytes.assign(text.begin(), text.end());
    }
    bytes = random() % 3 == 0 ? cut(bytes, random) : flip_bytes(bytes, random);
    CAPTURE(i);
    check_ends_well(bytes);
  }
}

TEST_CASE("whatever_loads_can_be_exported_and_loads_again") {
  std::mt19937 random(20240503);
  const auto samples = make_samples();
  const image::test::TemporaryFolder folder;
  const std::string in = folder.file("in.glb"), out = folder.file("out.glb");
  for (int i = 0; i < rounds(300); ++i) {
    GltfBuilder sample = samples[random() % samples.size()];
    mutate_json(sample.root, random);
    CAPTURE(i);
    image::test::write_bytes(in, sample.to_glb());
    const bool loads = scene::load_gltf(in).ok();
    const auto report = scene::export_area_lights(in, out);
    REQUIRE(report.ok() == loads);
    if (!loads) continue;
    const auto again = scene::load_gltf(out);
    CHECK_MESSAGE(again.ok(), (again.ok() ? "" : again.error().message));
  }
}

TEST_CASE("damaged_structure_never_crashes_the_importer") {
  std::mt19937 random(20240502);
  const auto samples = make_samples();
  std::size_t loaded_count = 0;
  for (int i = 0; i < rounds(3000); ++i) {
    GltfBuilder sample = samples[random() % samples.size()];
    sample.root["buffers"] =
        json::array({{{"byteLength", sample.buffer.size()}},
                     {{"byteLength", 64},
                      {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
    mutate_json(sample.root, random);
    CAPTURE(i);
    const Bytes bytes = sample.to_glb();
    check_ends_well(bytes);
    if (i < 3000) loaded_count += load_bytes(bytes).ok();
  }
  CHECK(loaded_count > 100); // the mutations are not all refused at the door
}

} // namespace
