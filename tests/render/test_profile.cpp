// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Point and spot lights with a measured profile, rendered.

#include "openltc/light/photometry/ies.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

using namespace openltc;

namespace {

constexpr double k_pi = std::numbers::pi;

// Four quarters that all differ, so that a mirrored or turned profile shows.
constexpr const char* k_lopsided = "IESNA:LM-63-2002\n"
                                   "TILT=NONE\n"
                                   "1 -1 1 4 5 1 2 0 0 0\n"
                                   "1 1 10\n"
                                   "0 30 60 90\n"
                                   "0 90 180 270 360\n"
                                   "500 400 300 0\n"
                                   "500 800 600 0\n"
                                   "500 200 150 0\n"
                                   "500 700 100 0\n"
                                   "500 400 300 0\n";

std::shared_ptr<const light::IesProfile> lopsided() {
  const auto profile = light::parse_ies(k_lopsided, "lopsided.ies");
  REQUIRE(profile.ok());
  return std::make_shared<light::IesProfile>(*profile);
}

// Radiance of the floor's point (x, z), albedo 0.5.
double floor_radiance(const light::PunctualLight& light, double x, double z,
                      render::Integrator integrator) {
  scene::Scene scene;
  test::add_floor(scene, 20, 0, test::diffuse_material({0.5f, 0.5f, 0.5f}));
  scene.lights.punctual.push_back(light);
  render::RenderOptions options;
  options.width = options.height = 9;
  options.samples = 1;
  options.integrator = integrator;
  const Vec3f target(float(x), 0, float(z));
  auto picture = render::render(scene, test::look_at(target + Vec3f(0.5f, 3, 0.5f), target, 1e-3f),
                                table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return double(picture->radiance.pixel(4, 4)[0]);
}

} // namespace

TEST_CASE("a floor under a luminaire has the illuminance of its profile") {
  const auto profile = lopsided();
  const double height = 2;
  light::PunctualLight light;
  light.profile = profile;
  light.position = {0, float(height), 0};
  light.direction = {0, -1, 0};
  light.right = {1, 0, 0};
  light.intensity = Vec3f(float(profile->max_candela));
  CHECK(profile->max_candela == 800);
  for (const render::Integrator integrator :
       {render::Integrator::ltc, render::Integrator::reference})
    for (const Vec2d& point : {Vec2d(0.3, 0.1), Vec2d(1, 1), Vec2d(1, -1), Vec2d(-2, 0.5),
                               Vec2d(-0.4, -2.2), Vec2d(0, 3), Vec2d(0, -3)}) {
      const double x = point.x, z = point.y;
      CAPTURE(x);
      CAPTURE(z);
      // Seen from above, counter-clockwise from +x is towards -z.
      const double vertical = std::atan2(std::hypot(x, z), height);
      const double candela = light::eval_candela(*profile, vertical, std::atan2(-z, x));
      const double distance2 = x * x + z * z + height * height;
      const double lux = candela * std::cos(vertical) / distance2;
      CHECK(floor_radiance(light, x, z, integrator) ==
            doctest::Approx(0.5 * lux / k_pi).epsilon(1e-3));
    }
}

TEST_CASE("a profile turns with its light and is cut by a spot's cone") {
  const auto profile = lopsided();
  light::PunctualLight light;
  light.type = light::PunctualType::spot;
  light.profile = profile;
  light.position = {0, 2, 0};
  // Tilted by 30 degrees towards +x; horizontal angle 0 is towards +z.
  light.direction = {0.5f, -float(std::sqrt(0.75)), 0};
  light.right = {0, 0, 1};
  light.cos_inner = 0.9f;
  light.cos_outer = 0.8f;
  light.intensity = Vec3f(1000.0f);
  const auto expected = [&](double vertical, double horizontal, double cos_floor,
                            double distance2) {
    return 0.5 / k_pi * cos_floor / distance2 * 1000 *
           light::eval_candela(*profile, vertical, horizontal) / 800;
  };
  const auto seen = [&](double x, double z) {
    return floor_radiance(light, x, z, render::Integrator::ltc);
  };
  // On the axis; the profile is 500 of 800 there.
  CHECK(seen(2 / std::sqrt(3.0), 0) ==
        doctest::Approx(expected(0, 0, std::sqrt(0.75), 4 / 0.75)).epsilon(1e-3));
  // 20 degrees off, towards the floor's point below and so against the tilt, in the plane z = 0.
  // Up is -direction; counter-clockwise about it from +z comes +x's side: angle 90.
  const double off = 20 * k_pi / 180, below = k_pi / 6 - off;
  CHECK(seen(2 * std::tan(below), 0) ==
        doctest::Approx(
            expected(off, 1.5 * k_pi, std::cos(below), 4 / (std::cos(below) * std::cos(below))))
            .epsilon(1e-3));
  // Straight below is outside half the cone: 30 degrees, cosine 0.866.
  const double ramp = (std::sqrt(0.75) - 0.8) / 0.1;
  CHECK(seen(0, 0) ==
        doctest::Approx(ramp * ramp * expected(k_pi / 6, 1.5 * k_pi, 1, 4)).epsilon(1e-3));
  CHECK(seen(-1.2, 0) == 0);
}

TEST_CASE("a profile without a usable axis is left out with a word") {
  scene::Scene scene;
  light::PunctualLight light;
  light.name = "lamp";
  light.profile = lopsided();
  light.right = light.direction;
  scene.lights.punctual.push_back(light);
  const render::LightSet set = render::pack_lights(scene.lights);
  CHECK(set.punctual.empty());
  REQUIRE(set.warnings.size() == 1);
  CHECK(set.warnings[0].find("\"lamp\"") != std::string::npos);
}

TEST_CASE("packed lights keep their profiles alive") {
  render::LightSet set;
  {
    scene::Scene scene;
    light::PunctualLight light;
    light.profile = lopsided();
    scene.lights.punctual.push_back(light);
    set = render::pack_lights(scene.lights);
  }
  REQUIRE(set.punctual.size() == 1);
  CHECK(set.profiles.at(0).use_count() == 1);
  CHECK(set.punctual[0].profile.values == set.profiles[0]->grid.data());
}

TEST_CASE("a floor under a floodlight and a headlamp has the illuminance of their own angles") {
  // Plain bilinear tables: the same corners as V and H, of type B and of type A.
  for (const int type : {2, 3}) {
    const std::string text = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 3 " + std::to_string(type) +
                             " 2 0 0 0\n1 1 10\n-90 0 90\n-90 0 90\n"
                             "0 300 0\n0 1000 400\n0 600 0\n";
    const auto parsed = light::parse_ies(text, "flood.ies");
    REQUIRE(parsed.ok());
    light::PunctualLight light;
    light.profile = std::make_shared<light::IesProfile>(*parsed);
    light.position = {0, 2, 0};
    light.direction = {0, -1, 0};
    light.right = {1, 0, 0}; // V > 0 towards +x; H > 0, clockwise seen from there, towards +z
    light.intensity = Vec3f(1000.0f);
    for (const Vec2d& point :
         {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1), Vec2d(0, -1), Vec2d(1, 2), Vec2d(0.7, -1.5)}) {
      const double x = point.x, z = point.y;
      CAPTURE(type);
      CAPTURE(x);
      CAPTURE(z);
      // B: V in the plane across y, H out of it; A: the other way around.
      const double v = type == 2 ? std::atan2(x, 2) : std::atan2(x, std::hypot(z, 2));
      const double h = type == 2 ? std::atan2(z, std::hypot(x, 2)) : std::atan2(z, 2);
      const double a = 2 * v / k_pi, b = std::abs(2 * h / k_pi); // x >= 0
      const double side = h < 0 ? 300 : 600;
      const double candela = (1 - a) * ((1 - b) * 1000 + b * side) + a * (1 - b) * 400;
      const double distance2 = x * x + z * z + 4;
      const double lux = candela * 2 / std::sqrt(distance2) / distance2;
      for (const render::Integrator integrator :
           {render::Integrator::ltc, render::Integrator::reference})
        CHECK(floor_radiance(light, x, z, integrator) ==
              doctest::Approx(0.5 * lux / k_pi).epsilon(1e-3));
    }
  }
}
