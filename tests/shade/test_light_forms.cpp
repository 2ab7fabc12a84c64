// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Every form of area lights beside the others: in a white furnace, and along paths on which nothing
// may step.

#include "placed_lights.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::testing;

namespace {

constexpr double k_pi = std::numbers::pi;

// Walls around the point and a ceiling, all of radiance 1: the whole hemisphere.
struct FiveWalls {
  double turn, height, a, b;

  double reflected(const f64::Surface& s) const {
    const Vec3d x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0), up(0, 0, height);
    const auto wall = [&](Vec3d center, Vec3d u, Vec3d v) {
      return placed_quad({center, u, v}).shade(s);
    };
    double sum = wall(up, y * b, x * a);
    for (const double side : {-1.0, 1.0}) {
      sum += wall(x * (side * a) + up * 0.5, y * (side * b), up * -0.5);
      sum += wall(y * (side * b) + up * 0.5, x * (-side * a), up * -0.5);
    }
    return sum;
  }
};

// What furnaces reflect over what they should: least, most, mean distance from 1; and the most that
// they reflect at all, where nothing is lost 1.
struct Furnaces {
  LightForm form;
  double least = 2, most = 0, distance = 0, brightest = 0;
};

constexpr int k_furnaces = 1500;

Furnaces measure(LightForm form, double from_degrees, double to_degrees, bool metal) {
  Random random(29);
  Furnaces result{form};
  for (int i = 0; i < k_furnaces; ++i) {
    const double theta = random.uniform(from_degrees, to_degrees) * k_pi / 180;
    const double roughness = random.uniform(0.06, 1);
    const f64::Surface s =
        surface_of_form(form, theta, roughness, metal ? 1.0 : 0.04, metal ? 0.0 : 1.0);
    const FiveWalls walls = {random.uniform(0, 2 * k_pi), random.uniform(0.3, 2.3),
                             random.uniform(0.5, 2), random.uniform(0.5, 2)};
    const bool by_ggx = form == LightForm::exact || form == LightForm::adaptive;
    // What a white dielectric loses its base has. A metal reflects its albedo: n1, of GGX itself
    // what visible normals have.
    double whole = 1;
    if (metal) whole = by_ggx ? visible_normals(s, 12, [](Vec3d) { return true; }) : s.fitted.n1;
    const double light = walls.reflected(s);
    result.least = std::min(result.least, light / whole);
    result.most = std::max(result.most, light / whole);
    result.distance += std::abs(light / whole - 1) / k_furnaces;
    result.brightest = std::max(result.brightest, light);
  }
  return result;
}

struct Case {
  const char* name;
  double from_degrees, to_degrees;
  bool metal;
  Furnaces bounds[6]; // just above what is measured
};

} // namespace

// By lobes alone a metal has its albedo n1, whatever the walls. The ratio in a wall's mean
// direction does not speak for all of it. A dielectric's Fresnel is that of mean directions, worst
// at grazing views, also by GGX itself where its lobe is narrow: decisions 51, 90; and its base has
// what the table's albedo leaves.
TEST_CASE("five walls of a white furnace, by every form of light") {
  constexpr double none = 1e-9;
  const Case cases[] = {{"metal, to 60 degrees",
                         0,
                         60,
                         true,
                         {{LightForm::lobe, 1 - none, 1 + none, none, 1 + none},
                          {LightForm::ratio, 0.99, 1.012, 0.0015, 1.002},
                          {LightForm::two_lobes, 1 - none, 1 + none, none, 1 + none},
                          {LightForm::two_lobes_ratio, 0.996, 1.006, 0.0007, 1.002},
                          {LightForm::adaptive, 0.996, 1.0045, 0.0006, 1.002},
                          {LightForm::exact, 0.9995, 1.0018, 0.00013, 1.0005}}},
                        {"metal, 60 to 89 degrees",
                         60,
                         89,
                         true,
                         {{LightForm::lobe, 1 - none, 1 + none, none, 1 + none},
                          {LightForm::ratio, 0.88, 1.037, 0.0075, 1.002},
                          {LightForm::two_lobes, 1 - none, 1 + none, none, 1 + none},
                          {LightForm::two_lobes_ratio, 0.93, 1.017, 0.004, 1.002},
                          {LightForm::adaptive, 0.993, 1.007, 0.001, 1.002},
                          {LightForm::exact, 0.999, 1.006, 0.0007, 1.001}}},
                        {"dielectric, to 60 degrees",
                         0,
                         60,
                         false,
                         {{LightForm::lobe, 0.9975, 1.004, 0.00025, 1.004},
                          {LightForm::ratio, 0.9975, 1.0045, 0.0003, 1.0045},
                          {LightForm::two_lobes, 0.997, 1.004, 0.00025, 1.004},
                          {LightForm::two_lobes_ratio, 0.997, 1.004, 0.00025, 1.004},
                          {LightForm::adaptive, 0.997, 1.0036, 0.00025, 1.0036},
                          {LightForm::exact, 0.9995, 1.0006, 0.00005, 1.0006}}},
                        {"dielectric, 60 to 89 degrees",
                         60,
                         89,
                         false,
                         {{LightForm::lobe, 0.965, 1.081, 0.0065, 1.081},
                          {LightForm::ratio, 0.96, 1.068, 0.0065, 1.068},
                          {LightForm::two_lobes, 0.97, 1.045, 0.005, 1.045},
                          {LightForm::two_lobes_ratio, 0.969, 1.041, 0.005, 1.041},
                          {LightForm::adaptive, 0.99, 1.0075, 0.0014, 1.0075},
                          {LightForm::exact, 0.99, 1.006, 0.0006, 1.006}}}};
  for (const Case& one : cases)
    for (std::size_t k = 0; k < std::size(k_light_forms); ++k) {
      const Furnaces& bound = one.bounds[k];
      const Furnaces found = measure(bound.form, one.from_degrees, one.to_degrees, one.metal);
      REQUIRE(k_light_forms[k].form == bound.form);
      MESSAGE(std::string(one.name), ", ", std::string(k_light_forms[k].name), ": ", found.least,
              " to ", found.most, ", mean distance ", found.distance, "; brightest ",
              found.brightest);
      CHECK(found.least > bound.least);
      CHECK(found.most < bound.most);
      CHECK(found.distance < bound.distance);
      CHECK(found.brightest < bound.brightest);
    }
}

