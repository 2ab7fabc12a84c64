// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a polygon, exact, clipped to both horizons.
//
// Source: the edge sum of edge.glsl.
//
// The prelude of each target gives the polygon, the same for all lanes, in world space:
//   int  polygon_point_count(Polygon)            rings one after the other, each closed by
//                                                repeating its first point
//   Vec3 polygon_point(Polygon, int)             world space
//   bool polygon_starts_ring(Polygon, int)
//   Vec2 polygon_point_in_plane(Polygon, int)    the same point in the plane's own frame
//   Vec3 polygon_origin(Polygon), polygon_axis_u(Polygon), polygon_axis_v(Polygon),
//   Vec3 polygon_normal(Polygon)                 that frame; unit normal to the emitting side
//   bool polygon_two_sided(Polygon)
//   bool polygon_convex(Polygon)                 one ring that no plane cuts more than twice
//   Real polygon_area(Polygon)                   square metres
//   Vec3 polygon_centroid(Polygon), polygon_spread_u(Polygon), polygon_spread_v(Polygon),
//   Real polygon_radius(Polygon)                 see light::PolygonMoments; around the centroid

/// Side of the apex: the sign of y where the polygon's plane, at signed distance h along its
/// normal, meets the y axis.
FN Real apex_side(Real normal_y, Real h) {
  return select(normal_y * h < Real(0.0), Real(-1.0), Real(1.0));
}

struct EdgeSums {
  Vec3 diffuse;  // 2 pi times the vector irradiance of the clipped polygon in shading space
  Vec3 specular; // the same in cosine space
};

/// The edge sums of a polygon, s being its apex_side. Positive z behind the polygon, negative in
/// front: there an outline that is counter-clockwise about the normal runs clockwise about
/// directions from the surface.
FN EdgeSums sum_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real s) {
  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  Vec3 a = Vec3(Real(0.0), Real(0.0), Real(1.0));
  Vec3 a_o = a;
  Real inv_a = Real(1.0);
  Real inv_a_o = Real(1.0);
  int count = polygon_point_count(polygon);
  for (int i = 0; i < count; ++i) {
    Vec3 b = to_shading(frame, polygon_point(polygon, i) - position);
    Vec3 b_o = to_cosine(lobe, b);
    Real inv_b = inversesqrt(max(dot(b, b), Real(k_least_length2)));
    Real inv_b_o = inversesqrt(max(dot(b_o, b_o), Real(k_least_length2)));
    if (!polygon_starts_ring(polygon, i)) {
      sums.diffuse = sums.diffuse + clipped_edge_term_scaled(a, b, a.z, b.z, s, inv_a, inv_b);
      sums.specular =
          sums.specular + clipped_edge_term_scaled(a_o, b_o, a.z, b.z, s, inv_a_o, inv_b_o);
    }
    a = b;
    a_o = b_o;
    inv_a = inv_b;
    inv_a_o = inv_b_o;
  }
  return sums;
}

/// Where the outline of a convex polygon leaves and enters through one horizon; the apex where it does
/// not, whose own arc is none.
struct HorizonCut {
  Vec3 leaves;
  Vec3 enters;
};

FN HorizonCut no_cut(Real s) {
  HorizonCut cut;
  cut.leaves = Vec3(Real(0.0), s, Real(0.0));
  cut.enters = cut.leaves;
  return cut;
}

/// Angle from a point of the plane with unit normal n, which holds the y axis, to the apex.
FN Real angle_to_apex(Vec3 p, Vec3 n, Real s) {
  Real x = p.x * n.z - p.z * n.x;
  Real inv_length = inversesqrt(max(x * x + p.y * p.y, Real(k_tiny)));
  x = x * inv_length;
  return s * x * theta_over_sin(s * p.y * inv_length, x * x);
}

/// Closes the outline along the horizon with unit normal n, by way of the apex: the arc from one point
/// to the other may be nearly half a turn, whose side rounding could not tell.
FN Vec3 closing_arcs_term(HorizonCut cut, Vec3 n, Real s) {
  return n * (angle_to_apex(cut.leaves, n, s) - angle_to_apex(cut.enters, n, s));
}

/// The sums of a convex polygon, and whether they hold: rounding may make a side along a horizon
/// cross it more than once.
struct ConvexSums {
  EdgeSums sums;
  Mask valid;
};

