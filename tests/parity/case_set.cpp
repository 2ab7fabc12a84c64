// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/parity/case_set.h"

#include "openltc/api/ggx_polynomial.inc"

#include <algorithm>
#include <cmath>

namespace openltc::testing {

namespace {

LightShape light_shape_of(CaseShape shape, int block) {
  // Random and adversarial blocks take turns.
  const int kind = block / 2;
  switch (shape) {
  case CaseShape::quad:
    return LightShape::rectangle;
  case CaseShape::polygon:
    return LightShape::polygon;
  case CaseShape::disk:
    return kind % 2 == 0 ? LightShape::disk : LightShape::ellipse;
  case CaseShape::sphere:
    return LightShape::sphere;
  case CaseShape::tube:
    return LightShape(int(LightShape::tube_open) + kind % 3);
  default:
    return LightShape::line;
  }
}

struct Parallelogram {
  Vec3f center, half_u, half_v;
};

// A rectangle whose corners are exact in single precision, so that it does not matter who adds them
// up: along each axis, all is rounded to a 2^-20 of the largest.
Parallelogram exact_quad(const PolygonView& view) {
  Vec3d corners[4];
  for (int i = 0; i < 4; ++i)
    corners[i] = to_double(f32::polygon_point(view, i));
  const Vec3d center = (corners[0] + corners[2]) * 0.5;
  const Vec3d u = (corners[1] - corners[0]) * 0.5, v = (corners[3] - corners[0]) * 0.5;
  const auto rounded = [](double& a, double& b, double& c) {
    const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
    if (largest == 0) return;
    const double step = std::ldexp(1.0, std::ilogb(largest) - 20);
    for (double* x : {&a, &b, &c})
      *x = std::nearbyint(*x / step) * step;
  };
  Vec3d c = center, p = u, q = v;
  rounded(c.x, p.x, q.x);
  rounded(c.y, p.y, q.y);
  rounded(c.z, p.z, q.z);
  return {to_float(c), to_float(p), to_float(q)};
}

std::unique_ptr<const PackedPolygon> packed(const Parallelogram& quad, bool two_sided) {
  const Vec3f c = quad.center, u = quad.half_u, v = quad.half_v;
  const Vec3d n = cross(to_double(u), to_double(v));
  const double length2 = dot(n, n);
  if (!(length2 > 0)) return std::make_unique<const PackedPolygon>();
  return std::make_unique<const PackedPolygon>(
      pack_polygon({c - u - v, c + u - v, c + u + v, c - u + v}, {4},
                   to_float(n / std::sqrt(length2)), two_sided));
}

// Turned from the shading normal, unless the eye would see its back. Half are not: what lanes have
// in common with a neighbour that is, must not change them.
Vec3f triangle_normal(const LightCase& light, Random& random) {
  const Vec3d n = to_double(light.normal), wo = to_double(light.wo);
  if (random.uniform(0, 1) < 0.5) return light.normal;
  const Vec3d turned = normalize(n + random.sphere() * random.uniform(0.01, 0.4));
  return dot(turned, wo) < 0.01 ? light.normal : to_float(turned);
}

void add_case(CaseSet& set, const LightCase& light, const Parallelogram& quad, float extra,
              int form, Random& random) {
  const bool flat = set.shape == CaseShape::quad;
  const auto add = [&](Vec3f v, float w) {
    set.numbers.insert(set.numbers.end(), {v.x, v.y, v.z, w});
  };
  add(light.position, light.roughness);
  add(light.normal, light.albedo);
  add(light.wo, light.f0);
  add(triangle_normal(light, random), float(form));
  add(flat ? quad.center : light.a, light.radius);
  add(flat ? quad.half_u : light.b, extra);
  add(flat ? quad.half_v : light.c, 0);
}

} // namespace

CaseBlock CaseSet::block(int index) const {
  return {shape,
          numbers.data() + std::ptrdiff_t(index) * k_case_block * k_case_numbers,
          polygons.empty() ? PolygonView{} : polygons[std::size_t(index)],
          {k_ggx_polynomial, k_ggx_polynomial_degree}};
}

CaseSet make_cases(CaseShape shape) {
  CaseSet set;
  set.shape = shape;
  Random random(std::uint64_t(shape) + 11);
  for (int block = 0; block < k_case_count / k_case_block; ++block) {
    const LightShape light_shape = light_shape_of(shape, block);
    const int form =
        block / 12 % k_case_forms; // six pairs of blocks: every kind of disk and tube in every form
    const std::vector<LightCase> lights = fuzz_lights(light_shape, std::uint64_t(block));
    Parallelogram quad;
    float extra = 0;
    if (shape == CaseShape::quad) {
      quad = exact_quad(lights[0].polygon->view());
      set.quads.push_back(packed(quad, lights[0].two_sided));
      set.polygons.push_back(set.quads.back()->view);
      set.polygons.back().two_sided = lights[0].two_sided;
    } else if (shape == CaseShape::polygon) {
      set.outlines.push_back(lights[0].polygon);
      set.polygons.push_back(lights[0].polygon->view());
      extra = float(set.elements.size() / 4);
      const std::vector<float> elements = polygon_elements(set.polygons.back());
      set.elements.insert(set.elements.end(), elements.begin(), elements.end());
    } else if (shape == CaseShape::tube) {
      extra = float(int(light_shape) - int(LightShape::tube_open));
    }
    for (const LightCase& light : lights) {
      const bool has_sides = shape == CaseShape::quad || shape == CaseShape::disk;
      add_case(set, light, quad, has_sides && light.two_sided ? 1.0f : extra, form, random);
    }
  }
  return set;
}

} // namespace openltc::testing