namespace {

struct Path {
  const char* name;
  std::function<Placed(double)> at; // t in 0..1
};

Placed facing(Vec3d center, double size) {
  const f64::Frame frame = f64::shading_frame(normalize(center) * -1.0, Vec3d(0, 0.31, 1));
  return {center, frame.t1 * size, frame.t2 * (0.7 * size)};
}

// The surface's horizon is z = 0; that of a lobe, which is tilted away from the viewer at +x, is
// crossed above it on the viewer's side.
const Path k_paths[] = {
    {"grows", [](double t) { return facing(Vec3d(-1, 0.4, 1.2), 0.002 * std::pow(1000, t)); }},
    {"shrinks to nothing", [](double t) { return facing(Vec3d(-1, 0.4, 1.2), 0.5 * (1 - t)); }},
    {"sets", [](double t) { return facing(Vec3d(-1.5, 0.3, 0.8 - 1.4 * t), 0.3); }},
    {"sets, wide", [](double t) { return facing(Vec3d(-1.5, 0.3, 1.2 - 2.4 * t), 1.1); }},
    {"crosses the lobe's horizon",
     [](double t) { return facing(Vec3d(-1 + 3 * t, 0.2, 0.9 - 0.3 * t), 0.2); }},
    {"passes the mirror direction",
     [](double t) { return facing(Vec3d(-1.2, -1 + 2 * t, 0.8), 0.15); }},
    {"passes the normal", [](double t) { return facing(Vec3d(-1 + 2 * t, 0.1, 1), 0.4); }}};

// The largest second difference of every `stride`-th value, over the largest value.
double largest_bend(const std::vector<double>& values, std::size_t stride) {
  double most = 0;
  for (std::size_t i = 2 * stride; i < values.size(); i += stride)
    most = std::max(most, std::abs(values[i] - 2 * values[i - stride] + values[i - 2 * stride]));
  return most / std::max(*std::max_element(values.begin(), values.end()), 1e-9);
}

// Second differences shrink as the steps do: with four times as many a sixteenth where all is
// smooth, a quarter at a kink; a step keeps its height. `known`: steps that are not looked for.
bool has_step(const std::vector<double>& values, double known) {
  return !(largest_bend(values, 1) < 0.5 * largest_bend(values, 4) + known);
}

// Steps that there are, over the largest light of a path. GGX itself takes more nodes where an arc
// begins to count as wide, and steps by what they change: circles most.
double known_step(LightForm form, const std::string& shape) {
  const bool exact = form == LightForm::exact || form == LightForm::adaptive;
  if (exact && (shape == "sphere" || shape == "ellipse")) return 2e-3;
  if (exact && shape == "capsule") return 5e-4;
  return exact ? 1e-4 : 1e-7;
}

} // namespace

TEST_CASE("no light steps on its path, by any form and of any shape; a seam would be noticed") {
  constexpr int k_steps = 6400;
  int seams = 0, noticed = 0;
  for (const NamedForm& named : k_light_forms)
    for (const PlacedShape& shape : k_placed_shapes)
      for (const Path& path : k_paths)
        for (const double roughness : {0.25, 0.6}) {
          const f64::Surface s = surface_of_form(named.form, 1.1, roughness);
          std::vector<double> values;
          for (int i = 0; i <= k_steps; ++i)
            values.push_back(shape.make(path.at(double(i) / k_steps)).shade(s));
          CAPTURE(std::string(named.name));
          CAPTURE(std::string(shape.name));
          CAPTURE(std::string(path.name));
          CAPTURE(roughness);
          double largest = 0;
          bool sound = true;
          for (const double value : values) {
            sound = sound && std::isfinite(value) && value >= 0;
            largest = std::max(largest, value);
          }
          CHECK(sound);
          const double known = known_step(named.form, shape.name);
          CHECK_FALSE_MESSAGE(has_step(values, known), largest_bend(values, 4), " then ",
                              largest_bend(values, 1));
          // The same with a seam half way.
          const double seam = std::max(2e-3, 4 * known) * largest;
          for (std::size_t i = values.size() / 2; i < values.size(); ++i)
            values[i] += seam;
          ++seams;
          noticed += has_step(values, known);
        }
  MESSAGE("seams noticed: ", noticed, " of ", seams);
  CHECK(noticed == seams);
}
