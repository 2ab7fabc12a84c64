// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The sum over a polygon's edges in shading space and in cosine space, clipped to both horizons, and where
// it is cut, to the plane of a triangle.
//
// Source: the edge sum of edge.glsl.

/// Side of the apex: the sign of y where the polygon's plane, at signed distance h along its
/// normal, meets the y axis.
FN Real apex_side(Real normal_y, Real h) {
  return select(normal_y * h < Real(0.0), Real(-1.0), Real(1.0));
}

/// The sums over the edges of an outline.
struct EdgeSums {
  Vec3 diffuse;  ///< 2 pi times the vector irradiance of the clipped polygon in shading space
  Vec3 specular; ///< the same in cosine space
  Real outline2; ///< square of the mean of the unit vectors to its corners, cosine space
};

/// Of an outline without an edge.
FN EdgeSums no_edge_sums() {
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  sums.outline2 = Real(1.0);
  return sums;
}

/// A corner of an outline as a point sees it.
struct Corner {
  Vec3 p;     ///< shading space
  Vec3 o;     ///< cosine space
  Real inv_p; ///< 1 / length
  Real inv_o; ///< 1 / length
};

/// The corner at p of shading space.
FN Corner corner_at(Vec3 p, Lobe lobe) {
  Corner corner;
  corner.p = p;
  corner.o = to_cosine(lobe, p);
  corner.inv_p = inverse_length(corner.p);
  corner.inv_o = inverse_length(corner.o);
  return corner;
}

/// Corner i of a polygon as `position`, world space, sees it.
FN_INLINE Corner corner_seen(Polygon polygon, int i, Vec3 position, Frame frame, Lobe lobe) {
  return corner_at(to_shading(frame, polygon_point(polygon, i) - position), lobe);
}

/// Height over the nearer of the two horizons, in units of its own space.
FN Real least_height(Corner corner) { return min(corner.p.z, corner.o.z); }

/// The term of the edge from a to b in shading space, clipped to the horizon; s: its apex_side.
FN Vec3 diffuse_term(Corner a, Corner b, Real s) {
  return edge_term_above(a.p, b.p, s, a.inv_p, b.inv_p);
}

/// And in cosine space, clipped to both horizons.
FN Vec3 specular_term(Corner a, Corner b, Real s) {
  return clipped_edge_term_scaled(a.o, b.o, a.p.z, b.p.z, s, a.inv_o, b.inv_o);
}

/// And above the surface's horizon, clipped to the cosine's, not yet closed.
FN EdgeAbove specular_edge(Corner a, Corner b, Real s) {
  return edge_above(a.o, b.o, s, a.inv_o, b.inv_o);
}

/// The same of an edge above both horizons.
FN Vec3 whole_diffuse_term(Corner a, Corner b) {
  return edge_term_scaled(a.p, b.p, b.p - a.p, a.inv_p, b.inv_p);
}

/// And in cosine space.
FN Vec3 whole_specular_term(Corner a, Corner b) {
  return edge_term_scaled(a.o, b.o, b.o - a.o, a.inv_o, b.inv_o);
}

/// Square of the length of a mean, from the sum and the number of its parts.
FN Real mean_length2(Vec3 sum, Real count) { return dot(sum, sum) / max(count * count, Real(1.0)); }

/// The edge sums of a polygon at signed distance h along its normal. Positive z behind it, negative
/// in front: there an outline that is counter-clockwise about the normal runs clockwise about
/// directions from the surface.
FN EdgeSums sum_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h) {
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  Vec3 outline = sums.diffuse;
  Real corners = Real(0.0);
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Corner b = corner_seen(polygon, i, position, frame, lobe);
    if (!polygon_starts_ring(polygon, i)) {
      sums.diffuse = sums.diffuse + diffuse_term(a, b, s);
      sums.specular = sums.specular + specular_term(a, b, s);
      outline = outline + b.o * b.inv_o;
      corners = corners + Real(1.0);
    }
    a = b;
  }
  sums.outline2 = mean_length2(outline, corners);
  return sums;
}

