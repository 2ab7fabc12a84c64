// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The cut of an outline into triangles covers it exactly, wherever it lies and however it turns.

#include "openltc/light/packed_polygon.h"
#include "openltc/light/polygon.h"
#include "openltc/light/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace openltc;
using namespace openltc::light;

using Ring = std::vector<Vec2d>;

struct Frame {
  Vec3d origin{0, 0, 0}, u{1, 0, 0}, v{0, 1, 0};
};

PolygonLight make_light(const std::vector<Ring>& rings, const Frame& frame = {}) {
  PolygonLight light;
  light.radiance = Vec3f(1, 2, 3);
  light.normal = to_float(cross(frame.u, frame.v));
  for (const Ring& ring : rings) {
    for (const Vec2d p : ring)
      light.vertices.push_back(to_float(frame.origin + frame.u * p.x + frame.v * p.y));
    light.ring_end.push_back(std::uint32_t(light.vertices.size()));
  }
  return light;
}

Frame random_frame(std::mt19937& random, double distance = 1) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3d(normal(random), normal(random), normal(random)); };
  Frame frame;
  frame.origin = vector() * distance;
  frame.u = normalize(vector());
  frame.v = normalize(cross(normalize(vector()), frame.u));
  return frame;
}

Ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring star(int points, double inner, double outer) {
  Ring ring;
  for (int i = 0; i < 2 * points; ++i) {
    const double radius = i % 2 ? inner : outer, angle_rad = std::numbers::pi * i / points;
    ring.push_back({radius * std::cos(angle_rad), radius * std::sin(angle_rad)});
  }
  return ring;
}

struct Shape {
  std::string name;
  std::vector<Ring> rings;
  double area;
};

std::vector<Shape> shapes() {
  const Ring l = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Ring comb = {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1},
                     {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  // A regular star's area: each of its 2 n triangles from the centre has sides inner and outer.
  const auto star_area = [](int n, double a, double b) {
    return n * a * b * std::sin(std::numbers::pi / n);
  };
  return {
      {"triangle", {{{0, 0}, {2, 0}, {0.5, 1}}}, 1},
      {"square", {box(0, 0, 2, 2)}, 4},
      {"sliver", {box(0, 0, 10, 0.1)}, 1},
      {"L", {l}, 4},
      {"comb", {comb}, 8},
      {"star", {star(5, 0.4, 1)}, star_area(5, 0.4, 1)},
      {"sharp star", {star(17, 0.1, 1)}, star_area(17, 0.1, 1)},
      {"frame", {box(-2, -2, 2, 2), reversed(box(-1, -1, 1, 1))}, 12},
      {"two holes",
       {box(0, 0, 5, 3), reversed(box(1, 1, 2, 2)), reversed(star(3, 0.2, 0.5))},
       15 - 1},
      {"island in a hole",
       {box(-3, -3, 3, 3), reversed(box(-2, -2, 2, 2)), box(-1, -1, 1, 1)},
       36 - 16 + 4},
      {"two islands", {box(0, 0, 1, 1), box(3, 0, 4, 2)}, 3},
      {"points on edges", {{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}}, 4},
  };
}

// The third ring of "two holes" must lie inside: moved there.
std::vector<Shape> placed_shapes() {
  std::vector<Shape> all = shapes();
  for (Shape& shape : all)
    if (shape.name == "two holes") {
      for (Vec2d& p : shape.rings[2])
        p = p + Vec2d(3.5, 1.5);
      shape.area -= 3 * 0.2 * 0.5 * std::sin(std::numbers::pi / 3);
    }
  return all;
}

// Whether a point of the plane lies inside, by the parity of edges to its right.
bool is_inside(const PolygonLight& light, Vec3d point, const Frame& frame) {
  const auto flat = [&](Vec3d p) {
    return Vec2d(dot(p - frame.origin, frame.u), dot(p - frame.origin, frame.v));
  };
  const Vec2d p = flat(point);
  bool inside = false;
  for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
    const auto ring = ring_vertices(light, r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = flat(to_double(ring[i])), b = flat(to_double(ring[(i + 1) % ring.size()]));
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) > p.x) inside = !inside;
    }
  }
  return inside;
}

