// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons. Its sampling: polygon_points.glsl.
//
// Source: the edge sum of edge.glsl.
//
// The prelude of each target gives the polygon, the same for all lanes, in world space:
//   int  polygon_point_count(Polygon)            rings one after the other, each closed by
//                                                repeating its first point
//   Vec3 polygon_point(Polygon, int)             world space
//   bool polygon_starts_ring(Polygon, int)
//   Vec3 polygon_origin(Polygon)                 a point of its plane
//   Vec3 polygon_normal(Polygon)                 unit, to the emitting side
//   bool polygon_two_sided(Polygon)
//   Real polygon_area(Polygon)                   square metres
//   Vec3 polygon_centroid(Polygon), polygon_spread_u(Polygon), polygon_spread_v(Polygon),
//   Real polygon_radius(Polygon)                 see PolygonMoments; around the centroid

/// Side of the apex: the sign of y where the polygon's plane, at signed distance h along its
/// normal, meets the y axis.
FN Real apex_side(Real normal_y, Real h) {
  return select(normal_y * h < Real(0.0), Real(-1.0), Real(1.0));
}

struct EdgeSums {
  Vec3 diffuse;  // 2 pi times the vector irradiance of the clipped polygon in shading space
  Vec3 specular; // the same in cosine space
};

/// A corner of an outline as a point sees it.
struct Corner {
  Vec3 p;     // shading space
  Vec3 o;     // cosine space
  Real inv_p; // 1 / length
  Real inv_o;
};

FN Corner corner_seen(Polygon polygon, int i, Vec3 position, Frame frame, Lobe lobe) {
  Corner corner;
  corner.p = to_shading(frame, polygon_point(polygon, i) - position);
  corner.o = to_cosine(lobe, corner.p);
  corner.inv_p = inverse_length(corner.p);
  corner.inv_o = inverse_length(corner.o);
  return corner;
}

/// Height over the nearer of the two horizons, in units of its own space.
FN Real least_height(Corner corner) { return min(corner.p.z, corner.o.z); }

FN Vec3 diffuse_term(Corner a, Corner b, Real s) {
  return edge_term_above(a.p, b.p, s, a.inv_p, b.inv_p);
}

FN Vec3 specular_term(Corner a, Corner b, Real s) {
  return clipped_edge_term_scaled(a.o, b.o, a.p.z, b.p.z, s, a.inv_o, b.inv_o);
}

/// The same of an edge above both horizons.
FN Vec3 whole_diffuse_term(Corner a, Corner b) {
  return edge_term_scaled(a.p, b.p, b.p - a.p, a.inv_p, b.inv_p);
}

FN Vec3 whole_specular_term(Corner a, Corner b) {
  return edge_term_scaled(a.o, b.o, b.o - a.o, a.inv_o, b.inv_o);
}

/// The edge sums of a polygon at signed distance h along its normal. Positive z behind it, negative
/// in front: there an outline that is counter-clockwise about the normal runs clockwise about
/// directions from the surface.
FN EdgeSums sum_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h) {
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Corner b = corner_seen(polygon, i, position, frame, lobe);
    if (!polygon_starts_ring(polygon, i)) {
      sums.diffuse = sums.diffuse + diffuse_term(a, b, s);
      sums.specular = sums.specular + specular_term(a, b, s);
    }
    a = b;
  }
  return sums;
}

