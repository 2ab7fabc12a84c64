// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A light of four corners, known by its middle.

/// A rectangle or parallelogram in world space; emits along half_u x half_v.
struct Quad {
  Vec3 center;    ///< world space
  Vec3 half_u;    ///< from there to the middle of one side, metres
  Vec3 half_v;    ///< and to that of the next, counter-clockwise as seen from the front
  Real two_sided; ///< 0 or 1
};

/// Corner i, counter-clockwise as seen from the front; 4 is the first again.
FN Vec3 quad_point(Quad quad, int i) {
  Real u = i == 1 || i == 2 ? Real(1.0) : Real(-1.0);
  Real v = i == 2 || i == 3 ? Real(1.0) : Real(-1.0);
  return quad.center + quad.half_u * u + quad.half_v * v;
}

/// A point of its plane.
FN Vec3 quad_origin(Quad quad) { return quad.center; }

/// Unit, to the emitting side.
FN Vec3 quad_normal(Quad quad) {
  Vec3 normal = cross(quad.half_u, quad.half_v);
  return normal * inversesqrt(max(dot(normal, normal), Real(k_tiny)));
}

/// Whether it emits to both sides.
FN bool quad_two_sided(Quad quad) { return quad.two_sided > Real(0.0); }

/// Square metres.
FN Real quad_area(Quad quad) {
  Vec3 normal = cross(quad.half_u, quad.half_v);
  return sqrt(dot(normal, normal)) * Real(4.0);
}

/// The middle of its area.
FN Vec3 quad_centroid(Quad quad) { return quad.center; }

/// From there to the middle of the side from corner 1 to 2.
FN Vec3 quad_half_u(Quad quad) { return quad.half_u; }

/// And of that from 2 to 3.
FN Vec3 quad_half_v(Quad quad) { return quad.half_v; }

/// The distance of the farthest corner from there.
FN Real quad_radius(Quad quad) {
  return sqrt(dot(quad.half_u, quad.half_u) + dot(quad.half_v, quad.half_v) +
              Real(2.0) * abs(dot(quad.half_u, quad.half_v)));
}

/// sqrt(2/3): sqrt(2) times the standard deviation of -1..1.
CONSTANT k_quad_spread = 0.81649658092772603;

/// Half of what stands for it where it is small: the mean over centroid +- spread_u and +- spread_v is
/// that over its area for every quadratic function.
FN Vec3 quad_spread_u(Quad quad) { return quad.half_u * Real(k_quad_spread); }

/// And the other half.
FN Vec3 quad_spread_v(Quad quad) { return quad.half_v * Real(k_quad_spread); }
