// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a ray meets and how it is lit there: emitters that do not light themselves, light that does
// not pass through walls, layers, cameras, textures.

#include "openltc/render/renderer.h"
#include "openltc/render/surface_point.h"
#include "openltc/target/shade_f64.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace openltc;

namespace {

render::Picture rendered(const scene::Scene& scene, const scene::Camera& camera,
                         render::Integrator integrator, int shadow_samples = 4,
                         const char* kernel = "auto") {
  render::RenderOptions options;
  options.width = options.height = 16;
  options.samples = 4;
  options.integrator = integrator;
  options.shadow_samples = shadow_samples;
  options.kernel = kernel;
  auto picture = render::render(scene, camera, table::builtin_ggx_table(), options);
  REQUIRE(picture.ok());
  return std::move(*picture);
}

float largest(const image::Image& image) {
  return *std::max_element(image.data.begin(), image.data.end());
}

// A square of half side `half` around `center`, spanned by orthonormal u, v; normal u x v.
void add_square(scene::Scene& scene, Vec3f center, Vec3f u, Vec3f v, float half,
                const scene::Material& material) {
  scene.materials.push_back(material);
  scene::Mesh mesh;
  mesh.material = int(scene.materials.size()) - 1;
  mesh.positions = {center - u * half - v * half, center + u * half - v * half,
                    center + u * half + v * half, center - u * half + v * half};
  mesh.normals.assign(4, cross(u, v));
  mesh.tex_coord_0 = mesh.tex_coord_1 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
}

light::PolygonLight light_of(const scene::Mesh& mesh, float nits, bool two_sided) {
  light::PolygonLight light;
  light.vertices = mesh.positions;
  light.ring_end = {4};
  light.normal = mesh.normals[0];
  light.radiance = Vec3f(nits);
  light.two_sided = two_sided;
  return light;
}

struct Basis {
  Vec3f u, v, n;
};
Basis random_basis(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  Basis b;
  b.n = normalize(Vec3f(uniform(random), uniform(random), uniform(random)));
  b.u = normalize(cross(b.n, std::abs(b.n.x) < 0.5f ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0)));
  b.v = cross(b.n, b.u);
  return b;
}

const render::Integrator k_both[] = {render::Integrator::ltc, render::Integrator::reference};

} // namespace

TEST_CASE("an emitter does not light itself, nor a wall flush with it, however it is turned") {
  std::mt19937 random(5);
  for (int turn = 0; turn < 20; ++turn) {
    const Basis b = random_basis(random);
    const Vec3f center(3.1f, -1.7f, 2.3f);
    for (const bool two_sided : {false, true}) {
      scene::Scene scene;
      scene::Material wall = test::glossy_material({0.8f, 0.8f, 0.8f}, 0.5f, false);
      add_square(scene, center, b.u, b.v, 1, wall);
      scene.lights.polygons.push_back(light_of(scene.meshes[0], 10, two_sided));
      // The wall goes on around the emitter.
      add_square(scene, center, b.u, b.v, 3, wall);
      const scene::Camera camera =
          test::look_at(center + b.n * 4.0f + b.u * 1.5f, center + b.u * 0.3f, 0.9f);
      for (const auto integrator : k_both)
        for (const char* kernel : {"scalar", "auto"}) {
          CHECK(largest(rendered(scene, camera, integrator, 4, kernel).radiance) == 0);
          CHECK(largest(rendered(scene, camera, integrator, 0, kernel).radiance) == 0);
        }
    }
  }
}

TEST_CASE("light does not pass through a wall whose normals are tilted") {
  scene::Scene scene;
  test::add_floor(scene, 10, 0, test::glossy_material({0.8f, 0.8f, 0.8f}, 0.5f, false));
  for (Vec3f& n : scene.meshes[0].normals)
    n = normalize(Vec3f(0.75f, 1, 0));
  light::PolygonLight below = test::ceiling_rectangle(1, -1, 3, 1, -0.5f, 1000);
  below.two_sided = true;
  scene.lights.polygons.push_back(below);
  light::PunctualLight point;
  point.position = {2, -0.5f, 0};
  point.intensity = Vec3f(1000);
  scene.lights.punctual.push_back(point);
  for (const auto integrator : k_both)
    CHECK(
        largest(rendered(scene, test::look_at({0, 4, 1}, {0, 0, 0}, 0.8f), integrator).radiance) ==
        0);
}

