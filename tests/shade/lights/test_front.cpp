// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What lies behind the triangle's plane is hidden by it, whatever the shading normal says: lights
// of every shape, cut by a third plane, against quadrature over what is left of their surface.

#include "openltc/table/lobe_table.h"
#include "tests/shade/lights/light_fixture.h"
#include "tests/shade/lights/light_reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace openltc;
using testing::LightCase;
using testing::LightShape;
using testing::Random;

namespace {

// A surface in the number type of namespace `real`, with the integral of a case's light.
#define OPENLTC_CASE_FUNCTIONS(real, Vec, from)                                                    \
  real::Surface surface_of(const LightCase& light, Vec front) {                                    \
    const Vec normal = from(light.normal), wo = from(light.wo);                                    \
    const real::FittedLobe fitted = real::fetch_lobe_of_roughness(                                 \
        table::builtin_ggx_table().view(), light.roughness, dot(normal, wo));                      \
    real::Surface s =                                                                              \
        real::make_surface(fitted, from(light.position), normal, wo, Vec(light.albedo),            \
                           Vec(light.f0), Vec(1), light.roughness);                                \
    return real::set_geometric_normal(s, front);                                                   \
  }                                                                                                \
  real::LightIntegral integral_of(const LightCase& light, const real::Surface& s) {                \
    const Vec a = from(light.a), b = from(light.b), c = from(light.c);                             \
    const auto radius = real::Real(light.radius);                                                  \
    switch (light.shape) {                                                                         \
    case LightShape::rectangle:                                                                    \
    case LightShape::polygon:                                                                      \
      return real::surface_polygon_integral(s, light.polygon->view());                             \
    case LightShape::disk:                                                                         \
    case LightShape::ellipse:                                                                      \
      return real::surface_ellipse_integral(s, {a, b, c, light.two_sided ? 1.0f : 0.0f});          \
    case LightShape::sphere:                                                                       \
      return real::surface_sphere_integral(s, {a, radius});                                        \
    case LightShape::tube_open:                                                                    \
      return real::surface_tube_integral(s, {a, b, radius, 0});                                    \
    case LightShape::tube_flat:                                                                    \
      return real::surface_tube_integral(s, {a, b, radius, 1});                                    \
    case LightShape::capsule:                                                                      \
      return real::surface_tube_integral(s, {a, b, radius, 2});                                    \
    default:                                                                                       \
      return real::surface_line_integral(s, {a, b});                                               \
    }                                                                                              \
  }
namespace precise {
OPENLTC_CASE_FUNCTIONS(f64, Vec3d, to_double)
}
Vec3f same(Vec3f v) { return v; }
namespace single {
OPENLTC_CASE_FUNCTIONS(f32, Vec3f, same)
}

Vec3d center_of(const LightCase& light) {
  if (testing::is_polygon(light.shape)) return f64::polygon_centroid(light.polygon->view());
  const bool long_one = light.shape >= LightShape::tube_open;
  return long_one ? (to_double(light.a) + to_double(light.b)) * 0.5 : to_double(light.a);
}

// A triangle's normal on the viewer's side, up to 80 degrees off the shading normal. Of `through`,
// its plane passes near the light's middle.
Vec3d random_front(const LightCase& light, bool through, Random& random) {
  const Vec3d n = to_double(light.normal), wo = to_double(light.wo);
  for (;;) {
    Vec3d front = normalize(n + random.sphere() * random.uniform(0, 6));
    if (through) {
      const Vec3d to = normalize(center_of(light) - to_double(light.position));
      front = normalize(front - to * (dot(front, to) + random.uniform(-0.2, 0.2)));
    }
    if (dot(front, wo) > 0.02 && dot(front, n) > 0.17) return front;
  }
}

} // namespace

