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

/// sum_edges, but for outline2, of a convex quad with these corners, shading space, in its order. s: its apex_side;
/// h: signed distance of its plane along its normal.
FN EdgeSums sum_convex_quad(Vec3 corner0, Vec3 corner1, Vec3 corner2, Vec3 corner3, Real s, Real h,
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
  Corner p0 = corner_at(select(four, d, horizon_point(d, a)), lobe);
  Corner p1 = corner_at(a, lobe);
  Vec3 diffuse = whole_diffuse_term(p0, p1);
  EdgeAbove specular = specular_edge(p0, p1, s);
  Corner p2 = corner_at(select(two, b, leaves), lobe);
  diffuse = diffuse + whole_diffuse_term(p1, p2);
  specular = join_edges(specular, specular_edge(p1, p2, s));
  Corner p3 = corner_at(select(three, c, leaves), lobe);
  diffuse = diffuse + whole_diffuse_term(p2, p3);
  specular = join_edges(specular, specular_edge(p2, p3, s));
  Corner p4 = corner_at(leaves, lobe);
  diffuse = diffuse + whole_diffuse_term(p3, p4) + whole_diffuse_term(p4, p0);
  specular = join_edges(specular, specular_edge(p3, p4, s));
  specular = join_edges(specular, specular_edge(p4, p0, s));
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  EdgeSums sums;
  sums.diffuse = select(seen, diffuse, none);
  sums.specular = select(seen, close_outline(specular, h * lobe.det), none);
  sums.outline2 = Real(0.0);
  return sums;
}

/// sum_edges_in_one_lane of a parallelogram at signed distance h along its normal: by its outline where a triangle's
/// plane cuts it, and else as above.
FN EdgeSums sum_quad_in_one_lane(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h,
                                 bool cut, Vec3 front) {
  Vec3 a = to_shading(frame, polygon_point(polygon, 0) - position);
  Vec3 b = to_shading(frame, polygon_point(polygon, 1) - position);
  Vec3 c = to_shading(frame, polygon_point(polygon, 2) - position);
  Vec3 d = to_shading(frame, polygon_point(polygon, 3) - position);
  if (cut) {
    Real lowest = min(min(dot(front, a), dot(front, b)), min(dot(front, c), dot(front, d)));
    if (any_lane(lowest < Real(0.0))) {
      return sum_edges_in_one_lane(polygon, position, frame, lobe, cut, front);
    }
  }
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  EdgeSums sums = sum_convex_quad(a, b, c, d, s, h, lobe);
  Vec3 corners = safe_direction(to_cosine(lobe, a)) + safe_direction(to_cosine(lobe, b)) +
                 safe_direction(to_cosine(lobe, c)) + safe_direction(to_cosine(lobe, d));
  sums.outline2 = mean_length2(corners, Real(4.0));
  return sums;
}
