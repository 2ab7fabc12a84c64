// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Edges of what a lobe is integrated over: clipped to both horizons, closed at an apex.
//
// Sources:
//   Lambert 1760; Baum, Rushmeier, Winget 1989, "Improving Radiosity Solutions Through the Use of
//     Analytically Determined Form-Factors", equation 9 (edge sum);
//   Heitz, Dupuy, Hill, Neubelt 2016, equations 4 to 11 (the integral under M^-1).
//
// For a polygon in cosine space, wholly above its horizon,
//   E = 1/(2 pi) sum over edges of theta_k (a_k x b_k)_z / |a_k x b_k|,
// theta_k being the angle between the edge's end points a_k and b_k as seen from the origin.
//
// Two horizons bound what counts: the surface's, z >= 0 before M^-1, and the cosine's, z_o >= 0
// after it. Together they leave a wedge whose apex is the line through the origin along which both
// planes meet. M^-1 keeps the y axis (see lobe.glsl), so that line is the y axis in either space.
//
// Each edge is clipped to the wedge by itself. Where it enters or leaves, the outline of the
// clipped polygon continues along one of the two planes, and we close it by an arc to the apex: to
// +y or -y, whichever the polygon's plane meets. Arcs on the same plane telescope, whatever the
// order of the edges, so concave outlines, holes and any number of vertices need no clip buffer and
// no search for neighbours: the result is a plain sum over edges. The arc to the apex q = (0, s, 0)
// has (p x q)_z = s p_x.

/// 1 / |v|, finite for the origin too: what is added vanishes beside lengths above 1e-8.
FN Real inverse_length(Vec3 v) {
  return inversesqrt(v.x * v.x + (v.y * v.y + (v.z * v.z + Real(k_least_length2))));
}

/// v / |v|, or the normal where v has no direction to speak of.
FN Vec3 safe_direction(Vec3 v) {
  Real length2 = dot(v, v);
  Mask usable = length2 > Real(k_tiny);
  return select(usable, v * inversesqrt(max(length2, Real(k_tiny))),
                Vec3(Real(0.0), Real(0.0), Real(1.0)));
}

/// theta / sin(theta) from x = cos(theta), for 0 <= theta <= pi/2; of -x for x < 0.
///
/// A rational minimax fit of degree 3/3, relative error 1.0e-9; smooth at 1, so that a cosine that
/// rounding took beyond does no harm.
FN Real acute_over_sin(Real x) {
  Real y = abs(x);
  Real p = Real(1.5707963252152057) +
           y * (Real(1.638642066993385) +
                y * (Real(0.35581734455759484) + y * Real(0.004572514079188905)));
  Real q = Real(1.0) + y * (Real(1.679811571269012) +
                            y * (Real(0.7959248032398663) + y * Real(0.09409187287776444)));
  return p * reciprocal(q);
}

/// theta / sin(theta) for 0 <= theta < pi, from `acute`, that of x = cos(theta), and sin2 =
/// sin(theta)^2: beyond a right angle theta = pi - theta', which is exact. It grows without bound
/// towards x = -1, where 1 - x^2 has no digits left; so the caller, who knows the vectors, passes
/// sin2 as well.
FN Real any_over_sin(Real x, Real sin2, Real acute) {
  Real inv_sin = inversesqrt(max(sin2, Real(k_tiny)));
  return select(x < Real(0.0), k_pi * inv_sin - acute, acute);
}

/// theta / sin(theta) of an angle with cosine x and squared sine sin2, 0..pi.
FN Real theta_over_sin(Real x, Real sin2) {
  Real weight = acute_over_sin(x);
  // Uniform shortcut: no lane's angle is beyond a right one.
  if (any_lane(x < Real(0.0))) {
    weight = any_over_sin(x, sin2, weight);
  }
  return weight;
}

/// Contribution of the arc from a to b = a + d to the vector irradiance, times 2 pi. d is passed by
/// itself so that the cross product of a small, far edge does not cancel. Never longer than pi: a
/// vector over its length, times an angle.
///
/// inv_a, inv_b: one over the lengths of a and b.
FN_INLINE Vec3 edge_term_scaled(Vec3 a, Vec3 b, Vec3 d, Real inv_a, Real inv_b) {
  Real scale = inv_a * inv_b;
  Vec3 c = cross(a, d);
  Real x = dot(a, b) * scale;
  Real weight = acute_over_sin(x);
  if (any_lane(x < Real(0.0))) {
    weight = any_over_sin(x, dot(c, c) * scale * scale, weight);
  }
  return c * (scale * weight);
}

/// edge_term_scaled, which finds the inverse lengths of a and b by itself.
FN Vec3 edge_term(Vec3 a, Vec3 b, Vec3 d) {
  return edge_term_scaled(a, b, d, inverse_length(a), inverse_length(b));
}

