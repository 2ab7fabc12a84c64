// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Elliptic cones: what ellipses, disks and spheres fill of the directions around a point, and what a
// linear map makes of that, which is an elliptic cone again. Their vector irradiance, exact and
// clipped to both horizons.
//
// Sources: the cone's axes as eigenvectors, and the whole cone's irradiance, follow Heitz and Hill
// 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines". They clip to the
// horizon by the form factor of a sphere of the same irradiance; here the arcs that are left above
// the horizons are integrated themselves, which is as exact as the edges of a polygon:
//
// In the frame of its axes the cone's outline is the curve of unit vectors
//   v(t) = (k1 cos t, k2 sin t, N),   N^2 = c1^2 cos^2 t + c2^2 sin^2 t,
// k and c being the sines and cosines of its half angles along the first two axes (k1 >= k2). With
// m^2 = k1^2 - k2^2, the integral of v x dv, which is the vector irradiance times 2 pi, is
//   ( -k2 c1^2 atanh(m sin t / N) / m,   k1 c2^2 atan(m cos t / N) / m,   k1 k2 t ).
// The whole circle leaves 2 pi k1 k2 along the axis. (Differentiate; v x dv / dt = (-k2 c1^2 cos t,
// -k1 c2^2 sin t, ...)/N, and N dN = m^2 sin t cos t dt.)
//
// A plane through the origin cuts that curve in at most two points, which bound one interval of t.
// What lies above both horizons is therefore the intersection of two intervals of a circle, at most
// two pieces, and each is closed by arcs to the wedge's apex as the edges of edge.glsl are.

/// An elliptic cone of directions around its apex, the point.
struct Cone {
  Vec3 e1; ///< orthonormal, right-handed; e3 the axis
  Vec3 e2; ///< the second axis, of the smaller half angle
  Vec3 e3; ///< the axis of the cone
  Real k1; ///< sines of the half angles, k1 >= k2
  Real k2; ///< of the one along e2
  Real c1; ///< their cosines, c1 <= c2
  Real c2; ///< of the one along e2
};

/// A symmetric matrix in a basis of its own, on the way to being diagonal.
struct Diagonalisation {
  Real s11; ///< its elements in that basis, by row and column
  Real s22; ///< see s11
  Real s33; ///< see s11
  Real s12; ///< see s11
  Real s13; ///< see s11
  Real s23; ///< see s11
  Vec3 e1;  ///< the basis, orthonormal
  Vec3 e2;  ///< see e1
  Vec3 e3;  ///< see e1
};

/// The tangent of the smaller rotation that clears the element `pq` between `pp` and `qq`.
FN Real jacobi_tangent(Real pp, Real qq, Real pq) {
  Real d = qq - pp;
  Real root = sqrt(d * d + Real(4.0) * pq * pq);
  Real t = Real(2.0) * pq / (d + select(d < Real(0.0), -root, root) + Real(k_tiny));
  return min(max(t, Real(-1.0)), Real(1.0));
}

/// One sweep of Jacobi's method.
FN Diagonalisation jacobi_sweep(Diagonalisation j) {
  Real t = jacobi_tangent(j.s11, j.s33, j.s13);
  Real c = inversesqrt(Real(1.0) + t * t);
  Real s = t * c;
  j.s11 = j.s11 - t * j.s13;
  j.s33 = j.s33 + t * j.s13;
  j.s13 = Real(0.0);
  Real s12 = c * j.s12 - s * j.s23;
  j.s23 = s * j.s12 + c * j.s23;
  j.s12 = s12;
  Vec3 e1 = j.e1 * c - j.e3 * s;
  j.e3 = j.e1 * s + j.e3 * c;
  j.e1 = e1;

  t = jacobi_tangent(j.s22, j.s33, j.s23);
  c = inversesqrt(Real(1.0) + t * t);
  s = t * c;
  j.s22 = j.s22 - t * j.s23;
  j.s33 = j.s33 + t * j.s23;
  j.s23 = Real(0.0);
  s12 = c * j.s12 - s * j.s13;
  j.s13 = s * j.s12 + c * j.s13;
  j.s12 = s12;
  Vec3 e2 = j.e2 * c - j.e3 * s;
  j.e3 = j.e2 * s + j.e3 * c;
  j.e2 = e2;

  t = jacobi_tangent(j.s11, j.s22, j.s12);
  c = inversesqrt(Real(1.0) + t * t);
  s = t * c;
  j.s11 = j.s11 - t * j.s12;
  j.s22 = j.s22 + t * j.s12;
  j.s12 = Real(0.0);
  Real s13 = c * j.s13 - s * j.s23;
  j.s23 = s * j.s13 + c * j.s23;
  j.s13 = s13;
  e1 = j.e1 * c - j.e2 * s;
  j.e2 = j.e1 * s + j.e2 * c;
  j.e1 = e1;
  return j;
}

