// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The sum over a polygon's edges as one lane does it by itself, as in a shader: an edge is cut by one plane after
// the other, and what nothing is left of is passed over by a branch. Code that is short and holds little at a time
// is what counts there, so each edge begins anew with its two ends.
//
// Where an outline crosses a plane, what is left of it goes on in the plane. All its crossings lie on the straight
// line in which the polygon's own plane meets this one, which a point that has a side of the polygon sees as less than
// half a turn: so edges between each crossing and the first telescope, and outlines may be concave, or have holes. Such
// an edge is then cut by the next plane like any other. Lanes, which all walk the same way, close at an apex instead,
// a sum without a memory (edge.glsl).

/// What is summed along an outline, and where it first crossed each plane.
struct OutlineSums {
  Vec3 diffuse;     ///< 2 pi times the vector irradiance, shading space
  Vec3 specular;    ///< the same in cosine space
  Vec3 front;       ///< the first crossing of the triangle's plane, shading space
  Vec3 horizon;     ///< of the surface's horizon, shading space
  Vec3 cosine;      ///< and of the cosine's horizon, unit, cosine space
  bool has_front;   ///< whether there was any
  bool has_horizon; ///< whether there was any
  bool has_cosine;  ///< whether there was any
};

/// No edges yet.
FN OutlineSums no_outline() {
  OutlineSums outline;
  outline.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  outline.specular = outline.diffuse;
  outline.front = outline.diffuse;
  outline.horizon = outline.diffuse;
  outline.cosine = outline.diffuse;
  outline.has_front = false;
  outline.has_horizon = false;
  outline.has_cosine = false;
  return outline;
}

/// The edge from a to b (cosine space), above the surface's horizon, cut by the cosine's, for the specular sum.
FN OutlineSums add_to_specular(OutlineSums outline, Vec3 a, Vec3 b) {
  OutlineSums next = outline;
  bool a_up = any_lane(a.z >= Real(0.0));
  bool b_up = any_lane(b.z >= Real(0.0));
  if (a_up || b_up) {
    Vec3 from = a;
    Vec3 to = b;
    Vec3 along = b - a;
    if (a_up != b_up) {
      Real t = crossing_place(a.z, b.z);
      Vec3 cut = Vec3(a.x + along.x * t, a.y + along.y * t, Real(0.0));
      Vec3 unit = cut * inverse_length(cut);
      Real leaves = Real(1.0);
      if (a_up) {
        to = cut;
        along = along * t;
      } else {
        from = cut;
        along = along * (Real(1.0) - t);
        leaves = Real(-1.0);
      }
      if (outline.has_cosine) {
        Real angle = angle_of_unit(dot(unit, outline.cosine),
                                   unit.x * outline.cosine.y - unit.y * outline.cosine.x);
        next.specular.z = next.specular.z + angle * leaves;
      } else {
        next.cosine = unit;
        next.has_cosine = true;
      }
    }
    next.specular = next.specular + edge_term(from, to, along);
  }
  return next;
}

/// The edge from a to b (shading space), cut by both horizons, for both sums.
FN OutlineSums add_to_outline(OutlineSums outline, Vec3 a, Vec3 b, Lobe lobe) {
  OutlineSums next = outline;
  bool a_up = any_lane(a.z >= Real(0.0));
  bool b_up = any_lane(b.z >= Real(0.0));
  Vec3 from = a;
  Vec3 to = b;
  int parts = a_up || b_up ? 1 : 0;
  if (a_up != b_up) {
    Real t = crossing_place(a.z, b.z);
    Vec3 cut = Vec3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, Real(0.0));
    if (a_up) {
      to = cut;
    } else {
      from = cut;
    }
    if (outline.has_horizon) {
      parts = 2;
    } else {
      next.horizon = cut;
      next.has_horizon = true;
    }
  }
  for (int i = 0; i < parts; ++i) {
    next.diffuse = next.diffuse + edge_term(from, to, to - from);
    next = add_to_specular(next, to_cosine(lobe, from), to_cosine(lobe, to));
    // What joins the crossing to the first.
    if (a_up) {
      from = to;
      to = outline.horizon;
    } else {
      to = from;
      from = outline.horizon;
    }
  }
  return next;
}

/// The same, with `cut` cut before all else by the plane of the triangle, whose unit normal in shading space is
/// `front`.
FN OutlineSums add_in_front(OutlineSums outline, Vec3 a, Vec3 b, Lobe lobe, bool cut, Vec3 front) {
  OutlineSums next = outline;
  Vec3 from = a;
  Vec3 to = b;
  Vec3 next_from = a;
  Vec3 next_to = a;
  int parts = 1;
  if (cut) {
    Real a_height = dot(front, a);
    Real b_height = dot(front, b);
    bool a_seen = any_lane(a_height >= Real(0.0));
    bool b_seen = any_lane(b_height >= Real(0.0));
    parts = a_seen || b_seen ? 1 : 0;
    if (a_seen != b_seen) {
      Vec3 crossing = a + (b - a) * crossing_place(a_height, b_height);
      // See corner_between.
      crossing = crossing - front * dot(front, crossing);
      if (a_seen) {
        to = crossing;
        next_from = crossing;
        next_to = outline.front;
      } else {
        from = crossing;
        next_from = outline.front;
        next_to = crossing;
      }
      if (outline.has_front) {
        parts = 2;
      } else {
        next.front = crossing;
        next.has_front = true;
      }
    }
  }
  for (int i = 0; i < parts; ++i) {
    next = add_to_outline(next, from, to, lobe);
    // What joins the crossing to the first.
    from = next_from;
    to = next_to;
  }
  return next;
}

/// sum_edges in one lane, and with `cut` of what is in front of the plane with unit normal `front`, shading space.
FN EdgeSums sum_edges_in_one_lane(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, bool cut,
                                  Vec3 front) {
  OutlineSums outline = no_outline();
  Vec3 corners = outline.diffuse;
  Real corner_count = Real(0.0);
  Vec3 a = to_shading(frame, polygon_point(polygon, 0) - position);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Vec3 b = to_shading(frame, polygon_point(polygon, i) - position);
    if (!polygon_starts_ring(polygon, i)) {
      Vec3 o = to_cosine(lobe, b);
      corners = corners + o * inverse_length(o);
      corner_count = corner_count + Real(1.0);
      outline = add_in_front(outline, a, b, lobe, cut, front);
    }
    a = b;
  }
  EdgeSums sums;
  sums.diffuse = outline.diffuse;
  sums.specular = outline.specular;
  sums.outline2 = mean_length2(corners, corner_count);
  return sums;
}
