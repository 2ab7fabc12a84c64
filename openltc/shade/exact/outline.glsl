// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The two integrals of half_vector.glsl and masking_ring.glsl along the outline of a light: edges of polygons and
// arcs of circles, by nodes of Gauss, five in either half and three on the whole.
//
// Scaled so that both ends have |g| = 1, a conic's parameter runs evenly along its arc as far as it can. Divided
// where g is at equal angles from both ends, a root of a quadratic, and scaled again, each half is
// so smooth that a few nodes do. So it is for visible normals. Rings turn around the normal, not with g: where they
// are in two parts it is at the middle of the arc's directions.

/// 1 / |g|^2 at the place t of an arc, g = (k2 t + k1) t + k0, times a weight.
FN Real visible_weight(Vec3 k0, Vec3 k1, Vec3 k2, Real t, Real w) {
  Vec3 g = k0 + (k1 + k2 * t) * t;
  return w * reciprocal(max(dot(g, g), Real(k_tiny)));
}

/// The contour integral of g x dg / |g|^2 along an arc, by five nodes of Gauss: g x dg is of degree 2 as g is.
FN Vec3 visible_part(Vec3 a, Vec3 m, Vec3 b) {
  Vec3 am = m - a;
  Vec3 mb = b - m;
  Vec3 k1 = am * Real(2.0);
  Vec3 k2 = mb - am;
  Real w0 = visible_weight(a, k1, k2, Real(0.04691007703066802), Real(0.23692688505618908));
  Real w1 = visible_weight(a, k1, k2, Real(0.23076534494715845), Real(0.47862867049936647));
  Real w2 = visible_weight(a, k1, k2, Real(0.5), Real(0.56888888888888889));
  Real w3 = visible_weight(a, k1, k2, Real(0.7692346550528415), Real(0.47862867049936647));
  Real w4 = visible_weight(a, k1, k2, Real(0.9530899229693319), Real(0.23692688505618908));
  // Of u^2, u t and t^2, u = 1 - t.
  Real middle = w2 * Real(0.25);
  Real uu = w0 * Real(0.9083804012656871) + w1 * Real(0.591721954534264) + middle +
            w3 * Real(0.05325264442858103) + w4 * Real(0.002200555327023207);
  Real tt = w0 * Real(0.002200555327023207) + w1 * Real(0.05325264442858103) + middle +
            w3 * Real(0.591721954534264) + w4 * Real(0.9083804012656871);
  Real ut = (w0 + w4) * Real(0.04470952170364481) + (w1 + w3) * Real(0.1775127005185774) + middle;
  return cross(a, am) * uu + cross(a, b - a) * ut + cross(m, mb) * tt;
}

/// Whether an edge passes the azimuth opposite of that at which rings begin. Its rings go on beyond it, so that
/// they have no step on the way: the step is at its higher end.
struct EdgePass {
  Real negative; ///< whole rings that count for nodes at negative azimuths
  Real positive; ///< and for those at positive ones
  bool some;     ///< whether any lane's edge passes it
};

/// An arc as a polynomial in its parameter.
struct ConicTerms {
  Vec3 r0; ///< direction, see ConicPoint: r0 + r1 t + r2 t^2
  Vec3 r1; ///< of t
  Vec3 r2; ///< of t^2
  Real l0; ///< its length, likewise
  Real l1; ///< of t
  Real l2; ///< of t^2
};