/// Where the edge from a to b crosses the plane with unit normal `front`; heights: of its ends over that.
FN Corner corner_between(Corner a, Corner b, Real a_height, Real b_height, Vec3 front, Lobe lobe) {
  Real t = abs(a_height) * reciprocal(max(abs(a_height) + abs(b_height), Real(k_tiny)));
  Corner cut;
  cut.p = a.p + (b.p - a.p) * t;
  // What rounding made of a crossing that is nearer than the ends would turn the plane, which may cut
  // right through a narrow lobe.
  cut.p = cut.p - front * dot(front, cut.p);
  cut.o = to_cosine(lobe, cut.p);
  cut.inv_p = inverse_length(cut.p);
  cut.inv_o = inverse_length(cut.o);
  return cut;
}

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
FN_CALL EdgeSums sum_edges_in_front(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h,
                                    Vec3 front) {
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  EdgeSums sums;
  sums.diffuse = none;
  sums.specular = none;
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  Corner q = a;
  Mask found = Real(1.0) < Real(0.0);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Corner b = corner_seen(polygon, i, position, frame, lobe);
    if (!polygon_starts_ring(polygon, i)) {
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
  return sums;
}

/// The point where an edge crosses the surface's horizon.
FN Corner horizon_corner(Corner a, Corner b, Lobe lobe) {
  Real t = abs(a.p.z) * reciprocal(max(abs(a.p.z) + abs(b.p.z), Real(k_tiny)));
  Corner cut;
  cut.p = Vec3(a.p.x + (b.p.x - a.p.x) * t, a.p.y + (b.p.y - a.p.y) * t, Real(0.0));
  cut.o = to_cosine(lobe, cut.p);
  cut.inv_p = inverse_length(cut.p);
  cut.inv_o = inverse_length(cut.o);
  return cut;
}

/// sum_edges for four corners, each above the surface's horizon in all lanes or below it in all: the
/// outline is clipped as scalar code would, once for both integrals, and closed by a whole edge. In
/// cosine space lanes differ: there each edge is clipped by itself, and the turns that close them
/// are multiplied, for a single angle in the end. They all lead the same way round, which h tells.
FN EdgeSums sum_clipped_quad(Corner a, Corner b, Corner c, Corner d, Real s, Real h, Lobe lobe) {
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
  sums.specular = sums.diffuse;
  Real turn_cos = Real(1.0);
  Real turn_sin = Real(0.0);
  bool turns = false;
  for (int k = 0; k < count; ++k) {
    int i = outline[k];
    int j = outline[k + 1 < count ? k + 1 : 0];
    sums.diffuse = sums.diffuse + whole_diffuse_term(points[i], points[j]);
    Real lower = min(points[i].o.z, points[j].o.z);
    Real upper = max(points[i].o.z, points[j].o.z);
    if (all_lanes(lower >= Real(0.0))) {
      sums.specular = sums.specular + whole_specular_term(points[i], points[j]);
    } else if (any_lane(upper >= Real(0.0))) {
      EdgeAbove edge = edge_above(points[i].o, points[j].o, s, points[i].inv_o, points[j].inv_o);
      sums.specular = sums.specular + edge.term;
      Real cosine = turn_cos * edge.turn_cos - turn_sin * edge.turn_sin;
      turn_sin = turn_cos * edge.turn_sin + turn_sin * edge.turn_cos;
      turn_cos = cosine;
      turns = true;
    }
  }
  if (turns) {
    Real angle = abs(angle_of_unit(turn_cos, turn_sin));
    sums.specular.z = sums.specular.z + select(h * lobe.det < Real(0.0), -angle, angle);
  }
  return sums;
}

/// sum_edges for four corners, which are seen once each.
FN EdgeSums sum_quad_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real h) {
  Corner a = corner_seen(polygon, 0, position, frame, lobe);
  Corner b = corner_seen(polygon, 1, position, frame, lobe);
  Corner c = corner_seen(polygon, 2, position, frame, lobe);
  Corner d = corner_seen(polygon, 3, position, frame, lobe);
  Real lowest = min(min(least_height(a), least_height(b)), min(least_height(c), least_height(d)));
  EdgeSums sums;
  // Uniform shortcut: no lane has anything to clip.
  if (all_lanes(lowest >= Real(0.0))) {
    sums.diffuse = whole_diffuse_term(a, b) + whole_diffuse_term(b, c) + whole_diffuse_term(c, d) +
                   whole_diffuse_term(d, a);
    sums.specular = whole_specular_term(a, b) + whole_specular_term(b, c) +
                    whole_specular_term(c, d) + whole_specular_term(d, a);
    return sums;
  }
  Real s = apex_side(dot(frame.t2, polygon_normal(polygon)), h);
  if (lanes_agree(a.p.z < Real(0.0)) && lanes_agree(b.p.z < Real(0.0)) &&
      lanes_agree(c.p.z < Real(0.0)) && lanes_agree(d.p.z < Real(0.0))) {
    sums = sum_clipped_quad(a, b, c, d, s, h, lobe);
  } else {
    sums.diffuse = diffuse_term(a, b, s) + diffuse_term(b, c, s) + diffuse_term(c, d, s) +
                   diffuse_term(d, a, s);
    sums.specular = specular_term(a, b, s) + specular_term(b, c, s) + specular_term(c, d, s) +
                    specular_term(d, a, s);
  }
  return sums;
}

