// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Export: reading what was written gives the lights that there were, and all else is kept.

#include "gltf_builder.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/scene/gltf/export.h"
#include "tests/image/make_picture.h"
#include "tests/scene/emissive/round_meshes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::test;
using image::test::TemporaryFolder;

const json k_turned = {0.1826, 0.3651, 0.5477, 0.7303};

std::vector<std::uint8_t> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

json json_of(const std::string& glb) {
  const auto bytes = bytes_of(glb);
  REQUIRE(bytes.size() > 20);
  const std::size_t size = bytes[12] | bytes[13] << 8 | bytes[14] << 16;
  return json::parse(bytes.begin() + 20, bytes.begin() + 20 + std::ptrdiff_t(size));
}

int add_primitive(GltfBuilder& file, json primitive, const scene::Mesh& mesh) {
  std::vector<float> positions;
  std::vector<std::uint16_t> indices;
  for (const Vec3f p : mesh.positions)
    positions.insert(positions.end(), {p.x, p.y, p.z});
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      indices.push_back(std::uint16_t(v));
  primitive["attributes"]["POSITION"] = file.add_vec3(positions);
  primitive["indices"] = file.add_indices(indices);
  return file.add("meshes", {{"primitives", json::array({primitive})}});
}

bool same(Vec3f a, Vec3f b, double scale) { return double(length(a - b)) <= 2e-6 * scale; }

// Whether both scenes have the same lights in the same order, to rounding.
void check_same_lights(const light::Lights& a, const light::Lights& b) {
  const auto same_emission = [](const light::Emitter& p, const light::Emitter& q) {
    CHECK(p.name == q.name);
    CHECK(same(p.radiance, q.radiance, double(length(p.radiance))));
    CHECK(p.two_sided == q.two_sided);
    CHECK(p.surface_deviation == doctest::Approx(q.surface_deviation));
  };
  REQUIRE(a.polygons.size() == b.polygons.size());
  REQUIRE(a.ellipses.size() == b.ellipses.size());
  CHECK(a.spheres.size() == b.spheres.size());
  CHECK(a.tubes.size() == b.tubes.size());
  CHECK(a.punctual.size() == b.punctual.size());
  std::vector<bool> taken(b.polygons.size(), false);
  for (const light::PolygonLight& p : a.polygons) {
    bool found = false;
    for (std::size_t i = 0; i < b.polygons.size() && !found; ++i) {
      const light::PolygonLight& q = b.polygons[i];
      if (taken[i] || p.vertices.size() != q.vertices.size()) continue;
      bool equal = same(p.normal, q.normal, 1);
      for (std::size_t v = 0; v < p.vertices.size(); ++v)
        equal = equal && same(p.vertices[v], q.vertices[v], 1 + double(length(p.vertices[v])));
      if (!equal) continue;
      same_emission(p, q);
      found = taken[i] = true;
    }
    CHECK_MESSAGE(found, p.name);
  }
  for (std::size_t i = 0; i < a.ellipses.size(); ++i) {
    const light::EllipseLight &p = a.ellipses[i], &q = b.ellipses[i];
    same_emission(p, q);
    CHECK(same(p.center, q.center, 1 + double(length(p.center))));
    CHECK(light::area(p) == doctest::Approx(light::area(q)).epsilon(1e-5));
    CHECK(same(normalize(cross(p.half_u, p.half_v)), normalize(cross(q.half_u, q.half_v)), 1));
  }
}

// Rectangles of two sides as the two lights that they are written as.
light::Lights with_sides_apart(light::Lights lights) {
  for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
    if (!lights.polygons[i].two_sided || lights.polygons[i].vertices.size() != 4) continue;
    lights.polygons[i].two_sided = false;
    light::PolygonLight other = lights.polygons[i];
    const auto v = other.vertices;
    other.vertices = {v[1], v[0], v[3], v[2]};
    other.normal = -other.normal;
    lights.polygons.push_back(std::move(other));
  }
  return lights;
}

struct RoundTrip {
  scene::Scene before, after;
  scene::ExportReport report;
  json written;
};

RoundTrip round_trip(const std::string& input, bool recognise = false) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.glb");
  scene::EmissiveOptions options;
  options.recognise_shapes = recognise;
  const auto report = scene::export_area_lights(input, output, options);
  REQUIRE_MESSAGE(report.ok(), (report.ok() ? "" : report.error().message));
  const auto before = scene::load_gltf(input, options), after = scene::load_gltf(output, options);
  REQUIRE(before.ok());
  REQUIRE_MESSAGE(after.ok(), (after.ok() ? "" : after.error().message));
  CHECK(before->meshes.size() == after->meshes.size());
  CHECK(before->materials.size() == after->materials.size());
  CHECK(before->cameras.size() == after->cameras.size());
  for (std::size_t i = 0; i < before->meshes.size(); ++i) {
    const Vec3f a = before->materials[std::size_t(before->meshes[i].material)].emission,
                b = after->materials[std::size_t(after->meshes[i].material)].emission;
    CHECK(same(a, b, 0)); // the camera sees them glow as before
  }
  return {*before, *after, *report, json_of(output)};
}

