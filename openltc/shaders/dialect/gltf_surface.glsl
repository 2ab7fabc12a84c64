// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A point of glTF 2.0's material model, and what may be added to a point.

/// A point of a surface by glTF's metallic-roughness model; all values 0..1, colours linear.
FN Surface gltf_surface(Lobes table, Vec3 position, Vec3 normal, Vec3 view, Vec3 base_color,
                        Real metallic, Real roughness) {
  Vec3 dielectric = Vec3(Real(0.04), Real(0.04), Real(0.04));
  Vec3 f0 = dielectric + (base_color - dielectric) * metallic;
  return surface_at(table, position, normal, view, base_color * (Real(1.0) - metallic), f0,
                    Vec3(Real(1.0), Real(1.0), Real(1.0)), roughness);
}