/// A small polygon: where it is in shading space, and how far it spreads.
struct SmallPolygon {
  Vec3 center;
  Vec3 u;
  Vec3 v;
  Real area_height; // area times the distance from its plane
};

/// 2 pi times the vector irradiance of a part of a light around p: its density times its solid
/// angle (MATHS section 5). A solid angle area h / |p|^3 is det |p|^3 / |o|^3 times that in cosine
/// space, o = M^-1 p.
FN Vec3 small_part_term(Vec3 p, Real area_height, Lobe lobe) {
  Vec3 o = to_cosine(lobe, p);
  Real inv_o2 = Real(1.0) / max(dot(o, o), Real(k_tiny));
  return o * (Real(2.0) * area_height * inv_o2 * (lobe.det * inv_o2));
}

/// 2 pi times the vector irradiance of a polygon that is small against its distance and wholly above
/// both horizons: four parts, which have its area, centroid and second moments.
FN Vec3 sum_small_polygon(SmallPolygon small, Lobe lobe) {
  Real quarter = Real(0.25) * small.area_height;
  return small_part_term(small.center + small.u, quarter, lobe) +
         small_part_term(small.center - small.u, quarter, lobe) +
         small_part_term(small.center + small.v, quarter, lobe) +
         small_part_term(small.center - small.v, quarter, lobe);
}

/// Square of the angular radius below which the small form begins, 0.05.
CONSTANT k_small_radius2 = 0.0025;

/// How much of the edge sums a polygon wants, 0 to 1; the rest is its small form.
///
/// The edge terms of a small polygon nearly cancel, of which rounding makes 1e-7 over its angular
/// radius, and the coordinates' own rounding the same again. So from a twentieth downwards it is
/// handed over, without a step, to its small form, which is wrong by the fourth power of that radius.
FN Real polygon_exactness(Vec3 center, Real radius, Lobe lobe) {
  Vec3 o = to_cosine(lobe, center);
  Real reach2 = radius * radius * lobe_stretch2(lobe);
  Real o2 = max(dot(o, o), Real(k_tiny));
  // Uniform shortcut: no lane sees it small.
  if (all_lanes(reach2 >= Real(k_small_radius2) * o2)) {
    return Real(1.0);
  }
  Real reach = sqrt(reach2);
  Real inv_o = inversesqrt(o2);
  Real exact = min(max((reach * inv_o - Real(0.03)) * Real(50.0), Real(0.0)), Real(1.0));
  Mask above = center.z > radius && o.z > reach;
  return select(above, exact, Real(1.0));
}