RoundTrip round_trip(const GltfBuilder& file, bool recognise = false) {
  const TemporaryFolder folder;
  const std::string path = folder.file("in.glb");
  image::test::write_bytes(path, file.to_glb());
  return round_trip(path, recognise);
}

TEST_CASE("the_demo_scene_keeps_its_lights") {
  const RoundTrip trip = round_trip(OPENLTC_SOURCE_DIR "/scenes/demo.glb");
  check_same_lights(with_sides_apart(trip.before.lights), trip.after.lights);
  CHECK(trip.report.written == trip.written["extensions"]["EXT_lights_area"]["lights"].size());
  CHECK(trip.report.left.size() == 2); // a ring and an L
}

TEST_CASE("emissive_rectangles_and_disks_become_area_lights_wherever_their_nodes_stand") {
  const json nodes[] = {
      json::object(),
      {{"translation", {5, 6, 7}}, {"rotation", k_turned}, {"scale", {3, 3, 3}}},
      {{"scale", {2, 1, 1}}, {"translation", {1, 0, 0}}},                              // uneven
      {{"scale", {-1, 1, 1}}},                                                         // mirrored
      {{"translation", {5e5, -6e6, 7}}, {"rotation", k_turned}, {"scale", {3, 3, 3}}}, // far away
      {{"scale", {2, 1, 1}}, {"translation", {6e6, 0, -5e5}}},
  };
  for (const json& node : nodes) {
    CAPTURE(node.dump());
    GltfBuilder file;
    const int glow = file.add("materials", {{"emissiveFactor", {1, 0.5, 0.25}}});
    json primitive = file.square_primitive();
    primitive["material"] = glow;
    json named = node;
    named["name"] = "Panel";
    named["extras"] = {{"note", "kept"}};
    file.add_mesh_node(primitive, named);
    const bool is_round = !node.contains("scale") || node["scale"][0] == 3;
    if (is_round) {
      json disk = node;
      disk["name"] = "Disk";
      disk["mesh"] = add_primitive(file, {{"material", glow}}, disk_mesh(32));
      file.root["scenes"][0]["nodes"].push_back(file.add("nodes", disk));
    }
    const RoundTrip trip = round_trip(file, true);
    CHECK(trip.before.lights.area_light_count() == (is_round ? 2u : 1u));
    CHECK(trip.report.written == trip.before.lights.area_light_count());
    CHECK(trip.report.left.empty());
    CHECK(length(trip.before.origin - trip.after.origin) == 0);
    check_same_lights(trip.before.lights, trip.after.lights);
    const json& from = trip.written["nodes"][0];
    CHECK(from["extras"]["note"] == "kept");
    CHECK(from["extras"]["openltc_emits_light"] == false);
    CHECK(trip.written["extensionsUsed"].dump().find("EXT_lights_area") != std::string::npos);
  }
}

TEST_CASE("a_light_of_two_sides_becomes_two_and_gives_as_much") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["material"] =
      file.add("materials", {{"emissiveFactor", {1, 1, 1}}, {"doubleSided", true}});
  file.add_mesh_node(primitive);
  const RoundTrip trip = round_trip(file);
  REQUIRE(trip.before.lights.polygons.size() == 1);
  REQUIRE(trip.after.lights.polygons.size() == 2);
  const auto& sides = trip.after.lights.polygons;
  CHECK(same(sides[0].normal, -sides[1].normal, 1));
  CHECK(double(light::flux_lumens(sides[0]).x + light::flux_lumens(sides[1]).x) ==
        doctest::Approx(double(light::flux_lumens(trip.before.lights.polygons[0]).x)));
}

