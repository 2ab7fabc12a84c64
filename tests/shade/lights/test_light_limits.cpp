// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Promises of every light shape: nothing leaks from below the horizon, parts add up to the whole,
// and a light that shrinks becomes a point light.

#include "openltc/table/lobe_table.h"
#include "tests/shade/lights/light_fixture.h"
#include "tests/shade/lights/light_reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace openltc;
using testing::CaseAnswer;
using testing::LightCase;
using testing::LightShape;
using testing::Random;

namespace {

// Height of the light's highest point above the surface.
double highest(const LightCase& light) {
  const Vec3d n = to_double(light.normal), p = to_double(light.position);
  const Vec3d a = to_double(light.a), b = to_double(light.b), c = to_double(light.c);
  const double r = double(light.radius);
  switch (light.shape) {
  case LightShape::rectangle:
  case LightShape::polygon: {
    const PolygonView& view = light.polygon->view();
    double height = -1e30;
    for (int i = 0; i < view.point_count; ++i)
      height = std::max(height, dot(n, f64::polygon_point(view, i) - p));
    return height;
  }
  case LightShape::disk:
  case LightShape::ellipse:
    return dot(n, a - p) + std::hypot(dot(n, b), dot(n, c));
  case LightShape::sphere:
    return dot(n, a - p) + r;
  case LightShape::line:
    return std::max(dot(n, a - p), dot(n, b - p));
  default:
    return std::max(dot(n, a - p), dot(n, b - p)) + r;
  }
}

void lift(LightCase& light, double height) {
  light.position = to_float(to_double(light.position) + to_double(light.normal) * height);
}

double sum_of(Vec3f v) { return double(v.x) + double(v.y) + double(v.z); }

} // namespace

TEST_CASE("lights below the horizon give exactly nothing") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    Random random(500 + std::uint64_t(k));
    int lights = 0;
    for (int i = 0; i < 4000; ++i) {
      LightCase light = testing::random_light(shape, random);
      // From just below to far below.
      const double height = highest(light);
      lift(light, height * 1.00001 + random.log_uniform(1e-5, 10));
      if (!(highest(light) < 0)) continue;
      ++lights;
      for (const float roughness : {0.0f, 0.1f, 0.4f, 1.0f}) {
        light.roughness = roughness;
        const CaseAnswer answer = testing::evaluate(light);
        CAPTURE(std::string(testing::shape_name(shape)));
        CAPTURE(i);
        CAPTURE(roughness);
        CAPTURE(highest(light));
        CHECK(answer.diffuse == 0);
        CHECK(answer.specular == 0);
        CHECK(sum_of(answer.shaded) == 0);
      }
    }
    CHECK(lights > 3000);
  }
}

TEST_CASE("a solid cylinder is its lateral surface and its ends") {
  Random random(510);
  for (int i = 0; i < 2000; ++i) {
    LightCase solid = testing::random_light(LightShape::tube_flat, random);
    solid.roughness = std::max(solid.roughness, 0.1f);
    LightCase open = solid;
    open.shape = LightShape::tube_open;
    const Vec3d axis = normalize(to_double(solid.b) - to_double(solid.a));
    const f64::Frame f = f64::shading_frame(axis, axis);
    LightCase first = solid, last = solid;
    first.shape = last.shape = LightShape::disk;
    first.two_sided = last.two_sided = false;
    const double r = double(solid.radius);
    first.b = last.c = to_float(f.t2 * r);
    first.c = last.b = to_float(f.t1 * r);
    last.a = solid.b;
    const CaseAnswer whole = testing::evaluate(solid);
    double diffuse = 0, specular = 0;
    for (const LightCase& part : {open, first, last}) {
      diffuse += double(testing::evaluate(part).diffuse);
      specular += double(testing::evaluate(part).specular);
    }
    CAPTURE(i);
    CHECK(std::abs(double(whole.diffuse) - diffuse) < 3e-5);
    CHECK(std::abs(double(whole.specular) - specular) < 3e-4);
  }
}

TEST_CASE("tubes and lines cut in two add up") {
  for (const LightShape shape : {LightShape::tube_open, LightShape::line}) {
    Random random(511);
    for (int i = 0; i < 2000; ++i) {
      LightCase whole = testing::random_light(shape, random);
      whole.roughness = std::max(whole.roughness, 0.1f);
      LightCase first = whole, last = whole;
      const float t = float(random.uniform(0.1, 0.9));
      first.b = last.a = whole.a + (whole.b - whole.a) * t;
      const CaseAnswer w = testing::evaluate(whole), f = testing::evaluate(first),
                       l = testing::evaluate(last);
      CAPTURE(int(shape));
      CAPTURE(i);
      CHECK(std::abs(double(w.diffuse) - double(f.diffuse) - double(l.diffuse)) <
            3e-5 * std::max(1.0, double(w.diffuse)));
      CHECK(std::abs(double(w.specular) - double(f.specular) - double(l.specular)) <
            3e-4 * std::max(1.0, double(w.specular)));
    }
  }
}

