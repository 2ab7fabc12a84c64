// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Quads in double. The polygons of C++ keep normal, area and spread in single precision, which for
// a huge quad is an error of its own; so here the dialect has a polygon of doubles.

#include "openltc/api/ggx_polynomial.inc"
#include "openltc/target/resources.h"
#include "openltc/target/vec.h"
#include "tests/parity/shader_case.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace openltc::exact {

/// A PolygonView of doubles.
struct ExactPolygon {
  const double* points = nullptr;
  const double* in_plane = nullptr;
  int point_count = 0;
  bool two_sided = false, parallelogram = false;
  double area = 0, radius = 0;
  double origin[3], axis_u[3], axis_v[3], normal[3], centroid[3], spread_u[3], spread_v[3];
  const float* triangles = nullptr; // for sampling, which nobody asks for here
  const float* triangle_cdf = nullptr;
  int triangle_count = 0;
};

inline Vec3T<double> load3(const double* p) { return {p[0], p[1], p[2]}; }

using Scalar = double;
#define PolygonView ExactPolygon
// Each builds on the one before.
// clang-format off
#include "openltc/target/scalar.inc"
#include "openltc/target/shade_all.inc"
#include "tests/parity/case_body.inc"
// clang-format on
#include "openltc/target/names_back.inc"
#undef PolygonView

} // namespace openltc::exact

namespace openltc::testing {

void shade_exact_quad(const double* numbers, double* out) {
  using exact::load3;
  const Vec3d center = load3(numbers + 16), u = load3(numbers + 20), v = load3(numbers + 24);
  const Vec3d across = cross(u, v);
  const double quarter = std::sqrt(dot(across, across));
  const auto put = [](Vec3d from, double* to) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
  };
  double points[20] = {};
  const double sides[][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (int i = 0; i < 5; ++i)
    put(center + u * sides[i][0] + v * sides[i][1], points + 4 * i);
  points[3] = 1;

  exact::ExactPolygon quad;
  quad.points = points;
  quad.point_count = quarter > 0 ? 5 : 0;
  quad.two_sided = numbers[23] > 0;
  quad.parallelogram = quarter > 0;
  quad.area = 4 * quarter;
  quad.radius = std::sqrt(std::max(dot(u + v, u + v), dot(u - v, u - v)));
  put(center, quad.origin);
  put(center, quad.centroid);
  put(across * (quarter > 0 ? 1 / quarter : 0.0), quad.normal);
  // sqrt(2) times the standard deviation over -1..1 (polygon_data.glsl).
  put(u * std::sqrt(2.0 / 3.0), quad.spread_u);
  put(v * std::sqrt(2.0 / 3.0), quad.spread_v);
  exact::shade_case(CaseShape::quad, int(numbers[15]), numbers, quad,
                    {k_ggx_polynomial, k_ggx_polynomial_degree}, out);
}

} // namespace openltc::testing
