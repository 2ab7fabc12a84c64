// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shaders/light_sample.h"

#include <cmath>

namespace openltc::testing {

void store(Vec3d v, float* out) {
  out[0] = float(v.x);
  out[1] = float(v.y);
  out[2] = float(v.z);
}

Vec3d load(const float* p) { return {double(p[0]), double(p[1]), double(p[2])}; }
Vec3f load_float(const float* p) { return {p[0], p[1], p[2]}; }

Vec3d unit(Vec3d v) { return v * (1.0 / std::sqrt(dot(v, v))); }

namespace {

// A frame, and a light of about `size` at `place`.
void place_light(Random& random, LightSample& sample, Vec3d place, double size) {
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
    sample.elements = polygon_elements(sample.packed.view);
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

} // namespace

LightSample make_light_sample(Random& random, metal_run::Shape shape) {
  LightSample sample{};
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

PackedPolygon corners_of(const metal_run::Case& at) {
  const Vec3f c = load_float(at.light), u = load_float(at.light + 3), v = load_float(at.light + 6);
  return pack_polygon({c - u - v, c + u - v, c + u + v, c - u + v}, {4}, normalize(cross(u, v)),
                      at.light[9] > 0);
}

} // namespace openltc::testing
