// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The ratio of the BRDF to the lobe in a light's mean direction: against GGX itself, integrated
// over the lights by midpoints, in double precision.

#include "openltc/table/lobe_table.h"
#include "polygon_fixture.h"
#include "random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace openltc;
using testing::Random;
using testing::TestPolygon;

namespace {

constexpr double k_pi = std::numbers::pi;

// A point at the origin, normal up, without diffuse part.
f64::Surface surface(double theta, double roughness, double f0 = 1) {
  const Vec3d wo(std::sin(theta), 0, std::cos(theta));
  const f64::FittedLobe fitted = f64::fetch_lobe(table::builtin_ggx_table().view(),
                                                 f64::alpha_from_roughness(roughness), wo.z);
  return f64::make_surface(fitted, Vec3d(0.0), Vec3d(0, 0, 1), wo, Vec3d(0.0), Vec3d(f0),
                           Vec3d(1.0), roughness);
}

double brdf(const f64::Surface& s, Vec3d towards) {
  const Vec3d wi = f64::to_shading(s.frame, normalize(towards));
  return f64::eval_ggx(s.wo, wi, s.alpha, s.f0, s.f90).x;
}

// What a patch of a light adds: `area` around p, with that normal.
double patch(const f64::Surface& s, Vec3d p, Vec3d normal, double area) {
  const double distance2 = dot(p, p), facing = -dot(p, normal) / std::sqrt(distance2);
  return facing > 0 ? brdf(s, p) * facing * area / distance2 : 0;
}

// A light of some shape around a centre: what it shades, and what is true.
struct Light {
  std::function<double(const f64::Surface&)> shade;
  std::function<double(const f64::Surface&, int steps)> exact; // steps each way
};

struct Placed {
  Vec3d center, u, v; // half extents at right angles, facing the origin with u x v
};

Light quad(Placed at) {
  const Vec3d axis_u = normalize(at.u), axis_v = normalize(at.v), normal = cross(axis_u, axis_v);
  const double a = length(at.u), b = length(at.v);
  return {[=](const f64::Surface& s) {
            const TestPolygon polygon({testing::rectangle(2 * a, 2 * b)}, at.center, axis_u,
                                      axis_v);
            return f64::shade_polygon(s, polygon.view()).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j)
                sum += patch(
                    s, at.center + at.u * (2 * (i + 0.5) / n - 1) + at.v * (2 * (j + 0.5) / n - 1),
                    normal, 4 * a * b / (n * n));
            return sum;
          }};
}

Light ellipse(Placed at) {
  const Vec3d normal = normalize(cross(at.u, at.v));
  const double area = k_pi * length(at.u) * length(at.v);
  return {[=](const f64::Surface& s) {
            f64::Ellipse light;
            light.center = at.center;
            light.half_u = at.u;
            light.half_v = at.v;
            light.two_sided = 0;
            return f64::shade_ellipse(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double r = std::sqrt((i + 0.5) / n), phi = 2 * k_pi * (j + 0.5) / n;
                sum += patch(s, at.center + at.u * (r * std::cos(phi)) + at.v * (r * std::sin(phi)),
                             normal, area / (n * n));
              }
            return sum;
          }};
}

Light sphere(Placed at) {
  const double radius = std::min(length(at.u), 0.95 * length(at.center));
  return {[=](const f64::Surface& s) {
            f64::Sphere light;
            light.center = at.center;
            light.radius = radius;
            return f64::shade_sphere(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            const double sine2 = radius * radius / dot(at.center, at.center);
            const double height = sine2 / (1 + std::sqrt(1 - sine2));
            const f64::Frame frame = f64::shading_frame(normalize(at.center), Vec3d(0.1, 0.3, 1));
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double down = height * (i + 0.5) / n, phi = 2 * k_pi * (j + 0.5) / n;
                const double across = std::sqrt(down * (2 - down));
                sum += brdf(s, frame.n * (1 - down) + frame.t1 * (across * std::cos(phi)) +
                                   frame.t2 * (across * std::sin(phi)));
              }
            return sum * 2 * k_pi * height / (n * n);
          }};
}

