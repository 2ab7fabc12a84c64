// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A point under a light, and what the shader files for Metal make of it: between C++20, which asks,
// and C++14, as which they are compiled.

#pragma once

namespace metal_run {

enum Shape { k_quad, k_polygon, k_disk, k_sphere, k_tube, k_line, k_textured, k_shapes };

struct Level {
  int columns, rows;
  const float* texels; ///< 4 floats each
};

struct Picture {
  const Level* levels;
  int count;
};

struct Case {
  Shape shape;
  float position[3], normal[3], view[3], base_color[3];
  float metallic, roughness;
  bool tilted; ///< whether `geometric` differs from the normal
  float geometric[3];
  bool corrected; ///< whether small lights become exact
  /// The arguments of the light's make_..., in their order.
  float light[10];
  const float* polygon; ///< 4 floats an element
  Picture picture;
};

/// Reflected light of a light of radiance 1; of one with a picture all of it as `diffuse`.
struct Light {
  float diffuse[3], specular[3];
};

/// By the file with polynomials.
Light shade_by_polynomial(const Case& at);

/// By the file with polynomials of two lobes.
Light shade_by_two_lobe_polynomial(const Case& at);

/// By the file with two lobes, from textures.
Light shade_by_two_lobes(const Case& at, const Picture& coefficients, const Picture& amplitudes,
                         const Picture& second);

/// By points of the light, by the file with polynomials and --sampling: the mean over side^2 evenly
/// spaced pairs of numbers, the share by_lobe of them drawn from the surface's lobe.
void shade_by_points(const Case& at, int side, float by_lobe, double out[3]);

} // namespace metal_run
