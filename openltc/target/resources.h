// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the dialect's resource handles, LobeTable, LobePolynomial, Polygon, Profile and
// EmissionTexture, are in C++: views of plain arrays, the same for every number type. The owner of
// the arrays outlives the views.

#pragma once

#include <cassert> // for the preludes: ASSERT_THAT
#include <cstddef>
#include <cstdint>

namespace openltc {

/// \addtogroup dialect
/// @{

/// View of a lobe table in the native packing.
struct LobeTableView {
  /// columns * rows texels, row-major, y (view angle) slow and x (roughness) fast, of 8 floats
  /// each: A B C D n1 n5 w 0. 32-byte texels let a lane build load one with a single instruction.
  const float* texels = nullptr;
  int columns = 0; ///< nodes of roughness
  int rows = 0;    ///< nodes of view angle
  /// A second lobe at every node, of weight w, 0..1, beside the first, which has the rest of n1: as
  /// many texels of 4 floats, its A B C D. Null: there is none, and w is 0.
  const float* second = nullptr;
};

/// View of the polynomial form of fitted lobes; see shade/polynomial.glsl.
struct LobePolynomialView {
  /// (degree + 1)(degree + 2)/2 terms of 8 floats each, A B C D n1 s t 0 with s = (n5/n1)^(1/5),
  /// the coefficients of T_i(u) T_j(v): j from 0 slow, i from 0 to degree - j fast.
  const float* coefficients = nullptr;
  int degree = 0; ///< in both variables together
  /// A second lobe, as many terms of 4 floats, its A B C D; its share of n1 is
  /// (1 + t / sqrt(1 + t^2)) / 2. Null: there is none, and t is 0.
  const float* second = nullptr;
};

/// View of a polygon light's outline.
struct PolygonView {
  const float* points = nullptr;   ///< point_count * 4: x y z (world space), 1 where a ring starts
  const float* in_plane = nullptr; ///< point_count * 2: the same points in (axis_u, axis_v)
  int point_count = 0;             ///< every ring repeats its first point at its end
  bool two_sided = false;          ///< whether it emits against its normal too
  bool parallelogram = false;      ///< whether it is one, of four corners
  float area = 0;                  ///< square metres
  float origin[3] = {0, 0, 0};     ///< a point of the plane, world space
  float axis_u[3] = {1, 0, 0};     ///< orthonormal with axis_v and normal
  float axis_v[3] = {0, 1, 0};     ///< normal x axis_u
  float normal[3] = {0, 0, 1};     ///< towards the emitting side
  float centroid[3] = {0, 0, 0};   ///< of the area, world space
  float spread_u[3] = {0, 0, 0};   ///< see PolygonMoments, world space
  float spread_v[3] = {0, 0, 0};   ///< and the one across
  float radius = 0;                ///< metres from the centroid to the farthest point
  /// Its area cut into triangles, for sampling: triangle_count * 9 floats, corner, edge, edge
  /// (world space).
  const float* triangles = nullptr;
  const float* triangle_cdf = nullptr; ///< running share of the area, 1 for the last
  int triangle_count = 0;              ///< triangles
};

/// View of a luminous intensity by direction; see shade/punctual.glsl.
struct ProfileView {
  /// columns * rows values from 0 to 1, shares of the maximum. Rows are slow: row j of n stands for
  /// the angle pi j/(n - 1) from the light's axis. Columns are fast: column i of m stands for the
  /// azimuth 2 pi i/(m - 1), the last being the first again; one column is the same all around.
  const float* values = nullptr;
  int columns = 0; ///< azimuths
  int rows = 0;    ///< angles from the axis
};

/// Linear values of a texture in the precision of its file: exactly one of the three pointers is
/// set, and `table` with the first two: what each of the 256 or 65536 values stands for. Grey
/// textures, of `grey_channels` samples a pixel (grey and alpha; 0 = not grey), are read as if each
/// pixel had three alike.
struct TextureSamples {
  const float* floats = nullptr;         ///< linear values
  const std::uint8_t* bits8 = nullptr;   ///< or places in a table of 256
  const std::uint16_t* bits16 = nullptr; ///< or in one of 65536
  const float* table = nullptr;          ///< linear values that they stand for
  std::size_t grey_channels = 0;         ///< samples a pixel of a grey texture; 0 = not grey

  /// Value i, three a pixel where the picture is grey.
  float operator[](std::size_t i) const {
    if (grey_channels != 0) i = i / 3 * grey_channels;
    return bits8 ? table[bits8[i]] : bits16 ? table[bits16[i]] : floats[i];
  }
};

/// View of a light's texture: prefiltered, as light/emission_stack.h makes it, and as it
/// is. The stack covers the light's bounding rectangle in its plane.
struct EmissionTextureView {
  /// All levels one after the other, rows from v = 0, 4 floats a texel: r g b times the share of
  /// the light in the texel's neighbourhood, and that share.
  const float* texels = nullptr;
  /// 4 numbers a level: first texel, columns, rows, 0. Columns and rows are powers of two and half
  /// those of the level before, but at least 1; the last level is one texel, the light's mean.
  const std::int32_t* levels = nullptr;
  int level_count = 0;         ///< levels, the finest first
  float corner[3] = {0, 0, 0}; ///< of the rectangle, world space
  float axis_u[3] = {1, 0, 0}; ///< unit, orthogonal: its sides
  float axis_v[3] = {0, 1, 0}; ///< the side across
  float extent[2] = {1, 1};    ///< their lengths, metres

  /// The texture itself: texture_columns * texture_rows texels of texture_channels values (3 or
  /// more: r g b ...), linear, clamped; what is negative or not a number counts as 0.
  TextureSamples texture;
  int texture_columns = 0;  ///< texels in a row of the texture
  int texture_rows = 0;     ///< rows of the texture
  int texture_channels = 3; ///< values a texel
  /// Its coordinates at a point p of the light: u = (p - texture_origin) . texture_u, v alike.
  float texture_origin[3] = {0, 0, 0};
  float texture_u[3] = {1, 0, 0}; ///< of u: 1/metres, world space
  float texture_v[3] = {0, 1, 0}; ///< of v

  /// For sampling: the stack's finest level as a distribution. Running shares of cell_rows rows.
  const float* row_cdf = nullptr;
  const float* cell_cdf = nullptr; ///< and in each row of its cell_columns cells
  int cell_columns = 0;            ///< cells in a row
  int cell_rows = 0;               ///< rows
  /// Of all samples this share is drawn by the cells; 0 where the texture is too even to gain by
  /// it.
  float cell_share = 0;
};

/// @}

} // namespace openltc
