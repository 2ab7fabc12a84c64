// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Points of a triangle, distributed as what a lobe has of it above both horizons.
//
// In cosine space that is a polygon by projected solid angle. Both horizons hold the y axis there
// (edge.glsl), so half planes from that axis slice it, and one between the horizons meets a triangle in one
// arc or none. With p the turn of a slice about y, x = sin p, and l the latitude along it,
//   o = (x cos l, sin l, cos p cos l),   o_z d omega = cos^2 l dl dx.
// Twice the projected solid angle of what has a smaller turn than p is Lambert's sum,
//   G(p) = sum of n_z theta over the edges' parts there + x (l1 - l0),   dG/dx = w = [l + sin l cos l],
// n being the unit normal of an edge's plane, to the inside, theta the angle of its part; w is the slice's width,
// between l0 and l1. G is monotone, and inverted by Newton's method between bounds. Turns are told by
// t = tan(p/2), which has all its digits at the horizons too.
//   Along the slice 2 l + sin 2 l is spread evenly. With q = pi - |2 l| that is Kepler's equation of
// eccentricity 1, q - sin q = d, whose series in (6 d)^(1/3) one step of Newton completes.
// So the density is that of the lobe over its integral, G of the whole over 2 pi.
//
// Sources: the task is that of Peters 2021, "BRDF Importance Sampling for Polygonal Lights", who turns about
// the normal instead, where sectors of a clipped polygon have to be sorted; Arvo 2001, "Stratified Sampling of
// 2-Manifolds" (marginal and conditional distribution); Lambert 1760.

/// The part of an edge that is above both horizons.
struct LobeEdge {
  Vec3 first;  ///< its end of smaller turn, cosine space, unit
  Vec3 normal; ///< of its plane, to the inside, any length
  Real t0;     ///< tan of half the turn there
  Real t1;     ///< and at the other end; the same for an edge of which nothing counts
  Real term;   ///< n_z theta of all of it
};

/// The edges of a triangle between the horizons, and what they enclose.
struct LobeTriangle {
  LobeEdge ab; ///< between the horizons, as the others
  LobeEdge bc; ///< from the second corner to the third
  LobeEdge ca; ///< from the third corner to the first
  Real base;   ///< x (l1 - l0) of the slice in the horizon where the turns begin
  Real mass;   ///< G of the whole: 2 pi times the integral of the lobe
  Real size;   ///< sum of the sizes of what cancels to it
};

/// Horizons in cosine space.
struct LobeWedge {
  Vec3 m;    ///< normal of the surface's horizon, unit
  Real rise; ///< height over it of what is at a height of 1 in shading space
  Real low;  ///< tan of half the turn where what is above both begins
  Real high; ///< and where it ends
};

/// tan(p/2) of a direction above the cosine's horizon.
FN Real half_turn_of(Vec3 o) { return o.x / max(sqrt(o.x * o.x + o.z * o.z) + o.z, Real(k_tiny)); }

/// The wedge of a lobe.
FN LobeWedge lobe_wedge(Lobe lobe) {
  LobeWedge wedge;
  wedge.m = horizon_normal_cosine(lobe);
  wedge.rise = lobe.det * inversesqrt(max(lobe.m00 * lobe.m00 + lobe.m20 * lobe.m20, Real(k_tiny)));
  // At right angles to m: the turns of (-m.z, m.x) and of (m.z, -m.x).
  Real low = -wedge.m.z / max(Real(1.0) + wedge.m.x, Real(k_tiny));
  Real high = wedge.m.z / max(Real(1.0) - wedge.m.x, Real(k_tiny));
  wedge.low = select(wedge.m.x > Real(0.0), max(low, Real(-1.0)), Real(-1.0));
  wedge.high = select(wedge.m.x < Real(0.0), min(high, Real(1.0)), Real(1.0));
  return wedge;
}

/// A corner of what is seen through a lobe.
struct LobeCorner {
  Vec3 o;      ///< cosine space, any length
  Real height; ///< over the surface's horizon there
};