/// Rings at the node t of an edge, of weight w.
FN ContourSums add_ring_node(GIVEN(ExactView) view, ContourSums sums, EdgePass pass, ConicTerms arc,
                             Real t, Real w) {
  Vec3 r_slope = arc.r1 + arc.r2 * t;
  Real l_slope = arc.l1 + arc.l2 * t;
  Vec3 r = arc.r0 + r_slope * t;
  Real inv_l = reciprocal(max(arc.l0 + l_slope * t, Real(k_tiny)));
  Real scale = w * inv_l;
  Vec3 dr = (r_slope + arc.r2 * t) * scale;
  Real z = min(max(r.z * inv_l, Real(0.0)), Real(1.0));
  Real dz = dr.z - z * ((l_slope + arc.l2 * t) * scale);
  Real r2 = r.x * r.x + r.y * r.y;
  Real inv_r = inversesqrt(max(r2, Real(k_tiny)));
  Ring ring = ring_at(view, z, min(r2 * inv_r * inv_l, Real(1.0)));
  RingPart part = ring_part(view, ring, r.x * inv_r, r.y * inv_r);
  RingPowers powers = part_powers(view, ring, part);
  if (pass.some) {
    Real turns = select(r.y < Real(0.0), pass.negative, pass.positive);
    RingPowers whole = whole_powers(ring);
    powers.less2 = powers.less2 + turns * whole.less2;
    powers.less1 = powers.less1 + turns * whole.less1;
    powers.angle = powers.angle + turns * whole.angle;
    powers.more1 = powers.more1 + turns * whole.more1;
    powers.low = select(turns != Real(0.0), whole.low, powers.low);
    powers.high = select(turns != Real(0.0), whole.high, powers.high);
  }
  RingLight light = ring_light(view, ring, powers, z);
  sums.masked = sums.masked - (light.scale - view.more_at_normal * powers.angle) * dz;
  sums.biased = sums.biased - (light.bias - view.biased_at_normal * powers.angle) * dz;
  sums.solid = sums.solid - (r.x * dr.y - r.y * dr.x) * (inv_l * reciprocal(Real(1.0) + z));
  return sums;
}

/// The arc of a, m and b as a polynomial.
FN ConicTerms conic_terms(ConicPoint a, ConicPoint m, ConicPoint b) {
  ConicTerms arc;
  Vec3 r_before = m.r - a.r;
  Real l_before = m.l - a.l;
  arc.r0 = a.r;
  arc.r1 = r_before * Real(2.0);
  arc.r2 = b.r - m.r - r_before;
  arc.l0 = a.l;
  arc.l1 = l_before * Real(2.0);
  arc.l2 = b.l - m.l - l_before;
  return arc;
}

/// Three nodes of Gauss along an arc. They gather where it crosses, or comes nearest to, the ring of the mirror
/// direction: rings have their peak there, however far from the highlight, and masking turns there.
struct RingNodes {
  Real first;         ///< their places on the arc, 0..1
  Real middle;        ///< likewise
  Real last;          ///< likewise
  Real first_weight;  ///< their weights, whose sum is 1
  Real middle_weight; ///< likewise
  Real last_weight;   ///< likewise
};

/// 1 over the widest gathering along an arc, of nodes that are as good as even.
CONSTANT k_even_nodes = 1.0e-3;

/// Of an arc. What is as high as the ring solves a quadratic. All of them at once and before they are needed: one
/// by one, each would wait for a chain of quotients and roots.
FN RingNodes ring_nodes(GIVEN(ExactView) view, ConicTerms arc) {
  Real q0 = arc.r0.z - view.cos_o * arc.l0;
  Real q1 = arc.r1.z - view.cos_o * arc.l1;
  Real q2 = arc.r2.z - view.cos_o * arc.l2;
  Real square = max(q1 * q1 - Real(4.0) * q0 * q2, Real(k_tiny));
  Real root = square * inversesqrt(square);
  Real larger = select(q1 < Real(0.0), root - q1, -root - q1);
  Real one = larger * q2 * (Real(0.5) * reciprocal(max(q2 * q2, Real(k_tiny))));
  Real other = Real(2.0) * q0 * larger * reciprocal(max(larger * larger, Real(k_tiny)));
  // Where both are as near to the middle neither is taken, and nodes are nearly even.
  one = min(max(one, Real(-1.0)), Real(2.0)) - Real(0.5);
  other = min(max(other, Real(-1.0)), Real(2.0)) - Real(0.5);
  Real of_other = one * one * (one * one);
  Real of_one = other * other * (other * other);
  Real t = Real(0.5) +
           (one * of_one + other * of_other) * reciprocal(max(of_one + of_other, Real(k_tiny)));
  t = min(max(t, Real(0.0)), Real(1.0));
  Real above = abs(q0 + (q1 + q2 * t) * t);
  Real length = arc.l0 + (arc.l1 + arc.l2 * t) * t;
  Real span = above + view.gather * length;
  Real slope = max(abs(q1 + Real(2.0) * q2 * t), span * Real(k_even_nodes));
  Real width = span * reciprocal(slope);
  Real inv_width = slope * reciprocal(span);
  Real from = peak_place(-t * inv_width);
  Real range = peak_place((Real(1.0) - t) * inv_width) - from;
  PeakPoint first = peak_point(from + range * Real(0.1127016653792583));
  PeakPoint middle = peak_point(from + range * Real(0.5));
  PeakPoint last = peak_point(from + range * Real(0.8872983346207417));
  Real weight = width * range;
  Real outer = weight * Real(0.2777777777777778);
  RingNodes nodes;
  nodes.first = t + width * first.x;
  nodes.middle = t + width * middle.x;
  nodes.last = t + width * last.x;
  nodes.first_weight = outer * first.slope;
  nodes.middle_weight = weight * Real(0.4444444444444444) * middle.slope;
  nodes.last_weight = outer * last.slope;
  return nodes;
}