/// Contribution of the arc from p to the apex (0, s, 0), s = 1 or -1.
FN Vec3 apex_term(Vec3 p, Real inv_p, Real s) {
  Vec3 u = p * inv_p;
  Real weight = s * theta_over_sin(s * u.y, u.x * u.x + u.z * u.z);
  return Vec3(-weight * u.z, Real(0.0), weight * u.x);
}

/// Where an edge crosses a plane, in units of the edge, 0..1; a, b: heights of its ends, of which one is
/// below and the other not. The bound is for targets whose reciprocal is not the last digit's: a place
/// beyond the end would count as cut by the other horizon (clip_edge).
FN Real crossing_place(Real a, Real b) {
  return min(abs(a) * reciprocal(max(abs(a) + abs(b), Real(k_tiny))), Real(1.0));
}

/// The part of an edge above a plane, in units of the edge; whole where both ends are above.
struct Span {
  Real t0; ///< where it begins, 0..1
  Real t1; ///< where it ends, 0..1
};

/// a, b: heights of the ends, of which one at least is not below.
FN Span span_above(Real a, Real b) {
  Real t = crossing_place(a, b);
  Span span;
  span.t0 = select(a < Real(0.0), t, Real(0.0));
  span.t1 = select(b < Real(0.0), t, Real(1.0));
  return span;
}

/// What is left of an edge within the wedge.
struct ClippedEdge {
  Vec3 p0;      ///< cosine space
  Vec3 p1;      ///< its end; p0 is its beginning
  Real extent;  ///< in units of the edge
  Mask outside; ///< whether nothing is left
};

/// a_o, b_o: end points in cosine space; a_z, b_z: their heights above the surface's horizon.
FN ClippedEdge clip_edge(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z) {
  Span surface = span_above(a_z, b_z);
  Span cosine = span_above(a_o.z, b_o.z);
  Real t0 = max(surface.t0, cosine.t0);
  Real t1 = min(surface.t1, cosine.t1);
  ClippedEdge edge;
  // t0 == t1 is not outside: an edge that leaves from, or ends at, a point on a horizon has no
  // length left but still opens or closes the outline there.
  edge.outside =
      (a_z < Real(0.0) && b_z < Real(0.0)) || (a_o.z < Real(0.0) && b_o.z < Real(0.0)) || t0 > t1;
  Vec3 d = b_o - a_o;
  edge.p0 = a_o + d * t0;
  edge.p1 = a_o + d * t1;
  edge.extent = t1 - t0;
  // A point cut at the cosine's horizon lies on it: seen near the apex, what rounding leaves of its
  // height would tilt the arc that closes.
  edge.p0.z = select(cosine.t0 > surface.t0, Real(0.0), max(edge.p0.z, Real(0.0)));
  edge.p1.z = select(cosine.t1 < surface.t1, Real(0.0), max(edge.p1.z, Real(0.0)));
  return edge;
}

/// Angle of a unit vector (c, s) from (1, 0), -pi..pi.
FN Real angle_of_unit(Real c, Real s) {
  Real acute = s * acute_over_sin(c);
  Real half_turn = select(s < Real(0.0), -Real(k_pi), Real(k_pi));
  return select(c < Real(0.0), half_turn - acute, acute);
}

/// One edge of an outline, clipped to the half space z >= 0, and the turn that closes it along the
/// plane, from where it was cut towards the apex: the cosine and sine of an angle about z, which
/// counts as it is.
struct EdgeAbove {
  Vec3 term;     ///< its contribution to the vector irradiance, times 2 pi
  Real turn_cos; ///< 1 where nothing was cut
  Real turn_sin; ///< 0 where nothing was cut
};

/// The edge from a to b, whose inverse lengths are inv_a and inv_b; s: the apex_side of its outline.
FN_INLINE EdgeAbove edge_above(Vec3 a, Vec3 b, Real s, Real inv_a, Real inv_b) {
  Mask a_up = a.z >= Real(0.0);
  Mask b_up = b.z >= Real(0.0);
  Vec3 d = b - a;
  Real t = crossing_place(a.z, b.z);
  Vec3 q = Vec3(a.x + d.x * t, a.y + d.y * t, Real(0.0));
  Real inv_q = inverse_length(q);
  Real extent = select(a_up, select(b_up, Real(1.0), t), Real(1.0) - t);
  EdgeAbove edge;
  edge.term = edge_term_scaled(select(a_up, a, q), select(b_up, b, q), d * extent,
                               select(a_up, inv_a, inv_q), select(b_up, inv_b, inv_q));
  edge.term = select(a_up || b_up, edge.term, Vec3(Real(0.0), Real(0.0), Real(0.0)));
  Mask leaves = a_up && !b_up;
  Mask enters = b_up && !a_up;
  Real inv_s = inv_q * s;
  Real x = q.x * inv_s;
  edge.turn_cos = select(leaves || enters, q.y * inv_s, Real(1.0));
  edge.turn_sin = select(leaves, x, select(enters, -x, Real(0.0)));
  return edge;
}

/// The sum of no edges.
FN EdgeAbove no_edges() {
  EdgeAbove sum;
  sum.term = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sum.turn_cos = Real(1.0);
  sum.turn_sin = Real(0.0);
  return sum;
}