Light line(Placed at) {
  const Vec3d half = at.u * 2.0;
  return {[=](const f64::Surface& s) {
            f64::Line light;
            light.from = at.center - half;
            light.to = at.center + half;
            return f64::shade_line(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            double sum = 0;
            const int steps = n * n / 4;
            for (int i = 0; i < steps; ++i) {
              const Vec3d p = at.center + half * (2 * (i + 0.5) / steps - 1);
              const double distance2 = dot(p, p);
              sum += brdf(s, p) * length(cross(p, half)) / (distance2 * std::sqrt(distance2));
            }
            return sum * 2 / steps;
          }};
}

// With round ends.
Light capsule(Placed at) {
  const Vec3d half = at.u * 1.5;
  const double radius = 0.2 * length(at.v), side = 2 * length(half);
  return {[=](const f64::Surface& s) {
            f64::Tube light;
            light.from = at.center - half;
            light.to = at.center + half;
            light.radius = radius;
            light.caps = 2;
            return f64::shade_tube(s, light).x;
          },
          [=](const f64::Surface& s, int n) {
            const Vec3d axis = normalize(half);
            const f64::Frame frame = f64::shading_frame(axis, Vec3d(0.13, 0.3, 1));
            double sum = 0;
            for (int i = 0; i < n; ++i)
              for (int j = 0; j < n; ++j) {
                const double phi = 2 * k_pi * (j + 0.5) / n;
                const Vec3d normal = frame.t1 * std::cos(phi) + frame.t2 * std::sin(phi);
                sum += patch(s, at.center + half * (2 * (i + 0.5) / n - 1) + normal * radius,
                             normal, side * 2 * k_pi * radius / (n * n));
                const double height = (i + 0.5) / n, across = std::sqrt(1 - height * height);
                for (const double end : {-1.0, 1.0}) {
                  const Vec3d out = normal * across + axis * (end * height);
                  sum += patch(s, at.center + half * end + out * radius, out,
                               2 * k_pi * radius * radius / (n * n));
                }
              }
            return sum;
          }};
}

struct Shape {
  const char* name;
  Light (*make)(Placed);
};
const Shape k_shapes[] = {
    {"quad", quad}, {"ellipse", ellipse}, {"sphere", sphere}, {"line", line}, {"capsule", capsule}};

// Somewhere above, more or less towards the point.
Placed place(double size, Random& random) {
  const Vec3d w = random.hemisphere();
  const f64::Frame frame =
      f64::shading_frame(normalize(random.sphere() * 0.5 - w), Vec3d(0, 0.3, 1));
  return {w * 2.0, frame.t1 * (size * random.uniform(0.2, 1)),
          frame.t2 * (size * random.uniform(0.2, 1))};
}

struct Errors {
  double of_light = 0; // sum of errors over the sum of light
  double median = 0;   // of relative errors
};

Errors errors(const std::vector<double>& found, const std::vector<double>& exact) {
  double error = 0, sum = 0;
  std::vector<double> relative;
  for (std::size_t i = 0; i < found.size(); ++i) {
    error += std::abs(found[i] - exact[i]);
    sum += exact[i];
    if (exact[i] > 1e-6) relative.push_back(std::abs(found[i] - exact[i]) / exact[i]);
  }
  std::nth_element(relative.begin(), relative.begin() + std::ptrdiff_t(relative.size() / 2),
                   relative.end());
  return {error / sum, relative[relative.size() / 2]};
}

} // namespace