TEST_CASE("an emitter that is not quite flat does not shadow its own light") {
  const auto mean = [](float deviation, bool shadows) {
    scene::Scene scene;
    test::add_floor(scene, 10, 0, test::diffuse_material({0.8f, 0.8f, 0.8f}));
    // The light's plane lies above the surface that it was made of, which would hide it.
    scene::Material lamp = test::diffuse_material({0, 0, 0});
    add_square(scene, {0, 0.5f - 0.0005f, 0}, {1, 0, 0}, {0, 0, 1}, 5, lamp);
    light::PolygonLight light = test::ceiling_rectangle(-5, -5, 5, 5, 0.5f, 10);
    light.surface_deviation = deviation;
    scene.lights.polygons.push_back(light);
    const auto picture = rendered(scene, test::look_at({0, 0.3f, 2}, {0, 0, 0}, 0.3f),
                                  render::Integrator::reference, shadows ? 1 : 0);
    double sum = 0;
    for (const float v : picture.radiance.data)
      sum += double(v);
    return sum;
  };
  const double open = mean(0.0005f, false);
  CHECK(open > 0);
  CHECK(mean(0.0005f, true) == doctest::Approx(open).epsilon(0.01));
  CHECK(mean(0.0f, true) < 0.5 * open);
}

TEST_CASE("white furnace: six walls of radiance 1 give 1, less what single scattering loses") {
  // A dielectric's loss is made up for by what it has below; a metal has nothing below, and the
  // closed form gives it its albedo n1 whichever walls the light comes from. A dielectric's Fresnel
  // is chosen wall by wall, which does not quite add up to the albedo of the whole.
  const auto furnace = [](float roughness, bool metal) {
    scene::Scene scene;
    test::add_sphere(scene, {0, 0, 0}, 0.5f, test::glossy_material({1, 1, 1}, roughness, metal));
    const Vec3f axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {-1.0f, 1.0f}) {
        const Vec3f n = axes[axis] * -side, u = axes[(axis + 1) % 3], v = cross(n, u);
        const Vec3f c = axes[axis] * (3 * side);
        light::PolygonLight light;
        light.vertices = {c - u * 3.0f - v * 3.0f, c + u * 3.0f - v * 3.0f, c + u * 3.0f + v * 3.0f,
                          c - u * 3.0f + v * 3.0f};
        light.ring_end = {4};
        light.normal = n;
        light.radiance = Vec3f(1);
        scene.lights.polygons.push_back(light);
      }
    return scene;
  };
  const scene::Camera camera = test::look_at({0.3f, 0.4f, 2}, {0, 0, 0}, 0.3f);
  for (const float roughness : {0.05f, 0.3f, 0.6f, 1.0f}) {
    const scene::Scene scene = furnace(roughness, false);
    // The closed form on the whole sphere, its rim included; the reference inside it, where no
    // pixel looks past it.
    scene::Camera wide = camera;
    wide.fov_y_rad = 0.6f;
    const image::Image ltc = rendered(scene, wide, render::Integrator::ltc, 0).radiance;
    MESSAGE("roughness " << roughness << ": largest " << largest(ltc));
    // Decision 51, by a search over single points: 1.008 from a cosine of .5 on, 1.035 from .2;
    // pixels of the rim hold cosines down to 0, and which of them depends on where their rays fall.
    CHECK(largest(ltc) < 1.03f);
    const image::Image inside = rendered(scene, camera, render::Integrator::ltc, 0).radiance;
    CHECK(largest(inside) < 1.008f); // cosines from .8 on
    CHECK(largest(ltc) > 0.999f);
    const image::Image metal =
        rendered(furnace(roughness, true), wide, render::Integrator::ltc, 0).radiance;
    CHECK(largest(metal) < 1.00001f);
    // No metal pixel of the sphere is darker than the least albedo; no other pixel is lit.
    float least = 1;
    for (const float v :
         rendered(furnace(roughness, true), camera, render::Integrator::ltc, 0).radiance.data)
      least = std::min(least, v);
    double least_albedo = 1;
    for (int i = 0; i <= 64; ++i)
      least_albedo = std::min(
          least_albedo, f64::fetch_lobe(table::builtin_ggx_table().view(),
                                        f64::alpha_from_roughness(double(roughness)), i / 64.0)
                            .n1);
    // The ratio in each wall's mean direction loses a little: at such views 0.5 % at most (the test
    // "five walls of a white furnace"), here 0.15 %.
    CHECK(double(least) > least_albedo - 0.0015);
    render::RenderOptions options;
    options.width = options.height = 8;
    options.samples = 1024;
    options.integrator = render::Integrator::reference;
    options.shadow_samples = 0;
    auto reference = render::render(scene, camera, table::builtin_ggx_table(), options);
    REQUIRE(reference.ok());
    double sum = 0;
    for (const float v : reference->radiance.data)
      sum += double(v);
    CHECK(sum / double(reference->radiance.data.size()) == doctest::Approx(1.0).epsilon(0.01));
  }
}