/// Rings along an arc, times `sign`.
FN ContourSums add_rings(GIVEN(ExactView) view, ContourSums sums, EdgePass pass, ConicTerms arc,
                         RingNodes nodes, Real sign) {
  sums = add_ring_node(view, sums, pass, arc, nodes.first, nodes.first_weight * sign);
  sums = add_ring_node(view, sums, pass, arc, nodes.middle, nodes.middle_weight * sign);
  return add_ring_node(view, sums, pass, arc, nodes.last, nodes.last_weight * sign);
}

/// An arc of a conic in two parts, in g.
struct ArcHalves {
  Vec3 before; ///< the first one's control point
  Vec3 middle; ///< where the second begins, |g| = 1
  Vec3 after;  ///< its control point
};

/// The arc of p, m, q, with |g| = 1 at its ends, divided where g is at equal angles from both of them; so are
/// the parts. (p - q).g = 0 is quadratic.
FN ArcHalves halves_of(Vec3 p, Vec3 m, Vec3 q) {
  Vec3 d = p - q;
  Real turn = Real(0.5) * dot(d, d) + Real(1.0e-14);
  Real lean = dot(d, m);
  Real length2 = lean * lean + turn * turn;
  Real longer = abs(lean) + length2 * inversesqrt(length2);
  Real ratio = select(lean < Real(0.0), turn * turn * reciprocal(longer), longer);
  Real t = ratio * reciprocal(ratio + turn);
  Real u = Real(1.0) - t;
  Vec3 before = p * u + m * t;
  Vec3 after = m * u + q * t;
  Vec3 middle = before * u + after * t;
  Real inv_g = inversesqrt(max(dot(middle, middle), Real(k_tiny)));
  Real root = inv_g * inversesqrt(inv_g);
  ArcHalves halves;
  halves.middle = middle * inv_g;
  halves.before = before * root;
  halves.after = after * root;
  return halves;
}

/// Rings along the two parts of the arc of p, m, q that t divides, times `sign`.
FN_CALL ContourSums add_rings_of_parts(GIVEN(ExactView) view, GIVEN(ContourSums) so_far,
                                       GIVEN(EdgePass) pass, GIVEN(ConicPoint) p,
                                       GIVEN(ConicPoint) m, GIVEN(ConicPoint) q, Real t,
                                       Real sign) {
  ContourSums sums = so_far;
  ConicPoint before = mix_points(p, m, t);
  ConicPoint after = mix_points(m, q, t);
  ConicPoint middle = mix_points(before, after, t);
  // Scaled so that both parts have |g| = 1 at their ends.
  Real inv_g = inversesqrt(max(dot(middle.g, middle.g), Real(k_tiny)));
  Real root = inv_g * inversesqrt(inv_g);
  middle = scale_point(middle, inv_g);
  ConicTerms first = conic_terms(p, scale_point(before, root), middle);
  ConicTerms second = conic_terms(middle, scale_point(after, root), q);
  RingNodes of_first = ring_nodes(view, first);
  RingNodes of_second = ring_nodes(view, second);
  sums = add_rings(view, sums, pass, first, of_first, sign);
  return add_rings(view, sums, pass, second, of_second, sign);
}

