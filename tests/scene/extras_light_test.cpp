// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Lights that nodes describe in their extras: every shape, every unit, and every way to be wrong.

#include "gltf_builder.h"
#include "openltc/image/file.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::test;

constexpr double k_pi = std::numbers::pi;
const json k_quarter_turn_about_x = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}; // -z goes to -y

bool is_near(Vec3f a, Vec3f b, float tolerance = 1e-5f) { return length(a - b) < tolerance; }

Result<scene::Scene> load_extras(const json& extras, json node = json::object(),
                                 const std::string& base_dir = "") {
  GltfBuilder file;
  node["extras"] = extras;
  if (!node.contains("name")) node["name"] = "Lamp";
  file.root["scenes"][0]["nodes"].push_back(file.add("nodes", node));
  const std::string text = file.to_text();
  return scene::load_gltf_memory({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                                 "test.gltf", base_dir);
}

Result<scene::Scene> load_light(const json& light, const json& node = json::object(),
                                const std::string& base_dir = "") {
  return load_extras({{"openltc_light", light}}, node, base_dir);
}

json with(json light, const json& more) {
  light.update(more);
  return light;
}

// Of the one light in the scene.
template <class Visit> void visit_only(const scene::Scene& scene, const Visit& visit) {
  for ([[maybe_unused]] const std::string& warning : scene.warnings)
    if (warning.find("nothing to see") == std::string::npos) MESSAGE("warning: " << warning);
  REQUIRE(scene.lights.area_light_count() == 1);
  scene.lights.for_each_area_light([&](const auto& light) {
    const Status status = light::validate(light);
    CHECK_MESSAGE(status.ok(), (status.ok() ? "" : status.error().message));
    visit(light);
  });
}

double flux_of(const json& light, const json& node = json::object()) {
  const auto loaded = load_light(light, node);
  REQUIRE(loaded.ok());
  double flux = 0;
  visit_only(*loaded, [&](const auto& l) { flux = double(light::flux_lumens(l).x); });
  return flux;
}

const json k_shapes[] = {
    {{"type", "rect"}, {"width", 2}, {"height", 0.5}},
    {{"type", "disk"}, {"radius", 0.4}},
    {{"type", "ellipse"}, {"radius_x", 0.4}, {"radius_y", 1}},
    {{"type", "polygon"}, {"points", {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}}},
    {{"type", "sphere"}, {"radius", 0.2}},
    {{"type", "tube"}, {"length", 1.2}, {"radius", 0.02}},
    {{"type", "tube"}, {"length", 1.2}, {"radius", 0.3}, {"caps", "flat"}},
    {{"type", "tube"}, {"length", 1.2}, {"radius", 0.3}, {"caps", "none"}},
};

TEST_CASE("every_shape_is_read_with_its_place_size_and_side") {
  const json node = {
      {"translation", {1, 2, 3}}, {"rotation", k_quarter_turn_about_x}, {"scale", {0.5, -2, 1}}};
  const json bright = {{"luminance_nits", 700}, {"color", {1, 0.5, 0}}};
  const auto load = [&](const json& shape) {
    auto loaded = load_light(with(shape, bright), node);
    REQUIRE(loaded.ok());
    return loaded;
  };
  const auto rect = load(k_shapes[0]);
  const light::PolygonLight& r = rect->lights.polygons.at(0);
  CHECK(light::area(r) == doctest::Approx(2 * 0.5 * 4)); // twice as large by the scale
  CHECK(is_near(r.normal, Vec3f(0, -1, 0)));
  CHECK(is_near(r.radiance, Vec3f(700, 350, 0)));
  CHECK(r.name == "Lamp");
  for (const Vec3f v : r.vertices) {
    CHECK(v.x - 1 == doctest::Approx(v.x > 1 ? 2 : -2));
    CHECK(v.z - 3 == doctest::Approx(v.z > 3 ? 0.5 : -0.5));
  }
  const auto ellipse = load(k_shapes[2]);
  const light::EllipseLight& e = ellipse->lights.ellipses.at(0);
  CHECK(length(e.half_u) == doctest::Approx(0.8));
  CHECK(length(e.half_v) == doctest::Approx(2));
  CHECK(is_near(normalize(cross(e.half_u, e.half_v)), Vec3f(0, -1, 0)));
  const auto polygon = load(k_shapes[3]);
  const light::PolygonLight& p = polygon->lights.polygons.at(0);
  CHECK(light::area(p) == doctest::Approx(4 * 1.0));
  CHECK(is_near(p.normal, Vec3f(0, -1, 0)));
  const auto sphere = load(k_shapes[4]);
  CHECK(is_near(sphere->lights.spheres.at(0).center, Vec3f(1, 2, 3)));
  CHECK(double(sphere->lights.spheres[0].radius) == doctest::Approx(0.4));
  const auto tube = load(k_shapes[6]);
  const light::TubeLight& t = tube->lights.tubes.at(0);
  CHECK(is_near(t.to - t.from, Vec3f(-2.4f, 0, 0)) != is_near(t.to - t.from, Vec3f(2.4f, 0, 0)));
  CHECK(is_near((t.to + t.from) * 0.5f, Vec3f(1, 2, 3)));
  CHECK(double(t.radius) == doctest::Approx(0.6));
  CHECK(t.caps == light::TubeCaps::flat);
}

TEST_CASE("the_same_flux_comes_out_however_brightness_is_said") {
  for (const json& shape : k_shapes)
    for (const double power : {0.0, 3.0}) {
      CAPTURE(shape.dump());
      const json base = with(shape, {{"cosine_power", power}});
      const json node = {{"scale", {3, 3, 3}}};
      CHECK(flux_of(with(base, {{"flux_lumens", 800}}), node) == doctest::Approx(800));
      CHECK(flux_of(with(base, {{"flux_lumens", 100}, {"exposure", 3}})) == doctest::Approx(800));
    }
  // Flat lights: intensity I = L A, flux pi I.
  for (const std::size_t flat : {0u, 1u, 2u, 3u}) {
    const json shape = with(k_shapes[flat], {{"intensity_candela", 50}});
    CHECK(flux_of(shape) == doctest::Approx(50 * k_pi));
    CHECK(flux_of(with(shape, {{"two_sided", true}})) == doctest::Approx(100 * k_pi));
    CHECK(flux_of(with(shape, {{"cosine_power", 2}})) == doctest::Approx(50 * k_pi / 2));
  }
  // A sphere is alike from all sides, whatever its emission.
  for (const double power : {0.0, 1.0, 5.0})
    CHECK(flux_of(with(k_shapes[4], {{"intensity_candela", 50}, {"cosine_power", power}})) ==
          doctest::Approx(200 * k_pi));
  CHECK(flux_of({{"type", "line"}, {"length", 2}, {"intensity_candela", 7}}) ==
        doctest::Approx(7 * k_pi * k_pi));
  CHECK(flux_of({{"type", "line"}, {"length", 2}, {"flux_lumens", 7}}) == doctest::Approx(7));
}

// Against quadrature over the half of the tube that a view across its axis sees.
TEST_CASE("the_intensity_of_tubes_is_that_seen_across") {
  for (const double power : {0.0, 1.0, 4.0})
    for (const char* caps : {"none", "flat", "round"}) {
      const double r = 0.3, l = 1.2;
      double seen = 0; // intensity at 1 nit
      const int n = 400;
      for (int i = 0; i < n; ++i) {
        const double t = (i + 0.5) / n * k_pi - k_pi / 2;
        seen += r * l * std::pow(std::cos(t), power + 1) * k_pi / n;
      }
      if (std::string(caps) == "round")
        for (int i = 0; i < n; ++i) { // rings of a sphere about the view
          const double t = (i + 0.5) / n * k_pi / 2;
          seen += 2 * k_pi * r * r * std::sin(t) * std::pow(std::cos(t), power + 1) * k_pi / 2 / n;
        }
      const auto loaded = load_light({{"type", "tube"},
                                      {"length", l},
                                      {"radius", r},
                                      {"caps", caps},
                                      {"cosine_power", power},
                                      {"intensity_candela", 10}});
      REQUIRE(loaded.ok());
      CHECK(double(loaded->lights.tubes.at(0).radiance.x) * seen ==
            doctest::Approx(10).epsilon(1e-4));
    }
}

TEST_CASE("holes_are_cut_out_and_drawn_either_way_round") {
  const json outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}; // closed by repeating the first
  json hole = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (int i = 0; i < 2; ++i) {
    const auto loaded = load_light({{"type", "polygon"},
                                    {"points", outer},
                                    {"holes", {hole, {2.5, 2.5, 3, 2.5, 3, 3}}},
                                    {"luminance_nits", 1}});
    REQUIRE(loaded.ok());
    visit_only(*loaded, [](const auto&) {});
    CHECK(light::area(loaded->lights.polygons.at(0)) == doctest::Approx(16 - 1 - 0.125));
    std::reverse(hole.begin(), hole.end());
  }
}

