// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The light that shader files compute, against the same source in double precision, whose quads
// take another way: they are clipped as a whole.

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/api/ggx_two_lobe_polynomial.inc"
#include "openltc/api/polygon_packing.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"
#include "tests/shaders/metal/metal_case.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace openltc;
using testing::Random;

namespace {

using Numbers = std::array<float, 3>;

void store(Vec3d v, float* out) {
  out[0] = float(v.x);
  out[1] = float(v.y);
  out[2] = float(v.z);
}

Vec3d load(const float* p) { return {double(p[0]), double(p[1]), double(p[2])}; }
Vec3f load_float(const float* p) { return {p[0], p[1], p[2]}; }

// Mip levels of a picture by means of four, as an engine would make them.
struct Mips {
  std::vector<float> texels;
  std::vector<std::int32_t> layout;
  std::vector<metal_run::Level> levels;

  explicit Mips(int side) {
    Random random(5);
    for (int i = 0; i < side * side; ++i)
      texels.insert(texels.end(), {float(random.uniform()), i % side < side / 2 ? 1.0f : 0.1f,
                                   float(i / side) / float(side), 1.0f});
    std::size_t before = 0;
    add_layout(0, side);
    for (int columns = side / 2; columns >= 1; columns /= 2) {
      const std::size_t first = texels.size();
      for (int y = 0; y < columns; ++y)
        for (int x = 0; x < columns; ++x)
          for (int channel = 0; channel < 4; ++channel) {
            const auto at = [&](int dx, int dy) {
              return texels[before + 4 * std::size_t((2 * y + dy) * 2 * columns + 2 * x + dx) +
                            std::size_t(channel)];
            };
            texels.push_back(0.25f * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
          }
      add_layout(first / 4, columns);
      before = first;
    }
    for (std::size_t i = 0; i < layout.size(); i += 4)
      levels.push_back({layout[i + 1], layout[i + 2], texels.data() + 4 * layout[i]});
  }

private:
  void add_layout(std::size_t first, int columns) {
    layout.insert(layout.end(), {std::int32_t(first), columns, columns, 0});
  }
};

// A polygon's elements as the shader files want them.
std::vector<float> elements_of(const PackedPolygon& packed) {
  const PolygonView& v = packed.view;
  std::vector<float> out = {float(v.point_count), v.two_sided ? 1.0f : 0.0f, v.area, 0.0f};
  const auto add = [&](const float* p, float w) { out.insert(out.end(), {p[0], p[1], p[2], w}); };
  add(v.origin, 0);
  add(v.axis_u, 0);
  add(v.axis_v, 0);
  add(v.normal, 0);
  add(v.centroid, v.radius);
  add(v.spread_u, 0);
  add(v.spread_v, 0);
  out.insert(out.end(), packed.points.begin(), packed.points.end());
  return out;
}

/// A point under a light at random, and what its light is.
struct Sample {
  metal_run::Case at;
  PackedPolygon packed;
  std::vector<float> elements;
};

Vec3d unit(Vec3d v) { return v * (1.0 / std::sqrt(dot(v, v))); }

// A frame, and a light of about `size` at `place`.
void place_light(Random& random, Sample& sample, Vec3d place, double size) {
  metal_run::Case& at = sample.at;
  const Vec3d u = unit(random.sphere());
  const Vec3d v = unit(cross(u, random.sphere()));
  float* l = at.light;
  store(place, l);
  const float two_sided = random.uniform() < 0.5 ? 1.0f : 0.0f;
  switch (at.shape) {
  case metal_run::k_quad:
  case metal_run::k_textured:
    store(u * size, l + 3);
    // Pictures want right angles.
    store((at.shape == metal_run::k_quad ? unit(v + u * random.uniform(-0.5, 0.5)) : v) * size *
              random.uniform(0.3, 1.0),
          l + 6);
    l[9] = two_sided;
    break;
  case metal_run::k_polygon: {
    // An L with a hole.
    const double outline[][2] = {{-1, -1}, {1, -1},      {1, 0},       {0, 0},       {0, 1},
                                 {-1, 1},  {-0.8, -0.8}, {-0.8, -0.4}, {-0.4, -0.4}, {-0.4, -0.8}};
    std::vector<Vec3f> vertices;
    for (const auto& p : outline) {
      float vertex[3];
      store(place + u * (p[0] * size) + v * (p[1] * size), vertex);
      vertices.push_back(load_float(vertex));
    }
    const Vec3d n = cross(u, v);
    sample.packed =
        pack_polygon(vertices, {6, 10}, Vec3f(float(n.x), float(n.y), float(n.z)), two_sided > 0);
    sample.elements = elements_of(sample.packed);
    break;
  }
  case metal_run::k_disk:
    store(u, l + 3);
    l[6] = float(size);
    l[7] = two_sided;
    break;
  case metal_run::k_sphere:
    l[3] = float(size);
    break;
  default: // tubes and lines
    store(place + u * (2 * size), l + 3);
    l[6] = float(size * random.uniform(0.05, 0.5));
    l[7] = float(random.integer(3));
  }
}

Sample make_sample(Random& random, metal_run::Shape shape) {
  Sample sample{};
  metal_run::Case& at = sample.at;
  at.shape = shape;
  const Vec3d normal = unit(random.sphere());
  Vec3d view = unit(random.sphere());
  while (dot(view, normal) < 0.05)
    view = unit(random.sphere());
  const Vec3d position = random.sphere() * random.uniform(0.0, 3.0);
  store(position, at.position);
  store(normal, at.normal);
  store(view, at.view);
  for (float& c : at.base_color)
    c = float(random.uniform(0.1, 0.9));
  at.metallic = random.uniform() < 0.5 ? 0.0f : float(random.uniform());
  at.roughness = float(random.uniform(0.15, 1.0));
  at.corrected = random.uniform() < 0.5;
  at.tilted = random.uniform() < 0.25;
  Vec3d geometric = unit(normal + random.sphere() * 0.4);
  if (dot(geometric, view) < 0.02) at.tilted = false;
  store(geometric, at.geometric);
  // From small to large against the distance, above, across and below the horizon.
  Vec3d direction = unit(random.sphere());
  if (dot(direction, normal) < -0.1) direction = direction * -1.0;
  const double distance = random.log_uniform(0.3, 5);
  place_light(random, sample, position + direction * distance,
              distance * random.log_uniform(0.01, 0.8));
  return sample;
}

enum class Lobes { polynomial, two_lobe_polynomial, two_lobe_table };

LobePolynomialView polynomial_of(Lobes lobes) {
  LobePolynomialView view;
  const bool two = lobes == Lobes::two_lobe_polynomial;
  view.coefficients = two ? k_ggx_two_lobe_polynomial : k_ggx_polynomial;
  view.degree = two ? k_ggx_two_lobe_polynomial_degree : k_ggx_polynomial_degree;
  if (two) view.second = k_ggx_two_lobe_polynomial_second;
  return view;
}

f64::Surface surface_of(const metal_run::Case& at, Lobes lobes) {
  const double roughness = double(at.roughness), metallic = double(at.metallic);
  const Vec3d n = load(at.normal), wo = load(at.view), base = load(at.base_color);
  const LobePolynomialView polynomial = polynomial_of(lobes);
  const LobeTableView table = table::builtin_ggx_two_lobe_table().view();
  const bool from_table = lobes == Lobes::two_lobe_table;
  const Vec3d f0 = Vec3d(0.04) * (1 - metallic) + base * metallic;
  const double cosine = dot(n, wo), alpha = f64::alpha_from_roughness(roughness);
  const f64::FittedLobe fitted = from_table ? f64::fetch_lobe_of_roughness(table, roughness, cosine)
                                            : f64::eval_lobe_polynomial(polynomial, alpha, cosine);
  f64::Surface s = f64::make_surface(fitted, load(at.position), n, wo, base * (1 - metallic), f0,
                                     Vec3d(1.0), roughness);
  if (from_table)
    s = f64::add_second_lobe(s, f64::fetch_second_lobe_of_roughness(table, roughness, cosine));
  if (lobes == Lobes::two_lobe_polynomial)
    s = f64::add_second_lobe(s, f64::eval_second_lobe_polynomial(polynomial, alpha, cosine));
  if (at.tilted) s = f64::set_geometric_normal(s, load(at.geometric));
  return at.corrected ? f64::correct_at_mean(s) : s;
}

PackedPolygon corners_of(const metal_run::Case& at) {
  const Vec3f c = load_float(at.light), u = load_float(at.light + 3), v = load_float(at.light + 6);
  return pack_polygon({c - u - v, c + u - v, c + u + v, c - u + v}, {4}, normalize(cross(u, v)),
                      at.light[9] > 0);
}

// Of a picture: each part times its mean as each lobe sees it (docs/lights.md).
Vec3d textured_light(const f64::Surface& s, const metal_run::Case& at, const Mips& mips) {
  const PackedPolygon quad = corners_of(at);
  EmissionTextureView view;
  view.texels = mips.texels.data();
  view.levels = mips.layout.data();
  view.level_count = int(mips.levels.size());
  const Vec3d c = load(at.light), u = load(at.light + 3), v = load(at.light + 6);
  store(c - u - v, view.corner);
  store(unit(u), view.axis_u);
  store(unit(v), view.axis_v);
  view.extent[0] = float(2 * std::sqrt(dot(u, u)));
  view.extent[1] = float(2 * std::sqrt(dot(v, v)));
  const f64::LightIntegral integral = f64::surface_polygon_integral(s, quad.view);
  const f64::ShadedLight shaded = f64::shade_integral(s, integral);
  const Vec3d front = f64::front_shading(s);
  const auto seen = [&](const f64::Lobe& lobe, Vec3d mean) {
    return f64::emission_seen_part(view, s.position, s.frame, lobe, mean, front, s.tilted);
  };
  Vec3d specular = seen(s.fitted.lobe, integral.specular_direction);
  if (s.two) {
    const double a = integral.specular * s.inv_share, b = integral.second * s.second_inv_share;
    const double inv = 1 / std::max(a + b, 1e-30);
    specular = seen(s.fitted.lobe, integral.first_direction) * (a * inv) +
               seen(s.second, integral.second_direction) * (b * inv);
  }
  return shaded.diffuse * seen(f64::cosine_lobe(), integral.diffuse_direction) +
         shaded.specular * specular;
}

f64::ShadedLight expected_light(const f64::Surface& s, const Sample& sample, const Mips& mips) {
  const metal_run::Case& at = sample.at;
  const float* l = at.light;
  switch (at.shape) {
  case metal_run::k_quad:
    return f64::shade_polygon_parts(s, corners_of(at).view);
  case metal_run::k_polygon:
    return f64::shade_polygon_parts(s, sample.packed.view);
  case metal_run::k_disk: {
    const Vec3d n = load(l + 3), u = f64::any_perpendicular(n);
    return f64::shade_ellipse_parts(
        s, {load(l), u * double(l[6]), cross(n, u) * double(l[6]), double(l[7])});
  }
  case metal_run::k_sphere:
    return f64::shade_sphere_parts(s, {load(l), double(l[3])});
  case metal_run::k_tube:
    return f64::shade_tube_parts(s, {load(l), load(l + 3), double(l[6]), double(l[7])});
  case metal_run::k_line:
    return f64::shade_line_parts(s, {load(l), load(l + 3)});
  default:
    return {textured_light(s, at, mips), Vec3d(0.0)};
  }
}

// The textures of a table, as the shader files want them.
struct TableTextures {
  std::vector<float> coefficients, amplitudes, second;
  metal_run::Level levels[3];

