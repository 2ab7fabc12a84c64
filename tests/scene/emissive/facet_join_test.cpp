// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Emissive meshes of many facets: what is joined, cut and united gives the light of the facets, by
// quadrature over them.

#include "openltc/light/emission_stack.h"
#include "openltc/light/polygon.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/emissive/ring_overlap.h"
#include "tests/scene/emissive/round_meshes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace openltc;

constexpr double k_pi = std::numbers::pi;

scene::Material glowing(float nits, bool double_sided = false) {
  scene::Material material;
  material.emission = Vec3f(nits);
  material.double_sided = double_sided;
  return material;
}

// A grid of quads over a map of the unit square, closed in both directions if it is a torus.
template <class Map>
scene::Mesh surface(std::uint32_t columns, std::uint32_t rows, const Map& map) {
  scene::Mesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.positions.push_back(to_float(map(double(i) / columns, double(j) / rows)));
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1));
  return mesh;
}

scene::Mesh torus(std::uint32_t columns, std::uint32_t rows) {
  return surface(columns, rows, [](double u, double v) {
    const double a = 2 * k_pi * u, b = 2 * k_pi * v;
    return Vec3d((1 + 0.3 * std::cos(b)) * std::cos(a), (1 + 0.3 * std::cos(b)) * std::sin(a),
                 0.3 * std::sin(b));
  });
}

double area_of_mesh(const scene::Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3d a = to_double(mesh.positions[t[0]]);
    sum += 0.5 *
           length(cross(to_double(mesh.positions[t[1]]) - a, to_double(mesh.positions[t[2]]) - a));
  }
  return sum;
}

// Irradiance per radiance at p on a surface that faces n, from a triangle, by quadrature; of a side
// or of both. The sign is that of the triangle's own direction relative to `normal`.
double irradiance(Vec3d p, Vec3d n, Vec3d a, Vec3d b, Vec3d c, Vec3d normal, bool two_sided,
                  int cuts) {
  const double area = 0.5 * dot(cross(b - a, c - a), normal) / (cuts * cuts);
  double sum = 0;
  for (int i = 0; i < cuts; ++i)
    for (int k = 0; k < 2 * (cuts - i) - 1; ++k) {
      // Centres of the small triangles, upright and inverted ones.
      const double s = (k % 2 ? 2.0 : 1.0) / 3;
      const Vec3d x = a + (b - a) * ((k / 2 + s) / cuts) + (c - a) * ((i + s) / cuts);
      const Vec3d d = x - p;
      const double r2 = dot(d, d);
      const double at_light = two_sided ? std::abs(dot(d, normal)) : -dot(d, normal);
      sum += std::max(dot(d, n), 0.0) * std::max(at_light, 0.0) / (r2 * r2);
    }
  return sum * area;
}

double from_mesh(const scene::Mesh& mesh, Vec3d p, Vec3d n, bool two_sided, int cuts) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3d a = to_double(mesh.positions[t[0]]), b = to_double(mesh.positions[t[1]]),
                c = to_double(mesh.positions[t[2]]);
    sum += irradiance(p, n, a, b, c, normalize(cross(b - a, c - a)), two_sided, cuts);
  }
  return sum;
}

// Signed fans of triangles: their overlaps cancel.
double from_lights(const light::Lights& lights, double nits, Vec3d p, Vec3d n) {
  double sum = 0;
  for (const light::PolygonLight& light : lights.polygons) {
    double one = 0;
    for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
      const auto ring = light::ring_vertices(light, r);
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        one += irradiance(p, n, to_double(ring[0]), to_double(ring[i]), to_double(ring[i + 1]),
                          to_double(light.normal), light.two_sided, 8);
    }
    sum += one * double(light.radiance.x) / nits;
  }
  return sum;
}

double flux(const light::Lights& lights) {
  double sum = 0;
  for (const light::PolygonLight& light : lights.polygons)
    sum += double(light::flux_lumens(light).x);
  return sum;
}