/// The cone of directions to the ellipse center + a cos t + b sin t, as seen from the origin. a and
/// b need not be perpendicular. An ellipse seen edge-on gives a flat cone, one around the origin a
/// half-space.
///
/// With K = [a b center], the directions v = K w, w.x^2 + w.y^2 <= w.z^2, are v' Q v <= 0 with
/// Q = K^-T diag(1, 1, -1) K^-1. Its inverse, S = a a' + b b' - center center', has the same
/// eigenvectors and needs no division. One of its eigenvalues, -q, is negative and belongs to the
/// axis; the others are s_i = q tan^2 of the half angles. The matrix is set up in a basis whose third
/// axis is close to the cone's: then the small elements of a narrow cone are not lost beside the
/// large one, and three sweeps of Jacobi's method find all to the last digits.
FN_CALL Cone make_cone(Vec3 center, Vec3 a, Vec3 b) {
  Real size2 = dot(center, center) + dot(a, a) + dot(b, b);
  Real scale = inversesqrt(max(size2, Real(k_tiny)));
  Vec3 c = center * scale;
  Vec3 p = a * scale;
  Vec3 q = b * scale;

  // Start from the direction to the centre, or from the ellipse's normal where that is closer to
  // the axis: where S is more negative along it.
  Vec3 n = cross(p, q);
  n = n * inversesqrt(max(dot(n, n), Real(k_tiny)));
  Real height = dot(n, c);
  Vec3 z_normal = n * select(height < Real(0.0), Real(-1.0), Real(1.0));
  Real c_length2 = dot(c, c);
  Real inv_c = inversesqrt(max(c_length2, Real(k_tiny)));
  Vec3 z_center = c * inv_c;
  Real along_p = dot(p, z_center);
  Real along_q = dot(q, z_center);
  Mask from_center = along_p * along_p + along_q * along_q - c_length2 < -(height * height);

  Diagonalisation j;
  j.e3 = select(from_center, z_center, z_normal);
  j.e1 = any_perpendicular(j.e3);
  j.e2 = cross(j.e3, j.e1);
  Vec3 pj = Vec3(dot(p, j.e1), dot(p, j.e2), dot(p, j.e3));
  Vec3 qj = Vec3(dot(q, j.e1), dot(q, j.e2), dot(q, j.e3));
  Real zero = Real(0.0);
  Vec3 cj = Vec3(select(from_center, zero, dot(c, j.e1)), select(from_center, zero, dot(c, j.e2)),
                 dot(c, j.e3));
  j.s11 = pj.x * pj.x + qj.x * qj.x - cj.x * cj.x;
  j.s22 = pj.y * pj.y + qj.y * qj.y - cj.y * cj.y;
  j.s33 = pj.z * pj.z + qj.z * qj.z - cj.z * cj.z;
  j.s12 = pj.x * pj.y + qj.x * qj.y - cj.x * cj.y;
  j.s13 = pj.x * pj.z + qj.x * qj.z - cj.x * cj.z;
  j.s23 = pj.y * pj.z + qj.y * qj.z - cj.y * cj.z;
  for (int i = 0; i < 3; ++i) {
    j = jacobi_sweep(j);
  }

  // The negative eigenvalue may have come out elsewhere: bring it to the third place.
  Mask first = j.s11 < j.s33 && j.s11 <= j.s22;
  Mask second = j.s22 < j.s33 && j.s22 < j.s11;
  Real s33 = min(min(j.s11, j.s22), j.s33);
  Vec3 e3 = select(first, j.e1, select(second, j.e2, j.e3));
  j.s11 = select(first, j.s33, j.s11);
  j.e1 = select(first, j.e3, j.e1);
  j.s22 = select(second, j.s33, j.s22);
  j.e2 = select(second, j.e3, j.e2);
  j.s33 = s33;
  j.e3 = e3;

  Cone cone;
  Real away = select(dot(j.e3, c) < Real(0.0), Real(-1.0), Real(1.0));
  cone.e3 = j.e3 * away;
  Mask swapped = j.s22 > j.s11;
  cone.e1 = select(swapped, j.e2, j.e1);
  cone.e2 = cross(cone.e3, cone.e1);
  Real s1 = max(max(j.s11, j.s22), Real(0.0));
  Real s2 = max(min(j.s11, j.s22), Real(0.0));
  Real negative = max(-j.s33, Real(1.0e-14));
  // The product of the eigenvalues is -det(K)^2, which keeps its digits where the smallest of them,
  // a difference of large numbers, has none left: in the flat cones of narrow lobes.
  Real det = abs(dot(cross(p, q), c));
  Real det_over_s1 = det / max(s1, Real(k_tiny));
  Real small_s2 = min(det_over_s1 * (det / negative), s1);
  s2 = select(s2 < Real(0.01) * min(s1, negative), small_s2, s2);
  Real small_negative = max(det_over_s1 * (det / max(s2, Real(k_tiny))), Real(1.0e-14));
  negative = select(negative < Real(0.01) * s2, small_negative, negative);
  Real inv1 = inversesqrt(s1 + negative);
  Real inv2 = inversesqrt(s2 + negative);
  Real root = sqrt(negative);
  cone.k1 = sqrt(s1) * inv1;
  cone.k2 = sqrt(s2) * inv2;
  cone.c1 = root * inv1;
  cone.c2 = root * inv2;
  return cone;
}