/// Integrals over a polygon seen from `position` (world space), for Lambert and for `lobe`. Zero
/// behind a one-sided polygon and in the plane of any; whoever knows `position` less well than its
/// last digit asks has_side (surface.glsl) as well.
///
/// The edge sum of the polygon in cosine space is a vector, its vector irradiance. The z component
/// is the integral; the direction is the mean direction of the part of the polygon that counts,
/// and M carries it back to shading space. It tells which Fresnel reflectance that light meets.
FN LightIntegral integrate_polygon(Polygon polygon, Vec3 position, Frame frame, Lobe lobe) {
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real h = dot(to_origin, normal);
  Real side = select(h < Real(0.0), Real(-1.0), polygon_two_sided(polygon) ? Real(1.0) : Real(0.0));
  side = select(lies_in_plane(h, to_origin, Real(0.0)), Real(0.0), side);
  Vec3 to_center = polygon_centroid(polygon) - position;
  Real radius = polygon_radius(polygon);
  Vec3 center = to_center;
  Real exact_diffuse = Real(1.0);
  Real exact_specular = Real(1.0);
  // Uniform shortcut: what is not small in shading space is not in cosine space, where its radius
  // counts as much longer as the distance can become.
  if (!all_lanes(radius * radius >= Real(k_small_radius2) * dot(to_center, to_center))) {
    center = to_shading(frame, to_center);
    exact_diffuse = polygon_exactness(center, radius, cosine_lobe());
    exact_specular = polygon_exactness(center, radius, lobe);
  }

  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  // Uniform shortcuts: no lane is on a lit side, or wants one form or the other.
  Mask lit = side != Real(0.0);
  if (any_lane(lit && (exact_diffuse > Real(0.0) || exact_specular > Real(0.0)))) {
    // Five points, the first of them twice, are one ring.
    if (polygon_point_count(polygon) == 5) {
      sums = sum_quad_edges(polygon, position, frame, lobe, h);
    } else {
      sums = sum_edges(polygon, position, frame, lobe, h);
    }
    sums.diffuse = sums.diffuse * (side * exact_diffuse);
    sums.specular = sums.specular * (side * exact_specular);
  }
  if (any_lane(lit && (exact_diffuse < Real(1.0) || exact_specular < Real(1.0)))) {
    SmallPolygon small;
    small.center = center;
    small.u = to_shading(frame, polygon_spread_u(polygon));
    small.v = to_shading(frame, polygon_spread_v(polygon));
    small.area_height = polygon_area(polygon) * abs(h) * abs(side);
    Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
    sums.diffuse =
        sums.diffuse + select(exact_diffuse < Real(1.0),
                              sum_small_polygon(small, cosine_lobe()) * (Real(1.0) - exact_diffuse),
                              none);
    sums.specular =
        sums.specular + select(exact_specular < Real(1.0),
                               sum_small_polygon(small, lobe) * (Real(1.0) - exact_specular), none);
  }
  return light_integral(sums.diffuse, sums.specular, lobe);
}

/// The same over what is in front of the plane with unit normal `front` (shading space). A function of its
/// own, so that nearly all groups of points, which no triangle cuts, need not carry it along.
FN_CALL LightIntegral integrate_polygon_in_front(Polygon polygon, Vec3 position, Frame frame,
                                                 Lobe lobe, Vec3 front) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real h = dot(to_origin, polygon_normal(polygon));
  Real side = select(h < Real(0.0), Real(-1.0), polygon_two_sided(polygon) ? Real(1.0) : Real(0.0));
  side = select(lies_in_plane(h, to_origin, Real(0.0)), Real(0.0), side);
  SmallPolygon small;
  small.center = to_shading(frame, polygon_centroid(polygon) - position);
  small.u = to_shading(frame, polygon_spread_u(polygon));
  small.v = to_shading(frame, polygon_spread_v(polygon));
  small.area_height = polygon_area(polygon) * abs(h) * abs(side);
  // What the plane may cut is summed by its edges, however small.
  Real radius = polygon_radius(polygon);
  Mask in_front = dot(front, small.center) > radius;
  Real exact_diffuse =
      select(in_front, polygon_exactness(small.center, radius, cosine_lobe()), Real(1.0));
  Real exact_specular = select(in_front, polygon_exactness(small.center, radius, lobe), Real(1.0));
  EdgeSums sums = sum_edges_in_front(polygon, position, frame, lobe, h, front);
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 small_diffuse = sum_small_polygon(small, cosine_lobe()) * (Real(1.0) - exact_diffuse);
  Vec3 small_specular = sum_small_polygon(small, lobe) * (Real(1.0) - exact_specular);
  sums.diffuse = sums.diffuse * (side * exact_diffuse) +
                 select(exact_diffuse < Real(1.0), small_diffuse, none);
  sums.specular = sums.specular * (side * exact_specular) +
                  select(exact_specular < Real(1.0), small_specular, none);
  return light_integral(sums.diffuse, sums.specular, lobe);
}

FN_CALL Heights polygon_heights(Polygon polygon, Vec3 position, Vec3 normal) {
  Heights heights;
  heights.low = dot(normal, polygon_point(polygon, 0) - position);
  heights.high = heights.low;
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Real height = dot(normal, polygon_point(polygon, i) - position);
    heights.low = min(heights.low, height);
    heights.high = max(heights.high, height);
  }
  return heights;
}