/// Two edges, or sums of edges, of an outline: their turns, which lead the same way round, one after the
/// other.
FN EdgeAbove join_edges(EdgeAbove a, EdgeAbove b) {
  EdgeAbove sum;
  sum.term = a.term + b.term;
  sum.turn_cos = a.turn_cos * b.turn_cos - a.turn_sin * b.turn_sin;
  sum.turn_sin = a.turn_cos * b.turn_sin + a.turn_sin * b.turn_cos;
  return sum;
}

/// The sum over all edges of an outline, closed along the plane. way: negative where a positive angle
/// about z leads backwards; it holds whatever rounding makes of an angle near 0.
FN Vec3 close_outline(EdgeAbove sum, Real way) {
  Real angle = abs(angle_of_unit(sum.turn_cos, sum.turn_sin));
  return Vec3(sum.term.x, sum.term.y, sum.term.z + select(way < Real(0.0), -angle, angle));
}

/// The same with the turn added: the diffuse part of an edge.
FN Vec3 edge_term_above(Vec3 a, Vec3 b, Real s, Real inv_a, Real inv_b) {
  Mask a_up = a.z >= Real(0.0);
  Mask b_up = b.z >= Real(0.0);
  // Uniform shortcuts: no lane needs to clip, or none has anything left.
  if (all_lanes(a_up && b_up)) {
    return edge_term_scaled(a, b, b - a, inv_a, inv_b);
  }
  if (!any_lane(a_up || b_up)) {
    return Vec3(Real(0.0), Real(0.0), Real(0.0));
  }
  EdgeAbove edge = edge_above(a, b, s, inv_a, inv_b);
  edge.term.z = edge.term.z + angle_of_unit(edge.turn_cos, edge.turn_sin);
  return edge.term;
}

/// One edge of an outline, clipped to the wedge and closed towards the apex where it was cut. An
/// outline passes the inverse lengths of its points on from edge to edge.
FN Vec3 clipped_edge_term_scaled(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z, Real s, Real inv_a,
                                 Real inv_b) {
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Mask a_inside = a_z >= Real(0.0) && a_o.z >= Real(0.0);
  Mask b_inside = b_z >= Real(0.0) && b_o.z >= Real(0.0);
  // Uniform shortcuts: no lane needs to clip, or none has anything left.
  if (all_lanes(a_inside && b_inside)) {
    return edge_term_scaled(a_o, b_o, b_o - a_o, inv_a, inv_b);
  }
  if (!any_lane((a_z >= Real(0.0) || b_z >= Real(0.0)) &&
                (a_o.z >= Real(0.0) || b_o.z >= Real(0.0)))) {
    return none;
  }
  ClippedEdge edge = clip_edge(a_o, b_o, a_z, b_z);
  // Nearly always one end at most was cut, q.
  Vec3 q = select(a_inside, edge.p1, edge.p0);
  Real inv_q = inverse_length(q);
  Real inv_p1 = select(b_inside, inv_b, inv_q);
  Real leaves = select(a_inside, select(b_inside, Real(0.0), Real(1.0)), Real(-1.0));
  Vec3 closing = apex_term(q, inv_q, s) * leaves;
  Mask both = !a_inside && !b_inside && !edge.outside;
  if (any_lane(both)) {
    Real inv_end = inverse_length(edge.p1);
    inv_p1 = select(both, inv_end, inv_p1);
    closing = closing + select(both, apex_term(edge.p1, inv_end, s), none);
  }
  // An end that was not cut stays the very point whose inverse length is known.
  Vec3 sum = edge_term_scaled(edge.p0, select(b_inside, b_o, edge.p1), (b_o - a_o) * edge.extent,
                              select(a_inside, inv_a, inv_q), inv_p1) +
             closing;
  return select(edge.outside, none, sum);
}

/// clipped_edge_term_scaled, which finds the inverse lengths by itself.
FN Vec3 clipped_edge_term(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z, Real s) {
  return clipped_edge_term_scaled(a_o, b_o, a_z, b_z, s, inverse_length(a_o), inverse_length(b_o));
}

/// The same closed at both ends, cut or not: for edges that meet arcs (cone.glsl), whose own
/// closing cancels it. Whether the common point is inside, both find by themselves, and rounding
/// may make them disagree; this way that does not matter.
FN Vec3 closed_edge_term(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z, Real s) {
  ClippedEdge edge = clip_edge(a_o, b_o, a_z, b_z);
  Real inv_p0 = inverse_length(edge.p0);
  Real inv_p1 = inverse_length(edge.p1);
  Vec3 sum = edge_term_scaled(edge.p0, edge.p1, (b_o - a_o) * edge.extent, inv_p0, inv_p1) +
             apex_term(edge.p1, inv_p1, s) - apex_term(edge.p0, inv_p0, s);
  return select(edge.outside, Vec3(Real(0.0), Real(0.0), Real(0.0)), sum);
}