TEST_CASE("nearly_coplanar_facets_are_joined_and_the_light_stays") {
  const scene::Mesh mesh = torus(220, 24); // 10,560 triangles
  REQUIRE(mesh.triangles.size() == 10560);
  const auto found = scene::emissive_lights(mesh, glowing(5), {});
  MESSAGE(found.lights.polygons.size(), " lights of ", mesh.triangles.size(), " triangles");
  CHECK(found.lights.polygons.size() < 1500);
  CHECK(found.triangles_without_area == 0);
  CHECK(flux(found.lights) == doctest::Approx(k_pi * 5 * area_of_mesh(mesh)).epsilon(2e-4));
  const scene::EmissiveOptions options;
  for (const auto& light : found.lights.polygons) {
    CHECK(light::validate(light).ok());
    CHECK(double(light.surface_deviation) <= options.join_distance * 3.8 + 1e-5);
    CHECK(double(light.radiance.x) <= 5 / std::cos(options.join_angle_rad) + 1e-4);
  }
  std::mt19937 random(4);
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 12; ++i) {
    const auto direction = [&] {
      return normalize(Vec3d(gauss(random), gauss(random), gauss(random)));
    };
    const Vec3d p = direction() * (i < 6 ? 2.2 : 8.0), n = direction() * 0.7 - normalize(p);
    const double truth = from_mesh(mesh, p, normalize(n), false, 2);
    CAPTURE(truth);
    CHECK(from_lights(found.lights, 5, p, normalize(n)) == doctest::Approx(truth).epsilon(0.006));
  }
}

TEST_CASE("few_facets_stay_as_they_are") {
  const scene::Mesh mesh = torus(8, 6);
  const auto found = scene::emissive_lights(mesh, glowing(5), {});
  double area = 0;
  for (const auto& light : found.lights.polygons) {
    area += light::area(light);
    CHECK(light.radiance.x == 5.0f);
  }
  CHECK(area == doctest::Approx(area_of_mesh(mesh)).epsilon(1e-5));
}

TEST_CASE("a_shallow_cone_with_a_hole_is_one_plate_with_a_hole") {
  // Its sides rise by 2 degrees, so no two of its 96 quads lie in one plane.
  const scene::Mesh mesh = surface(96, 1, [](double u, double v) {
    const double radius = 1 - 0.6 * v;
    return Vec3d(radius * std::cos(2 * k_pi * u), radius * std::sin(2 * k_pi * u), 0.035 * 0.6 * v);
  });
  scene::EmissiveOptions options;
  options.few_planes = 16;
  options.join_distance = 0.02;
  options.most_corners = 1000;
  for (const bool two_sided : {false, true}) {
    const auto found = scene::emissive_lights(mesh, glowing(1, two_sided), {}, options);
    REQUIRE(found.lights.polygons.size() == 1);
    const light::PolygonLight& light = found.lights.polygons[0];
    REQUIRE(light.ring_end.size() == 2);
    CHECK(light.two_sided == two_sided);
    CHECK(double(light.radiance.x) * light::area(light) ==
          doctest::Approx(area_of_mesh(mesh)).epsilon(2e-4));
    // The hole's outline is 0.4 from the axis.
    for (std::uint32_t i = light.ring_end[0]; i < light.ring_end[1]; ++i)
      CHECK(std::hypot(light.vertices[i].x, light.vertices[i].y) == doctest::Approx(0.4f));
  }
}

TEST_CASE("facets_of_unlike_emission_are_not_joined") {
  // An arc of 128 facets, each turned by 1.3 degrees, the left half of its texture dark red, the
  // right half bright.
  const scene::Mesh bent = surface(
      128, 1, [](double u, double v) { return Vec3d(std::sin(3 * u), v, std::cos(3 * u)); });
  scene::Mesh mesh = bent;
  for (std::uint32_t j = 0; j <= 1; ++j)
    for (std::uint32_t i = 0; i <= 128; ++i)
      mesh.tex_coord_0.push_back(Vec2f(float(i) / 128, 0.5f));
  scene::Texture texture;
  texture.nearest = true;
  image::Image picture(128, 1, 4);
  for (int x = 0; x < 128; ++x)
    for (int c = 0; c < 4; ++c)
      picture.pixel(x, 0)[c] = x < 64 ? (c == 0 ? 0.2f : 0.01f) : 1.0f;
  texture.image = picture;
  scene::Material material = glowing(10);
  material.emission_texture.texture = 0;
  const auto found = scene::emissive_lights(mesh, material, {texture});
  CHECK(found.lights.polygons.size() < 64);
  double dark = 0, bright = 0;
  for (const auto& light : found.lights.polygons) {
    const bool is_dark = light.radiance.x < 5;
    CHECK(double(light.radiance.x) == doctest::Approx(is_dark ? 2 : 10).epsilon(0.005));
    (is_dark ? dark : bright) += light::area(light) * double(light.radiance.x);
  }
  const double half = area_of_mesh(mesh) / 2;
  CHECK(dark == doctest::Approx(2 * half).epsilon(1e-3));
  CHECK(bright == doctest::Approx(10 * half).epsilon(1e-3));
}

