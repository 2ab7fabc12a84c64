// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What every light gives at random points, as numbers: to compare machines and compilers with each
// other (tools/cross.sh). A line is a name, the number of its case and values.
//
// Includes nothing but the public API, and draws its random numbers itself, since those of the
// standard library differ from one to another.

#include "openltc/openltc.h"

#include <cstdint>
#include <cstdio>

using namespace openltc;

namespace {

/// A linear congruential generator, Knuth's MMIX, of which the upper half is used.
class Random {
public:
  float between(float a, float b) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return a + (b - a) * (float(state_ >> 40) / 16777216.0f);
  }
  Vec3f in_box(float half) {
    const float x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }

private:
  std::uint64_t state_ = 5;
};

void print(const char* name, int number, Vec3f a, Vec3f b) {
  std::printf("%s %d %.9g %.9g %.9g %.9g %.9g %.9g\n", name, number, double(a.x), double(a.y),
              double(a.z), double(b.x), double(b.y), double(b.z));
}

template <class Light>
void print_light(const char* name, int number, const Surface& surface, const Light& light) {
  const ShadedParts parts = shade_parts(surface, light);
  print(name, number, parts.diffuse, parts.specular);
}

template <class Light>
void print_sampled(const char* name, int number, const Surface& surface, const Light& light,
                   Vec2f u) {
  print_light(name, number, surface, light);
  const LightSample sample = sample_light(surface, light, u);
  if (sample.valid) print("  sample", number, sample.direction, {sample.pdf, sample.distance, 0});
}

} // namespace

int main() {
  Random random;
  for (int i = 0; i < 400; ++i) {
    Material material;
    material.base_color = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    material.metallic = i % 3 == 0 ? 1.0f : 0.0f;
    // Narrower lobes turn the rounding of a direction into more of their own.
    material.roughness = random.between(0.15f, 1);
    const Lobes lobes = i % 2 ? built_in_table() : built_in_polynomial();
    const Vec3f position = random.in_box(1), normal = random.in_box(1), view = random.in_box(1);
    const Surface surface = make_surface(position, normal, view, material, lobes);
    const Vec3f center = random.in_box(2), u = random.in_box(0.7f);
    const Vec3f v = cross(u, random.in_box(1));
    const float radius = random.between(0.05f, 0.8f);
    const Vec2f place{random.between(0, 1), random.between(0, 1)}; // braces: from left to right
    print_sampled("rectangle", i, surface, Polygon::rectangle(center, u, v, true), place);
    print_sampled("triangle", i, surface,
                  Polygon::from_vertices({center - u, center + v, center + u}, true), place);
    print_sampled("ellipse", i, surface, Ellipse{center, u, v, true}, place);
    print_sampled("sphere", i, surface, Sphere{center, radius}, place);
    print_sampled("tube", i, surface, Tube{center, center + v, radius, TubeCaps(i % 3)}, place);
    print_light("line", i, surface, Line{center, center + v});
    print_light("point", i, surface, PointLight{center, {9, 9, 9}, 0});
    print_light("spot", i, surface, SpotLight{center, u, {9, 9, 9}, 5, 0.3f, 1.2f});
    print_light("sun", i, surface, DirectionalLight{u, {9, 9, 9}});
    const DirectionSample drawn = sample_surface(surface, place);
    if (drawn.valid) print("direction", i, drawn.direction, {drawn.pdf, drawn.value.x, 0});
  }
  return 0;
}