/// From shading space.
FN LobeCorner lobe_corner(Lobe lobe, LobeWedge wedge, Vec3 p) {
  LobeCorner corner;
  corner.o = to_cosine(lobe, p);
  corner.height = p.z * wedge.rise;
  return corner;
}

/// Sine of an angle over a horizon, below which what rounding left there counts as beneath it.
CONSTANT k_on_horizon = 4.0e-6;
/// How far beside a horizon, in tan(p/2), its own slice asks which edges it crosses: less than that.
CONSTANT k_next_to_horizon = 1.0e-6;

/// Height over a horizon less what counts as none.
FN Real clear_height(Real height, Vec3 o) { return height - Real(k_on_horizon) * sqrt(dot(o, o)); }

/// A corner, or where the edge from it to `other` meets a horizon if it is `below`; a, b: their heights over that.
FN LobeCorner raised_corner(LobeCorner corner, LobeCorner other, Mask below, Real a, Real b) {
  Real gap = b - a;
  Real at = min(max(-a / select(abs(gap) > Real(k_tiny), gap, Real(1.0)), Real(-1.0)), Real(1.0));
  at = select(below, at, Real(0.0));
  LobeCorner raised;
  raised.o = corner.o + (other.o - corner.o) * at;
  raised.height = corner.height + (other.height - corner.height) * at;
  return raised;
}

/// The edge from a to b = a + d in cosine space; side: 1 where a x b points to the inside, else -1; clips: whether
/// some lane has a corner below a horizon.
FN LobeEdge lobe_edge(LobeCorner a, LobeCorner b, Vec3 d, Real side, LobeWedge wedge, bool clips) {
  LobeEdge edge;
  edge.normal = cross(a.o, d) * side;
  LobeCorner p = a;
  LobeCorner q = b;
  Mask some = Real(0.0) < Real(1.0);
  Mask p_cut = Real(1.0) < Real(0.0);
  Mask q_cut = p_cut;
  if (clips) {
    Mask p_below = clear_height(p.o.z, p.o) <= Real(0.0);
    Mask q_below = clear_height(q.o.z, q.o) <= Real(0.0);
    some = !(p_below && q_below);
    LobeCorner from = raised_corner(p, q, p_below, p.o.z, q.o.z);
    LobeCorner to = raised_corner(q, p, q_below, q.o.z, p.o.z);
    p_cut = p_below;
    q_cut = q_below;
    p_below = clear_height(from.height, from.o) <= Real(0.0);
    q_below = clear_height(to.height, to.o) <= Real(0.0);
    some = some && !(p_below && q_below);
    p = raised_corner(from, to, p_below, from.height, to.height);
    q = raised_corner(to, from, q_below, to.height, from.height);
    p_cut = p_cut || p_below;
    q_cut = q_cut || q_below;
    p.o.z = max(p.o.z, Real(0.0));
    q.o.z = max(q.o.z, Real(0.0));
  }
  Real inv_p = inverse_length(p.o);
  Real inv_q = inverse_length(q.o);
  Vec3 pq = d;
  Real tp = half_turn_of(p.o);
  Real tq = half_turn_of(q.o);
  if (clips) {
    pq = select(p_cut || q_cut, q.o - p.o, d);
    // Which of the horizons it is: the one or the other side of the middle.
    Real p_side = p.o.x * (Real(1.0) + wedge.m.z) - p.o.z * wedge.m.x;
    Real q_side = q.o.x * (Real(1.0) + wedge.m.z) - q.o.z * wedge.m.x;
    tp = select(p_cut, select(p_side < Real(0.0), wedge.low, wedge.high), tp);
    tq = select(q_cut, select(q_side < Real(0.0), wedge.low, wedge.high), tq);
    tp = min(max(tp, wedge.low), wedge.high);
    tq = min(max(tq, wedge.low), wedge.high);
  }
  edge.term = edge_term_scaled(p.o, q.o, pq, inv_p, inv_q).z * side;
  edge.term = select(some, edge.term, Real(0.0));
  Mask forth = tp <= tq;
  edge.first = select(forth, p.o * inv_p, q.o * inv_q);
  edge.t0 = select(forth, tp, tq);
  edge.t1 = select(some, select(forth, tq, tp), edge.t0);
  return edge;
}

