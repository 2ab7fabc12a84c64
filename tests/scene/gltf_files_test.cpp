// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The real and the broken files beside the repository.

#include "gltf_builder.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/scene/tangents.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace {

using namespace openltc;
using namespace openltc::test;

namespace fs = std::filesystem;

const fs::path k_shared = OPENLTC_SHARED_DIR;

// Whether a folder is there; says so when it is not.
bool is_there(const fs::path& folder) {
  if (fs::is_directory(folder)) return true;
  MESSAGE("skipped: " << folder.string() << " is not there");
  return false;
}

std::vector<fs::path> gltf_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// What scene.h promises.
void check_promises(const scene::Scene& scene) {
  REQUIRE(!scene.materials.empty());
  const auto check_ref = [&](const scene::TextureRef& ref) {
    REQUIRE(ref.texture < int(scene.textures.size()));
    REQUIRE((ref.tex_coord == 0 || ref.tex_coord == 1));
  };
  for (const auto& m : scene.materials) {
    check_ref(m.base_color_texture);
    check_ref(m.metallic_roughness_texture);
    check_ref(m.normal_texture);
    check_ref(m.emission_texture);
    check_ref(m.specular_texture);
    check_ref(m.specular_color_texture);
  }
  for (const auto& texture : scene.textures) {
    REQUIRE(!texture.image.empty());
    REQUIRE(texture.image.byte_count() >= texture.image.pixel_count());
  }
  for (const auto& mesh : scene.meshes) {
    REQUIRE((mesh.material >= 0 && mesh.material < int(scene.materials.size())));
    const std::size_t n = mesh.positions.size();
    REQUIRE(!mesh.triangles.empty());
    REQUIRE(mesh.normals.size() == n);
    const auto& material = scene.materials[std::size_t(mesh.material)];
    REQUIRE(mesh.tangents.size() == (material.normal_texture.texture >= 0 ? n : 0));
    for (const std::size_t size :
         {mesh.tex_coord_0.size(), mesh.tex_coord_1.size(), mesh.colors.size()})
      REQUIRE((size == 0 || size == n));
    for (const auto& t : mesh.triangles)
      for (const std::uint32_t c : t)
        REQUIRE(c < n);
    for (const Vec3f p : mesh.positions)
      REQUIRE((std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)));
    for (std::size_t i = 0; i < n; ++i) {
      REQUIRE(std::abs(length(mesh.normals[i]) - 1) < 1e-4f);
      if (mesh.tangents.empty()) continue;
      const Vec3f t(mesh.tangents[i].x, mesh.tangents[i].y, mesh.tangents[i].z);
      REQUIRE(std::abs(length(t) - 1) < 1e-4f);
      REQUIRE(std::abs(dot(t, mesh.normals[i])) < 1e-3f);
      REQUIRE(std::abs(mesh.tangents[i].w) == 1.0f);
    }
  }
  for (const auto& light : scene.lights.polygons)
    REQUIRE(light::validate(light).ok());
  for (const auto& light : scene.lights.punctual)
    REQUIRE(light::validate(light).ok());
}

TEST_CASE("real_files_load_as_the_scenes_that_they_are") {
  if (!is_there(k_shared / "scenes")) return;
  struct Expected {
    std::size_t meshes, triangles, polygon_lights, punctual_lights, cameras, warnings;
  };
  const std::map<std::string, Expected> expected = {
      {"AnisotropyDiscTest.glb", {12, 2788, 0, 0, 0, 1}},
      {"ClearCoatTest.glb", {27, 37116, 18, 0, 0, 1}},
      {"CornellBox.glb", {6, 36, 1, 0, 0, 0}},
      {"FlightHelmet.gltf", {6, 94722, 0, 0, 0, 0}},
      {"Lights.glb", {1, 12, 0, 4, 1, 0}},
      {"NormalTangentTest.glb", {1, 7774, 0, 0, 0, 0}},
      {"SpecularTest.glb", {24, 44828, 0, 0, 0, 0}},
      {"bunny.glb", {1, 5648, 0, 0, 0, 0}},
      {"geometry-camera-light.glb", {2, 14, 0, 2, 2, 0}},
      {"suzi.glb", {1, 14842, 0, 0, 0, 0}},
  };
  std::size_t found = 0;
  for (const fs::path& path : gltf_files(k_shared / "scenes")) {
    CAPTURE(path.string());
    const auto loaded = scene::load_gltf(path.string());
    if (!loaded.ok()) FAIL(loaded.error().message);
    check_promises(*loaded);
    const auto wanted = expected.find(path.filename().string());
    if (wanted == expected.end()) continue;
    ++found;
    std::size_t triangles = 0;
    for (const auto& mesh : loaded->meshes)
      triangles += mesh.triangles.size();
    CHECK(loaded->meshes.size() == wanted->second.meshes);
    CHECK(triangles == wanted->second.triangles);
    CHECK(loaded->lights.polygons.size() == wanted->second.polygon_lights);
    CHECK(loaded->lights.punctual.size() == wanted->second.punctual_lights);
    CHECK(loaded->cameras.size() == wanted->second.cameras);
    CHECK(loaded->warnings.size() == wanted->second.warnings);
  }
  CHECK(found == expected.size());
}