  explicit TableTextures(const LobeTableView& table) {
    for (int i = 0; i < table.columns * table.rows; ++i) {
      const float* t = table.texels + 8 * i;
      coefficients.insert(coefficients.end(), t, t + 4);
      amplitudes.insert(amplitudes.end(), t + 4, t + 8);
      second.insert(second.end(), table.second + 4 * i, table.second + 4 * i + 4);
    }
    levels[0] = {table.columns, table.rows, coefficients.data()};
    levels[1] = {table.columns, table.rows, amplitudes.data()};
    levels[2] = {table.columns, table.rows, second.data()};
  }
};

struct Errors {
  double mean = 0, worst = 0;
  int lit = 0;
};

metal_run::Light light_of(const metal_run::Case& at, Lobes lobes, const TableTextures& textures) {
  if (lobes == Lobes::polynomial) return metal_run::shade_by_polynomial(at);
  if (lobes == Lobes::two_lobe_polynomial) return metal_run::shade_by_two_lobe_polynomial(at);
  return metal_run::shade_by_two_lobes(at, {&textures.levels[0], 1}, {&textures.levels[1], 1},
                                       {&textures.levels[2], 1});
}

// Of what the file says, relative to the light, or to a thousandth where there is less.
Errors errors_of(metal_run::Shape shape, Lobes lobes) {
  constexpr int k_samples = 1500;
  constexpr const char* k_names[] = {"quad", "polygon", "disk",    "sphere",
                                     "tube", "line",    "textured"};
  constexpr const char* k_lobes[] = {"polynomial", "two-lobe polynomial", "two-lobe table"};
  Random random(std::uint64_t(shape) + 1);
  const Mips mips(32);
  const TableTextures textures(table::builtin_ggx_two_lobe_table().view());
  Errors errors;
  for (int i = 0; i < k_samples; ++i) {
    Sample sample = make_sample(random, shape);
    sample.at.polygon = sample.elements.data();
    sample.at.picture = {mips.levels.data(), int(mips.levels.size())};
    const metal_run::Light light = light_of(sample.at, lobes, textures);
    const f64::ShadedLight expected = expected_light(surface_of(sample.at, lobes), sample, mips);
    const Vec3d sum = expected.diffuse + expected.specular;
    const double scale = std::max({sum.x, sum.y, sum.z, 1e-3});
    const Vec3d off = load(light.diffuse) - expected.diffuse;
    const Vec3d off_too = load(light.specular) - expected.specular;
    double error = 0;
    for (const double e : {off.x, off.y, off.z, off_too.x, off_too.y, off_too.z})
      error = std::max(error, std::isfinite(e) ? std::abs(e) / scale : 1e9);
    errors.mean += error / k_samples;
    errors.worst = std::max(errors.worst, error);
    if (sum.y > 1e-3) ++errors.lit;
  }
  MESSAGE(fmt::format("{}, {}: mean {:.2g}, worst {:.2g}, lit {}", k_names[shape],
                      k_lobes[int(lobes)], errors.mean, errors.worst, errors.lit));
  return errors;
}

} // namespace

TEST_CASE("shader files compute the light of the source in double precision") {
  for (int shape = 0; shape < metal_run::k_shapes; ++shape)
    for (const Lobes lobes :
         {Lobes::polynomial, Lobes::two_lobe_polynomial, Lobes::two_lobe_table}) {
      const Errors errors = errors_of(metal_run::Shape(shape), lobes);
      CHECK(errors.mean < 1e-5);
      CHECK(errors.worst < 2e-3);
      CHECK(errors.lit > 300); // or the test sees nothing
    }
}
