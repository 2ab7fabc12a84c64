// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A convex quad cut by both horizons in one lane, without a loop and with next to no branch: what the surface's
// horizon leaves of it has five corners at most, and five that may coincide stand for every case. In cosine space
// their five edges are cut one by one and closed in their plane, as in lanes (close_outline).

/// The point where an edge crosses the surface's horizon, shading space.
FN Vec3 horizon_point(Vec3 a, Vec3 b) {
  Real t = crossing_place(a.z, b.z);
  return Vec3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, Real(0.0));
}

/// Five corners of a convex outline in its order, of which some may coincide.
struct FiveCorners {
  Vec3 first;  ///< shading space
  Vec3 second; ///< see first
  Vec3 third;  ///< see first
  Vec3 fourth; ///< see first
  Vec3 fifth;  ///< see first
};

/// The same, from the second on.
FN FiveCorners next_corner_first(FiveCorners corners) {
  FiveCorners next;
  next.first = corners.second;
  next.second = corners.third;
  next.third = corners.fourth;
  next.fourth = corners.fifth;
  next.fifth = corners.first;
  return next;
}

/// 2 pi times the vector irradiance of what they bound, which is above the horizon, shading space.
FN Vec3 sum_corners(FiveCorners corners) {
  FiveCorners left = corners;
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 a = corners.fifth;
  Real inv_a = inverse_length(a);
  for (int i = 0; i < 5; ++i) {
    Vec3 b = left.first;
    Real inv_b = inverse_length(b);
    sum = sum + edge_term_scaled(a, b, b - a, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = next_corner_first(left);
  }
  return sum;
}

/// The sum over a convex outline in cosine space, and where it crosses the cosine's horizon: at most once either way.
struct ConvexSum {
  Vec3 term;   ///< 2 pi times the vector irradiance, not yet closed
  Vec3 enters; ///< where the outline comes up, unit
  Vec3 leaves; ///< and where it goes down
};

/// No edges yet.
FN ConvexSum no_convex_edges() {
  ConvexSum sum;
  sum.term = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sum.enters = Vec3(Real(1.0), Real(0.0), Real(0.0));
  sum.leaves = sum.enters;
  return sum;
}

/// The edge from a to b, cosine space, cut by its horizon without a branch: of an edge below it the length is 0. inv_a,
/// inv_b: 1 / their lengths.
FN ConvexSum add_convex_edge(ConvexSum sum, Vec3 a, Vec3 b, Real inv_a, Real inv_b) {
  Mask a_up = a.z >= Real(0.0);
  Mask b_up = b.z >= Real(0.0);
  Vec3 along = b - a;
  Real t = crossing_place(a.z, b.z);
  Vec3 cut = Vec3(a.x + along.x * t, a.y + along.y * t, Real(0.0));
  Real inv_cut = inverse_length(cut);
  Vec3 unit = cut * inv_cut;
  Real extent = select(a_up, select(b_up, Real(1.0), t), select(b_up, Real(1.0) - t, Real(0.0)));
  ConvexSum next;
  next.term =
      sum.term + edge_term_scaled(select(a_up, a, cut), select(b_up, b, cut), along * extent,
                                  select(a_up, inv_a, inv_cut), select(b_up, inv_b, inv_cut));
  next.enters = select(b_up && !a_up, unit, sum.enters);
  next.leaves = select(a_up && !b_up, unit, sum.leaves);
  return next;
}

/// The specular sum of a whole outline, closed along the cosine's horizon. way: negative where a positive angle about z
/// leads backwards; it holds whatever rounding makes of an angle near 0.
FN Vec3 close_convex_outline(ConvexSum sum, Real way) {
  Vec3 a = sum.leaves;
  Vec3 b = sum.enters;
  Real angle = abs(angle_of_unit(a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x));
  return Vec3(sum.term.x, sum.term.y, sum.term.z + select(way < Real(0.0), -angle, angle));
}

/// sum_corners in cosine space. way: see close_convex_outline.
FN Vec3 sum_corners_cosine(FiveCorners corners, Lobe lobe, Real way) {
  FiveCorners left = corners;
  ConvexSum sum = no_convex_edges();
  Vec3 a = to_cosine(lobe, corners.fifth);
  Real inv_a = inverse_length(a);
  for (int i = 0; i < 5; ++i) {
    Vec3 b = to_cosine(lobe, left.first);
    Real inv_b = inverse_length(b);
    sum = add_convex_edge(sum, a, b, inv_a, inv_b);
    a = b;
    inv_a = inv_b;
    left = next_corner_first(left);
  }
  return close_convex_outline(sum, way);
}

/// sum_edges, but for outline2, of a convex quad with these corners, shading space, in its order. h: signed
/// distance of its plane along its normal.
FN EdgeSums sum_convex_quad(Vec3 corner0, Vec3 corner1, Vec3 corner2, Vec3 corner3, Real h,
                            Lobe lobe) {
  Vec3 a = corner0;
  Vec3 b = corner1;
  Vec3 c = corner2;
  Vec3 d = corner3;
  // Turned until it enters at a: a is above and d is not. One that is wholly above comes as it may.
  for (int i = 0; i < 3; ++i) {
    Mask enters = a.z >= Real(0.0) && d.z < Real(0.0);
    Vec3 first = a;
    a = select(enters, a, b);
    b = select(enters, b, c);
    c = select(enters, c, d);
    d = select(enters, d, first);
  }
  Mask seen = a.z >= Real(0.0);
  Mask two = b.z >= Real(0.0);
  Mask three = two && c.z >= Real(0.0);
  Mask four = d.z >= Real(0.0);
  Vec3 last = select(three, c, select(two, b, a));
  Vec3 below = select(three, d, select(two, c, b));
  Vec3 leaves = select(four, d, horizon_point(last, below));
  FiveCorners corners;
  corners.first = a;
  corners.second = select(two, b, leaves);
  corners.third = select(three, c, leaves);
  corners.fourth = leaves;
  corners.fifth = select(four, d, horizon_point(d, a));
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  EdgeSums sums;
  sums.diffuse = select(seen, sum_corners(corners), none);
  sums.specular = select(seen, sum_corners_cosine(corners, lobe, h * lobe.det), none);
  sums.outline2 = Real(0.0);
  return sums;
}

/// sum_edges_in_one_lane of a parallelogram at signed distance h along its normal: by its outline where a triangle's
/// plane cuts it, and else as above.
FN EdgeSums sum_quad_in_one_lane(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h,
                                 bool cut, Vec3 front) {
  // Its middle and sides take three turns where four corners take four.
  Vec3 middle = to_shading(frame, polygon_centroid(polygon) - position);
  Vec3 u = to_shading(frame, polygon_half_u(polygon));
  Vec3 v = to_shading(frame, polygon_half_v(polygon));
  Vec3 a = middle - u - v;
  Vec3 b = middle + u - v;
  Vec3 c = middle + u + v;
  Vec3 d = middle - u + v;
  if (cut) {
    Real lowest = min(min(dot(front, a), dot(front, b)), min(dot(front, c), dot(front, d)));
    if (any_lane(lowest < Real(0.0))) {
      return sum_edges_in_one_lane(polygon, position, frame, lobe, cut, front);
    }
  }
  EdgeSums sums = sum_convex_quad(a, b, c, d, h, lobe);
  Vec3 corners = safe_direction(to_cosine(lobe, a)) + safe_direction(to_cosine(lobe, b)) +
                 safe_direction(to_cosine(lobe, c)) + safe_direction(to_cosine(lobe, d));
  sums.outline2 = mean_length2(corners, Real(4.0));
  return sums;
}