TEST_CASE("a disk lies between the polygons inside and around it, and is their limit") {
  Random random(512);
  constexpr int corners = 128;
  const double outer = 1 / std::cos(f64::k_pi / corners);
  for (int i = 0; i < 1000; ++i) {
    LightCase disk = testing::random_light(LightShape::disk, random);
    disk.roughness = std::max(disk.roughness, 0.1f);
    const double radius = length(to_double(disk.b));
    const Vec3d u = to_double(disk.b) / radius, v = to_double(disk.c) / radius;
    double diffuse[2], specular[2];
    for (int k = 0; k < 2; ++k) {
      testing::Ring ring;
      for (int j = 0; j < corners; ++j) {
        const double phi = 2 * f64::k_pi * j / corners, r = radius * (k == 0 ? 1 : outer);
        ring.push_back(Vec2d(r * std::cos(phi), r * std::sin(phi)));
      }
      LightCase polygon = disk;
      polygon.shape = LightShape::polygon;
      polygon.polygon = std::make_shared<const testing::TestPolygon>(
          std::vector<testing::Ring>{ring}, to_double(disk.a), u, v, disk.two_sided);
      const CaseAnswer answer = testing::evaluate(polygon);
      diffuse[k] = double(answer.diffuse);
      specular[k] = double(answer.specular);
    }
    const CaseAnswer answer = testing::evaluate(disk);
    CAPTURE(i);
    CHECK(double(answer.diffuse) > diffuse[0] - 2e-5);
    CHECK(double(answer.diffuse) < diffuse[1] + 2e-5);
    CHECK(double(answer.specular) > specular[0] - 2e-4);
    CHECK(double(answer.specular) < specular[1] + 2e-4);
    CHECK(diffuse[1] - diffuse[0] < 3e-3);
  }
}

TEST_CASE("an ellipse does not mind which of its diameters are given, nor a line its direction") {
  Random random(513);
  for (int i = 0; i < 2000; ++i) {
    LightCase disk = testing::random_light(LightShape::disk, random), turned = disk;
    disk.roughness = turned.roughness = std::max(disk.roughness, 0.1f);
    const float phi = float(random.uniform(0, 6)), c = std::cos(phi), s = std::sin(phi);
    turned.b = disk.b * c + disk.c * s;
    turned.c = disk.c * c - disk.b * s;
    const CaseAnswer a = testing::evaluate(disk), b = testing::evaluate(turned);
    CHECK(std::abs(a.diffuse - b.diffuse) < 2e-5f);
    CHECK(std::abs(a.specular - b.specular) < 3e-4f);
    LightCase line = testing::random_light(LightShape::capsule, random);
    line.roughness = std::max(line.roughness, 0.1f);
    for (const LightShape shape : {LightShape::line, LightShape::capsule, LightShape::tube_open}) {
      line.shape = shape;
      LightCase back = line;
      std::swap(back.a, back.b);
      const CaseAnswer forth = testing::evaluate(line), again = testing::evaluate(back);
      CAPTURE(i);
      CAPTURE(int(shape));
      CHECK(std::abs(forth.specular - again.specular) < 3e-4f * std::max(1.0f, forth.specular));
    }
  }
}