/// Cosine of the angle in g between the ends of half an edge from which on it is divided once more.
CONSTANT k_wide_arc_cos = 0.6;
/// Cosine of that between the ends of a whole one up to which it is not divided,
CONSTANT k_narrow_arc_cos = 0.6;
/// and square of the cosine of the angle at which its control point is seen from them, up to which it keeps to its
/// chord.
CONSTANT k_narrow_bend_cos2 = 0.75;

/// Cosine of the view below which rings along every arc are in two parts,
CONSTANT k_parted_view_cos = 0.09;
/// and 1 over what lies between that and where they are nothing else.
CONSTANT k_inv_parted_view_range = 40.0;

/// Visible normals along the two halves of an arc.
FN_CALL Vec3 visible_halves(Vec3 a, Vec3 m, Vec3 b) {
  ArcHalves halves = halves_of(a, m, b);
  return visible_part(a, halves.before, halves.middle) +
         visible_part(halves.middle, halves.after, b);
}

/// Visible normals along half of an arc, itself in two halves where it is wide.
FN Vec3 visible_half(Vec3 a, Vec3 m, Vec3 b) {
  Vec3 whole = visible_part(a, m, b);
  Mask wide = dot(a, b) < Real(k_wide_arc_cos);
  // Uniform shortcut: no lane's is.
  if (any_lane(wide)) {
    whole = select(wide, visible_halves(a, m, b), whole);
  }
  return whole;
}

/// The arc of p, m, q, points of unit directions above the horizon and the control point between, times `sign`.
FN_CALL ContourSums add_arc(GIVEN(ExactView) view, GIVEN(ContourSums) so_far, GIVEN(ConicPoint) p,
                            GIVEN(ConicPoint) m, GIVEN(ConicPoint) q, Real sign) {
  ContourSums sums = so_far;
  EdgePass pass;
  pass.negative = Real(0.0);
  pass.positive = Real(0.0);
  Mask begins_behind = p.r.y < Real(0.0);
  Mask ends_behind = q.r.y < Real(0.0);
  pass.some = any_lane(begins_behind != ends_behind);
  if (pass.some) {
    Real x = p.r.x + (q.r.x - p.r.x) * crossing_place(p.r.y, q.r.y);
    Mask passes = begins_behind != ends_behind && x < Real(0.0);
    pass.some = any_lane(passes);
    if (pass.some) {
      Real way = select(passes, select(ends_behind, Real(-1.0), Real(1.0)), Real(0.0));
      Mask behind_is_higher = select(ends_behind, q.r.z - p.r.z, p.r.z - q.r.z) > Real(0.0);
      pass.negative = select(behind_is_higher, abs(way), Real(0.0));
      pass.positive = select(behind_is_higher, Real(0.0), -abs(way));
      sums = add_cap(view, sums, min(max(max(p.r.z, q.r.z), Real(0.0)), Real(1.0)), way * sign);
    }
  }
  Real inv_p = inversesqrt(max(dot(p.g, p.g), Real(k_tiny)));
  Real inv_q = inversesqrt(max(dot(q.g, q.g), Real(k_tiny)));
  ConicPoint from = scale_point(p, inv_p);
  ConicPoint to = scale_point(q, inv_q);
  Real inv_both = inv_p * inv_q;
  ConicPoint control = scale_point(m, inv_both * inversesqrt(inv_both));
  ConicTerms arc = conic_terms(from, control, to);
  RingNodes nodes = ring_nodes(view, arc);
  // Rings are in two parts, without a step, from 50 degrees on to 70, and where the view nearly lies in the surface:
  // masking turns over little of an arc's height there.
  Real wide = (Real(0.64) * (p.l * q.l) - dot(p.r, q.r)) * Real(1.0 / 0.3);
  wide = max(wide, (Real(k_parted_view_cos) - view.cos_o) * Real(k_inv_parted_view_range));
  wide = min(max(wide, Real(0.0)), Real(1.0));
  // A narrow arc that keeps to its chord is as smooth as the halves of others.
  Real turn = dot(from.g, control.g);
  Mask narrow = dot(from.g, to.g) > Real(k_narrow_arc_cos) && turn > Real(0.0) &&
                turn * turn > Real(k_narrow_bend_cos2) * dot(control.g, control.g);
  Vec3 visible = visible_part(from.g, control.g, to.g);
  // Uniform shortcut: all lanes' are.
  if (any_lane(!narrow)) {
    ArcHalves halves = halves_of(from.g, control.g, to.g);
    visible = select(narrow, visible,
                     visible_half(from.g, halves.before, halves.middle) +
                         visible_half(halves.middle, halves.after, to.g));
  }
  sums.visible = sums.visible + visible * sign;
  // Uniform shortcuts: no lane's arc is wide, or all are.
  if (!any_lane(wide > Real(0.0))) {
    return add_rings(view, sums, pass, arc, nodes, sign);
  }
  // At the middle of its directions, where the turn around the normal is; half of the way in g may be a tenth of it.
  Real root_p = inv_p * inversesqrt(inv_p);
  Real root_q = inv_q * inversesqrt(inv_q);
  ContourSums parts = add_rings_of_parts(view, sums, pass, from, control, to,
                                         root_p * reciprocal(root_p + root_q), sign);
  if (all_lanes(wide >= Real(1.0))) {
    return parts;
  }
  sums = add_rings(view, sums, pass, arc, nodes, sign);
  sums.masked = sums.masked + (parts.masked - sums.masked) * wide;
  sums.biased = sums.biased + (parts.biased - sums.biased) * wide;
  sums.solid = sums.solid + (parts.solid - sums.solid) * wide;
  return sums;
}