TEST_CASE("a_fine_disk_is_a_few_lights_of_few_corners") {
  constexpr std::uint32_t corners = 40000;
  const scene::Mesh mesh = test::disk_mesh(corners);
  const auto found = scene::emissive_lights(mesh, glowing(3), {});
  std::size_t vertices = 0;
  for (const auto& light : found.lights.polygons) {
    CHECK(light.vertices.size() <= scene::EmissiveOptions().most_corners);
    vertices += light.vertices.size();
  }
  MESSAGE(found.lights.polygons.size(), " lights, ", vertices, " corners");
  CHECK(vertices < 400);
  CHECK(flux(found.lights) == doctest::Approx(k_pi * 3 * k_pi).epsilon(1e-4));
  for (const Vec3d p : {Vec3d(0.3, 0.2, 0.4), Vec3d(1.2, 0, 0.3), Vec3d(0, -3, 2)}) {
    // Towards a coaxial disk the irradiance on a parallel surface is known off the axis as well:
    // E = pi/2 L (1 + (1 - h^2 - d^2) / sqrt((1 + h^2 + d^2)^2 - 4 d^2)), radius 1.
    const double h2 = p.z * p.z, d2 = p.x * p.x + p.y * p.y, s = 1 + h2 + d2;
    const double truth = k_pi / 2 * (1 + (1 - h2 - d2) / std::sqrt(s * s - 4 * d2));
    CHECK(from_lights(found.lights, 3, p, Vec3d(0, 0, -1)) == doctest::Approx(truth).epsilon(0.02));
  }
}

// Rectangles of sides 2 half and 2 half * aspect, turned, in z = 0.
struct Square {
  double x, y, c, s;
  bool holds(double px, double py, double half, double aspect = 1) const {
    return std::abs((px - x) * c + (py - y) * s) <= half &&
           std::abs((py - y) * c - (px - x) * s) <= half * aspect;
  }
};

std::vector<Square> random_squares(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return double(random()) / 4294967296.0; };
  std::vector<Square> squares;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = k_pi * uniform();
    squares.push_back({2 * uniform() - 1, 2 * uniform() - 1, std::cos(angle), std::sin(angle)});
  }
  return squares;
}

