// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/light_list.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/emissive/emissive_texture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using namespace openltc;

scene::Texture stripes(scene::Wrap wrap = scene::Wrap::repeat) {
  scene::Texture texture;
  image::Image picture(64, 32, 4);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c)
        picture.pixel(x, y)[c] = (x / 8) % 2 ? 1.0f : 0.25f;
  texture.image = picture;
  texture.wrap_u = texture.wrap_v = wrap;
  return texture;
}

scene::Material pictured() {
  scene::Material material;
  material.emission = Vec3f(100, 100, 100);
  material.emission_texture.texture = 0;
  return material;
}

// A rectangle of 3 x 2 quads somewhere in space; texture coordinates from its own, 0 to 1.
template <class Map> scene::Mesh grid(Vec3f corner, Vec3f along, Vec3f up, const Map& map) {
  scene::Mesh mesh;
  mesh.name = "screen";
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i <= 3; ++i) {
      const float x = float(i) / 3, y = float(j) / 2;
      mesh.positions.push_back(corner + along * x + up * y);
      mesh.tex_coord_0.push_back(map(x, y));
    }
  for (std::uint32_t j = 0; j < 2; ++j)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = 4 * j + i;
      mesh.triangles.push_back({a, a + 1, a + 5});
      mesh.triangles.push_back({a, a + 5, a + 4});
    }
  mesh.normals.assign(mesh.positions.size(), normalize(cross(along, up)));
  return mesh;
}

Vec2f picture_coordinates(const light::PolygonLight& light, Vec3f p) {
  const Vec3f d = p - light.texture_corner;
  return {dot(d, light.texture_u) / dot(light.texture_u, light.texture_u),
          dot(d, light.texture_v) / dot(light.texture_v, light.texture_v)};
}

TEST_CASE("an_affine_texture_becomes_the_lights_picture") {
  std::mt19937 generator(7);
  const auto random = [&](float low, float high) {
    return low + (high - low) * float(generator() >> 8) * 0x1p-24f;
  };
  const auto vector = [&] { return Vec3f(random(-1, 1), random(-1, 1), random(-1, 1)); };
  for (int i = 0; i < 50; ++i) {
    // Turned, mirrored and sheared maps that stay within the picture.
    const float a = random(-0.4f, 0.4f), b = random(-0.4f, 0.4f);
    const float c = random(-0.4f, 0.4f), d = random(-0.4f, 0.4f);
    if (std::abs(a * d - b * c) < 0.02f) continue;
    const Vec3f along = vector() * 2.0f;
    const Vec3f up = normalize(cross(along, vector()));
    const scene::Mesh mesh = grid(vector(), along, up, [&](float x, float y) {
      x -= 0.5f;
      y -= 0.5f;
      return Vec2f(0.5f + a * x + b * y, 0.5f + c * x + d * y);
    });
    const auto found = scene::emissive_lights(mesh, pictured(), {stripes()});
    REQUIRE(found.lights.polygons.size() == 1);
    CHECK(!found.is_texture_averaged);
    const light::PolygonLight& light = found.lights.polygons[0];
    CHECK(light.texture == 0);
    CHECK(light.radiance.x == 100.0f);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
      const Vec2f uv = picture_coordinates(light, mesh.positions[k]);
      CHECK(uv.x == doctest::Approx(mesh.tex_coord_0[k].x).epsilon(1e-4));
      CHECK(uv.y == doctest::Approx(mesh.tex_coord_0[k].y).epsilon(1e-4));
    }
  }
}

TEST_CASE("the_transform_of_the_material_is_part_of_the_map") {
  const scene::Mesh mesh =
      grid({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, [](float x, float y) { return Vec2f(x, 1 - y); });
  scene::Material material = pictured();
  material.emission_texture.uv_row0 = {0.5f, 0, 0.25f};
  material.emission_texture.uv_row1 = {0, 0.25f, 0};
  const auto found = scene::emissive_lights(mesh, material, {stripes()});
  REQUIRE(found.lights.polygons.size() == 1);
  const Vec2f uv = picture_coordinates(found.lights.polygons[0], {3, 0, 0});
  CHECK(uv.x == doctest::Approx(0.75f));
  CHECK(uv.y == doctest::Approx(0.25f));
}

TEST_CASE("a_picture_is_shown_once_or_averaged") {
  using scene::Wrap;
  struct Case {
    float u0, u1;
    Wrap wrap;
    bool is_picture;
  };
  for (const Case& c :
       {Case{0, 1, Wrap::repeat, true}, Case{2, 3, Wrap::repeat, true},
        Case{-1, 0, Wrap::repeat, true}, Case{0, 2, Wrap::repeat, false},
        Case{0.5f, 1.5f, Wrap::repeat, false}, Case{-1, 2, Wrap::clamp_to_edge, true},
        Case{0, 1, Wrap::mirrored_repeat, true}, Case{1, 2, Wrap::mirrored_repeat, false}}) {
    CAPTURE(c.u0);
    CAPTURE(c.u1);
    const scene::Mesh mesh = grid({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, [&](float x, float y) {
      return Vec2f(c.u0 + (c.u1 - c.u0) * x, 1 - y);
    });
    const auto found = scene::emissive_lights(mesh, pictured(), {stripes(c.wrap)});
    REQUIRE(found.lights.polygons.size() == 1);
    CHECK((found.lights.polygons[0].texture == 0) == c.is_picture);
    CHECK(found.is_texture_averaged == !c.is_picture);
    if (c.is_picture && c.wrap == Wrap::repeat) {
      CHECK(picture_coordinates(found.lights.polygons[0], {0, 0, 0}).x ==
            doctest::Approx(0).epsilon(1e-5));
    }
  }
}

TEST_CASE("a_bent_map_is_averaged") {
  const scene::Mesh mesh =
      grid({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, [](float x, float y) { return Vec2f(x * x, 1 - y); });
  const auto found = scene::emissive_lights(mesh, pictured(), {stripes()});
  REQUIRE(found.lights.polygons.size() == 1);
  CHECK(found.lights.polygons[0].texture == -1);
  CHECK(found.is_texture_averaged);
  CHECK(found.lights.polygons[0].radiance.x < 100.0f);
}

TEST_CASE("lights_of_one_texture_share_one_picture") {
  scene::Scene scene;
  scene.textures = {stripes(), stripes()};
  scene.materials = {pictured()};
  scene.materials[0].emission_texture.texture = 1;
  const auto map = [](float x, float y) { return Vec2f(x, 1 - y); };
  scene.meshes = {grid({0, 0, 0}, {3, 0, 0}, {0, 2, 0}, map),
                  grid({0, 0, 5}, {1, 0, 0}, {0, 0, 1}, map)};
  scene::Warnings warnings;
  for (const light::Lights& lights : scene::find_emissive_lights(scene, {}, warnings))
    light::append_lights(lights, scene.lights);
  REQUIRE(scene.lights.polygons.size() == 2);
  REQUIRE(scene.lights.textures.size() == 1);
  CHECK(scene.lights.polygons[0].texture == 0);
  CHECK(scene.lights.polygons[1].texture == 0);
  CHECK(scene.lights.textures[0].to_image().data == scene.textures[1].image.to_image().data);
  CHECK(scene.lights.textures[0].identity() == scene.textures[1].image.identity());
}

} // namespace
