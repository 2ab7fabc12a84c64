// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_builder.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::test;

bool is_near(Vec3f a, Vec3f b, float tolerance = 1e-5f) { return length(a - b) < tolerance; }

Result<scene::Scene> load_light(const char* extension, const json& light, const json& node) {
  GltfBuilder file;
  file.use(extension);
  file.root["extensions"][extension]["lights"] = json::array({light});
  json with_light = node;
  with_light["extensions"][extension]["light"] = 0;
  file.root["scenes"][0]["nodes"].push_back(file.add("nodes", with_light));
  return file.load();
}

const json k_quarter_turn_about_x = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}; // -z goes to -y

TEST_CASE("punctual_lights_stand_where_their_node_stands_unmoved_by_scale") {
  const auto loaded = load_light(
      "KHR_lights_punctual",
      {{"type", "spot"},
       {"name", "lamp"},
       {"color", {1, 0.5, 0.25}},
       {"intensity", 800},
       {"range", 12},
       {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}},
      {{"translation", {1, 2, 3}}, {"rotation", k_quarter_turn_about_x}, {"scale", {5, 6, 7}}});
  REQUIRE(loaded.ok());
  const light::PunctualLight& light = loaded->lights.punctual.at(0);
  CHECK(light.type == light::PunctualType::spot);
  CHECK(light.name == "lamp");
  CHECK(is_near(light.position, Vec3f(1, 2, 3)));
  CHECK(is_near(light.direction, Vec3f(0, -1, 0)));
  CHECK(is_near(light.intensity, Vec3f(800, 400, 200)));
  CHECK(light.range == 12.0f);
  CHECK(light.cos_inner == doctest::Approx(std::cos(0.2)));
  CHECK(light.cos_outer == doctest::Approx(std::cos(0.5)));
  CHECK(light::validate(light).ok());
}

TEST_CASE("punctual_lights_have_the_defaults_of_the_extension") {
  const auto point = load_light("KHR_lights_punctual", {{"type", "point"}}, json::object());
  REQUIRE(point.ok());
  CHECK(is_near(point->lights.punctual[0].intensity, Vec3f(1, 1, 1)));
  CHECK(point->lights.punctual[0].range == 0.0f);
  const auto spot = load_light("KHR_lights_punctual", {{"type", "spot"}, {"spot", json::object()}},
                               json::object());
  REQUIRE(spot.ok());
  CHECK(spot->lights.punctual[0].cos_inner == doctest::Approx(1.0f));
  CHECK(spot->lights.punctual[0].cos_outer == doctest::Approx(std::cos(std::numbers::pi / 4)));
  const auto sun = load_light("KHR_lights_punctual", {{"type", "directional"}}, json::object());
  REQUIRE(sun.ok());
  CHECK(is_near(sun->lights.punctual[0].direction, Vec3f(0, 0, -1)));
}

TEST_CASE("impossible_spot_cones_are_corrected_with_a_warning") {
  const auto loaded =
      load_light("KHR_lights_punctual",
                 {{"type", "spot"}, {"spot", {{"innerConeAngle", 2}, {"outerConeAngle", 0.5}}}},
                 json::object());
  REQUIRE(loaded.ok());
  CHECK(warns_about(*loaded, "KHR_lights_punctual.lights[0].spot"));
  CHECK(light::validate(loaded->lights.punctual[0]).ok());
}

TEST_CASE("area_rectangles_have_size_aspect_and_the_largest_scale") {
  const auto loaded = load_light(
      "EXT_lights_area",
      {{"type", "rect"}, {"color", {1, 1, 0.5}}, {"size", 2}, {"rect", {{"aspect", 1.5}}}},
      {{"translation", {0, 4, 0}}, {"rotation", k_quarter_turn_about_x}, {"scale", {1, -2, 0.5}}});
  REQUIRE(loaded.ok());
  REQUIRE(loaded->lights.polygons.size() == 1);
  const light::PolygonLight& light = loaded->lights.polygons[0];
  CHECK(light::area(light) == doctest::Approx(4.0 * 6.0)); // height 2 x 2, width 1.5 times that
  CHECK(is_near(light.radiance, Vec3f(1000, 1000, 500)));  // the default 1000 nits
  CHECK(is_near(light.normal, Vec3f(0, -1, 0)));
  CHECK(!light.two_sided);
  for (const Vec3f v : light.vertices) {
    CHECK(v.y == doctest::Approx(4.0f));
    CHECK(std::abs(v.x) == doctest::Approx(3.0f));
    CHECK(std::abs(v.z) == doctest::Approx(2.0f));
  }
  CHECK(light::validate(light).ok());
  CHECK(loaded->meshes.empty()); // the camera does not see it
}