TEST_CASE("a light of constant flux that shrinks becomes the point light, without a step") {
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    const LightShape shape = testing::shape_of_index(k);
    Random random(520 + std::uint64_t(k));
    double worst_limit = 0, worst_precision[4] = {0, 0, 0, 0};
    int paths = 0;
    while (paths < 60) {
      LightCase light;
      light.shape = shape;
      const Vec3d n(0, 0, 1);
      const f64::Frame tilt = f64::shading_frame(random.sphere(), random.sphere());
      const double theta = random.uniform(0.05, 1.3), turn = random.uniform(0, 6.28);
      const Vec3d wo(std::sin(theta), 0, std::cos(theta));
      light.normal = to_float(f64::to_world(tilt, n));
      light.wo = to_float(f64::to_world(tilt, wo));
      light.roughness = float(random.uniform(0.3, 1));
      light.albedo = 0.5f;
      light.f0 = 0.04f;
      const double lift_angle = random.uniform(0, 1.2);
      const Vec3d w =
          f64::to_world(tilt, Vec3d(std::sin(lift_angle) * std::cos(turn),
                                    std::sin(lift_angle) * std::sin(turn), std::cos(lift_angle)));
      const double distance = random.log_uniform(0.5, 5);
      const f64::Frame axes = f64::shading_frame(random.sphere(), random.sphere());
      Vec3d u = axes.t1, v = axes.t2;
      if (dot(cross(u, v), w) > 0) std::swap(u, v);
      const double facing = -dot(cross(u, v), w), across = length(cross(u, w));
      if (facing < 0.2 || across < 0.2) continue;
      ++paths;

      const f32::FittedLobe fitted =
          f32::fetch_lobe(table::builtin_ggx_table().view(),
                          f32::alpha_from_roughness(light.roughness), dot(light.normal, light.wo));
      const f32::Surface s =
          f32::make_surface(fitted, light.position, light.normal, light.wo, Vec3f(light.albedo),
                            Vec3f(light.f0), Vec3f(1.0f), light.roughness);
      const double point =
          double(f32::eval_surface_ltc(s, f32::to_shading(s.frame, to_float(w))).x);

      double previous = 0;
      for (int step = 0; step <= 80; ++step) {
        const double size = std::pow(10.0, -1 - step * 0.05); // over the distance, to 1e-5
        const double h = size * distance, r = 0.3 * h;
        const Vec3d center = w * distance;
        double area = 0; // across the line of sight, or length for lines
        light.a = to_float(center);
        light.radius = float(r);
        switch (shape) {
        case LightShape::rectangle:
        case LightShape::polygon: {
          const auto rings = shape == LightShape::rectangle
                                 ? std::vector<testing::Ring>{testing::rectangle(2 * h, h)}
                                 : std::vector<testing::Ring>{testing::star(5, h, 0.5 * h)};
          light.polygon = std::make_shared<const testing::TestPolygon>(rings, center, u, v);
          area = facing * h * h *
                 (shape == LightShape::rectangle ? 2 : 5 * 0.5 * std::sin(f64::k_pi / 5));
          break;
        }
        case LightShape::disk:
        case LightShape::ellipse: {
          const double ratio = shape == LightShape::disk ? 1 : 0.2;
          light.b = to_float(u * h);
          light.c = to_float(v * (h * ratio));
          area = facing * f64::k_pi * h * h * ratio;
          break;
        }
        case LightShape::sphere:
          light.radius = float(h);
          area = f64::k_pi * h * h;
          break;
        default:
          light.a = to_float(center - u * h);
          light.b = to_float(center + u * h);
          area = 2 * h * across * (shape == LightShape::line ? 1 : 2 * r);
          if (shape == LightShape::tube_flat) area += f64::k_pi * r * r * std::abs(dot(u, w));
          if (shape == LightShape::capsule) area += f64::k_pi * r * r;
          break;
        }
        const double solid_angle = area / (distance * distance);
        const CaseAnswer answer = testing::evaluate(light);
        const double value = double(answer.shaded.x) / solid_angle / point;
        CAPTURE(std::string(testing::shape_name(shape)));
        CAPTURE(paths);
        CAPTURE(size);
        // What single precision may take: the ends of tubes and lines are known to 6e-8 of their
        // distance, which is 6e-3 of a light of 1e-5. Polygons carry their area.
        const bool given_by_ends = int(shape) > int(LightShape::sphere);
        const double rounding = given_by_ends ? 6e-7 / size : 1e-4;
        // 1. To the point light: what is left is the light's extent, the curvature of the
        // densities at roughness 0.3, and rounding.
        // An open tube's ends, of which one looks into one, leave a term of the first order.
        const double extent = 1000 * size * size + (shape == LightShape::tube_open ? 2 * size : 0);
        if (size < 2e-3) {
          worst_limit = std::max(worst_limit, std::abs(value - 1));
          CHECK(std::abs(value - 1) < extent + rounding);
        }
        // 2. Without a step.
        if (step > 0 && size < 1e-2)
          CHECK(std::abs(value - previous) < 0.5 * extent + 2 * rounding);
        previous = value;
        // 3. Relative precision of the integrals on the way.
        const testing::CaseView view = testing::view_of(light);
        const double exact = testing::contour_integral(light, view, f64::cosine_lobe()).z;
        const int decade = std::min(step / 20, 3);
        worst_precision[decade] =
            std::max(worst_precision[decade], std::abs(double(answer.diffuse) / exact - 1));
      }
    }
    MESSAGE(
        std::string(testing::shape_name(shape)), ": at most ", worst_limit,
        " from the point light at sizes below 0.002; relative precision of the diffuse integral "
        "by decade of size from 0.1: ",
        worst_precision[0], " ", worst_precision[1], " ", worst_precision[2], " ",
        worst_precision[3]);
  }
}
