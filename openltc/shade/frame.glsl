// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shading frame: t1 in the plane of normal and view direction, t2 = n x t1, n.
//
// In it wo = (sin theta, 0, cos theta), so an isotropic BRDF depends on theta and roughness alone.

/// The shading frame of a point: the axes x, y and z of shading space, orthonormal.
struct Frame {
  Vec3 t1; ///< unit, world space
  Vec3 t2; ///< n x t1
  Vec3 n;  ///< the normal
};

/// A unit vector perpendicular to the unit vector n, without a branch: Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited", equation 3.
FN Vec3 any_perpendicular(Vec3 n) {
  Real s = select(n.z < Real(0.0), Real(-1.0), Real(1.0));
  Real a = Real(-1.0) / (s + n.z);
  return Vec3(Real(1.0) + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

/// Frame of a unit normal and a unit direction to the viewer, world space. When the two are
/// parallel any tangent serves.
FN Frame shading_frame(Vec3 n, Vec3 wo) {
  ASSERT_THAT(is_unit(n));
  Vec3 in_plane = wo - n * dot(n, wo);
  Real length2 = dot(in_plane, in_plane);

  // Below this sine, 1e-4, rounding would dominate the direction; the lobe is round there.
  Mask parallel = length2 < Real(1.0e-8);
  Vec3 t1 = in_plane * inversesqrt(max(length2, Real(1.0e-8)));
  // Uniform shortcut: no lane looks along its normal.
  if (any_lane(parallel)) {
    t1 = select(parallel, any_perpendicular(n), t1);
  }

  Frame frame;
  frame.t1 = t1;
  frame.t2 = cross(n, t1);
  frame.n = n;
  return frame;
}

/// A vector of world space in shading space.
FN Vec3 to_shading(Frame frame, Vec3 v_world) {
  return Vec3(dot(frame.t1, v_world), dot(frame.t2, v_world), dot(frame.n, v_world));
}

/// A vector of shading space in world space.
FN Vec3 to_world(Frame frame, Vec3 v_shading) {
  return frame.t1 * v_shading.x + frame.t2 * v_shading.y + frame.n * v_shading.z;
}