TEST_CASE("in front of a tilted triangle every shape has the light that quadrature finds there") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    Random random(1700 + std::uint64_t(k));
    double worst = 0, worst_single = 0;
    int cut = 0;
    for (int i = 0; i < 60; ++i) {
      LightCase light = testing::random_light(shape, random);
      light.roughness = std::max(light.roughness, 0.3f);
      const Vec3d front = random_front(light, i % 4 != 3, random);
      const f64::Surface s = precise::surface_of(light, front);
      const testing::CaseView view{s.position, s.frame, s.fitted.lobe};
      const f64::LightIntegral exact = precise::integral_of(light, s);
      const f32::LightIntegral fast =
          single::integral_of(light, single::surface_of(light, to_float(front)));
      const auto check = [&](const f64::Lobe& lobe, double precise, float single) {
        const double truth = testing::surface_integral(light, view, lobe, 1e-8, &front);
        const double whole = testing::surface_integral(light, view, lobe, 1e-6);
        // Per metre of diameter: relative for lines.
        const double scale = shape == LightShape::line ? std::max(whole, 1.0) : 1.0;
        CAPTURE(k);
        CAPTURE(i);
        CAPTURE(truth);
        CAPTURE(precise);
        CAPTURE(whole);
        CHECK(std::abs(precise - truth) / scale < 3e-6); // what the quadrature itself is held to
        CHECK(std::abs(double(single) - truth) / scale < 1e-5);
        worst = std::max(worst, std::abs(precise - truth) / scale);
        worst_single = std::max(worst_single, std::abs(double(single) - truth) / scale);
        cut += truth > 1e-3 && truth < 0.97 * whole;
      };
      check(f64::cosine_lobe(), exact.diffuse, fast.diffuse);
      check(view.lobe, exact.specular, fast.specular);
    }
    MESSAGE(std::string(testing::shape_name(shape)), ": double ", worst, ", single ", worst_single,
            "; ", cut, " of 120 cut");
    CHECK(cut > 15);
  }
}

TEST_CASE("wholly behind the triangle's plane a light of any shape gives exactly nothing") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    Random random(1800 + std::uint64_t(k));
    int lit = 0;
    for (int i = 0; i < 4000; ++i) {
      const LightCase light = i % 2 == 0 ? testing::random_light(shape, random)
                                         : testing::adversarial_light(shape, random);
      const Vec3d shading = to_double(light.normal), wo = to_double(light.wo);
      const Vec3d position = to_double(light.position);
      // The plane looks away from the light.
      const Vec3d away = position - center_of(light);
      if (!(length(away) > 0)) continue;
      const Vec3d front = normalize(normalize(away) + random.sphere() * random.uniform(0, 0.8));
      if (dot(front, wo) < 0 || dot(front, shading) > 0.9999) continue;
      const f32::Surface s = single::surface_of(light, to_float(front));
      const auto whole = single::integral_of(light, single::surface_of(light, light.normal));
      double highest = 0;
      const Vec3f f = to_float(front);
      const f32::Real caps = shape == LightShape::capsule ? 2.0f : 0.0f;
      if (testing::is_polygon(shape))
        highest = double(f32::polygon_heights(light.polygon->view(), s.position, f).high);
      else if (shape == LightShape::disk || shape == LightShape::ellipse)
        highest = double(f32::ellipse_heights({light.a, light.b, light.c, 0}, s.position, f).high);
      else if (shape == LightShape::sphere)
        highest = double(f32::sphere_heights({light.a, light.radius}, s.position, f).high);
      else if (shape == LightShape::line)
        highest = double(f32::line_heights({light.a, light.b}, s.position, f).high);
      else
        highest =
            double(f32::tube_heights({light.a, light.b, light.radius, caps}, s.position, f).high);
      if (highest > 0) continue;
      lit += whole.diffuse > 0 || whole.specular > 0;
      const f32::LightIntegral integral = single::integral_of(light, s);
      CHECK(integral.diffuse == 0);
      CHECK(integral.specular == 0);
    }
    MESSAGE(std::string(testing::shape_name(shape)), ": ", lit,
            " would be lit without the triangle");
    CHECK(lit > 30);
  }
}

TEST_CASE("as the triangle turns its plane through a light nothing steps") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    if (shape == LightShape::line) continue; // of no width: one that lies along the plane does step
    Random random(1900 + std::uint64_t(k));
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
      LightCase light = testing::random_light(shape, random);
      light.roughness = std::max(light.roughness, 0.3f);
      const Vec3d n = to_double(light.normal);
      const Vec3d sideways = normalize(cross(n, random.sphere()));
      const int steps = 2000;
      f32::LightIntegral before;
      for (int step = 0; step <= steps; ++step) {
        const double angle = 1.4 * step / steps;
        const Vec3f front = to_float(n * std::cos(angle) + sideways * std::sin(angle));
        const f32::LightIntegral now = single::integral_of(light, single::surface_of(light, front));
        if (step > 0) {
          // A plane turned by 7e-4 sweeps a lune of that solid angle times 2 at most; a lobe of
          // roughness 0.3 has a density of some 40.
          worst = std::max({worst, std::abs(double(now.diffuse - before.diffuse)),
                            std::abs(double(now.specular - before.specular)) / 10});
        }
        before = now;
      }
    }
    MESSAGE(std::string(testing::shape_name(shape)), ": largest change in a step ", worst);
    CHECK(worst < 1.5e-3);
  }
}