/// Where the edge from a to b crosses the plane with unit normal `front`; heights: of its ends over that.
FN Corner corner_between(Corner a, Corner b, Real a_height, Real b_height, Vec3 front, Lobe lobe) {
  Vec3 p = a.p + (b.p - a.p) * crossing_place(a_height, b_height);
  // What rounding made of a crossing that is nearer than the ends would turn the plane, which may cut
  // right through a narrow lobe.
  return corner_at(p - front * dot(front, p), lobe);
}

/// a where the mask is set, b elsewhere.
FN Corner select_corner(Mask m, Corner a, Corner b) {
  Corner corner;
  corner.p = select(m, a.p, b.p);
  corner.o = select(m, a.o, b.o);
  corner.inv_p = select(m, a.inv_p, b.inv_p);
  corner.inv_o = select(m, a.inv_o, b.inv_o);
  return corner;
}

/// sum_edges of the polygon's part in front of the plane with unit normal `front` (shading space).
/// Where an edge crosses it, an edge along it leads to the first such crossing; see front.glsl.
FN_CALL EdgeSums sum_edges_in_front(Polygon polygon, Vec3 position, GIVEN(Frame) frame,
                                    GIVEN(Lobe) lobe, Real h, Vec3 front) {
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  EdgeSums sums;
  sums.diffuse = none;
  sums.specular = none;
  Vec3 outline = none;
  Real corners = Real(0.0);
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  Corner q = a;
  Mask found = Real(1.0) < Real(0.0);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Corner b = corner_seen(polygon, i, position, frame, lobe);
    if (!polygon_starts_ring(polygon, i)) {
      outline = outline + b.o * b.inv_o;
      corners = corners + Real(1.0);
      Real a_height = dot(front, a.p);
      Real b_height = dot(front, b.p);
      Mask a_seen = a_height >= Real(0.0);
      Mask b_seen = b_height >= Real(0.0);
      if (any_lane(a_seen || b_seen)) {
        Corner cut = corner_between(a, b, a_height, b_height, front, lobe);
        Corner from = select_corner(a_seen, a, cut);
        Corner to = select_corner(b_seen, b, cut);
        sums.diffuse = sums.diffuse + select(a_seen || b_seen, diffuse_term(from, to, s), none);
        sums.specular = sums.specular + select(a_seen || b_seen, specular_term(from, to, s), none);
        Mask crosses = a_seen != b_seen;
        if (any_lane(crosses)) {
          q = select_corner(crosses && !found, cut, q);
          found = found || crosses;
          Real leaves = select(crosses, select(a_seen, Real(1.0), Real(-1.0)), Real(0.0));
          sums.diffuse = sums.diffuse + diffuse_term(cut, q, s) * leaves;
          sums.specular = sums.specular + specular_term(cut, q, s) * leaves;
        }
      }
    }
    a = b;
  }
  sums.outline2 = mean_length2(outline, corners);
  return sums;
}

/// The point where an edge crosses the surface's horizon.
FN_INLINE Corner horizon_corner(Corner a, Corner b, Lobe lobe) {
  Real t = crossing_place(a.p.z, b.p.z);
  return corner_at(Vec3(a.p.x + (b.p.x - a.p.x) * t, a.p.y + (b.p.y - a.p.y) * t, Real(0.0)), lobe);
}

/// sum_edges for four corners, each above the surface's horizon in all lanes or below it in all: the
/// outline is clipped as scalar code would, once for both integrals, and closed by a whole edge. In
/// cosine space lanes differ: there each edge is clipped by itself, and the turns that close them
/// are multiplied, for a single angle in the end. They all lead the same way round, which h tells.
FN_INLINE EdgeSums sum_clipped_quad(Corner a, Corner b, Corner c, Corner d, Real s, Real h,
                                    Lobe lobe) {
  // Corners at even places, the cuts of the edges that leave them at odd ones, those in use by turns.
  Corner points[8];
  points[0] = a;
  points[2] = b;
  points[4] = c;
  points[6] = d;
  int outline[8];
  int count = 0;
  for (int i = 0; i < 8; i = i + 2) {
    int next = i < 6 ? i + 2 : 0;
    bool above = !any_lane(points[i].p.z < Real(0.0));
    if (above) {
      outline[count] = i;
      count = count + 1;
    }
    if (above != !any_lane(points[next].p.z < Real(0.0))) {
      points[i + 1] = horizon_corner(points[i], points[next], lobe);
      outline[count] = i + 1;
      count = count + 1;
    }
  }
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.outline2 = Real(0.0);
  EdgeAbove specular = no_edges();
  for (int k = 0; k < count; ++k) {
    int i = outline[k];
    int j = outline[k + 1 < count ? k + 1 : 0];
    sums.diffuse = sums.diffuse + whole_diffuse_term(points[i], points[j]);
    Real lower = min(points[i].o.z, points[j].o.z);
    Real upper = max(points[i].o.z, points[j].o.z);
    if (all_lanes(lower >= Real(0.0))) {
      specular.term = specular.term + whole_specular_term(points[i], points[j]);
    } else if (any_lane(upper >= Real(0.0))) {
      specular = join_edges(specular, specular_edge(points[i], points[j], s));
    }
  }
  sums.specular = close_outline(specular, h * lobe.det);
  return sums;
}