double distance_to_outline(const PolygonLight& light, Vec3d point) {
  double nearest = 1e30;
  for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
    const auto ring = ring_vertices(light, r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3d a = to_double(ring[i]), ab = to_double(ring[(i + 1) % ring.size()]) - a;
      const double t = std::clamp(dot(point - a, ab) / std::max(dot(ab, ab), 1e-300), 0.0, 1.0);
      nearest = std::min(nearest, length(point - a - ab * t));
    }
  }
  return nearest;
}

struct Cut {
  Vec3d corner, ab, ac;
  double area() const { return 0.5 * length(cross(ab, ac)); }
};

std::vector<Cut> cuts_of(const PackedPolygon& packed) {
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i + 9 <= packed.triangles.size(); i += 9) {
    const float* t = packed.triangles.data() + i;
    cuts.push_back({Vec3d(t[0], t[1], t[2]), Vec3d(t[3], t[4], t[5]), Vec3d(t[6], t[7], t[8])});
  }
  return cuts;
}

} // namespace

TEST_CASE("packed_area_is_the_area_of_the_rings_however_they_turn") {
  std::mt19937 random(1);
  for (const Shape& shape : placed_shapes()) {
    CAPTURE(shape.name);
    for (int turn = 0; turn < 20; ++turn) {
      const PolygonLight light =
          make_light(shape.rings, turn == 0 ? Frame{} : random_frame(random));
      CHECK(area(light) == doctest::Approx(shape.area).epsilon(1e-4));
      const PackedPolygon packed = pack_polygon(light);
      CHECK(double(packed.area) == doctest::Approx(area(light)).epsilon(1e-4));
      double sum = 0;
      for (const Cut& cut : cuts_of(packed))
        sum += cut.area();
      CHECK(sum == doctest::Approx(double(packed.area)).epsilon(1e-5));
    }
  }
}

TEST_CASE("triangles_cover_the_light_and_nothing_else") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform;
  for (const Shape& shape : placed_shapes()) {
    CAPTURE(shape.name);
    for (int turn = 0; turn < 3; ++turn) {
      const Frame frame = random_frame(random);
      const PolygonLight light = make_light(shape.rings, frame);
      const PackedPolygon packed = pack_polygon(light);
      const std::vector<Cut> cuts = cuts_of(packed);
      int outside = 0, off_plane = 0;
      for (const Cut& cut : cuts)
        for (int i = 0; i < 100; ++i) {
          double a = uniform(random), b = uniform(random);
          if (a + b > 1) a = 1 - a, b = 1 - b;
          const Vec3d p = cut.corner + cut.ab * a + cut.ac * b;
          off_plane += std::abs(dot(p - frame.origin, cross(frame.u, frame.v))) > 1e-4;
          if (distance_to_outline(light, p) < 1e-4) continue; // rounding decides
          outside += !is_inside(light, p, frame);
        }
      CHECK(outside == 0);
      CHECK(off_plane == 0);
      // Inside, and as large together as the light: they overlap nowhere and leave nothing out.
    }
  }
}

TEST_CASE("the_distribution_of_triangles_follows_their_area") {
  for (const Shape& shape : placed_shapes()) {
    CAPTURE(shape.name);
    const PackedPolygon packed = pack_polygon(make_light(shape.rings));
    const std::vector<Cut> cuts = cuts_of(packed);
    REQUIRE(packed.triangle_cdf.size() == cuts.size());
    REQUIRE(!cuts.empty());
    CHECK(packed.triangle_cdf.back() == 1.0f);
    double sum = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      sum += cuts[i].area() / double(packed.area);
      CHECK(double(packed.triangle_cdf[i]) == doctest::Approx(sum).epsilon(1e-4));
    }
  }
}