TEST_CASE("computed_tangents_agree_with_those_that_exporters_wrote") {
  if (!is_there(k_shared / "scenes")) return;
  for (const char* name : {"FlightHelmet/FlightHelmet.gltf", "ClearCoatTest.glb"}) {
    const auto loaded = scene::load_gltf((k_shared / "scenes" / name).string());
    REQUIRE(loaded.ok());
    std::size_t corners = 0, same_sign = 0;
    double cos_sum = 0;
    for (const scene::Mesh& mesh : loaded->meshes) {
      if (mesh.tangents.empty()) continue;
      scene::Mesh computed = mesh;
      scene::compute_tangents(computed, 0);
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          const Vec4f a = mesh.tangents[mesh.triangles[i][c]];
          const Vec4f b = computed.tangents[computed.triangles[i][c]];
          ++corners;
          same_sign += a.w == b.w;
          cos_sum += double(a.x * b.x + a.y * b.y + a.z * b.z);
        }
    }
    CHECK(double(same_sign) / double(corners) > 0.999);
    CHECK(cos_sum / double(corners) > 0.995);
  }
}

TEST_CASE("the_cornell_box_is_lit_by_its_lamp") {
  const fs::path path = k_shared / "scenes/CornellBox.glb";
  if (!is_there(k_shared / "scenes")) return;
  const auto loaded = scene::load_gltf(path.string());
  REQUIRE(loaded.ok());
  const light::PolygonLight& lamp = loaded->lights.polygons.at(0);
  CHECK(lamp.vertices.size() == 4);
  CHECK(light::area(lamp) == doctest::Approx(130.0 * 105.0).epsilon(1e-3)); // of the original box
  CHECK(lamp.radiance.x == doctest::Approx(100.0f));
  CHECK(std::abs(lamp.normal.y) == doctest::Approx(1.0f));
}

TEST_CASE("broken_files_give_one_line_or_a_scene_that_keeps_its_promises") {
  if (!is_there(k_shared / "malformed")) return;
  // The part of the message that names the field; an empty text: it can be loaded.
  const std::map<std::string, std::string> expected = {
      {"BoxBadNormals.glb", ""},
      {"BoxWithInfinites.glb", "meshes[0].primitives[0].attributes.POSITION"},
      {"Cube.gltf", "bufferViews[2].byteLength"},
      {"IndexOutOfRange.gltf", "meshes[0].primitives[0].indices"},
      {"AllIndicesOutOfRange.gltf", "meshes[0].primitives[0].indices"},
      {"BoxTextured.gltf", "buffers[0].uri"},
      {"RecursiveNodes.gltf", "nodes[0].children"},
      {"sceneWrongType.gltf", "scene"},
      {"NoScene.gltf", "scene"},
      {"SceneWithoutNodes.gltf", ""}, // valid, only empty
      {"texcoord_crash.gltf", ""},    // a texture without coordinates
      {"badArray.gltf", "meshes[0].primitives"},
      {"badExtension.gltf", "KHR_texture_transform"},
      {"badNumber.gltf", "materials[0].normalTexture"},
      {"badObject.gltf", "materials[0].pbrMetallicRoughness"},
      {"badString.gltf", "scenes[0].name"},
      {"badUint.gltf", "materials[0].pbrMetallicRoughness.baseColorTexture.index"},
  };
  std::set<std::string> seen;
  for (const fs::path& path : gltf_files(k_shared / "malformed")) {
    CAPTURE(path.string());
    const auto loaded = scene::load_gltf(path.string());
    if (loaded.ok()) {
      check_promises(*loaded);
    } else {
      CHECK(loaded.error().message.rfind(path.string() + ": ", 0) == 0);
      CHECK(loaded.error().message.find('\n') == std::string::npos);
    }
    const auto wanted = expected.find(path.filename().string());
    if (wanted == expected.end()) continue;
    seen.insert(wanted->first);
    CHECK(loaded.ok() == wanted->second.empty());
    if (loaded.ok()) CHECK(loaded->warnings.size() == 1);
    if (!loaded.ok()) CHECK(loaded.error().message.find(wanted->second) != std::string::npos);
  }
  CHECK(seen.size() == expected.size());
}

} // namespace
