// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights of every shape around a place, as shading has them and by GGX itself at points of them, in
// double precision.

#pragma once

#include "openltc/target/shade_f64.h"
#include "random.h"

#include <functional>

namespace openltc::testing {

/// How the specular part of area lights is shaded.
enum class LightForm { lobe, ratio, two_lobes, two_lobes_ratio, adaptive, exact };

struct NamedForm {
  const char* name;
  LightForm form;
};
inline constexpr NamedForm k_light_forms[] = {{"one lobe", LightForm::lobe},
                                              {"one lobe, ratio", LightForm::ratio},
                                              {"two lobes", LightForm::two_lobes},
                                              {"two lobes, ratio", LightForm::two_lobes_ratio},
                                              {"two lobes or GGX", LightForm::adaptive},
                                              {"exact", LightForm::exact}};

/// A point at the origin, normal up, seen from the angle theta in the plane of x, by the built-in
/// tables. `albedo` is that of the diffuse part.
f64::Surface surface_of_form(LightForm form, double theta, double roughness, double f0 = 1,
                             double albedo = 0);

/// What `meets` holds of the light by visible normals, spread evenly (Hammersley's points, 2^bits):
/// of directions of world space. For F = 1; where all meet it is the albedo of GGX.
double visible_normals(const f64::Surface& s, int bits, const std::function<bool(Vec3d)>& meets);

/// A light of some shape at a place: what it shades, and what is true.
struct PlacedLight {
  std::function<double(const f64::Surface&)> shade;
  std::function<double(const f64::Surface&, int steps)> exact; ///< midpoints, steps each way
};

struct Placed {
  Vec3d center, u, v; ///< half extents at right angles, facing the origin with u x v
};

PlacedLight placed_quad(Placed at);

struct PlacedShape {
  const char* name;
  PlacedLight (*make)(Placed);
};

/// Quad, ellipse, sphere, line, capsule.
extern const PlacedShape k_placed_shapes[5];

/// Somewhere above, more or less towards the point.
Placed random_place(double size, Random& random);

} // namespace openltc::testing
