// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What you call: a point of a surface, once for all lights.

/// A point with any reflectance. `normal`, on the viewer's side, and `view`, to the eye, are unit, world
/// space; `albedo` is that of the diffuse part, `f0` and `f90` the specular reflectance at normal and
/// grazing incidence, `roughness` 0..1.
FN Surface surface_at(LobeTable table, Vec3 position, Vec3 normal, Vec3 view, Vec3 albedo, Vec3 f0,
                      Vec3 f90, Real roughness) {
  Real cos_theta = dot(normal, view);
  FittedLobe fitted = fetch_lobe_of_roughness(table, roughness, cos_theta);
  return add_second_lobe(make_surface(fitted, position, normal, view, albedo, f0, f90, roughness),
                         fetch_second_lobe_of_roughness(table, roughness, cos_theta));
}
