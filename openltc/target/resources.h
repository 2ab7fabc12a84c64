// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the dialect's resource handles, LobeTable, LobePolynomial and Polygon, are in C++: views of
// plain arrays, the same for every number type. The owner of the arrays outlives the views.

#pragma once

namespace openltc {

/// View of a lobe table in the native packing.
struct LobeTableView {
  /// columns * rows texels, row-major, y (view angle) slow and x (roughness) fast, of 8 floats
  /// each: A B C D n1 n5 0 0. 32-byte texels let a lane build load one with a single instruction.
  const float* texels = nullptr;
  int columns = 0;
  int rows = 0;
};

/// View of the polynomial form of fitted lobes; see shade/polynomial.glsl.
struct LobePolynomialView {
  /// (degree + 1)(degree + 2)/2 terms of 8 floats each, A B C D n1 n5 0 0, the coefficients of
  /// T_i(u) T_j(v): j from 0 slow, i from 0 to degree - j fast.
  const float* coefficients = nullptr;
  int degree = 0;
};

/// View of a polygon light's outline.
struct PolygonView {
  const float* points = nullptr;   ///< point_count * 4: x y z (world space), 1 where a ring starts
  const float* in_plane = nullptr; ///< point_count * 2: the same points in (axis_u, axis_v)
  int point_count = 0;             ///< every ring repeats its first point at its end
  bool two_sided = false;
  float area = 0;              ///< square metres
  float origin[3] = {0, 0, 0}; ///< a point of the plane, world space
  float axis_u[3] = {1, 0, 0}; ///< orthonormal with axis_v and normal
  float axis_v[3] = {0, 1, 0};
  float normal[3] = {0, 0, 1}; ///< towards the emitting side
};

} // namespace openltc