/// A slice of a triangle.
struct LobeSlice {
  Real x;     ///< sine of its turn
  Real z;     ///< cosine of its turn
  Real c;     ///< cosine of the latitude where it begins
  Real s;     ///< sine of that
  Real angle; ///< of latitudes between its ends
  Real width; ///< dG/dx
  Real below; ///< G of what has a smaller turn
};

/// The two edges that bound a slice, each with where its part of smaller turn begins.
struct SliceEnds {
  Vec3 lower;       ///< normal; what has none ends at the pole
  Vec3 lower_first; ///< cosine space, unit
  Vec3 upper;       ///< the same of the other end
  Vec3 upper_first; ///< cosine space, unit
  Real whole;       ///< terms of the edges all of whose turns are smaller
};

/// Takes in an edge.
FN SliceEnds slice_ends(SliceEnds ends, LobeEdge edge, Real t) {
  Mask crosses = edge.t0 < t && edge.t1 >= t;
  Mask lower = crosses && edge.normal.y > Real(0.0);
  Mask upper = crosses && edge.normal.y < Real(0.0);
  ends.lower = select(lower, edge.normal, ends.lower);
  ends.lower_first = select(lower, edge.first, ends.lower_first);
  ends.upper = select(upper, edge.normal, ends.upper);
  ends.upper_first = select(upper, edge.first, ends.upper_first);
  ends.whole = ends.whole + select(edge.t1 < t, edge.term, Real(0.0));
  return ends;
}

/// theta n_z of the arc from a to b, both unit.
FN Real part_term(Vec3 a, Vec3 b) {
  Vec3 d = b - a;
  Vec3 c = cross(a, d);
  return c.z * theta_over_sin(dot(a, b), dot(c, c));
}

/// At t; edges are those that cross at `t_edges`, which is t or next to it.
FN LobeSlice slice_at(LobeTriangle triangle, Real t, Real t_edges) {
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  SliceEnds ends;
  ends.lower = none;
  ends.lower_first = none;
  ends.upper = none;
  ends.upper_first = none;
  ends.whole = Real(0.0);
  ends = slice_ends(ends, triangle.ab, t_edges);
  ends = slice_ends(ends, triangle.bc, t_edges);
  ends = slice_ends(ends, triangle.ca, t_edges);
  Real inv = Real(1.0) / (Real(1.0) + t * t);
  LobeSlice slice;
  slice.x = Real(2.0) * t * inv;
  slice.z = (Real(1.0) - t) * (Real(1.0) + t) * inv;
  // n . o = 0 at the latitude of tangent -(n_x x + n_z z) / n_y.
  Mask has_lower = ends.lower.y > Real(0.0);
  Mask has_upper = ends.upper.y < Real(0.0);
  Real lower_y = -(ends.lower.x * slice.x + ends.lower.z * slice.z);
  Real upper_y = ends.upper.x * slice.x + ends.upper.z * slice.z;
  Real inv_lower = inversesqrt(max(ends.lower.y * ends.lower.y + lower_y * lower_y, Real(k_tiny)));
  Real inv_upper = inversesqrt(max(ends.upper.y * ends.upper.y + upper_y * upper_y, Real(k_tiny)));
  slice.c = select(has_lower, ends.lower.y * inv_lower, Real(0.0));
  slice.s = select(has_lower, lower_y * inv_lower, Real(-1.0));
  Real upper_c = select(has_upper, -ends.upper.y * inv_upper, Real(0.0));
  Real upper_s = select(has_upper, upper_y * inv_upper, Real(1.0));
  Real sine = max(slice.c * upper_s - slice.s * upper_c, Real(0.0));
  Mask some = has_lower || has_upper;
  slice.angle = select(some, angle_of(slice.c * upper_c + slice.s * upper_s, sine), Real(0.0));
  slice.width =
      max(slice.angle + select(some, sine, Real(0.0)) * (slice.c * upper_c - slice.s * upper_s),
          Real(0.0));
  Vec3 lower = Vec3(slice.c * slice.x, slice.s, slice.c * slice.z);
  Vec3 upper = Vec3(upper_c * slice.x, upper_s, upper_c * slice.z);
  Real arcs = select(has_lower, part_term(ends.lower_first, lower), Real(0.0)) -
              select(has_upper, part_term(ends.upper_first, upper), Real(0.0));
  slice.below = ends.whole + arcs + slice.x * slice.angle;
  return slice;
}