TEST_CASE("any number of clear layers hides nothing, too many blended ones lose no light") {
  for (const int panes : {3, 31, 33, 200}) {
    for (const float alpha : {0.0f, 0.01f}) {
      scene::Scene scene;
      scene::Material glow = test::diffuse_material({0, 0, 0});
      glow.emission = Vec3f(10);
      test::add_floor(scene, 10, 0, glow);
      scene::Material pane = glow;
      pane.alpha_mode = scene::AlphaMode::blend;
      pane.base_color.w = alpha;
      for (int i = 0; i < panes; ++i)
        test::add_floor(scene, 10, 0.01f * float(i + 1), pane);
      const auto picture =
          rendered(scene, test::look_at({0, 4, 0.1f}, {0, 0, 0}, 0.1f), render::Integrator::ltc);
      CHECK(double(picture.radiance.pixel(8, 8)[0]) == doctest::Approx(10));
    }
  }
}

TEST_CASE("what lies a centimetre behind a clear pane is seen from a kilometre away") {
  scene::Scene scene;
  scene::Material glow = test::diffuse_material({0, 0, 0});
  glow.emission = Vec3f(10);
  test::add_floor(scene, 10, 0, glow);
  scene::Material pane = test::diffuse_material({0, 0, 0});
  pane.alpha_mode = scene::AlphaMode::blend;
  pane.base_color.w = 0;
  test::add_floor(scene, 10, 0.01f, pane);
  const auto picture =
      rendered(scene, test::look_at({0, 1000, 1}, {0, 0, 0}, 0.001f), render::Integrator::ltc);
  CHECK(picture.radiance.pixel(8, 8)[0] == 10);
}

TEST_CASE("orthographic camera, near and far planes") {
  scene::Scene scene;
  scene::Material glow = test::diffuse_material({0, 0, 0});
  glow.emission = Vec3f(10);
  test::add_floor(scene, 1, 0, glow); // 2 m x 2 m
  scene::Camera camera = test::look_at({0, 5, 0.001f}, {0, 0, 0}, 0.5f);
  camera.projection = scene::Projection::orthographic;
  camera.height = 4; // the floor fills a quarter of the picture
  const auto lit_share = [&] {
    const auto picture = rendered(scene, camera, render::Integrator::ltc);
    double sum = 0;
    for (const float v : picture.radiance.data)
      sum += double(v) / 10;
    return sum / double(picture.radiance.data.size());
  };
  CHECK(lit_share() == doctest::Approx(0.25).epsilon(0.03));
  camera.far = 4.9f;
  CHECK(lit_share() == 0);
  camera.far = 5.1f;
  CHECK(lit_share() > 0.2);
  camera.near = 5.05f;
  CHECK(lit_share() == 0);
}

TEST_CASE("textures: normal maps turn the normal, each set of coordinates has its own footprint") {
  scene::Scene scene;
  scene::Texture tilt; // tangent-space normal (0.6, 0, 0.8)
  image::Image tilted(2, 2, 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const float texel[4] = {0.8f, 0.5f, 0.9f, 1};
    std::copy(texel, texel + 4, tilted.data.begin() + std::ptrdiff_t(4 * i));
  }
  tilt.image = tilted;
  scene::Texture checker; // black and white texels: grey when seen from afar
  image::Image squares(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 4; ++c)
        squares.pixel(x, y)[c] = float((x + y) % 2);
  checker.image = squares;
  scene.textures = {tilt, checker};
  scene::Material m = test::diffuse_material({1, 1, 1});
  m.normal_texture.texture = 0;
  m.base_color_texture.texture = 1;
  m.base_color_texture.tex_coord = 1;
  m.double_sided = true;
  add_square(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, m);
  scene::Mesh& mesh = scene.meshes[0];
  mesh.tangents.assign(4, {1, 0, 0, 1});
  // Set 0 is nearly constant, so its footprint is small; set 1 decides for the checker.
  for (Vec2f& t : mesh.tex_coord_0)
    t = t * 1.0e-3f;

  const render::TextureSet textures(scene);
  const Vec3f away(0, 0, -1);
  const render::SurfacePoint front =
      render::evaluate_surface(scene, textures, 0, 0, 0.25f, 0.25f, away, 1.0f);
  CHECK(double(front.normal.x) == doctest::Approx(0.6).epsilon(1e-3));
  CHECK(double(front.normal.z) == doctest::Approx(0.8).epsilon(1e-3));
  CHECK(double(front.albedo.x) == doctest::Approx(0.5).epsilon(0.01)); // filtered: a metre wide
  const render::SurfacePoint near =
      render::evaluate_surface(scene, textures, 0, 0, 0.265625f, 0.2578125f, away, 1.0e-6f);
  CHECK(std::abs(near.albedo.x - 0.5f) > 0.45f); // the middle of a texel
  const render::SurfacePoint back =
      render::evaluate_surface(scene, textures, 0, 0, 0.25f, 0.25f, -away, 1.0f);
  CHECK(dot(back.normal, back.view) > 0);
  CHECK(dot(back.geometric, back.view) > 0);
}