/// More than the extent of an arc that a plane cuts, 9e-5 below 2 pi: a full turn, whose start is its
/// lowest point, and cuts nothing.
CONSTANT k_full_turn = 6.2831;

/// An interval of the outline's parameter: counter-clockwise from `start`.
struct Arc {
  Real start;  ///< -pi..pi
  Real extent; ///< 0..2 pi
};

/// The part of the outline above the plane with unit normal `up`.
///
/// In terms of the circle that the outline is a linear image of, the plane is p cos + q sin + r = 0.
FN_CALL Arc arc_above(GIVEN(Cone) cone, Vec3 up) {
  Real ratio = cone.c1 / cone.c2;
  Real p = dot(up, cone.e1) * cone.k1;
  Real q = dot(up, cone.e2) * cone.k2 * ratio;
  Real r = dot(up, cone.e3) * cone.c1;
  // Of size 1, so that the products below neither vanish nor overflow.
  Real scale = Real(1.0) / max(max(max(abs(p), abs(q)), abs(r)), Real(k_tiny));
  p = p * scale;
  q = q * scale;
  r = r * scale;
  Real radius2 = p * p + q * q;
  Real w2 = radius2 - r * r;
  Real w = sqrt(max(w2, Real(0.0)));
  // The two roots, up to a positive factor, turned from the circle's parameter into the outline's.
  Real start_x = w * q - r * p;
  Real start_y = ratio * (-(w * p) - r * q);
  Real end_x = -(w * q) - r * p;
  Real end_y = ratio * (w * p - r * q);
  Arc arc;
  arc.start = angle_of(start_x, start_y);
  Real length = angle_of(start_x * end_x + start_y * end_y, start_x * end_y - start_y * end_x);
  // Less than half of the outline is above exactly when the axis is not; rounding must not turn a
  // little into nearly all.
  Real half_turn = Real(0.5) * k_pi;
  Real turn = Real(2.0) * k_pi;
  Real less = select(length < -half_turn, length + turn, max(length, Real(0.0)));
  Real more = select(length < half_turn, length + turn, length);
  arc.extent = min(select(r < Real(0.0), less, more), turn);
  Mask uncut = w2 <= Real(0.0);
  arc.extent = select(uncut, select(r < Real(0.0), Real(0.0), turn), arc.extent);
  return arc;
}