TEST_CASE("extras_become_area_lights_and_other_shapes_stay") {
  GltfBuilder file;
  const auto add = [&](const char* name, const json& light) {
    const int node = file.add("nodes", {{"name", name},
                                        {"translation", {1, 2, 3}},
                                        {"rotation", k_turned},
                                        {"scale", {2, 2, 2}},
                                        {"extras", {{"openltc_light", light}, {"note", 1}}}});
    file.root["scenes"][0]["nodes"].push_back(node);
  };
  add("Rect", {{"type", "rect"}, {"width", 2}, {"height", 1}, {"flux_lumens", 300}});
  add("Disk", json({{"type", "disk"}, {"radius", 2}, {"luminance_nits", 30}}).dump());
  add("Square",
      {{"type", "polygon"}, {"points", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {"luminance_nits", 5}});
  add("Bulb", {{"type", "sphere"}, {"radius", 2}, {"luminance_nits", 30}});
  add("Narrow", {{"type", "disk"}, {"radius", 2}, {"luminance_nits", 30}, {"cosine_power", 2}});
  add("Broken", {{"type", "sphere"}, {"radius", 0}});
  const RoundTrip trip = round_trip(file);
  check_same_lights(trip.before.lights, trip.after.lights);
  CHECK(trip.report.written == 3);
  REQUIRE(trip.report.left.size() == 2);
  CHECK(trip.report.left[0].find("\"Bulb\": a sphere") != std::string::npos);
  CHECK(trip.report.left[1].find("\"Narrow\"") != std::string::npos);
  CHECK(!trip.written["nodes"][0]["extras"].contains("openltc_light"));
  CHECK(trip.written["nodes"][0]["extras"]["note"] == 1);
  CHECK(trip.written["nodes"][3]["extras"].contains("openltc_light"));
}

TEST_CASE("a_node_with_one_light_that_cannot_be_said_goes_on_emitting") {
  GltfBuilder file;
  const int glow = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  const int mesh = add_primitive(file, {{"material", glow}},
                                 together(icosphere(2), disk_mesh(32), Vec3f(3, 0, 0)));
  file.root["scenes"][0]["nodes"].push_back(file.add("nodes", {{"mesh", mesh}, {"name", "Both"}}));
  const RoundTrip trip = round_trip(file, true);
  CHECK(trip.report.written == 0);
  CHECK(trip.report.left.size() == 1);
  check_same_lights(trip.before.lights, trip.after.lights);
  CHECK(!trip.written.contains("extensionsUsed"));
}

TEST_CASE("what_the_importer_does_not_read_is_carried_over") {
  GltfBuilder file;
  const int glow = file.add("materials", {{"emissiveFactor", {1, 1, 1}}, {"extras", {{"a", 0.1}}}});
  json primitive = file.square_primitive();
  primitive["material"] = glow;
  file.add_mesh_node(primitive);
  file.root["animations"] =
      json::array({{{"name", "spin"}, {"channels", json::array()}, {"samplers", json::array()}}});
  file.root["extensions"]["VENDOR_thing"] = {{"deep", {{"value", {1, 2.5, "x"}}}}};
  file.root["extras"] = "anything";
  file.use("VENDOR_thing");
  const RoundTrip trip = round_trip(file);
  CHECK(trip.written["animations"] == file.root["animations"]);
  CHECK(trip.written["extensions"]["VENDOR_thing"] == file.root["extensions"]["VENDOR_thing"]);
  CHECK(trip.written["extras"] == "anything");
  CHECK(trip.written["materials"] == file.root["materials"]);
  CHECK(trip.written["accessors"] == file.root["accessors"]);
  CHECK(trip.written["bufferViews"] == file.root["bufferViews"]);
}

TEST_CASE("buffers_and_pictures_beside_the_file_move_into_it") {
  const TemporaryFolder folder;
  GltfBuilder file;
  const int glow = file.add("materials", {{"emissiveFactor", {1, 1, 1}}});
  json primitive = file.square_primitive();
  primitive["material"] = glow;
  file.add_mesh_node(primitive);
  const int texture = file.add_texture(2, 2, std::vector<std::uint8_t>(16, 200));
  file.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = texture;
  const std::vector<std::uint8_t> head(file.buffer.begin(), file.buffer.begin() + 48);
  image::test::write_bytes(folder.file("a b.bin"), head);
  image::test::write_bytes(folder.file("picture.png"),
                           make_png(2, 2, std::vector<std::uint8_t>(16, 200)));
  file.root["images"][0]["uri"] = "picture.png";
  // The first view in a file of its own, with an escaped name, the others in a data URI.
  file.root["buffers"] =
      json::array({{{"byteLength", 48}, {"uri", "a%20b.bin"}},
                   {{"byteLength", file.buffer.size()},
                    {"uri", "data:application/octet-stream;base64," + base64(file.buffer)}}});
  for (std::size_t i = 1; i < file.root["bufferViews"].size(); ++i)
    file.root["bufferViews"][i]["buffer"] = 1;
  const std::string text = file.root.dump(), path = folder.file("in.gltf");
  image::test::write_bytes(path, std::vector<std::uint8_t>(text.begin(), text.end()));
  const RoundTrip trip = round_trip(path);
  CHECK(trip.report.written == 1);
  check_same_lights(trip.before.lights, trip.after.lights);
  CHECK(trip.written.dump().find("uri") == std::string::npos);
  CHECK(trip.before.textures.size() == 1);
  CHECK(trip.after.textures.at(0).image.to_image().data ==
        trip.before.textures[0].image.to_image().data);
  REQUIRE(trip.after.meshes.size() == 1);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(same(trip.before.meshes[0].positions[i], trip.after.meshes[0].positions[i], 0));
}

TEST_CASE("a_failed_export_names_the_file_and_leaves_the_old_one") {
  const TemporaryFolder folder;
  const std::string in = folder.file("in.glb"), out = folder.file("out.glb");
  image::test::write_bytes(in, {'g', 'l', 'T', 'F', 2});
  image::test::write_bytes(out, {1, 2, 3});
  const auto report = scene::export_area_lights(in, out);
  REQUIRE(!report.ok());
  CHECK(report.error().message.rfind(in + ": ", 0) == 0);
  CHECK(bytes_of(out).size() == 3);
  CHECK(
      !scene::export_area_lights(OPENLTC_SOURCE_DIR "/scenes/demo.glb", folder.file("no/where.glb"))
           .ok());
}

} // namespace
