// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What bounds of lights promise: no point reflects more of a light, or of lights together, than its
// bound.

#include "openltc/light/packed_polygon.h"
#include "openltc/light/shapes.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/lights/light_tree.h"
#include "openltc/render/point_buffer.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f64.h"
#include "tests/render/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace openltc;
using test::Random;

namespace {

light::PolygonLight random_panel(Random& random, Vec3f around, float apart) {
  const Vec3f n = random.direction();
  const Vec3f t = normalize(cross(n, std::abs(n.y) < 0.9f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0)));
  const float size = std::exp(random(-4, 1));
  light::PolygonLight light = light::rectangle(around + random.in_box(apart), t * size,
                                               cross(n, t) * (size * random(0.1f, 1)),
                                               Vec3f(random(0, 1), 1, random(0, 5)));
  light.two_sided = random(0, 1) < 0.1f;
  return light;
}

/// Surface points as a tile may have them: near each other or not, alike or not.
std::vector<render::SurfacePoint> random_points(Random& random) {
  const float apart = std::exp(random(-6, 1.5f)), turned = std::exp(random(-6, 1));
  const float roughness = random(0, 1), mixed = random(0, 1) < 0.3f ? 0.3f : 0.01f;
  const Vec3f normal = random.direction();
  Vec3f view = random.direction();
  if (dot(view, normal) < 0) view = -view;
  if (random(0, 1) < 0.2f) view = normalize(normal + random.in_box(0.01f)); // frames of any azimuth
  const bool metal = random(0, 1) < 0.5f;
  const bool smooth = random(0, 1) < 0.5f; // shading normals that are not the triangles'
  const float bent = std::exp(random(-6, 0));
  std::vector<render::SurfacePoint> points(40);
  for (render::SurfacePoint& p : points) {
    p.position = random.in_box(apart);
    p.normal = p.geometric = normalize(normal + random.in_box(turned));
    p.view = normalize(view + random.in_box(std::min(turned, 0.3f)));
    if (dot(p.view, p.normal) < 0.01f) p.normal = p.geometric = p.view;
    const Vec3f triangle = normalize(p.normal + random.in_box(bent));
    if (smooth && dot(p.view, triangle) > 0) p.geometric = triangle;
    p.albedo = metal ? Vec3f(0) : Vec3f(random(0, 1), 0.5f, random(0, 1));
    p.f0 = metal ? Vec3f(random(0.5f, 1), 0.8f, 0.9f) : Vec3f(0.04f);
    p.roughness = std::clamp(roughness + random(-mixed, mixed), 0.0f, 1.0f);
  }
  return points;
}

const table::LobeTable& table_of(bool two) {
  return two ? table::builtin_ggx_two_lobe_table() : table::builtin_ggx_table();
}

f64::Surface surface_f64(const render::SurfacePoint& p, bool two) {
  const f64::Vec3 normal = normalize(to_double(p.normal)), view = normalize(to_double(p.view));
  const double f90 = double(p.f90);
  const LobeTableView table = table_of(two).view();
  const double roughness = double(p.roughness), cos_theta = dot(normal, view);
  f64::Surface s = f64::make_surface(f64::fetch_lobe_of_roughness(table, roughness, cos_theta),
                                     to_double(p.position), normal, view, to_double(p.albedo),
                                     to_double(p.f0), {f90, f90, f90}, roughness);
  if (two)
    s = f64::add_second_lobe(s, f64::fetch_second_lobe_of_roughness(table, roughness, cos_theta));
  return f64::set_geometric_normal(s, normalize(to_double(p.geometric)));
}

/// What a point reflects of polygon lights, in double precision.
f64::Vec3 reflected(const f64::Surface& s, const std::vector<light::PackedPolygon>& lights,
                    const std::vector<light::PolygonLight>& sources) {
  f64::Vec3 sum(0.0);
  for (std::size_t i = 0; i < lights.size(); ++i)
    sum += f64::shade_polygon(s, lights[i].view) * to_double(sources[i].radiance);
  return sum;
}