/// sum_edges for a convex polygon, which each horizon cuts once or not at all: the arcs that close it
/// are summed once for each horizon, not for every edge.
FN ConvexSums sum_convex_edges(Polygon polygon, Vec3 position, Frame frame, Lobe lobe, Real s) {
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  HorizonCut diffuse_cut = no_cut(s);
  HorizonCut surface_cut = diffuse_cut;
  HorizonCut cosine_cut = diffuse_cut;
  Real surface_leaves = Real(0.0);
  Real cosine_leaves = Real(0.0);
  EdgeSums sums;
  sums.diffuse = none;
  sums.specular = none;
  Vec3 first = to_shading(frame, polygon_point(polygon, 0) - position);
  Vec3 first_o = to_cosine(lobe, first);
  Real inv_first = inversesqrt(max(dot(first, first), Real(k_least_length2)));
  Real inv_first_o = inversesqrt(max(dot(first_o, first_o), Real(k_least_length2)));
  Vec3 a = first;
  Vec3 a_o = first_o;
  Real inv_a = inv_first;
  Real inv_a_o = inv_first_o;
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Vec3 b = first;
    Vec3 b_o = first_o;
    Real inv_b = inv_first;
    Real inv_b_o = inv_first_o;
    if (i + 1 < count) {
      b = to_shading(frame, polygon_point(polygon, i) - position);
      b_o = to_cosine(lobe, b);
      inv_b = inversesqrt(max(dot(b, b), Real(k_least_length2)));
      inv_b_o = inversesqrt(max(dot(b_o, b_o), Real(k_least_length2)));
    }
    Mask a_up = a.z >= Real(0.0);
    Mask b_up = b.z >= Real(0.0);
    // Uniform shortcuts: no lane's edge is below the surface, or every lane's is.
    if (all_lanes(a_up && b_up)) {
      sums.diffuse = sums.diffuse + edge_term_scaled(a, b, b - a, inv_a, inv_b);
    } else if (any_lane(a_up || b_up)) {
      Span span = span_above(a.z, b.z);
      Vec3 d = b - a;
      Vec3 p0 = a + d * span.t0;
      Vec3 p1 = a + d * span.t1;
      p0.z = max(p0.z, Real(0.0));
      p1.z = max(p1.z, Real(0.0));
      Mask enters = !a_up && b_up;
      Mask leaves = a_up && !b_up;
      diffuse_cut.enters = select(enters, p0, diffuse_cut.enters);
      diffuse_cut.leaves = select(leaves, p1, diffuse_cut.leaves);
      surface_leaves = surface_leaves + select(leaves, Real(1.0), Real(0.0));
      sums.diffuse =
          sums.diffuse + select(a_up || b_up, edge_term(p0, p1, d * (span.t1 - span.t0)), none);
    }
    Mask a_inside = a_up && a_o.z >= Real(0.0);
    Mask b_inside = b_up && b_o.z >= Real(0.0);
    if (all_lanes(a_inside && b_inside)) {
      sums.specular = sums.specular + edge_term_scaled(a_o, b_o, b_o - a_o, inv_a_o, inv_b_o);
    } else if (any_lane((a_up || b_up) && (a_o.z >= Real(0.0) || b_o.z >= Real(0.0)))) {
      ClippedEdge edge = clip_edge(a_o, b_o, a.z, b.z);
      Mask enters = !a_inside && !edge.outside;
      Mask leaves = !b_inside && !edge.outside;
      Mask on_surface = enters && edge.p0_on_surface;
      surface_cut.enters = select(on_surface, edge.p0, surface_cut.enters);
      cosine_cut.enters = select(enters && !on_surface, edge.p0, cosine_cut.enters);
      on_surface = leaves && edge.p1_on_surface;
      surface_cut.leaves = select(on_surface, edge.p1, surface_cut.leaves);
      cosine_cut.leaves = select(leaves && !on_surface, edge.p1, cosine_cut.leaves);
      sums.specular = sums.specular +
                      select(edge.outside, none,
                             edge_term(edge.p0, edge.p1, (b_o - a_o) * edge.extent));
    }
    cosine_leaves = cosine_leaves +
                    select(a_o.z >= Real(0.0) && b_o.z < Real(0.0), Real(1.0), Real(0.0));
    a = b;
    a_o = b_o;
    inv_a = inv_b;
    inv_a_o = inv_b_o;
  }
  Vec3 up = Vec3(Real(0.0), Real(0.0), Real(1.0));
  // Uniform shortcuts: no lane was cut.
  if (any_lane(surface_leaves > Real(0.0))) {
    sums.diffuse = sums.diffuse + closing_arcs_term(diffuse_cut, up, s);
    sums.specular =
        sums.specular + closing_arcs_term(surface_cut, horizon_normal_cosine(lobe), s);
  }
  if (any_lane(cosine_leaves > Real(0.0))) {
    sums.specular = sums.specular + closing_arcs_term(cosine_cut, up, s);
  }
  ConvexSums result;
  result.sums = sums;
  result.valid = surface_leaves <= Real(1.0) && cosine_leaves <= Real(1.0);
  return result;
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
  if (all_lanes(reach2 >= Real(0.0025) * o2)) {
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
  Vec3 center = to_shading(frame, polygon_centroid(polygon) - position);
  Real radius = polygon_radius(polygon);
  Real exact_diffuse = polygon_exactness(center, radius, cosine_lobe());
  Real exact_specular = polygon_exactness(center, radius, lobe);

  EdgeSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.specular = sums.diffuse;
  // Uniform shortcuts: no lane wants one form or the other.
  if (any_lane(exact_diffuse > Real(0.0) || exact_specular > Real(0.0))) {
    Real s = apex_side(dot(frame.t2, normal), h);
    bool done = false;
    if (polygon_convex(polygon)) {
      ConvexSums convex = sum_convex_edges(polygon, position, frame, lobe, s);
      sums = convex.sums;
      done = all_lanes(convex.valid);
    }
    if (!done) {
      sums = sum_edges(polygon, position, frame, lobe, s);
    }
    sums.diffuse = sums.diffuse * (side * exact_diffuse);
    sums.specular = sums.specular * (side * exact_specular);
  }
  if (any_lane(exact_diffuse < Real(1.0) || exact_specular < Real(1.0))) {
    SmallPolygon small;
    small.center = center;
    small.u = to_shading(frame, polygon_spread_u(polygon));
    small.v = to_shading(frame, polygon_spread_v(polygon));
    small.area_height = polygon_area(polygon) * abs(h) * abs(side);
    Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
    sums.diffuse = sums.diffuse + select(exact_diffuse < Real(1.0),
                                         sum_small_polygon(small, cosine_lobe()) *
                                             (Real(1.0) - exact_diffuse),
                                         none);
    sums.specular =
        sums.specular + select(exact_specular < Real(1.0),
                               sum_small_polygon(small, lobe) * (Real(1.0) - exact_specular), none);
  }
  return light_integral(sums.diffuse, sums.specular, lobe);
}