scene::Mesh mesh_of(const std::vector<Square>& squares, double half, double aspect = 1) {
  scene::Mesh mesh;
  mesh.name = "heap";
  for (const Square& q : squares) {
    const std::uint32_t first = std::uint32_t(mesh.positions.size());
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      mesh.positions.push_back(Vec3f(float(q.x + half * (u * q.c - aspect * v * q.s)),
                                     float(q.y + half * (u * q.s + aspect * v * q.c)), 0));
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  mesh.normals.assign(mesh.positions.size(), Vec3f(0, 0, 1));
  return mesh;
}

// Area of the union by counting on a grid.
double union_area(const std::vector<Square>& squares, double half, double aspect = 1) {
  constexpr int n = 1500;
  std::vector<bool> covered(std::size_t(n) * n);
  const double extent = 1 + 1.5 * half, step = 2 * extent / n;
  for (const Square& q : squares) {
    const double reach_x = half * (std::abs(q.c) + aspect * std::abs(q.s));
    const double reach_y = half * (std::abs(q.s) + aspect * std::abs(q.c));
    const auto range = [&](double middle, double reach, int& from, int& to) {
      from = std::max(int((middle - reach + extent) / step), 0);
      to = std::min(int((middle + reach + extent) / step) + 1, n);
    };
    int x0, x1, y0, y1;
    range(q.x, reach_x, x0, x1);
    range(q.y, reach_y, y0, y1);
    for (int j = y0; j < y1; ++j)
      for (int i = x0; i < x1; ++i)
        if (q.holds(-extent + (i + 0.5) * step, -extent + (j + 0.5) * step, half, aspect))
          covered[std::size_t(j) * n + std::size_t(i)] = true;
  }
  return double(std::count(covered.begin(), covered.end(), true)) * step * step;
}

TEST_CASE("what_overlaps_in_a_plane_shines_once") {
  for (const std::size_t count : {2u, 5u, 30u, 200u}) {
    CAPTURE(count);
    const double half = 0.18;
    const std::vector<Square> squares = random_squares(count, 11);
    const auto found = scene::emissive_lights(mesh_of(squares, half), glowing(1), {});
    CHECK(!found.is_tangled);
    CHECK(flux(found.lights) == doctest::Approx(k_pi * union_area(squares, half)).epsilon(0.004));
    // No place lies in two lights or two rings: at most one winding anywhere.
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
      const double x = double(random()) / 2147483648.0 - 1, y = double(random()) / 2147483648.0 - 1;
      int winding = 0;
      for (const auto& light : found.lights.polygons)
        for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
          const auto ring = light::ring_vertices(light, r);
          for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec3d a = to_double(ring[k]), b = to_double(ring[(k + 1) % ring.size()]);
            const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
            if (a.y <= y && b.y > y && side > 0) ++winding;
            if (b.y <= y && a.y > y && side < 0) --winding;
          }
        }
      const bool is_covered = std::any_of(squares.begin(), squares.end(),
                                          [&](const Square& q) { return q.holds(x, y, half); });
      CHECK(winding == (is_covered ? 1 : 0));
    }
  }
}

TEST_CASE("ten_thousand_overlapping_squares_and_a_heap_of_needles_shine_as_their_union") {
  struct Case {
    std::size_t count;
    double half, aspect;
    bool is_tangled;
  };
  // Each of the needles crosses most of the others: their union is too much to cut out.
  for (const Case& c : {Case{10000, 0.05, 1, false}, Case{600, 1, 0.004, true}}) {
    CAPTURE(c.count);
    const std::vector<Square> squares = random_squares(c.count, 12);
    const auto found = scene::emissive_lights(mesh_of(squares, c.half, c.aspect), glowing(2), {});
    CHECK(found.is_tangled == c.is_tangled);
    CHECK(found.pictures.size() == (c.is_tangled ? 1u : 0u));
    CHECK(found.lights.polygons.size() < 2000);
    double lumens = flux(found.lights);
    if (c.is_tangled) {
      REQUIRE(found.lights.polygons.size() == 1);
      CHECK(found.lights.polygons[0].texture == 0);
      lumens *= double(light::mean_of_texture(found.lights.polygons[0], found.pictures).x);
    }
    CHECK(lumens ==
          doctest::Approx(2 * k_pi * union_area(squares, c.half, c.aspect)).epsilon(0.006));
  }
}

TEST_CASE("rings_that_do_not_overlap_are_told_from_those_that_do") {
  const auto square = [](double x, double y, double half, bool clockwise) {
    scene::Ring ring = {Vec3d(x - half, y - half, 0), Vec3d(x + half, y - half, 0),
                        Vec3d(x + half, y + half, 0), Vec3d(x - half, y + half, 0)};
    if (clockwise) std::reverse(ring.begin(), ring.end());
    return ring;
  };
  const Vec3d up(0, 0, 1);
  const auto twice = [&](std::vector<scene::Ring> rings) {
    return scene::covers_twice(rings, up, 1e-6);
  };
  CHECK(!twice({square(0, 0, 1, false)}));
  CHECK(!twice({square(0, 0, 1, false), square(3, 0, 1, false)}));
  CHECK(!twice({square(0, 0, 1, false), square(2, 0, 1, false)}));  // side by side
  CHECK(!twice({square(0, 0, 1, false), square(0, 0, 0.5, true)})); // a hole
  CHECK(!twice({square(0, 0, 1, false), square(0, 0, 0.5, true), square(0, 0, 0.25, false)}));
  CHECK(twice({square(0, 0, 1, false), square(0, 0, 0.5, false)})); // one in the other
  CHECK(twice({square(0, 0, 1, false), square(1, 1, 1, false)}));
}

} // namespace
