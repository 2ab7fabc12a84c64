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
#include "tests/shaders/light_sample.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::testing;

namespace {

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

f64::ShadedLight expected_light(const f64::Surface& s, const LightSample& sample,
                                const Mips& mips) {
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
    LightSample sample = make_light_sample(random, shape);
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