TEST_CASE("lights_without_extent_have_the_intensity_of_their_flux") {
  const auto load = [](const json& light) {
    const auto loaded = load_light(light);
    REQUIRE(loaded.ok());
    REQUIRE(loaded->lights.punctual.size() == 1);
    CHECK(light::validate(loaded->lights.punctual[0]).ok());
    return loaded->lights.punctual[0];
  };
  CHECK(double(load({{"type", "point"}, {"flux_lumens", 800}, {"range", 4}}).intensity.x) ==
        doctest::Approx(800 / (4 * k_pi)));
  CHECK(double(load({{"type", "directional"}, {"illuminance_lux", 9}}).intensity.x) == 9);
  const auto spot = load({{"type", "spot"},
                          {"flux_lumens", 100},
                          {"inner_cone_degrees", 20},
                          {"outer_cone_degrees", 60}});
  double flux = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double c = (i + 0.5) / n;
    const double ramp = std::clamp(
        (c - double(spot.cos_outer)) / double(spot.cos_inner - spot.cos_outer), 0.0, 1.0);
    flux += 2 * k_pi / n * ramp * ramp * double(spot.intensity.x);
  }
  CHECK(flux == doctest::Approx(100).epsilon(1e-3));
  CHECK(is_near(spot.direction, Vec3f(0, 0, -1)));
}

