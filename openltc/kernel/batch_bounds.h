// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the surface points of a batch have in common: the range of every quantity that a bound of
// the light they reflect is made of. A kernel measures it, so the points themselves are bounded and
// not the materials they come from.

#pragma once

namespace openltc::kernel {

/// Of the fields that are vectors, the first component is named; the others follow it.
///
/// The mirror frame of a point (shade/lobe.glsl) is x', y, z' in world space, z' being the mirror
/// direction of the view. A direction w of coordinates (x', y, z') in it goes to
///   o = (A x' + aB z', y, aC x' + aD z')
/// in cosine space, and the lobe's density is det max(0, o_z) / (pi |o|^4).
enum BoundField {
  k_bound_position, ///< world space
  k_bound_normal = k_bound_position + 3,
  k_bound_view = k_bound_normal + 3, ///< to the viewer
  k_bound_mirror_x = k_bound_view + 3,
  k_bound_mirror_y = k_bound_mirror_x + 3,
  k_bound_mirror_z = k_bound_mirror_y + 3,
  k_bound_a = k_bound_mirror_z + 3,
  k_bound_ab,
  k_bound_ac,
  k_bound_ad,
  k_bound_density,                        ///< det / (pi share above the horizon)
  k_bound_peak,                           ///< at least the lobe's largest density, over its share
  k_bound_diffuse,                        ///< albedo of the Lambertian part, r g b
  k_bound_specular = k_bound_diffuse + 3, ///< F0 n1, r g b
  k_bound_grazing = k_bound_specular + 3, ///< (F90 - F0) n1, r g b
  k_bound_axis_weight = k_bound_grazing + 3, ///< size of Surface::axis_weight
  k_bound_stretch,   ///< how M^-1 magnifies an emitter's area times its distance from a centre
  k_bound_longest,   ///< and at most how it magnifies any distance
  k_bound_geometric, ///< normal of the triangle
  k_bound_tilt = k_bound_geometric + 3, ///< length of its difference from the shading normal
  k_bound_ratio, ///< what a lobe's light is at most multiplied by: Surface::max_ratio
  /// Of a second lobe the six from k_bound_a to k_bound_peak; all 0 where there is none. The
  /// weights of both lobes are in their densities and peaks.
  k_bound_second,
  k_bound_second_density = k_bound_second + (k_bound_density - k_bound_a),
  k_bound_second_peak,
  k_bound_alpha,     ///< Surface::alpha
  k_bound_cos_view,  ///< cosine of the view, 0..1
  k_bound_amplitude, ///< n1
  k_bound_field_count
};

/// Range of each field over the points of a batch.
struct BatchBounds {
  float lower[k_bound_field_count];
  float upper[k_bound_field_count];
};

} // namespace openltc::kernel