TEST_CASE("ratio at the mean direction: an area light that shrinks becomes the exact point light") {
  for (const Shape& shape : k_shapes) {
    CAPTURE(std::string(shape.name));
    Random random(7);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      const f64::Surface s = f64::correct_at_mean(
          surface(random.uniform(0, 1.5), random.uniform(0.1, 1), i % 2 ? 1.0 : 0.04));
      const Placed at = place(0.004, random);
      const Light light = shape.make(at);
      const double exact = light.exact(s, 80);
      // Where the lobe has nothing, beyond its own horizon, there is nothing to correct.
      const double density =
          f64::eval_lobe(s.fitted.lobe, f64::to_shading(s.frame, normalize(at.center)));
      if (exact < 1e-9 || density < 1e-4 || at.center.z < 0.1) continue;
      worst = std::max(worst, std::abs(light.shade(s) - exact) / exact);
    }
    MESSAGE(std::string(shape.name), ": ", worst);
    CHECK(worst < 3e-3); // sizes of 0.002 of the distance, lobes that turn by a few times that
  }
}

TEST_CASE(
    "ratio at the mean direction: errors of lights of every shape and size, halved at least") {
  struct Size {
    double size, of_light, median; // bounds a fifth above what is measured
  };
  // A light at twice its size; as wide as half the distance; a quarter; a tenth.
  for (const Size& size : {Size{2, 0.032, 0.027}, Size{1, 0.031, 0.022}, Size{0.5, 0.02, 0.008},
                           Size{0.2, 0.015, 0.0016}}) {
    for (const Shape& shape : k_shapes) {
      Random random(17);
      std::vector<double> plain, corrected, exact;
      for (int i = 0; i < 160; ++i) {
        const f64::Surface s = surface(random.uniform(0, 1.56), random.uniform(0.1, 1));
        const Light light = shape.make(place(size.size, random));
        const double truth = light.exact(s, 160);
        if (truth < 1e-7) continue;
        exact.push_back(truth);
        plain.push_back(light.shade(s));
        corrected.push_back(light.shade(f64::correct_at_mean(s)));
      }
      const Errors before = errors(plain, exact), after = errors(corrected, exact);
      CAPTURE(size.size);
      CAPTURE(std::string(shape.name));
      MESSAGE(std::string(shape.name), " of size ", size.size, ": ", 100 * before.of_light, " to ",
              100 * after.of_light, " % of the light, median ", 100 * before.median, " to ",
              100 * after.median, " %");
      CHECK(after.of_light < size.of_light);
      CHECK(after.median < size.median);
      CHECK(after.of_light < before.of_light);
      CHECK(after.median < 0.7 * before.median);
    }
  }
}

TEST_CASE(
    "ratio at the mean direction: a line low over a glossy dielectric, down to the floor itself") {
  Random random(23);
  for (const double height : {0.01, 0.0}) {
    std::vector<double> plain, corrected, exact;
    for (int i = 0; i < 200; ++i) {
      const f64::Surface s = surface(random.uniform(1, 1.5), 0.3, 0.04);
      const double turn = random.uniform(0, 2 * k_pi), away = random.uniform(0.05, 2);
      const Vec3d out(std::cos(turn), std::sin(turn), 0), along(-out.y, out.x, 0);
      Placed at;
      at.center = out * away + along * random.uniform(-1, 1) + Vec3d(0, 0, height);
      at.u = along * 0.5;
      at.v = Vec3d(0, 0, 1);
      const Light light = line(at);
      exact.push_back(light.exact(s, 400));
      plain.push_back(light.shade(s));
      corrected.push_back(light.shade(f64::correct_at_mean(s)));
    }
    if (height > 0) {
      const Errors before = errors(plain, exact), after = errors(corrected, exact);
      MESSAGE("1 cm over the floor: ", 100 * before.of_light, " to ", 100 * after.of_light,
              " % of the light");
      CHECK(before.of_light > 0.2);
      CHECK(after.of_light < 0.03);
    } else {
      for (const double light : corrected)
        CHECK(light < 1e-9);
    }
  }
}

