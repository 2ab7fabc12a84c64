// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A third half space: what lies behind the plane of the triangle is hidden by it, whatever the
// shading normal says. Where a normal map or interpolation turns that normal, the plane is neither
// horizon, and it cuts the light before both.
//
// A light's outline stays a closed outline when a plane cuts it: pieces end where they cross the
// plane, and edges in the plane join their ends. In directions such an edge is an arc of the plane's
// great circle, that is, an edge like any other, which the two horizons clip and close as they do
// all. So nothing has to be known of three planes at a time, and the integral stays exact.
//
// A polygon's crossings lie on one straight line, where its own plane meets this one: edges from each
// of them to the first found there telescope, and outlines need no order (polygon.glsl). A cone's
// outline is crossed twice at most: what is left is one arc and its chord. A tube's four pieces are
// joined by way of a common crossing q, as the apex joins what the horizons cut.

/// A plane's normal in cosine space, unit, from that of shading space: M^T n, see
/// horizon_normal_cosine.
FN Vec3 plane_normal_cosine(Lobe lobe, Vec3 normal) {
  Vec3 n = Vec3(lobe.m22 * normal.x - lobe.m20 * normal.z, lobe.det * normal.y,
                lobe.m00 * normal.z - lobe.m02 * normal.x);
  return n * inversesqrt(max(dot(n, n), Real(k_tiny)));
}

/// The part of a segment in front of a plane.
struct FrontSegment {
  Vec3 a;    ///< where it begins
  Vec3 b;    ///< where it ends
  Mask some; ///< whether there is any
};

/// The part of the segment from a to b in front of the plane through the origin with that normal.
FN FrontSegment segment_in_front(Vec3 a, Vec3 b, Vec3 front) {
  Real a_height = dot(front, a);
  Real b_height = dot(front, b);
  Span span = span_above(a_height, b_height);
  Vec3 d = b - a;
  FrontSegment segment;
  segment.a = a + d * span.t0;
  segment.b = select(b_height < Real(0.0), a + d * span.t1, b);
  segment.some = a_height > Real(0.0) || b_height > Real(0.0);
  return segment;
}

/// An edge in the wedge between the horizons with unit normals `up` and z; see closed_edge_term.
FN Vec3 closed_term(Vec3 a, Vec3 b, Vec3 up, Real s) {
  return closed_edge_term(a, b, dot(up, a), dot(up, b), s);
}

/// clipped_cone for the part of the cone in front of the plane with unit normal `front`.
FN_CALL Vec3 clipped_cone_in_front(GIVEN(Cone) cone, Vec3 up, Vec3 front) {
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Arc part = arc_above(cone, front);
  Mask uncut = part.extent > Real(k_full_turn);
  Mask hidden = part.extent <= Real(0.0);
  Arc surface = arc_above(cone, up);
  Arc cosine = arc_above(cone, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  Real start = select(surface.extent > Real(k_full_turn), cosine.start, surface.start);
  part.start = select(uncut, start, part.start);
  part.extent = select(uncut, Real(2.0) * k_pi, part.extent);
  Real s = select(cone.e3.y < Real(0.0), Real(-1.0), Real(1.0));
  Vec3 from = cone_direction(cone, part.start + part.extent);
  Vec3 to = cone_direction(cone, part.start);
  Vec3 sum =
      clipped_arc_term(cone, part, up, s) + select(uncut, none, closed_term(from, to, up, s));
  Vec3 all = cone.e3 * (Real(2.0) * k_pi * cone.k1 * cone.k2);
  return select(hidden, none, select(uncut && cone_is_above(cone, up), all, sum));
}

/// An edge's part in front of the plane with unit normal `front`, and what joins its ends to q in that
/// plane. Ends that another piece goes on from are joined too, and cancel.
FN_CALL Vec3 edge_in_front(Vec3 a, Vec3 b, Vec3 q, Vec3 up, Vec3 front, Real s) {
  FrontSegment part = segment_in_front(a, b, front);
  Vec3 sum = closed_term(part.a, part.b, up, s) + closed_term(part.b, q, up, s) -
             closed_term(part.a, q, up, s);
  return select(part.some, sum, Vec3(Real(0.0), Real(0.0), Real(0.0)));
}

/// The same of an arc of a cone's outline.
FN_CALL Vec3 arc_in_front(GIVEN(Cone) cone, GIVEN(Arc) part, Vec3 q, Vec3 up, Vec3 front, Real s) {
  Arc above = arc_above(cone, front);
  Real turn = Real(2.0) * k_pi;
  Real x =
      select(above.extent > Real(k_full_turn), Real(0.0), wrapped_turn(above.start - part.start));
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 sum = none;
  // Intervals on a circle meet themselves again after a turn.
  for (int i = 0; i < 2; ++i) {
    Real low = max(x, Real(0.0));
    Real high = min(x + above.extent, part.extent);
    Mask some = high > low;
    if (any_lane(some)) {
      Arc piece;
      piece.start = part.start + low;
      piece.extent = high - low;
      Vec3 from = cone_direction(cone, piece.start);
      Vec3 to = cone_direction(cone, piece.start + piece.extent);
      Vec3 term = clipped_arc_term(cone, piece, up, s) + closed_term(to, q, up, s) -
                  closed_term(from, q, up, s);
      sum = sum + select(some, term, none);
    }
    x = x - turn;
  }
  return sum;
}

/// Where an edge crosses the plane; `otherwise` where it does not.
FN Vec3 edge_crossing(Vec3 a, Vec3 b, Vec3 front, Vec3 otherwise) {
  Real a_height = dot(front, a);
  Real b_height = dot(front, b);
  Real t = crossing_place(a_height, b_height);
  return select((a_height < Real(0.0)) != (b_height < Real(0.0)), a + (b - a) * t, otherwise);
}

/// The same of an arc of a cone's outline.
FN Vec3 arc_crossing(Cone cone, Arc part, Vec3 front, Vec3 otherwise) {
  Arc above = arc_above(cone, front);
  Mask cut = above.extent > Real(0.0) && above.extent <= Real(k_full_turn);
  Real end = above.start + above.extent;
  Vec3 q = select(cut && wrapped_turn(end - part.start) <= part.extent, cone_direction(cone, end),
                  otherwise);
  return select(cut && wrapped_turn(above.start - part.start) <= part.extent,
                cone_direction(cone, above.start), q);
}
