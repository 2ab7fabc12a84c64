// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Emitters of which alpha removes a part. What is right follows from the specification (glTF 2.0,
// section 3.9.4) and from counting: flux is pi times radiance times the open area.

#include "openltc/light/emission_stack.h"
#include "openltc/light/polygon.h"
#include "openltc/scene/emissive/emissive.h"
#include "tests/scene/emissive/round_meshes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace openltc;

constexpr double k_pi = std::numbers::pi;

// A rectangle of 2 x 1 metres in z = 0; texture coordinates from its own, 0 to 1.
template <class Map> scene::Mesh rectangle(const Map& map) {
  scene::Mesh mesh;
  mesh.name = "panel";
  mesh.positions = {Vec3f(0, 0, 0), Vec3f(2, 0, 0), Vec3f(2, 1, 0), Vec3f(0, 1, 0)};
  mesh.normals.assign(4, Vec3f(0, 0, 1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const Vec3f p : mesh.positions)
    mesh.tex_coord_0.push_back(map(p.x / 2, p.y));
  return mesh;
}

scene::Mesh upright() {
  return rectangle([](float x, float y) { return Vec2f(x, 1 - y); });
}

scene::Material glowing(scene::AlphaMode mode, float alpha = 1) {
  scene::Material material;
  material.emission = Vec3f(100, 100, 100);
  material.alpha_mode = mode;
  material.base_color.w = alpha;
  return material;
}

template <class Alpha>
scene::Texture alpha_texture(int width, int height, bool nearest, const Alpha& alpha) {
  scene::Texture texture;
  texture.nearest = nearest;
  texture.wrap_u = texture.wrap_v = scene::Wrap::clamp_to_edge;
  image::Image picture(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      float* p = picture.pixel(x, y);
      p[0] = p[1] = p[2] = 1;
      p[3] = alpha(x, y);
    }
  texture.image = picture;
  return texture;
}

// Flux over all lights, lumens, of the first channel, with their pictures.
double flux(const scene::EmissiveLights& found, std::size_t textures) {
  double sum = 0;
  for (light::PolygonLight light : found.lights.polygons) {
    double share = 1;
    if (light.texture >= 0) {
      REQUIRE(std::size_t(light.texture) >= textures);
      light.texture -= int(textures);
      share = double(light::mean_of_texture(light, found.pictures).x);
    }
    sum += share * double(light::flux_lumens(light).x);
  }
  return sum;
}

TEST_CASE("constant_alpha_scales_blended_light_and_decides_over_masked_light") {
  using scene::AlphaMode;
  const scene::Mesh mesh = upright();
  struct Case {
    AlphaMode mode;
    float alpha;
    double share;
  };
  for (const Case& c : {Case{AlphaMode::opaque, 0.25f, 1}, Case{AlphaMode::blend, 0.25f, 0.25},
                        Case{AlphaMode::blend, 0, 0}, Case{AlphaMode::mask, 0.25f, 0},
                        Case{AlphaMode::mask, 0.5f, 1}, Case{AlphaMode::mask, 0.75f, 1}}) {
    CAPTURE(c.alpha);
    const auto found = scene::emissive_lights(mesh, glowing(c.mode, c.alpha), {});
    CHECK(found.lights.polygons.size() == (c.share > 0 ? 1u : 0u));
    CHECK(found.pictures.empty());
    CHECK(flux(found, 0) == doctest::Approx(k_pi * 100 * 2 * c.share));
  }
}

TEST_CASE("the_picture_of_a_cut_emitter_counts_before_it_is_drawn") {
  const scene::Texture texture =
      alpha_texture(256, 128, true, [](int x, int) { return x % 2 == 0 ? 1.0f : 0.0f; });
  scene::Material material = glowing(scene::AlphaMode::mask);
  material.base_color_texture.texture = 0;
  const std::uint64_t before = memory_budget().in_use();
  {
    const auto found = scene::emissive_lights(upright(), material, {texture});
    REQUIRE(found.pictures.size() == 1);
    // A pixel for each texel, three floats each.
    CHECK(memory_budget().in_use() - before == 256 * 128 * 12);
    CHECK(found.refusal.empty());
  }
  CHECK(memory_budget().in_use() == before);
  // Without room the light has the mean: half of the texels.
  const std::uint64_t limit = memory_budget().limit();
  memory_budget().set_limit(before + 100000);
  const auto found = scene::emissive_lights(upright(), material, {texture});
  memory_budget().set_limit(limit);
  CHECK(found.pictures.empty());
  CHECK(found.refusal.find("256x128 pixels: asks for 384 KiB") != std::string::npos);
  CHECK(found.refusal.find("--memory") != std::string::npos);
  CHECK(flux(found, 1) == doctest::Approx(k_pi * 100 * 2 * 0.5));
}

TEST_CASE("a_masked_texture_leaves_its_open_texels") {
  std::mt19937 random(3);
  int open = 0;
  const scene::Texture texture = alpha_texture(64, 32, true, [&](int, int) {
    const bool is_open = random() % 4 == 0;
    open += is_open;
    return is_open ? 0.6f : 0.4f;
  });
  scene::Material material = glowing(scene::AlphaMode::mask);
  material.base_color_texture.texture = 0;
  const auto found = scene::emissive_lights(upright(), material, {texture});
  REQUIRE(found.lights.polygons.size() == 1);
  REQUIRE(found.pictures.size() == 1);
  CHECK(!found.is_texture_averaged);
  CHECK(flux(found, 1) == doctest::Approx(k_pi * 100 * 2 * open / (64.0 * 32)).epsilon(1e-5));
  // Where the holes are: the picture is the texture.
  const light::PolygonLight& light = found.lights.polygons[0];
  const image::Image picture = found.pictures[0].to_image();
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const Vec3f p(float(x + 0.5) / 32, 1 - float(y + 0.5) / 32, 0);
      const Vec3f d = p - light.texture_corner;
      const double u = double(dot(d, light.texture_u) / dot(light.texture_u, light.texture_u));
      const double v = double(dot(d, light.texture_v) / dot(light.texture_v, light.texture_v));
      const float value = picture.rgb(int(u * picture.width), int(v * picture.height)).x;
      CHECK(value == (texture.image.rgba(x, y).w >= 0.5f ? 1.0f : 0.0f));
    }
  // The cutoff counts, and the factor before it.
  material.base_color.w = 0.8f; // .48 and .32
  CHECK(scene::emissive_lights(upright(), material, {texture}).lights.empty());
  material.alpha_cutoff = 0.4f;
  CHECK(flux(scene::emissive_lights(upright(), material, {texture}), 1) ==
        doctest::Approx(k_pi * 100 * 2 * open / (64.0 * 32)).epsilon(1e-5));
}