TEST_CASE("ratio at the mean direction: five walls of a white furnace, and a quad in two halves") {
  Random random(29);
  double least = 2, most = 0, split = 0;
  std::vector<double> splits;
  for (int i = 0; i < 1500; ++i) {
    const f64::Surface s =
        f64::correct_at_mean(surface(random.uniform(0, 1.55), random.uniform(0.06, 1)));
    const double turn = random.uniform(0, 2 * k_pi), h = random.uniform(0.3, 2.3);
    const Vec3d x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0), z(0, 0, 1);
    const double a = random.uniform(0.5, 2), b = random.uniform(0.5, 2);
    const auto wall = [&](Vec3d center, Vec3d u, Vec3d v) { return quad({center, u, v}).shade(s); };
    double sum = wall(z * h, y * b, x * a);
    for (const double side : {-1.0, 1.0}) {
      sum += wall(x * (side * a) + z * (h / 2), y * (side * b), z * (-h / 2));
      sum += wall(y * (side * b) + z * (h / 2), x * (-side * a), z * (-h / 2));
    }
    least = std::min(least, sum / s.fitted.n1);
    most = std::max(most, sum / s.fitted.n1);

    const Placed at = place(1, random);
    const Light whole = quad(at);
    const double light = whole.shade(s);
    if (light < 1e-3) continue;
    const double halves = quad({at.center - at.u * 0.5, at.u * 0.5, at.v}).shade(s) +
                          quad({at.center + at.u * 0.5, at.u * 0.5, at.v}).shade(s);
    splits.push_back(std::abs(halves - light) / light);
    split += splits.back();
  }
  std::sort(splits.begin(), splits.end());
  MESSAGE("furnace ", least, " to ", most, "; halves: mean ", split / double(splits.size()),
          ", p95 ", splits[splits.size() * 95 / 100]);
  // Of one lobe, whose shape is so far off that one direction of a wall does not speak for all of
  // it.
  CHECK(least > 0.94);
  CHECK(most < 1.05);
  CHECK(split / double(splits.size()) < 0.02);
}

TEST_CASE("ratio at the mean direction: no step where a light grows, sets or passes the mirror "
          "direction") {
  // Along each path the second differences shrink as the steps do: with four times as many steps a
  // sixteenth where all is smooth, a quarter at a kink; a step keeps its height.
  struct Path {
    const char* name;
    std::function<Placed(double)> at; // t in 0..1
  };
  const auto facing = [](Vec3d center, double size) {
    const f64::Frame frame = f64::shading_frame(normalize(center) * -1.0, Vec3d(0, 0.31, 1));
    return Placed{center, frame.t1 * size, frame.t2 * (0.7 * size)};
  };
  const Path paths[] = {
      {"grows", [&](double t) { return facing(Vec3d(-1, 0.4, 1.2), 0.002 * std::pow(1000, t)); }},
      {"sets", [&](double t) { return facing(Vec3d(-1.5, 0.3, 0.8 - 1.4 * t), 0.3); }},
      {"sets, wide", [&](double t) { return facing(Vec3d(-1.5, 0.3, 1.2 - 2.4 * t), 1.1); }},
      {"crosses the lobe's horizon",
       [&](double t) { return facing(Vec3d(-1 + 3 * t, 0.2, 0.9 - 0.3 * t), 0.2); }},
      {"passes the mirror direction",
       [&](double t) { return facing(Vec3d(-1.2, -1 + 2 * t, 0.8), 0.15); }}};
  for (const Shape& shape : k_shapes)
    for (const Path& path : paths)
      for (const double roughness : {0.25, 0.6}) {
        const f64::Surface s = f64::correct_at_mean(surface(1.1, roughness));
        const auto largest = [&](int steps) {
          double before = 0, last = 0, most = 0, light = 1e-9;
          for (int i = 0; i <= steps; ++i) {
            const double next = shape.make(path.at(double(i) / steps)).shade(s);
            CHECK(std::isfinite(next));
            CHECK(next >= 0);
            if (i >= 2) most = std::max(most, std::abs(next - 2 * last + before));
            before = last;
            last = next;
            light = std::max(light, next);
          }
          return most / light;
        };
        const double coarse = largest(400), fine = largest(1600);
        CAPTURE(std::string(shape.name));
        CAPTURE(std::string(path.name));
        CAPTURE(roughness);
        CHECK(fine < 0.5 * coarse + 1e-5);
      }
}