/// A triangle's corners in cosine space, and its edges.
struct LobeCorners {
  LobeCorner a; ///< the first corner
  LobeCorner b; ///< the second
  LobeCorner c; ///< the third
  Vec3 ab;      ///< cosine space
  Vec3 ac;      ///< cosine space
  Real side;    ///< 1 where a x b points to the inside, else -1
  bool clips;   ///< whether some lane has a corner below a horizon
};

/// A triangle of shading space, seen from its origin: a corner, and the edges from there.
FN LobeCorners lobe_corners(Lobe lobe, LobeWedge wedge, Vec3 corner, Vec3 ab, Vec3 ac) {
  LobeCorners corners;
  corners.a = lobe_corner(lobe, wedge, corner);
  corners.b = lobe_corner(lobe, wedge, corner + ab);
  corners.c = lobe_corner(lobe, wedge, corner + ac);
  corners.ab = to_cosine(lobe, ab);
  corners.ac = to_cosine(lobe, ac);
  corners.side =
      select(dot(cross(corners.a.o, corners.ab), corners.ac) < Real(0.0), Real(-1.0), Real(1.0));
  Real lowest = min(min(clear_height(min(corners.a.o.z, corners.a.height), corners.a.o),
                        clear_height(min(corners.b.o.z, corners.b.height), corners.b.o)),
                    clear_height(min(corners.c.o.z, corners.c.height), corners.c.o));
  corners.clips = any_lane(lowest <= Real(0.0));
  return corners;
}

/// The edges between the horizons, and what they enclose.
FN LobeTriangle lobe_triangle(LobeCorners corners, LobeWedge wedge) {
  LobeTriangle triangle;
  triangle.ab = lobe_edge(corners.a, corners.b, corners.ab, corners.side, wedge, corners.clips);
  triangle.bc =
      lobe_edge(corners.b, corners.c, corners.ac - corners.ab, corners.side, wedge, corners.clips);
  triangle.ca = lobe_edge(corners.c, corners.a, -corners.ac, corners.side, wedge, corners.clips);
  triangle.base = Real(0.0);
  triangle.mass = triangle.ab.term + triangle.bc.term + triangle.ca.term;
  triangle.size = abs(triangle.ab.term) + abs(triangle.bc.term) + abs(triangle.ca.term);
  if (corners.clips) {
    LobeSlice first = slice_at(triangle, wedge.low, wedge.low + Real(k_next_to_horizon));
    LobeSlice last = slice_at(triangle, wedge.high, wedge.high - Real(k_next_to_horizon));
    triangle.base = first.x * first.angle;
    triangle.size = triangle.size + abs(triangle.base) + abs(last.x * last.angle);
    triangle.mass = last.below - triangle.base;
  }
  triangle.mass = max(triangle.mass, Real(0.0));
  return triangle;
}