TEST_CASE("photometric_files_give_points_and_spots_their_distribution") {
  const std::string dir = std::string(OPENLTC_SOURCE_DIR) + "/tests/light/files";
  const json point = {{"type", "point"}, {"ies", "wall_washer.ies"}};
  const auto own = load_light(point, json::object(), dir);
  REQUIRE(own.ok());
  REQUIRE(own->lights.punctual.size() == 1);
  const light::PunctualLight& light = own->lights.punctual[0];
  REQUIRE(light.profile);
  CHECK(double(light.intensity.x) == doctest::Approx(light.profile->max_candela));
  CHECK(is_near(light.direction, Vec3f(0, 0, -1)));
  CHECK(is_near(light.right, Vec3f(1, 0, 0)));
  // The file's flux, said in lumens, gives the file's intensity.
  const auto same =
      load_light(with(point, {{"flux_lumens", light.profile->flux_lumens}}), json::object(), dir);
  REQUIRE(same.ok());
  REQUIRE(same->lights.punctual.size() == 1);
  CHECK(double(same->lights.punctual[0].intensity.x) ==
        doctest::Approx(light.profile->max_candela).epsilon(0.01));
  // A spot without a cone of its own is as wide as the file; with one it is cut.
  const json spot = with(point, {{"type", "spot"}});
  CHECK(load_light(spot, json::object(), dir)->lights.punctual[0].type ==
        light::PunctualType::point);
  CHECK(load_light(with(spot, {{"outer_cone_degrees", 30}}), json::object(), dir)
            ->lights.punctual[0]
            .type == light::PunctualType::spot);
  // What is wrong with the file is said, and the light left out.
  for (const char* const name : {"none.ies", "../ies_test.cpp", "not_there/x.ies"}) {
    const auto broken = load_light(with(point, {{"ies", name}}), json::object(), dir);
    REQUIRE(broken.ok());
    CHECK(broken->lights.punctual.empty());
    REQUIRE(!broken->warnings.empty());
    CHECK(broken->warnings[0].find("openltc_light.ies") != std::string::npos);
  }
}