TEST_CASE("a_part_of_an_atlas_is_cut_as_well") {
  // The rectangle shows a quarter of the texture; only there texels are open.
  const scene::Texture texture = alpha_texture(64, 64, true, [](int x, int y) {
    return x >= 32 && y < 32 && (x / 4 + y / 4) % 2 ? 1.f : 0.f;
  });
  scene::Material material = glowing(scene::AlphaMode::mask);
  material.base_color_texture.texture = 0;
  const auto found = scene::emissive_lights(
      rectangle([](float x, float y) { return Vec2f(0.5f + 0.5f * x, 0.5f - 0.5f * y); }), material,
      {texture});
  REQUIRE(found.pictures.size() == 1);
  CHECK(found.pictures[0].width == 32);
  CHECK(found.pictures[0].height == 32);
  CHECK(flux(found, 1) == doctest::Approx(k_pi * 100 * 2 / 2).epsilon(1e-5));
}

TEST_CASE("blended_alpha_and_emission_of_maps_of_their_own_multiply") {
  // alpha = u, emission = v', of another set of coordinates that is turned: the mean over the
  // rectangle of x * (x + y) / 2 is (1/3 + 1/4) / 2.
  const scene::Texture alpha =
      alpha_texture(256, 4, false, [](int x, int) { return (float(x) + 0.5f) / 256; });
  scene::Texture glow = alpha_texture(256, 256, false, [](int, int) { return 1.0f; });
  image::Image ramp = glow.image.to_image();
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      for (int c = 0; c < 3; ++c)
        ramp.pixel(x, y)[c] = (float(y) + 0.5f) / 256;
  glow.image = ramp;
  scene::Mesh mesh = upright();
  mesh.tex_coord_1.clear();
  for (const Vec3f p : mesh.positions)
    mesh.tex_coord_1.push_back(Vec2f(0.3f, (p.x / 2 + p.y) / 2));
  scene::Material material = glowing(scene::AlphaMode::blend);
  material.base_color_texture.texture = 0;
  material.emission_texture.texture = 1;
  material.emission_texture.tex_coord = 1;
  const auto found = scene::emissive_lights(mesh, material, {alpha, glow});
  CHECK(!found.is_texture_averaged);
  CHECK(flux(found, 2) == doctest::Approx(k_pi * 100 * 2 * (1.0 / 3 + 0.25) / 2).epsilon(0.003));
}