/// Coefficients of (n.(d + t e))(m.(d + t e)) / |d + t e|^4 at t^0 to t^2, from the series of each
/// factor: that of |d + t e|^-4 has -4 (d.e) and 12 (d.e)^2 - 2 |d|^2 |e|^2 in it.
std::array<double, 3> patch_series(Vec3d n, Vec3d m, Vec3d d, Vec3d e) {
  const double d2 = dot(d, d), de = dot(d, e) / d2, e2 = dot(e, e) / d2;
  const double nd = dot(n, d), ne = dot(n, e), md = dot(m, d), me = dot(m, e);
  const double s1 = -4 * de, s2 = 12 * de * de - 2 * e2;
  const double scale = 1 / (d2 * d2);
  return {nd * md * scale, (nd * me + ne * md + nd * md * s1) * scale,
          (ne * me + (nd * me + ne * md) * s1 + nd * md * s2) * scale};
}

/// The far form in double precision, written anew: up to second order in the places of the lights,
/// in the surface's space and in the lobe's. There a vector e goes to M^-1 e and an area vector m
/// to det M^T m.
f64::Vec3 far_reflected(const f64::Surface& s, const render::FarLight& far, bool specular,
                        bool plain) {
  const Vec3d d = to_double(far.center) - s.position;
  if (dot(s.frame.n, d) <= 0 || (s.tilted && dot(s.geometric, d) <= 0)) return f64::Vec3(0.0);
  const f64::Lobe lobe = s.fitted.lobe;
  const auto cosine_space = [&](Vec3d v) {
    return f64::to_cosine(lobe, f64::to_shading(s.frame, v));
  };
  // M from the columns of M^-1, by cross products.
  const Vec3d columns[3] = {{lobe.m00, 0, lobe.m20}, {0, 1, 0}, {lobe.m02, 0, lobe.m22}};
  const Vec3d rows[3] = {cross(columns[1], columns[2]), cross(columns[2], columns[0]),
                         cross(columns[0], columns[1])}; // of det M
  const auto area = [&](Vec3d m) {
    const f64::Vec3 v = f64::to_shading(s.frame, m);
    return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z; // det M^T v
  };
  // Steps whose products add up to the covariance, by Cholesky.
  const float* c = far.covariance;
  double l[3][3] = {};
  const double a[3][3] = {{c[0], c[5], c[4]}, {c[5], c[1], c[3]}, {c[4], c[3], c[2]}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) {
      double v = a[i][j];
      for (int k = 0; k < j; ++k)
        v -= l[i][k] * l[j][k];
      if (i == j)
        l[i][i] = v > 1e-7 * a[i][i] ? std::sqrt(v) : 0;
      else
        l[i][j] = l[j][j] > 0 ? v / l[j][j] : 0;
    }
  const float share[3] = {far.channel.x, far.channel.y, far.channel.z};
  const auto sum = [&](int channel, const auto& value) {
    const Vec3d m = to_double(far.moment[channel]);
    double total = value(m, Vec3d(0.0))[0];
    if (plain) return std::max(-total, 0.0);
    const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < 3; ++k) {
      total += value(to_double(far.first[k]) * double(share[channel]), axes[k])[1];
      total += value(m, Vec3d(l[0][k], l[1][k], l[2][k]))[2];
    }
    return std::max(-total, 0.0);
  };
  const Vec3d z(0, 0, 1), o = cosine_space(d);
  const double pi = 3.14159265358979;
  const f64::Vec3 fresnel =
      s.f0 + (s.f90 - s.f0) * f64::fresnel_weight(s.wo, f64::to_shading(s.frame, normalize(d)));
  double diffuse[3], lobe_light[3];
  for (int channel = 0; channel < 3; ++channel) {
    diffuse[channel] =
        sum(channel, [&](Vec3d m, Vec3d e) { return patch_series(s.frame.n, m, d, e); }) / pi;
    lobe_light[channel] =
        specular && o.z > 0
            ? sum(channel,
                  [&](Vec3d m, Vec3d e) { return patch_series(z, area(m), o, cosine_space(e)); }) *
                  s.fitted.n1 * s.inv_share / pi
            : 0;
  }
  return s.diffuse * f64::Vec3(diffuse[0], diffuse[1], diffuse[2]) +
         fresnel * f64::Vec3(lobe_light[0], lobe_light[1], lobe_light[2]);
}