/// N of the point with cosine c and sine s of its parameter.
FN Real cone_height(Cone cone, Real c, Real s) {
  return sqrt(max(cone.c1 * cone.c1 * c * c + cone.c2 * cone.c2 * s * s, Real(k_tiny)));
}

/// The unit vector v(t), in the space of the cone's axes.
FN Vec3 cone_direction(Cone cone, Real t) {
  Real c = cos(t);
  Real s = sin(t);
  return cone.e1 * (cone.k1 * c) + cone.e2 * (cone.k2 * s) + cone.e3 * cone_height(cone, c, s);
}

/// The antiderivative of v x dv at the parameter t, in the frame of the cone, and v there.
struct ConePoint {
  Vec3 sum;       ///< the antiderivative
  Vec3 direction; ///< v, unit
};

/// Both at the parameter t, radians.
FN_CALL ConePoint cone_point(GIVEN(Cone) cone, Real t) {
  Real c = cos(t);
  Real s = sin(t);
  Real m2 = max((cone.k1 - cone.k2) * (cone.k1 + cone.k2), Real(0.0));
  Real m = sqrt(m2);
  Real n = cone_height(cone, c, s);
  Real inv_n = Real(1.0) / n;
  // atanh(z) / m = s / n times atanh(z) / z; the logarithm's argument is (1 + z) / sqrt(1 - z^2).
  Real ms = m * abs(s);
  Real z2 = min(ms * ms * inv_n * inv_n, Real(1.0));
  Real series = Real(1.0) + z2 * (Real(1.0 / 3.0) + z2 * (Real(1.0 / 5.0) + z2 * Real(1.0 / 7.0)));
  Real logarithm = log((n + ms) / max(cone.c1, Real(1.0e-12)));
  Real atanh_over_z = select(z2 < Real(0.01), series, logarithm * n / max(ms, Real(k_tiny)));
  ConePoint point;
  point.sum = Vec3(-(cone.k2 * cone.c1 * cone.c1 * s * inv_n * atanh_over_z),
                   cone.k1 * cone.c2 * cone.c2 * c * inv_n * atan_over(m * c * inv_n),
                   cone.k1 * cone.k2 * t);
  point.direction = cone.e1 * (cone.k1 * c) + cone.e2 * (cone.k2 * s) + cone.e3 * n;
  return point;
}

/// The same angle within a turn: 0 to 2 pi, from -2 pi to 4 pi.
FN Real wrapped_turn(Real angle) {
  Real turn = Real(2.0) * k_pi;
  Real a = select(angle < Real(0.0), angle + turn, angle);
  return select(a < turn, a, a - turn);
}

/// What the arcs `part`, `surface` and `cosine` of an outline have in common, the latter two being what is above each
/// horizon, closed towards the apex (0, s, 0) at both ends of every piece: 2 pi times its share of the vector
/// irradiance.
FN_CALL Vec3 common_arc_term(GIVEN(Cone) cone, GIVEN(Arc) part, GIVEN(Arc) surface,
                             GIVEN(Arc) cosine, Real s) {
  Real turn = Real(2.0) * k_pi;
  Real x1 = select(surface.extent > Real(k_full_turn), Real(0.0),
                   wrapped_turn(surface.start - part.start));
  Real x2 =
      select(cosine.extent > Real(k_full_turn), Real(0.0), wrapped_turn(cosine.start - part.start));
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 ends = sum;
  // Intervals on a circle meet themselves again after a turn.
  for (int i = 0; i < 2; ++i) {
    Real a = x1 - turn * Real(i);
    for (int k = 0; k < 2; ++k) {
      Real b = x2 - turn * Real(k);
      Real low = max(max(a, b), Real(0.0));
      Real high = min(min(a + surface.extent, b + cosine.extent), part.extent);
      Mask some = high > low;
      if (any_lane(some)) {
        // Its end, then its beginning.
        Real t = high;
        Real sign = Real(1.0);
        for (int end = 0; end < 2; ++end) {
          ConePoint point = cone_point(cone, part.start + t);
          Real counts = select(some, sign, Real(0.0));
          sum = sum + point.sum * counts;
          ends = ends + apex_term(point.direction, inverse_length(point.direction), s) * counts;
          t = low;
          sign = Real(-1.0);
        }
      }
    }
  }
  return cone.e1 * sum.x + cone.e2 * sum.y + cone.e3 * sum.z + ends;
}