TEST_CASE("a_custom_property_may_be_an_object_a_text_or_many_properties") {
  const json object = {{"type", "sphere"}, {"radius", 0.2}, {"luminance_nits", 4000}};
  for (const json& extras :
       {json{{"openltc_light", object}}, json{{"openltc_light", object.dump()}},
        json{{"openltc_light", "sphere"},
             {"openltc_radius", 0.2},
             {"openltc_luminance_nits", 4000},
             {"something_else", 5}}}) {
    const auto loaded = load_extras(extras);
    REQUIRE(loaded.ok());
    REQUIRE(loaded->lights.spheres.size() == 1);
    CHECK(double(loaded->lights.spheres[0].radius) == doctest::Approx(0.2));
    CHECK(loaded->lights.spheres[0].radiance.y == 4000.0f);
  }
  const auto stray = load_extras({{"openltc_radius", 0.2}});
  REQUIRE(stray.ok());
  CHECK(warns_about(*stray, "openltc_radius"));
}

TEST_CASE("what_cannot_be_understood_is_left_out_and_named") {
  const json sphere = {{"type", "sphere"}, {"radius", 0.2}, {"luminance_nits", 4000}};
  const json rect = {{"type", "rect"}, {"width", 1}, {"height", 1}, {"flux_lumens", 1}};
  const json square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const json polygon = {{"type", "polygon"}, {"points", square}, {"flux_lumens", 1}};
  const json spot = {{"type", "spot"}, {"flux_lumens", 1}};
  struct Case {
    json light;
    std::string property;
  };
  const Case cases[] = {
      {5, "openltc_light"},
      {"{\"type\": ", "openltc_light"},
      {json::object(), "openltc_light.type"},
      {"glow worm", "openltc_light.type"},
      {{{"type", 3}}, "openltc_light.type"},
      {{{"type", "sphere"}, {"luminance_nits", 1}}, "radius: is missing"},
      {with(sphere, {{"radius", 0}}), "openltc_light.radius"},
      {with(sphere, {{"radius", -1}}), "openltc_light.radius"},
      {with(sphere, {{"radius", "big"}}), "openltc_light.radius"},
      {with(sphere, {{"radius", 1e35}}), "openltc_light.radius"},
      {with(sphere, {{"radiuss", 1}}), "openltc_light.radiuss"},
      {with(sphere, {{"two_sided", true}}), "openltc_light.two_sided"},
      {with(sphere, {{"flux_lumens", 1}}), "openltc_light.flux_lumens"}, // twice
      {with(sphere, {{"luminance_nits", -1}}), "openltc_light.luminance_nits"},
      {with(sphere, {{"color", {1, 1}}}), "openltc_light.color"},
      {with(sphere, {{"color", {1, 1, -1}}}), "openltc_light.color"},
      {with(sphere, {{"cosine_power", -2}}), "openltc_light.cosine_power"},
      {with(sphere, {{"texture", "x.png"}}), "openltc_light.texture"},
      {with(sphere, {{"exposure", 1e6}}), "openltc_light"},
      {{{"type", "sphere"}, {"radius", 1}}, "luminance_nits: is missing"},
      {with(rect, {{"width", 0}}), "openltc_light.width"},
      {with(rect, {{"two_sided", "yes"}}), "openltc_light.two_sided"},
      {with(rect, {{"texture", 4}}), "openltc_light.texture"},
      {{{"type", "tube"}, {"length", 1}, {"radius", 1}, {"flux_lumens", 1}, {"caps", "ball"}},
       "openltc_light.caps"},
      {{{"type", "line"}, {"length", 1}, {"luminance_nits", 1}}, "openltc_light.luminance_nits"},
      {with(polygon, {{"points", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}}),
       "points: the outline crosses"},
      {with(polygon, {{"points", {{0, 0}, {1, 1}}}}), "openltc_light.points"},
      {with(polygon, {{"points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}}}}), "not planar"},
      {with(polygon, {{"points", {{0, 0}, {1, 0}, {2, 0}}}}), "openltc_light.points"},
      {with(polygon, {{"points", {0, 0, 1}}}), "openltc_light.points"},
      {with(polygon, {{"points", "square"}}), "openltc_light.points"},
      {with(polygon, {{"holes", {{{5, 5}, {6, 5}, {5, 6}}}}}), "holes[0]"},
      {with(polygon, {{"holes", 5}}), "openltc_light.holes"},
      {with(spot, {{"outer_cone_degrees", 100}}), "openltc_light.outer_cone_degrees"},
      {with(spot, {{"inner_cone_degrees", 80}}), "openltc_light.inner_cone_degrees"},
      {with(spot, {{"luminance_nits", 80}}), "openltc_light.luminance_nits"},
      {{{"type", "directional"}, {"flux_lumens", 1}}, "openltc_light.flux_lumens"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.light.dump());
    const auto loaded = load_light(c.light);
    REQUIRE(loaded.ok());
    CHECK(loaded->lights.empty());
    CHECK(warns_about(*loaded, "nodes[0] \"Lamp\".extras.openltc_light"));
    CHECK(warns_about(*loaded, c.property));
    CHECK(warns_about(*loaded, "the light is left out"));
  }
  const auto flat = load_light(sphere, {{"scale", {0, 0, 0}}});
  REQUIRE(flat.ok());
  CHECK(flat->lights.empty());
  CHECK(warns_about(*flat, "radius"));
}

TEST_CASE("textures_lie_upright_on_the_emitting_side") {
  const image::test::TemporaryFolder folder;
  image::Image picture(4, 2, 3);
  picture.pixel(0, 0)[0] = 5; // the upper left corner
  REQUIRE(image::write_exr(folder.file("sign.exr"), std::vector<image::Layer>{{"", picture}}).ok());
  REQUIRE(image::write_hdr(folder.file("sign.hdr"), picture).ok());
  REQUIRE(image::write_png(folder.file("sign.png"), picture).ok());
  const std::string dir = folder.file("");
  const json rect = {{"type", "rect"}, {"width", 2}, {"height", 1}, {"luminance_nits", 10}};
  for (const char* name : {"sign.exr", "sign.hdr", "sign.png"}) {
    const auto loaded = load_light(with(rect, {{"texture", name}}), json::object(), dir);
    REQUIRE(loaded.ok());
    REQUIRE(loaded->lights.textures.size() == 1);
    CHECK(loaded->lights.textures[0].width == 4);
    const light::PolygonLight& light = loaded->lights.polygons.at(0);
    CHECK(light.texture == 0);
    // Seen from the emitting side, along +z with y up, x points to the left.
    CHECK(is_near(light.texture_corner, Vec3f(1, 0.5f, 0)));
    CHECK(is_near(light.texture_u, Vec3f(-2, 0, 0)));
    CHECK(is_near(light.texture_v, Vec3f(0, -1, 0)));
  }
  const auto disk =
      load_light({{"type", "disk"}, {"radius", 1}, {"luminance_nits", 1}, {"texture", "sign.exr"}},
                 {{"scale", {2, 2, 2}}}, dir);
  REQUIRE(disk.ok());
  CHECK(is_near(disk->lights.ellipses.at(0).texture_corner, Vec3f(2, 2, 0)));
  image::test::write_bytes(folder.file("broken.png"), {1, 2, 3});
  image::test::write_bytes(folder.file("sign.txt"), {1, 2, 3});
  for (const char* name :
       {"missing.png", "broken.png", "sign.txt", "/etc/passwd", "http://a/b.png"}) {
    const auto loaded = load_light(with(rect, {{"texture", name}}), json::object(), dir);
    REQUIRE(loaded.ok());
    CHECK(loaded->lights.empty());
    CHECK(loaded->lights.textures.empty());
    CHECK(warns_about(*loaded, "openltc_light.texture"));
  }
}

} // namespace
