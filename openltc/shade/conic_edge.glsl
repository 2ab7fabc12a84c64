// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The two integrals of half_vector.glsl and masking_ring.glsl along one edge, by five and three nodes of Gauss
// in either half of it.
//
// Scaled so that both ends have |g| = 1, a conic's parameter runs evenly along its arc as far as it can. Divided
// where g is at equal angles from both ends, a root of a quadratic, and scaled again, each half is
// so smooth that a few nodes do.

/// Visible normals at the node t of a part of an edge, of weight w. c0, c1, c2: cross products of control points.
FN Vec3 visible_node(ConicPoint a, ConicPoint m, ConicPoint b, Vec3 c0, Vec3 c1, Vec3 c2, Real t,
                     Real w) {
  Real u = Real(1.0) - t;
  Real uu = u * u;
  Real ut = u * t;
  Real tt = t * t;
  Vec3 g = a.g * uu + m.g * (Real(2.0) * ut) + b.g * tt;
  Real scale = w / max(dot(g, g), Real(k_tiny));
  return (c0 * uu + c1 * ut + c2 * tt) * scale;
}

/// Whether an edge passes the azimuth opposite of that at which rings begin. Its rings go on beyond it, so that
/// they have no step on the way: the step is at its higher end.
struct EdgePass {
  Real negative; ///< whole rings that count for nodes at negative azimuths
  Real positive; ///< and for those at positive ones
  bool some;     ///< whether any lane's edge passes it
};

/// Rings at the node t of a part of an edge, of weight w.
FN ContourSums add_ring_node(ExactView view, ContourSums sums, EdgePass pass, ConicPoint a,
                             ConicPoint m, ConicPoint b, Real t, Real w) {
  Real u = Real(1.0) - t;
  Vec3 r0 = a.r * u + m.r * t;
  Vec3 r1 = m.r * u + b.r * t;
  Real l0 = a.l * u + m.l * t;
  Real l1 = m.l * u + b.l * t;
  Vec3 r = r0 * u + r1 * t;
  Real inv_l = Real(1.0) / max(l0 * u + l1 * t, Real(k_tiny));
  Real z = min(max(r.z * inv_l, Real(0.0)), Real(1.0));
  Vec3 dr = (r1 - r0) * (Real(2.0) * w * inv_l);
  Real dz = dr.z - z * ((l1 - l0) * (Real(2.0) * w * inv_l));
  Ring ring = ring_at(view, z, min(sqrt(r.x * r.x + r.y * r.y) * inv_l, Real(1.0)));
  RingPart part = ring_part(view, ring, r.x, r.y);
  Real integral = ring_integral(view, ring, part);
  if (pass.some) {
    Real turns = select(r.y < Real(0.0), pass.negative, pass.positive);
    integral = integral + turns * whole_ring(view, ring);
    part.angle = part.angle + turns * (Real(2.0) * k_pi);
  }
  Real more = integral * (masking_of_height(view, z) - view.masking);
  sums.masked = sums.masked - (more - view.more_at_normal * part.angle) * dz;
  sums.solid = sums.solid - (r.x * dr.y - r.y * dr.x) * inv_l / (Real(1.0) + z);
  return sums;
}

/// A part of an edge whose ends have |g| = 1, times `sign`.
FN_CALL ContourSums add_conic(ExactView view, ContourSums sums, EdgePass pass, ConicPoint a,
                              ConicPoint m, ConicPoint b, Real sign) {
  Vec3 c0 = cross(a.g, m.g - a.g);
  Vec3 c1 = cross(a.g, b.g - a.g);
  Vec3 c2 = cross(m.g, b.g - m.g);
  // Five nodes of Gauss.
  Vec3 visible =
      visible_node(a, m, b, c0, c1, c2, Real(0.04691007703066802), Real(0.23692688505618908)) +
      visible_node(a, m, b, c0, c1, c2, Real(0.23076534494715845), Real(0.4786286704993665)) +
      visible_node(a, m, b, c0, c1, c2, Real(0.5), Real(0.5688888888888889)) +
      visible_node(a, m, b, c0, c1, c2, Real(0.7692346550528415), Real(0.4786286704993665)) +
      visible_node(a, m, b, c0, c1, c2, Real(0.953089922969332), Real(0.23692688505618908));
  sums.visible = sums.visible + visible * sign;
  // Three.
  Real outer = sign * Real(0.2777777777777778);
  sums = add_ring_node(view, sums, pass, a, m, b, Real(0.1127016653792583), outer);
  sums = add_ring_node(view, sums, pass, a, m, b, Real(0.5), sign * Real(0.4444444444444444));
  sums = add_ring_node(view, sums, pass, a, m, b, Real(0.8872983346207417), outer);
  return sums;
}

/// An arc of a conic in two parts.
struct ConicHalves {
  ConicPoint before; ///< the first one's control point
  ConicPoint middle; ///< where the second begins
  ConicPoint after;  ///< its control point
};