/// The outline's arc `part`, clipped to the wedge between the horizons with unit normals `up` and z, and closed as
/// above. Ends that other edges continue from cancel with those.
FN_CALL Vec3 clipped_arc_term(GIVEN(Cone) cone, GIVEN(Arc) part, Vec3 up, Real s) {
  return common_arc_term(cone, part, arc_above(cone, up),
                         arc_above(cone, Vec3(Real(0.0), Real(0.0), Real(1.0))), s);
}

/// Whether a cone lies wholly above the planes with unit normals `up` and z: the axis' height over
/// each against the reach sideways.
FN Mask cone_is_above(Cone cone, Vec3 up) {
  Real height = dot(up, cone.e3) * cone.c1 * cone.c2;
  Real p = dot(up, cone.e1) * cone.k1 * cone.c2;
  Real q = dot(up, cone.e2) * cone.k2 * cone.c1;
  Real height_o = cone.e3.z * cone.c1 * cone.c2;
  Real po = cone.e1.z * cone.k1 * cone.c2;
  Real qo = cone.e2.z * cone.k2 * cone.c1;
  return height > Real(0.0) && height * height >= p * p + q * q && height_o > Real(0.0) &&
         height_o * height_o >= po * po + qo * qo;
}

/// Square of the mean of the unit vectors to the ends of a cone's axes; see light_concentration.
FN Real cone_outline2(Cone cone) {
  Real mean = Real(0.5) * (cone.c1 + cone.c2);
  return mean * mean;
}

/// Vector irradiance times 2 pi of a whole cone, clipped to the wedge between the horizons with unit
/// normals `up` and z.
FN_CALL Vec3 clipped_cone(GIVEN(Cone) cone, Vec3 up) {
  Mask whole = cone_is_above(cone, up);
  Vec3 all = cone.e3 * (Real(2.0) * k_pi * cone.k1 * cone.k2);
  // Uniform shortcut: no lane needs to clip.
  if (all_lanes(whole)) {
    return all;
  }
  // The outline is taken up where a horizon cuts it.
  Arc surface = arc_above(cone, up);
  Arc cosine = arc_above(cone, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  Arc part;
  part.start = select(surface.extent > Real(k_full_turn), cosine.start, surface.start);
  part.extent = Real(2.0) * k_pi;
  Real s = select(cone.e3.y < Real(0.0), Real(-1.0), Real(1.0));
  return select(whole, all, common_arc_term(cone, part, surface, cosine, s));
}

/// Parameter of the outline at a direction on it, -pi..pi.
///
/// Of a nearly flat cone the second coordinate is mostly rounding: there its sign alone is taken,
/// and its size from the first.
FN Real outline_parameter(Cone cone, Vec3 direction) {
  Real inv_length = inversesqrt(max(dot(direction, direction), Real(k_tiny)));
  Real x = dot(direction, cone.e1) * inv_length;
  Real y = dot(direction, cone.e2) * inv_length;
  Real x1 = min(max(x / max(cone.k1, Real(1.0e-12)), Real(-1.0)), Real(1.0));
  Real y1 = sqrt(Real(1.0) - x1 * x1);
  Mask flat_cone = cone.k2 < Real(0.02) * cone.k1;
  return angle_of(select(flat_cone, x1, x * cone.k2),
                  select(flat_cone, select(y < Real(0.0), -y1, y1), y * cone.k1));
}

/// Share of the outline's arc `part` in 2 pi times the vector irradiance, without horizons.
FN Vec3 arc_term(Cone cone, Arc part) {
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Real t = part.start + part.extent;
  Real sign = Real(1.0);
  for (int end = 0; end < 2; ++end) {
    sum = sum + cone_point(cone, t).sum * sign;
    t = part.start;
    sign = Real(-1.0);
  }
  return cone.e1 * sum.x + cone.e2 * sum.y + cone.e3 * sum.z;
}