/// Mass and size of a triangle, as lobe_triangle has them.
FN Vec2 lobe_mass(LobeCorners corners, LobeWedge wedge) {
  if (corners.clips) {
    LobeTriangle triangle = lobe_triangle(corners, wedge);
    return Vec2(triangle.mass, triangle.size);
  }
  Vec3 a = corners.a.o;
  Vec3 b = corners.b.o;
  Vec3 c = corners.c.o;
  Real inv_a = inverse_length(a);
  Real inv_b = inverse_length(b);
  Real inv_c = inverse_length(c);
  Real ab = edge_term_scaled(a, b, corners.ab, inv_a, inv_b).z;
  Real bc = edge_term_scaled(b, c, corners.ac - corners.ab, inv_b, inv_c).z;
  Real ca = edge_term_scaled(c, a, -corners.ac, inv_c, inv_a).z;
  return Vec2(max((ab + bc + ca) * corners.side, Real(0.0)), abs(ab) + abs(bc) + abs(ca));
}

/// The slice below which the share u of a triangle is.
FN LobeSlice slice_of_share(LobeTriangle triangle, Real u) {
  Real low = min(min(triangle.ab.t0, triangle.bc.t0), triangle.ca.t0);
  Real high = max(max(triangle.ab.t1, triangle.bc.t1), triangle.ca.t1);
  // Slices widen from one end to the corner between, and narrow from there. Clipped, there may be no end.
  Real t = max(max(triangle.ab.t0, triangle.bc.t0), triangle.ca.t0);
  t = select(t > low, t, high);
  LobeSlice slice = slice_at(triangle, t, t);
  Real first = (slice.below - triangle.base) / max(triangle.mass, Real(k_tiny));
  Mask before = u < first;
  Real part = select(before, u / max(first, Real(k_tiny)),
                     (Real(1.0) - u) / max(Real(1.0) - first, Real(k_tiny)));
  part = sqrt(min(max(part, Real(0.0)), Real(1.0)));
  Real end = select(before, low, high);
  low = select(before, low, t);
  high = select(before, t, high);
  t = end + (t - end) * part;
  Real wanted = u * triangle.mass + triangle.base;
  Real close = Real(1.0e-6) * triangle.mass + Real(1.0e-7) * triangle.size;
  slice = slice_at(triangle, t, t);
  for (int i = 0; i < 12; ++i) {
    Real over = slice.below - wanted;
    if (all_lanes(abs(over) <= close && slice.width > Real(0.0))) {
      return slice;
    }
    low = select(over < Real(0.0), t, low);
    high = select(over < Real(0.0), high, t);
    // dG/dt = w dx/dt, x = 2 t / (1 + t^2).
    Real slope = slice.width * slice.z * Real(2.0);
    Real next = t - over * (Real(1.0) + t * t) / max(slope, Real(k_tiny));
    t = select(next > low && next < high, next, Real(0.5) * (low + high));
    slice = slice_at(triangle, t, t);
  }
  return slice;
}

/// Cosine and sine of the latitude l with 2 l + sin 2 l = k, k from -pi to pi.
FN Vec2 latitude_of(Real k) {
  Real d = max(k_pi - abs(k), Real(0.0));
  Real s = pow(max(Real(6.0) * d, Real(k_tiny)), Real(1.0 / 3.0));
  Real s2 = s * s;
  Real q = s * (Real(1.0) + s2 * (Real(1.0 / 60.0) +
                                  s2 * (Real(1.0 / 1400.0) + s2 * (Real(1.0 / 25200.0) +
                                                                   s2 * Real(43.0 / 17248000.0)))));
  Real sine = sin(Real(0.5) * q);
  Real cosine = cos(Real(0.5) * q);
  // q - sin q has no digits where q is small; the series needs no help there.
  Real step = (q - Real(2.0) * sine * cosine - d) / max(Real(2.0) * sine * sine, Real(0.1));
  step = select(q > Real(0.8), Real(0.5) * step, Real(0.0));
  Real almost_one = Real(1.0) - Real(0.5) * step * step;
  Real north = cosine * almost_one + sine * step;
  return Vec2(sine * almost_one - cosine * step, select(k < Real(0.0), -north, north));
}
