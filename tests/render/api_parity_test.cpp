// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The public API (openltc/openltc.h) and the renderer shade alike: the kernel without lanes, to the
// bit.

#include "openltc/openltc.h"
#include "openltc/render/lights/light_set.h"
#include "openltc/render/point_buffer.h"
#include "openltc/render/surface_point.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace openltc;

namespace {

struct Random {
  std::mt19937 engine{3};
  float between(float a, float b) { return std::uniform_real_distribution<float>(a, b)(engine); }
  bool heads() { return between(0, 1) < 0.5f; }
  Vec3f in_box(float half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
};

Material random_material(Random& random) {
  Material m;
  m.base_color = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
  m.metallic = random.heads() ? 0.0f : random.between(0, 1);
  m.roughness = random.between(0, 1);
  m.specular = random.between(0, 1);
  m.specular_color = {random.between(0, 2), 1, random.between(0, 1)};
  m.ior = random.between(1, 2.5f);
  return m;
}

/// What the kernel makes of a point and the lights of one set.
Vec3f kernel_light(const Surface& surface, Vec3f view, const Material& material,
                   const light::Lights& lights, bool polynomial) {
  const f32::Surface& s = surface.point;
  const Reflectance r = reflectance_of(material);
  render::SurfacePoint p;
  p.position = s.position;
  p.normal = s.frame.n;
  p.geometric = s.geometric;
  p.view = view;
  p.albedo = r.albedo;
  p.f0 = r.f0;
  p.f90 = r.f90;
  p.roughness = r.roughness;
  p.offset = 2 * std::sqrt(s.position_error2);
  render::PointBuffer buffer(render::k_batch_padding);
  buffer.add(p, {});
  const render::LightSet set = render::pack_lights(lights);
  REQUIRE(set.warnings.empty());
  render::KernelContext context;
  context.table = table::builtin_ggx_table().view();
  if (polynomial) context.polynomial = table::builtin_ggx_polynomial().view();
  context.area_lights = set.area_lights.data();
  context.area_light_count = int(set.area_lights.size());
  context.punctual = set.punctual.data();
  context.punctual_count = int(set.punctual.size());
  std::vector<Vec3f> samples(1);
  std::vector<float> no_sums;
  buffer.shade(render::kernel_by_name("scalar"), context, samples, no_sums, 1);
  return samples[0];
}

} // namespace

TEST_CASE("the public API and the kernel shade every light alike") {
  Random random;
  int lit = 0, tilted = 0, checked = 0;
  for (int i = 0; i < 400; ++i) {
    const bool polynomial = random.heads();
    const Lobes lobes = polynomial ? built_in_polynomial() : built_in_table();
    const Material material = random_material(random);
    const Vec3f position = random.in_box(1), normal = random.in_box(1), view = random.in_box(1);
    const Surface surface = random.heads() ? make_surface(position, normal, view, material, lobes)
                                           : make_surface(position, normal, view, material, lobes,
                                                          normal + random.in_box(0.5f));
    if (!surface.usable) continue;
    tilted += surface.point.tilted;
    const Vec3f wo = detail::unit_or(view, normal);
    const Vec3f radiance(random.between(0, 9), random.between(0, 9), 1);
    const auto check = [&](Vec3f ours, const light::Lights& lights) {
      const Vec3f theirs = kernel_light(surface, wo, material, lights, polynomial);
      CAPTURE(i);
      CHECK(ours.x == theirs.x);
      CHECK(ours.y == theirs.y);
      CHECK(ours.z == theirs.z);
      lit += ours.y > 0;
      ++checked;
    };

    const Vec3f center = random.in_box(2), u = random.in_box(0.7f);
    const Vec3f v = cross(u, random.in_box(1));
    const bool two_sided = random.heads();
    const Polygon polygon =
        random.heads() ? Polygon::rectangle(center, u, v, two_sided)
                       : Polygon::from_vertices({center - u, center + v, center + u}, two_sided);
    if (polygon.usable()) {
      light::Lights lights;
      light::PolygonLight light;
      for (int k = 0; k + 1 < polygon.view().point_count; ++k)
        light.vertices.push_back(f32::polygon_point(polygon.view(), k));
      light.ring_end = {std::uint32_t(light.vertices.size())};
      light.normal = polygon.normal();
      light.radiance = radiance;
      light.two_sided = two_sided;
      lights.polygons = {light};
      check(shade(surface, polygon, radiance), lights);
    }
    {
      light::Lights lights;
      light::EllipseLight light;
      light.center = center;
      light.half_u = u;
      light.half_v = v;
      light.radiance = radiance;
      light.two_sided = two_sided;
      lights.ellipses = {light};
      check(shade(surface, Ellipse{center, u, v, two_sided}, radiance), lights);
    }
    const float radius = random.between(0.01f, 1);
    {
      light::Lights lights;
      light::SphereLight light;
      light.center = center;
      light.radius = radius;
      light.radiance = radiance;
      lights.spheres = {light};
      check(shade(surface, Sphere{center, radius}, radiance), lights);
    }
    const TubeCaps caps[] = {TubeCaps::none, TubeCaps::flat, TubeCaps::round};
    const light::TubeCaps their_caps[] = {light::TubeCaps::none, light::TubeCaps::flat,
                                          light::TubeCaps::round};
    for (int k = 0; k < 3; ++k) {
      light::Lights lights;
      light::TubeLight light;
      light.from = center;
      light.to = center + v;
      light.radius = radius;
      light.caps = their_caps[k];
      light.radiance = radiance;
      lights.tubes = {light};
      check(shade(surface, Tube{center, center + v, radius, caps[k]}, radiance), lights);
    }
    {
      light::Lights lights;
      light::LineLight light;
      light.from = center;
      light.to = center + v;
      light.intensity_per_metre = radiance;
      lights.lines = {light};
      check(shade(surface, Line{center, center + v}, radiance), lights);
    }
  }
  CHECK(checked > 2000);
  CHECK(lit > 500);
  CHECK(tilted > 100);
}

TEST_CASE("the public API and the kernel agree on lights without extent") {
  // Sums in another order: to rounding.
  Random random;
  int lit = 0;
  for (int i = 0; i < 300; ++i) {
    const Material material = random_material(random);
    const Vec3f view = random.in_box(1), normal = random.in_box(1);
    const Surface surface = make_surface(random.in_box(1), normal, view, material, built_in_table(),
                                         normal + random.in_box(0.4f));
    if (!surface.usable) continue;
    const Vec3f wo = detail::unit_or(view, normal), at = random.in_box(3),
                intensity = random.in_box(1) + Vec3f(2.0f);
    const Vec3f direction = detail::unit_or(random.in_box(1), {0, 1, 0});
    for (const light::PunctualType type : {light::PunctualType::point, light::PunctualType::spot,
                                           light::PunctualType::directional}) {
      light::PunctualLight light;
      light.type = type;
      light.position = at;
      light.direction = direction;
      light.intensity = intensity;
      light.range = 4;
      light.cos_inner = std::cos(0.5f);
      light.cos_outer = std::cos(1.2f);
      light::Lights lights;
      lights.punctual = {light};
      const Vec3f theirs = kernel_light(surface, wo, material, lights, false);
      const Vec3f ours = type == light::PunctualType::point
                             ? shade(surface, PointLight{at, intensity, 4})
                         : type == light::PunctualType::spot
                             ? shade(surface, SpotLight{at, direction, intensity, 4, 0.5f, 1.2f})
                             : shade(surface, DirectionalLight{direction, intensity});
      CAPTURE(i);
      CHECK(ours.x == doctest::Approx(theirs.x).epsilon(1e-5));
      CHECK(ours.y == doctest::Approx(theirs.y).epsilon(1e-5));
      CHECK(ours.z == doctest::Approx(theirs.z).epsilon(1e-5));
      lit += ours.x > 0;
    }
  }
  CHECK(lit > 200);
}

TEST_CASE("the renderer and the public API know a material alike") {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Material m = random_material(random);
    scene::Scene scene;
    scene::Material material;
    material.base_color = {m.base_color.x, m.base_color.y, m.base_color.z, 1};
    material.metallic = m.metallic;
    material.roughness = m.roughness;
    material.specular = m.specular;
    material.specular_color = m.specular_color;
    material.ior = m.ior;
    scene.materials = {material};
    scene::Mesh mesh;
    mesh.material = 0;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    scene.meshes = {mesh};
    const render::TextureSet textures(scene);
    const render::SurfacePoint p =
        render::evaluate_surface(scene, textures, 0, 0, 0.25f, 0.25f, {0, 0, -1}, 0.01f);
    const Reflectance r = reflectance_of(m);
    CHECK(p.f0.x == r.f0.x);
    CHECK(p.f0.y == r.f0.y);
    CHECK(p.f0.z == r.f0.z);
    CHECK(p.f90 == r.f90);
    CHECK(p.albedo.x == r.albedo.x);
    CHECK(p.albedo.z == r.albedo.z);
    CHECK(p.roughness == r.roughness);
  }
}