/// The same with all corners above the surface's horizon in all lanes: nothing is cut but in cosine space.
FN_INLINE EdgeSums sum_quad_above(Corner a, Corner b, Corner c, Corner d, Real s, Real h,
                                  Lobe lobe) {
  EdgeSums sums;
  sums.outline2 = Real(0.0);
  sums.diffuse = whole_diffuse_term(a, b) + whole_diffuse_term(b, c) + whole_diffuse_term(c, d) +
                 whole_diffuse_term(d, a);
  EdgeAbove to_c = join_edges(specular_edge(a, b, s), specular_edge(b, c, s));
  EdgeAbove to_a = join_edges(specular_edge(c, d, s), specular_edge(d, a, s));
  sums.specular = close_outline(join_edges(to_c, to_a), h * lobe.det);
  return sums;
}

/// sum_edges for four corners above both horizons: nothing is cut.
FN_INLINE EdgeSums sum_whole_quad(Corner a, Corner b, Corner c, Corner d) {
  EdgeSums sums;
  sums.outline2 =
      mean_length2(a.o * a.inv_o + b.o * b.inv_o + c.o * c.inv_o + d.o * d.inv_o, Real(4.0));
  sums.diffuse = whole_diffuse_term(a, b) + whole_diffuse_term(b, c) + whole_diffuse_term(c, d) +
                 whole_diffuse_term(d, a);
  sums.specular = whole_specular_term(a, b) + whole_specular_term(b, c) +
                  whole_specular_term(c, d) + whole_specular_term(d, a);
  return sums;
}

/// sum_edges for four corners, which are seen once each.
FN_INLINE EdgeSums sum_quad_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h) {
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  Corner b = corner_seen(polygon, 1, position, frame, lobe);
  Corner c = corner_seen(polygon, 2, position, frame, lobe);
  Corner d = corner_seen(polygon, 3, position, frame, lobe);
  Real lowest = min(min(least_height(a), least_height(b)), min(least_height(c), least_height(d)));
  // Uniform shortcut: no lane has anything to clip.
  if (all_lanes(lowest >= Real(0.0))) {
    return sum_whole_quad(a, b, c, d);
  }
  EdgeSums sums;
  Real outline2 =
      mean_length2(a.o * a.inv_o + b.o * b.inv_o + c.o * c.inv_o + d.o * d.inv_o, Real(4.0));
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  if (all_lanes(min(min(a.p.z, b.p.z), min(c.p.z, d.p.z)) >= Real(0.0))) {
    sums = sum_quad_above(a, b, c, d, s, h, lobe);
  } else if (lanes_agree(a.p.z < Real(0.0)) && lanes_agree(b.p.z < Real(0.0)) &&
             lanes_agree(c.p.z < Real(0.0)) && lanes_agree(d.p.z < Real(0.0))) {
    sums = sum_clipped_quad(a, b, c, d, s, h, lobe);
  } else {
    sums.diffuse = diffuse_term(a, b, s) + diffuse_term(b, c, s) + diffuse_term(c, d, s) +
                   diffuse_term(d, a, s);
    sums.specular = specular_term(a, b, s) + specular_term(b, c, s) + specular_term(c, d, s) +
                    specular_term(d, a, s);
  }
  sums.outline2 = outline2;
  return sums;
}