/// The arc of p, m, q, with |g| = 1 at its ends, divided where g is at equal angles from both of them; so are
/// the parts. (p.g - q.g).g = 0 is quadratic.
FN_CALL ConicHalves halves_of(ConicPoint p, ConicPoint m, ConicPoint q) {
  Vec3 d = p.g - q.g;
  Real turn = Real(0.5) * dot(d, d) + Real(k_least_length2);
  Real lean = dot(d, m.g);
  Real longer = abs(lean) + sqrt(lean * lean + turn * turn);
  Real ratio = select(lean < Real(0.0), turn * turn / longer, longer);
  Real t = ratio / (ratio + turn);
  ConicHalves halves;
  halves.before = mix_points(p, m, t);
  halves.after = mix_points(m, q, t);
  halves.middle = mix_points(halves.before, halves.after, t);
  Real inv_middle = inversesqrt(max(dot(halves.middle.g, halves.middle.g), Real(k_tiny)));
  Real root = sqrt(inv_middle);
  halves.middle = scale_point(halves.middle, inv_middle);
  halves.before = scale_point(halves.before, root);
  halves.after = scale_point(halves.after, root);
  return halves;
}

/// Cosine of the angle between the ends of a half of an edge from which on it is divided once more: of half vectors
/// in g,
CONSTANT k_wide_arc_cos = 0.3;
/// and of the edge itself.
CONSTANT k_wide_edge_cos = 0.5;

/// Half of an edge, itself in two halves where it is wide.
FN_CALL ContourSums add_half_edge(ExactView view, ContourSums sums, EdgePass pass, ConicPoint a,
                                  ConicPoint m, ConicPoint b, Real sign) {
  ContourSums whole = add_conic(view, sums, pass, a, m, b, sign);
  Mask wide =
      dot(a.g, b.g) < Real(k_wide_arc_cos) || dot(a.r, b.r) < Real(k_wide_edge_cos) * a.l * b.l;
  // Uniform shortcut: no lane's is.
  if (!any_lane(wide)) {
    return whole;
  }
  ConicHalves halves = halves_of(a, m, b);
  sums = add_conic(view, sums, pass, a, halves.before, halves.middle, sign);
  sums = add_conic(view, sums, pass, halves.middle, halves.after, b, sign);
  sums.visible = select(wide, sums.visible, whole.visible);
  sums.masked = select(wide, sums.masked, whole.masked);
  sums.solid = select(wide, sums.solid, whole.solid);
  return sums;
}

/// The edge from a to b, unit vectors above the horizon, times `sign`.
FN_CALL ContourSums add_whole_edge(ExactView view, ContourSums sums, Vec3 a, Vec3 b, Real sign) {
  Vec3 sum = a + b;
  Real sum2 = max(dot(sum, sum), Real(k_tiny));
  Real inv_sum = inversesqrt(sum2);
  ConicPoint p = conic_point(view, a, Real(1.0));
  ConicPoint q = conic_point(view, b, Real(1.0));
  ConicPoint m = conic_point(view, sum * inv_sum, Real(0.5) * sum2 * inv_sum);

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
  p = scale_point(p, inv_p);
  q = scale_point(q, inv_q);
  m = scale_point(m, sqrt(inv_p * inv_q));
  ConicHalves halves = halves_of(p, m, q);
  sums = add_half_edge(view, sums, pass, p, halves.before, halves.middle, sign);
  return add_half_edge(view, sums, pass, halves.middle, halves.after, q, sign);
}

/// Sine of a height that counts as none, so that edges along the horizon are its arcs, which are exact.
CONSTANT k_in_horizon = 1.0e-6;

/// The edge from a to b, unit vectors, as far as it is above the horizon, times `sign`; where it was cut, closed
/// by an arc of the horizon to the azimuth at which rings begin.
FN ContourSums add_edge(ExactView view, ContourSums sums, Vec3 a, Vec3 b, Real sign) {
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

/// The light of the outline and where it comes from.
struct ExactIntegral {
  Real light;     ///< integral of f_s cos_i for F = 1
  Vec3 direction; ///< its mean direction, shading space, unit
};

/// From the sums along an outline that runs counter-clockwise for side = 1, clockwise for -1.
FN ExactIntegral exact_integral(ExactView view, ContourSums sums, Real side) {
  Vec3 v = sums.visible * side;
  Real visible = max(view.alpha * view.sin_o * v.x + view.cos_o * v.z, Real(0.0));
  // B^-1 V, times alpha.
  Vec3 h = safe_direction(Vec3(view.alpha * v.x, view.alpha * v.y, v.z));
  Real o_h = h.x * view.sin_o + h.z * view.cos_o;
  h = select(o_h < Real(0.0), -h, h);
  Vec3 wo = Vec3(view.sin_o, Real(0.0), view.cos_o);
  ExactIntegral result;
  result.direction = safe_direction(h * (Real(2.0) * abs(o_h)) - wo);
  Real rest = (sums.masked + view.more_at_normal * sums.solid) * side;
  result.light = max((Real(2.0) * view.masking * visible + rest) * k_inv_pi, Real(0.0));
  return result;
}