TEST_CASE("the_view_repeats_each_ring's_first_point_and_marks_it") {
  const PolygonLight light = make_light(placed_shapes()[7].rings); // the frame
  const PackedPolygon packed = pack_polygon(light);
  const PolygonView& view = packed.view;
  REQUIRE(view.point_count == 10);
  for (const int first : {0, 5}) {
    CHECK(view.points[4 * first + 3] == 1.0f);
    for (int i = 1; i < 5; ++i)
      CHECK(view.points[4 * (first + i) + 3] == 0.0f);
    for (int k = 0; k < 3; ++k)
      CHECK(view.points[4 * first + k] == view.points[4 * (first + 4) + k]);
  }
  // The plane's coordinates give the points back.
  for (int i = 0; i < view.point_count; ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(double(view.origin[k] + view.axis_u[k] * view.in_plane[2 * i] +
                   view.axis_v[k] * view.in_plane[2 * i + 1]) ==
            doctest::Approx(double(view.points[4 * i + k])));
}

TEST_CASE("lights_without_area_give_no_points") {
  const std::vector<std::vector<Ring>> empty = {
      {},
      {{{0, 0}, {1, 0}, {2, 0}}},
      {{{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
      {{{0, 0}, {1, 0}}},
      {box(0, 0, 1, 1), reversed(box(0, 0, 1, 1))}, // the hole is all of it
  };
  for (const std::vector<Ring>& rings : empty) {
    const PackedPolygon packed = pack_polygon(make_light(rings));
    CHECK(packed.view.point_count == 0);
    CHECK(packed.triangles.empty());
    CHECK(packed.area == 0.0f);
  }
}

TEST_CASE("an_outline_that_runs_the_wrong_way_lights_nothing") {
  CHECK(pack_polygon(make_light({box(0, 0, 1, 1)})).view.point_count == 5);
  CHECK(pack_polygon(make_light({reversed(box(0, 0, 1, 1))})).view.point_count == 0);
}

TEST_CASE("far_from_the_origin_only_the_coordinates'_own_rounding_counts") {
  std::mt19937 random(3);
  for (int turn = 0; turn < 20; ++turn) {
    const PolygonLight light = make_light({star(5, 0.4, 1)}, random_frame(random, 5000));
    const PackedPolygon packed = pack_polygon(light);
    // Coordinates of some thousand metres are rounded to half a millimetre.
    CHECK(double(packed.area) == doctest::Approx(area(light)).epsilon(1e-3));
    double sum = 0;
    for (const Cut& cut : cuts_of(packed)) {
      sum += cut.area();
      CHECK(distance_to_outline(light, cut.corner) < 2e-3);
    }
    CHECK(sum == doctest::Approx(double(packed.area)).epsilon(1e-5));
  }
}

TEST_CASE("sizes_from_a_spark_to_a_city") {
  std::mt19937 random(4);
  for (const double size : {1e-6, 1e-3, 1e3, 1e5}) {
    CAPTURE(size);
    Ring ring = star(7, 0.5, 1);
    for (Vec2d& p : ring)
      p = p * size;
    Frame frame = random_frame(random);
    frame.origin = frame.origin * size;
    const PackedPolygon packed = pack_polygon(make_light({ring}, frame));
    const double expected = size * size * 7 * 0.5 * std::sin(std::numbers::pi / 7);
    CHECK(double(packed.area) / expected == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("disks_and_rectangles_are_cut_into_few_triangles") {
  const PackedPolygon square = pack_polygon(
      rectangle(Vec3f(1, 2, 3), Vec3f(0.3f, 0.2f, 0), Vec3f(-0.2f, 0.3f, 0), Vec3f(1)));
  CHECK(square.triangle_cdf.size() <= 6); // two, but for rounding
  const PackedPolygon round = pack_polygon(make_light({star(32, 1, 1)}));
  CHECK(round.triangle_cdf.size() <= 128);
  CHECK(double(round.area) == doctest::Approx(32 * std::sin(std::numbers::pi / 32)).epsilon(1e-5));
}

TEST_CASE("thousands_of_corners_are_packed_in_reasonable_time") {
  const int points = 4000;
  const auto start = std::chrono::steady_clock::now();
  std::mt19937 random(5);
  const PolygonLight light = make_light({star(points, 0.8, 1)}, random_frame(random));
  const PackedPolygon packed = pack_polygon(light);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CHECK(double(packed.area) == doctest::Approx(area(light)).epsilon(1e-3));
  CHECK(packed.triangle_cdf.size() < std::size_t(3 * 2 * points));
  CHECK(seconds < 5);
}