/// Where a ray from `position` along the unit `direction` meets the polygon: the plane first, then
/// the parity of the outline's crossings with a line through the point. The density is that of
/// sampling its area evenly.
FN LightPoint intersect_polygon(Polygon polygon, Vec3 position, Vec3 direction) {
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real slope = dot(direction, normal);
  Real t = dot(to_origin, normal) / (slope + select(slope == Real(0.0), Real(1.0), Real(0.0)));
  Vec3 on_plane = direction * t - to_origin;
  Real x = dot(on_plane, polygon_axis_u(polygon));
  Real y = dot(on_plane, polygon_axis_v(polygon));

  Mask inside = Real(1.0) < Real(0.0);
  Vec2 a = Vec2(Real(0.0), Real(0.0));
  int count = polygon_point_count(polygon);
  for (int i = 0; i < count; ++i) {
    Vec2 b = polygon_point_in_plane(polygon, i);
    if (!polygon_starts_ring(polygon, i)) {
      Mask straddles = (a.y > y) != (b.y > y);
      Real rise = b.y - a.y + select(a.y == b.y, Real(1.0), Real(0.0));
      Mask crosses = straddles && x < a.x + (y - a.y) * (b.x - a.x) / rise;
      inside = inside != crosses;
    }
    a = b;
  }

  Mask faces = slope < Real(0.0);
  if (polygon_two_sided(polygon)) {
    faces = slope != Real(0.0);
  }
  Mask in_plane = lies_in_plane(dot(to_origin, normal), to_origin, Real(0.0));
  LightPoint result;
  result.hit = inside && faces && t > Real(0.0) && !in_plane;
  result.direction = direction;
  result.distance = max(t, Real(0.0));
  result.cos_light = abs(slope);
  result.solid_angle = solid_angle_of_area(polygon_area(polygon), result.cos_light, t * t);
  return result;
}

/// Where a unit direction that leads to the polygon meets it; the density is 1 / solid_angle.
FN LightPoint polygon_point_towards(Polygon polygon, Vec3 position, Vec3 direction,
                                    Real solid_angle) {
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - position;
  Real h = dot(to_origin, normal);
  Real slope = dot(direction, normal);
  Mask faces = slope < Real(0.0);
  if (polygon_two_sided(polygon)) {
    faces = slope != Real(0.0);
  }
  LightPoint result;
  result.direction = direction;
  result.distance = h / (slope + select(slope == Real(0.0), Real(1.0), Real(0.0)));
  result.cos_light = abs(slope);
  result.solid_angle = solid_angle;
  result.hit = faces && result.distance > Real(0.0) && result.cos_light > Real(1.0e-6) &&
               !lies_in_plane(h, to_origin, Real(0.0));
  return result;
}

/// The point of the polygon that `point` (world space, evenly distributed over its area) is.
FN LightPoint polygon_point_at(Polygon polygon, Vec3 position, Vec3 point) {
  Vec3 to_origin = polygon_origin(polygon) - position;
  Vec3 normal = polygon_normal(polygon);
  Mask in_plane = lies_in_plane(dot(to_origin, normal), to_origin, Real(0.0));
  return area_light_point(point - position, normal, polygon_area(polygon),
                          polygon_two_sided(polygon) ? Real(1.0) : Real(0.0), in_plane);
}