TEST_CASE("area_disks_are_exact_and_emit_along_minus_z") {
  const auto loaded =
      load_light("EXT_lights_area", {{"type", "disk"}, {"size", 3}, {"intensity", 50}},
                 {{"scale", {0.5, -2, 1}}, {"translation", {1, 2, 3}}});
  REQUIRE(loaded.ok());
  CHECK(loaded->lights.polygons.empty());
  const light::EllipseLight& light = loaded->lights.ellipses.at(0);
  CHECK(light::area(light) == doctest::Approx(std::numbers::pi * 9)); // the size is the diameter
  CHECK(length(light.half_u) == doctest::Approx(length(light.half_v)));
  CHECK(is_near(light.center, Vec3f(1, 2, 3)));
  CHECK(is_near(normalize(cross(light.half_u, light.half_v)), Vec3f(0, 0, -1)));
  CHECK(light.radiance.x == 50.0f);
  CHECK(!light.two_sided);
  CHECK(light::validate(light).ok());
  const auto plain = load_light("EXT_lights_area", {{"type", "disk"}}, json::object());
  CHECK(is_near(plain->lights.ellipses.at(0).radiance, Vec3f(1000)));
  CHECK(length(plain->lights.ellipses[0].half_u) == doctest::Approx(0.5));
}

TEST_CASE("area_lights_without_size_are_left_out_by_field_and_the_rest_renders") {
  const auto leaves_out = [](const json& light, const std::string& part,
                             const json& node = json::object()) {
    const auto loaded = load_light("EXT_lights_area", light, node);
    return loaded.ok() && loaded->lights.empty() && warns_about(*loaded, part) &&
           warns_about(*loaded, "the light is left out");
  };
  CHECK(leaves_out({{"type", "rect"}, {"size", 0}}, "EXT_lights_area.lights[0].size"));
  CHECK(leaves_out({{"type", "rect"}, {"size", -1}}, "EXT_lights_area.lights[0].size"));
  CHECK(leaves_out({{"type", "rect"}, {"rect", {{"aspect", 0}}}}, "rect.aspect"));
  CHECK(leaves_out({{"type", "disk"}, {"intensity", -5}}, "lights[0].intensity"));
  CHECK(leaves_out({{"type", "disk"}}, "lights[0].size", {{"scale", {0, 0, 0}}}));
  CHECK(leaves_out({{"type", "tube"}}, "lights[0].type"));
  CHECK(leaves_out(json::object(), "lights[0].type"));
}

Result<scene::Scene> load_camera(const json& camera, const json& node = json::object()) {
  GltfBuilder file;
  json with_camera = node;
  with_camera["camera"] = file.add("cameras", camera);
  file.root["scenes"][0]["nodes"].push_back(file.add("nodes", with_camera));
  return file.load();
}

TEST_CASE("perspective_cameras_keep_their_angle_and_an_orthonormal_frame") {
  const auto loaded = load_camera(
      {{"type", "perspective"},
       {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 1.5}}}},
      {{"translation", {0, 5, 0}}, {"rotation", k_quarter_turn_about_x}, {"scale", {2, 3, 4}}});
  REQUIRE(loaded.ok());
  const scene::Camera& camera = loaded->cameras.at(0);
  CHECK(camera.projection == scene::Projection::perspective);
  CHECK(camera.fov_y_rad == doctest::Approx(0.7f));
  CHECK(camera.aspect == doctest::Approx(1.5f));
  CHECK(camera.near == doctest::Approx(0.1f));
  CHECK(camera.far == doctest::Approx(50.0f));
  CHECK(is_near(camera.position, Vec3f(0, 5, 0)));
  CHECK(is_near(camera.forward, Vec3f(0, -1, 0)));
  CHECK(is_near(camera.up, Vec3f(0, 0, -1)));
  CHECK(is_near(camera.right, Vec3f(1, 0, 0)));
}

TEST_CASE("orthographic_cameras_span_twice_their_magnification") {
  const auto loaded =
      load_camera({{"type", "orthographic"},
                   {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}});
  REQUIRE(loaded.ok());
  CHECK(loaded->cameras.at(0).projection == scene::Projection::orthographic);
  CHECK(loaded->cameras[0].height == 4.0f);
  CHECK(loaded->cameras[0].aspect == 1.5f);
}

TEST_CASE("cameras_that_give_no_picture_are_refused_by_field") {
  const auto perspective = [](const json& values) {
    return load_camera({{"type", "perspective"}, {"perspective", values}});
  };
  CHECK(fails_naming(perspective({{"yfov", 0}, {"znear", 0.1}}), "cameras[0].perspective.yfov"));
  CHECK(fails_naming(perspective({{"yfov", 3.2}, {"znear", 0.1}}), "cameras[0].perspective.yfov"));
  CHECK(fails_naming(perspective({{"yfov", 1}, {"znear", 2}, {"zfar", 1}}), "zfar"));
  CHECK(fails_naming(perspective({{"znear", 1}}), "cameras[0].perspective.yfov"));
  CHECK(fails_naming(
      load_camera({{"type", "orthographic"},
                   {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}}),
      "cameras[0].orthographic"));
}

} // namespace