double largest(f64::Vec3 v) { return std::max({v.x, v.y, v.z}); }
double largest_size(f64::Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

render::TreeLight tree_light_of(const light::PolygonLight& light) {
  return render::tree_light(light, light::pack_polygon(light));
}

render::BatchBounds measured(const std::vector<render::SurfacePoint>& points,
                             render::SpecularForm form = render::SpecularForm::lobe,
                             bool two = false) {
  render::PointBuffer buffer(64);
  for (const render::SurfacePoint& p : points)
    buffer.add(p, {});
  render::KernelContext context;
  context.table = table_of(two).view();
  context.specular_form = form;
  return buffer.measure(render::best_kernel(), context, buffer.all());
}

} // namespace

TEST_CASE(
    "no point reflects more of a light, or of a group, than their bound; nor errs the far form") {
  Random random(1);
  int informative = 0, far_forms = 0;
  for (int round = 0; round < 1500; ++round) {
    const std::vector<render::SurfacePoint> points = random_points(random);
    const bool two = round % 3 == 0; // lobes
    const render::BatchBounds bounds = measured(points, render::SpecularForm::lobe, two);
    const Vec3f around = random.direction() * std::exp(random(-1, 4));
    const int count = round % 2 ? 1 : 1 + int(random(0, 6));
    std::vector<light::PolygonLight> lights;
    std::vector<light::PackedPolygon> packed;
    std::vector<render::TreeLight> tree_lights;
    const float apart = std::exp(random(-3, 1));
    const bool one_sided = random(0, 1) < 0.8f;
    for (int i = 0; i < count; ++i) {
      light::PolygonLight light = random_panel(random, around, apart);
      if (one_sided) light.two_sided = false;
      lights.push_back(light);
      packed.push_back(light::pack_polygon(light));
      tree_lights.push_back(render::tree_light(light, packed.back()));
    }
    const render::TreeLight group = render::united(tree_lights);
    const render::LightBound bound =
        render::bound_light(render::PreparedBatch(bounds), group.extent, group.far_error);
    if (bound.all < 0.1f) ++informative;
    if (two) CHECK_FALSE(bound.far_specular);
    if (bound.far_error < bound.all) ++far_forms;
    for (std::size_t p = 0; p < points.size(); p += 4) {
      const f64::Surface s = surface_f64(points[p], two);
      const f64::Vec3 truth = reflected(s, packed, lights);
      CAPTURE(round);
      CHECK(largest(truth) <= double(bound.all) + 1e-7);
      if (bound.all == 0) continue; // nothing to have a form for
      if (bound.far_error < render::k_unbounded)
        CHECK(largest_size(far_reflected(s, group.far, bound.far_specular, false) - truth) <=
              double(bound.far_error) + 1e-7);
      if (bound.plain_error < render::k_unbounded)
        CHECK(largest_size(far_reflected(s, group.far, bound.far_specular, true) - truth) <=
              double(bound.plain_error) + 1e-7);
    }
  }
  // The bound must also say something.
  CHECK(informative > 300);
  CHECK(far_forms > 100);
}