TEST_CASE("the_alpha_of_vertex_colours_counts") {
  // 0 at the left, 1 at the right.
  scene::Mesh mesh = upright();
  for (const Vec3f p : mesh.positions)
    mesh.colors.push_back({1, 1, 1, p.x / 2});
  const auto blended = scene::emissive_lights(mesh, glowing(scene::AlphaMode::blend), {});
  REQUIRE(blended.pictures.size() == 1);
  CHECK(flux(blended, 0) == doctest::Approx(k_pi * 100 * 2 / 2).epsilon(0.002));
  // Half of the light lies in the right 1 - sqrt(1/2) of the width: less than half of it is lit at
  // a cutoff of .7071.
  scene::Material masked = glowing(scene::AlphaMode::mask);
  masked.alpha_cutoff = 0.7071f;
  CHECK(flux(scene::emissive_lights(mesh, masked, {}), 0) ==
        doctest::Approx(k_pi * 100 * 2 * (1 - 0.7071)).epsilon(0.005));
  CHECK(scene::emissive_lights(mesh, glowing(scene::AlphaMode::opaque), {}).pictures.empty());
}

TEST_CASE("curved_emitters_shine_with_what_alpha_leaves_of_each_facet") {
  // A cylinder of 48 sides around x; stripes around it, 3 of 4 texels closed.
  scene::Mesh mesh = test::cylinder_mesh(48, 2, 0);
  for (const Vec3f p : mesh.positions)
    mesh.tex_coord_0.push_back(Vec2f(p.x / 2, 0.5f));
  const scene::Texture texture =
      alpha_texture(128, 1, true, [](int x, int) { return x / 4 % 4 == 0 ? 1.0f : 0.0f; });
  scene::Material material = glowing(scene::AlphaMode::mask);
  material.base_color_texture.texture = 0;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3d a = to_double(mesh.positions[t[0]]);
    area += 0.5 *
            length(cross(to_double(mesh.positions[t[1]]) - a, to_double(mesh.positions[t[2]]) - a));
  }
  const auto found = scene::emissive_lights(mesh, material, {texture});
  CHECK(found.lights.polygons.size() >= 24);
  CHECK(found.is_texture_averaged);
  CHECK(flux(found, 1) == doctest::Approx(k_pi * 100 * area / 4).epsilon(0.02));
  // A recognised cylinder too.
  scene::EmissiveOptions options;
  options.recognise_shapes = true;
  const auto round = scene::emissive_lights(mesh, material, {texture}, options);
  REQUIRE(round.lights.tubes.size() == 1);
  CHECK(round.lights.tubes[0].radiance.x == doctest::Approx(25).epsilon(0.02));
}

TEST_CASE("two_lit_texels_of_many_make_a_light") {
  scene::Texture texture = alpha_texture(512, 512, false, [](int, int) { return 1.0f; });
  image::Image dots(512, 512, 4);
  for (int c = 0; c < 3; ++c)
    dots.pixel(100, 57)[c] = dots.pixel(400, 391)[c] = 1.0f;
  texture.image = dots;
  scene::Material material = glowing(scene::AlphaMode::opaque);
  material.emission_texture.texture = 0;
  const auto found = scene::emissive_lights(upright(), material, {texture});
  REQUIRE(found.lights.polygons.size() == 1);
  CHECK(found.lights.polygons[0].texture == 0);
  CHECK(light::mean_of_texture(found.lights.polygons[0], {dots}).x ==
        doctest::Approx(2.0 / (512 * 512)).epsilon(1e-4));
}

} // namespace