/// The edge from a to b, unit vectors above the horizon, times `sign`.
FN ContourSums add_whole_edge(GIVEN(ExactView) view, GIVEN(ContourSums) sums, Vec3 a, Vec3 b,
                              Real sign) {
  Vec3 sum = a + b;
  Real sum2 = max(dot(sum, sum), Real(k_tiny));
  Real inv_sum = inversesqrt(sum2);
  ConicPoint m = conic_point(view, sum * inv_sum, Real(0.5) * sum2 * inv_sum);
  return add_arc(view, sums, conic_point(view, a, Real(1.0)), m, conic_point(view, b, Real(1.0)),
                 sign);
}

/// Sine of a height that counts as none, so that edges along the horizon are its arcs, which are exact.
CONSTANT k_in_horizon = 1.0e-6;

/// The edge from a to b, unit vectors, as far as it is above the horizon, times `sign`; where it was cut, closed
/// by an arc of the horizon to the azimuth at which rings begin.
FN ContourSums add_edge(GIVEN(ExactView) view, ContourSums sums, Vec3 a, Vec3 b, Real sign) {
  Mask a_up = a.z > Real(k_in_horizon);
  Mask b_up = b.z > Real(k_in_horizon);
  // Uniform shortcuts: no lane has anything left, or needs to clip.
  if (!any_lane(a_up || b_up)) {
    return sums;
  }
  if (all_lanes(a_up && b_up)) {
    return add_whole_edge(view, sums, a, b, sign);
  }
  Real t = crossing_place(a.z, b.z);
  Vec3 cut = Vec3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, Real(0.0));
  cut = cut * inverse_length(cut);
  Real leaves =
      select(a_up, select(b_up, Real(0.0), Real(-1.0)), select(b_up, Real(1.0), Real(0.0)));
  sums = add_horizon_arc(view, sums, conic_point(view, cut, Real(1.0)), leaves * sign);
  return add_whole_edge(view, sums, select(a_up, a, cut), select(b_up, b, cut),
                        select(a_up || b_up, sign, Real(0.0)));
}
