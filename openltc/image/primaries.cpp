// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: SMPTE RP 177-1993, "Derivation of Basic Television Color Equations", for the matrix of a
// set of primaries; Lam 1985, "Metamerism and Colour Constancy", as in Lindbloom, "Chromatic
// Adaptation", for the Bradford transform; ITU-R BT.709-6, items 1.3 and 1.4.

#include "openltc/image/primaries.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace openltc::image {

namespace {

constexpr double k_largest = double(std::numeric_limits<float>::max());

using Column = std::array<double, 3>;

Column operator*(const ColorMatrix& m, const Column& v) {
  Column out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

ColorMatrix operator*(const ColorMatrix& a, const ColorMatrix& b) {
  ColorMatrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}

double determinant(const ColorMatrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

ColorMatrix inverse(const ColorMatrix& m) {
  const double d = determinant(m);
  ColorMatrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
      out[i][j] = (m[a][c] * m[b][e] - m[a][e] * m[b][c]) / d;
    }
  return out;
}

Column xyz_of_white(const std::array<double, 2>& xy) {
  return {xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]};
}

// Cone responses of the Bradford transform from XYZ.
constexpr ColorMatrix k_bradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

bool is_xyz(const Primaries& p) {
  const auto near = [](const std::array<double, 2>& xy, double x, double y) {
    return std::fabs(xy[0] - x) < 1e-6 && std::fabs(xy[1] - y) < 1e-6;
  };
  return near(p.red, 1, 0) && near(p.green, 0, 1) && near(p.blue, 0, 0);
}

} // namespace

bool is_rec709(const Primaries& primaries) {
  const Primaries rec709;
  const auto near = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::fabs(a[0] - b[0]) <= 1e-3 && std::fabs(a[1] - b[1]) <= 1e-3;
  };
  return near(primaries.red, rec709.red) && near(primaries.green, rec709.green) &&
         near(primaries.blue, rec709.blue) && near(primaries.white, rec709.white);
}

std::optional<ColorMatrix> xyz_from_rgb(const Primaries& p) {
  ColorMatrix columns{};
  const std::array<std::array<double, 2>, 3> corners = {p.red, p.green, p.blue};
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = corners[c][0], y = corners[c][1];
    if (!(std::fabs(x) <= 10 && std::fabs(y) <= 10)) return {}; // no NaN either
    columns[0][c] = x;
    columns[1][c] = y;
    columns[2][c] = 1 - x - y;
  }
  if (!(std::fabs(determinant(columns)) > 1e-4)) return {};
  if (!(p.white[0] >= 0 && p.white[0] <= 1 && p.white[1] > 0.01 && p.white[1] <= 1)) return {};
  const Column weights = inverse(columns) * xyz_of_white(p.white);
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(weights[c] > 0)) return {};
    for (std::size_t i = 0; i < 3; ++i)
      columns[i][c] *= weights[c];
  }
  return columns;
}

ColorMatrix rec709_from_xyz() { return inverse(*xyz_from_rgb(Primaries{})); }

std::optional<ColorMatrix> rec709_from_rgb(const Primaries& primaries) {
  const std::optional<ColorMatrix> to_xyz = xyz_from_rgb(primaries);
  if (!to_xyz) return {};
  if (is_xyz(primaries)) return rec709_from_xyz() * *to_xyz;
  const Column from = k_bradford * xyz_of_white(primaries.white);
  const Column to = k_bradford * xyz_of_white(Primaries{}.white);
  ColorMatrix scale{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(from[i] > 1e-3)) return {};
    scale[i][i] = to[i] / from[i];
  }
  return rec709_from_xyz() * inverse(k_bradford) * scale * k_bradford * *to_xyz;
}

void multiply_colors(const ColorMatrix& m, Image& image) {
  if (image.channels < 3) return;
  for (std::size_t i = 0; i < image.data.size(); i += std::size_t(image.channels)) {
    float* p = &image.data[i];
    const Column v = m * Column{double(p[0]), double(p[1]), double(p[2])};
    // What was finite stays so.
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = float(finite ? std::clamp(v[c], -k_largest, k_largest) : v[c]);
  }
}

} // namespace openltc::image