TEST_CASE("no point reflects more of a light of any shape than its bound") {
  Random random(2);
  for (int round = 0; round < 1500; ++round) {
    light::Lights lights;
    const Vec3f at = random.direction() * std::exp(random(-1, 3));
    const Vec3f n = random.direction();
    const Vec3f t = normalize(cross(n, std::abs(n.y) < 0.9f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0)));
    const float size = std::exp(random(-4, 1));
    const Vec3f radiance(random(0, 1), 1, random(0, 5));
    const float power = random(0, 1) < 0.5f ? 0 : random(0, 30);
    if (round % 4 == 0) {
      light::EllipseLight light;
      light.center = at;
      light.half_u = t * size;
      light.half_v = cross(n, t) * (size * random(0.1f, 1));
      light.two_sided = random(0, 1) < 0.3f;
      lights.ellipses = {light};
    } else if (round % 4 == 1) {
      light::SphereLight light;
      light.center = at;
      light.radius = size;
      lights.spheres = {light};
    } else if (round % 4 == 2) {
      light::TubeLight light;
      light.from = at;
      light.to = at + t * random(0.1f, 3);
      light.radius = 0.3f * size;
      light.caps = light::TubeCaps(round / 4 % 3);
      lights.tubes = {light};
    } else {
      light::LineLight light;
      light.from = at;
      light.to = at + t * random(0.1f, 3);
      light.intensity_per_metre = radiance;
      lights.lines = {light};
    }
    const auto shine = [&](light::Emitter& light) {
      light.radiance = radiance;
      light.cosine_power = power;
    };
    for (auto& l : lights.ellipses)
      shine(l);
    for (auto& l : lights.spheres)
      shine(l);
    for (auto& l : lights.tubes)
      shine(l);
    const render::LightSet set = render::pack_lights(lights);
    REQUIRE(set.area_lights.size() == 1);

    const std::vector<render::SurfacePoint> points = random_points(random);
    render::PointBuffer buffer(64);
    for (std::size_t i = 0; i < points.size(); ++i) {
      render::PointTarget target;
      target.sample = std::uint32_t(i);
      buffer.add(points[i], target);
    }
    const bool two = round / 4 % 3 == 0; // lobes
    render::KernelContext context;
    context.table = table_of(two).view();
    context.area_lights = set.area_lights.data();
    context.area_light_count = 1;
    const render::SpecularForm forms[] = {render::SpecularForm::lobe, render::SpecularForm::ratio,
                                          render::SpecularForm::exact,
                                          render::SpecularForm::adaptive};
    context.specular_form = forms[round / 4 % 4];
    std::vector<Vec3f> out(points.size(), Vec3f(0));
    std::vector<float> no_ratio;
    const render::BatchBounds bounds = measured(points, context.specular_form, two);
    buffer.shade(render::best_kernel(), context, out, no_ratio, 1);
    const float bound =
        render::bound_light(render::PreparedBatch(bounds), set.tree_lights.front().extent,
                            set.tree_lights.front().far_error)
            .all;
    CAPTURE(round);
    for (const Vec3f& v : out)
      CHECK(std::max({v.x, v.y, v.z}) <= bound * 1.001f + 1e-6f);
  }
}

TEST_CASE("a light behind all points, or facing away from them, adds nothing for certain") {
  std::vector<render::SurfacePoint> points(16);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].position = {0.1f * float(i), 0, 0};
    points[i].normal = points[i].geometric = {0, 1, 0};
    points[i].view = normalize(Vec3f(0.1f, 1, 0.3f));
    points[i].albedo = Vec3f(0.5f);
    points[i].f0 = Vec3f(0.04f);
  }
  const auto bound_of = [&](Vec3f center, Vec3f right, Vec3f up) {
    const render::TreeLight light = tree_light_of(light::rectangle(center, right, up, Vec3f(100)));
    const render::BatchBounds bounds = measured(points);
    return render::bound_light(render::PreparedBatch(bounds), light.extent, light.far_error).all;
  };
  CHECK(bound_of({0, 3, 0}, {1, 0, 0}, {0, 0, 1}) > 0);  // shines down
  CHECK(bound_of({0, 3, 0}, {0, 0, 1}, {1, 0, 0}) == 0); // shines up
  CHECK(bound_of({0, -3, 0}, {0, 0, 1}, {1, 0, 0}) == 0);
}
