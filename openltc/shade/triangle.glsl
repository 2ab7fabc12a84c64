// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Directions to a triangle, evenly distributed over its solid angle: how polygons are sampled.
//
// Sources: van Oosterom and Strackee 1983, "The Solid Angle of a Plane Triangle", equation 8; Arvo
// 1995, "Stratified Sampling of Spherical Triangles", whose two steps are these, without his inverse
// trigonometric functions.
//
// With unit vectors a, b, c to the corners the solid angle W is
//   tan(W/2) = a.(b x c) / (1 + a.b + b.c + c.a).
// Let t be the unit vector at a along the side to c, so that c' = a cos p + t sin p runs along it. The
// triangle a b c' has
//   T = tan(W'/2) = n sin p / (q (1 + cos p) + r sin p),   n = t.(a x b), q = 1 + a.b, r = b.t,
// which is n x / (q + r x) with x = tan(p/2), and so x = T q / (n - T r).

/// A triangle seen from a point, which is the origin. What is small is formed of its edges, not of its
/// corners, and keeps its digits however far away it is.
struct SphericalTriangle {
  Vec3 a;           ///< unit
  Vec3 b;           ///< unit
  Vec3 t;           ///< unit: at a, along the side to c
  Real n;           ///< t.(a x b)
  Real q;           ///< 1 + a.b
  Real r;           ///< b.t
  Real solid_angle; ///< steradians, 0..2 pi; 0 in its own plane
};

/// a: from the point to a corner; ab, ac: edges from there.
FN SphericalTriangle spherical_triangle(Vec3 a, Vec3 ab, Vec3 ac) {
  Vec3 b = a + ab;
  Vec3 c = a + ac;
  Real inv_a = inversesqrt(max(dot(a, a), Real(k_tiny)));
  Real inv_b = inversesqrt(max(dot(b, b), Real(k_tiny)));
  Real inv_c = inversesqrt(max(dot(c, c), Real(k_tiny)));
  SphericalTriangle s;
  s.a = a * inv_a;
  s.b = b * inv_b;
  Vec3 normal = cross(a, ab) * (inv_a * inv_b); // a x b
  // Seen from either side.
  Real side = select(dot(normal, ac) < Real(0.0), Real(-1.0), Real(1.0));
  s.t = safe_direction(ac - s.a * dot(s.a, ac));
  s.n = side * dot(normal, s.t);
  s.q = Real(1.0) + dot(s.a, s.b);
  s.r = dot(s.t, ab) * inv_b;
  Real triple = side * dot(normal, ac) * inv_c;
  Real sum = s.q + dot(s.b, c) * inv_c + dot(s.a, c) * inv_c;
  s.solid_angle = Real(2.0) * angle_of(sum, triple);
  return s;
}

/// A direction to the triangle from two numbers in [0, 1), unit. Its density is 1 / solid_angle.
FN Vec3 sample_spherical_triangle(SphericalTriangle s, Vec2 u) {
  // The corner c' that cuts off the share u.x of the solid angle.
  Real half_part = Real(0.5) * u.x * s.solid_angle;
  Real x = sin(half_part) * s.q;
  Real y = s.n * cos(half_part) - sin(half_part) * s.r;
  Real inv_length2 = Real(1.0) / max(x * x + y * y, Real(k_tiny));
  Real cos_p = (y - x) * (y + x) * inv_length2;
  Real sin_p = Real(2.0) * x * y * inv_length2;
  Vec3 c = s.a * cos_p + s.t * sin_p;
  // Evenly in the cosine from b towards it; 1 - cosine is formed of the difference.
  Vec3 side = c - s.b;
  Real one_minus_cos = u.y * Real(0.5) * dot(side, side);
  Real sine = sqrt(max(one_minus_cos * (Real(2.0) - one_minus_cos), Real(0.0)));
  Vec3 across = side - s.b * dot(side, s.b);
  across = across * inversesqrt(max(dot(across, across), Real(k_tiny)));
  Vec3 direction = s.b * (Real(1.0) - one_minus_cos) + across * sine;
  return direction * inversesqrt(max(dot(direction, direction), Real(k_tiny)));
}
