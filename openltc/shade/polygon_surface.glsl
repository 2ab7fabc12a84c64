// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polygon as a surface sees it, less what the surface's triangle hides: by the fitted lobe (polygon.glsl), or by
// GGX itself, along the same edges (exact/half_vector.glsl).

/// The sums over a polygon's edges.
struct ExactPolygonSums {
  Vec3 diffuse;        ///< see EdgeSums
  ContourSums contour; ///< above the horizon
};

/// The edge from a to b, shading space, added to both; inv_a, inv_b: 1 / their lengths.
FN ExactPolygonSums add_both_edges(GIVEN(ExactView) view, ExactPolygonSums sums, Vec3 a, Vec3 b,
                                   Real inv_a, Real inv_b, Real apex, Real sign) {
  sums.diffuse = sums.diffuse + edge_term_above(a, b, apex, inv_a, inv_b) * sign;
  sums.contour = add_edge(view, sums.contour, a * inv_a, b * inv_b, sign);
  return sums;
}

/// Over the edges of a polygon at signed distance h along its normal.
FN_CALL ExactPolygonSums sum_exact_edges(Polygon polygon, GIVEN(Surface) s, GIVEN(ExactView) view,
                                         Real h) {
  Real apex = apex_side(dot(s.frame.t2, polygon_normal(polygon)), h);
  ExactPolygonSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.contour = no_contour();
  Vec3 a = to_shading(s.frame, polygon_point(polygon, 0) - s.position);
  Real inv_a = inverse_length(a);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Vec3 b = to_shading(s.frame, polygon_point(polygon, i) - s.position);
    Real inv_b = inverse_length(b);
    if (!polygon_starts_ring(polygon, i)) {
      sums = add_both_edges(view, sums, a, b, inv_a, inv_b, apex, Real(1.0));
    }
    a = b;
    inv_a = inv_b;
  }
  return sums;
}

/// sum_exact_edges of the polygon's part in front of the plane with unit normal `front` (shading space): see
/// sum_edges_in_front.
FN_CALL ExactPolygonSums sum_exact_edges_in_front(Polygon polygon, GIVEN(Surface) s,
                                                  GIVEN(ExactView) view, Real h, Vec3 front) {
  Real apex = apex_side(dot(s.frame.t2, polygon_normal(polygon)), h);
  ExactPolygonSums sums;
  sums.diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.contour = no_contour();
  Vec3 a = to_shading(s.frame, polygon_point(polygon, 0) - s.position);
  Vec3 q = a;
  Mask found = Real(1.0) < Real(0.0);
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Vec3 b = to_shading(s.frame, polygon_point(polygon, i) - s.position);
    if (!polygon_starts_ring(polygon, i)) {
      Real a_height = dot(front, a);
      Real b_height = dot(front, b);
      Mask a_seen = a_height >= Real(0.0);
      Mask b_seen = b_height >= Real(0.0);
      if (any_lane(a_seen || b_seen)) {
        Vec3 at = a + (b - a) * crossing_place(a_height, b_height);
        at = at - front * dot(front, at);
        Vec3 from = select(a_seen, a, at);
        Vec3 to = select(b_seen, b, at);
        Real seen = select(a_seen || b_seen, Real(1.0), Real(0.0));
        sums = add_both_edges(view, sums, from, to, inverse_length(from), inverse_length(to), apex,
                              seen);
        Mask crosses = a_seen != b_seen;
        if (any_lane(crosses)) {
          q = select(crosses && !found, at, q);
          found = found || crosses;
          Real leaves = select(crosses, select(a_seen, Real(1.0), Real(-1.0)), Real(0.0));
          sums = add_both_edges(view, sums, at, q, inverse_length(at), inverse_length(q), apex,
                                leaves);
        }
      }
    }
    a = b;
  }
  return sums;
}

/// Whether a polygon is nine points, not four: what lobes give nearly as well is not worth nine.
FN bool takes_nine_points(GIVEN(Surface) s, Polygon polygon) {
  return !s.adaptive && polygon_is_parallelogram(polygon);
}

/// GGX itself over a polygon, by a few points of it; diffuse: see EdgeSums.
FN ExactIntegral polygon_by_points(GIVEN(Surface) s, Polygon polygon, Vec3 center, Vec3 diffuse) {
  Real alpha2 = s.alpha * s.alpha;
  Real root2 = s.wo.z * s.wo.z * (Real(1.0) - alpha2) + alpha2;
  Real root_o = root2 * inversesqrt(root2);
  FewPoints sums;
  if (takes_nine_points(s, polygon)) {
    sums = sum_nine_points(s, root_o, center, to_shading(s.frame, polygon_half_u(polygon)),
                           to_shading(s.frame, polygon_half_v(polygon)));
  } else {
    sums = sum_four_points(s, root_o, center, to_shading(s.frame, polygon_spread_u(polygon)),
                           to_shading(s.frame, polygon_spread_v(polygon)));
  }
  return integral_of_points(s, sums, Real(0.5) * diffuse.z);
}

/// The integral over a polygon as a surface sees it, its specular part that of GGX itself for F = 1; points: how much
/// of it is a few points, see share_of_points.
FN_CALL LightIntegral exact_polygon_integral(GIVEN(Surface) s, Polygon polygon, Real points) {
  Vec3 normal = polygon_normal(polygon);
  PolygonSight sight = see_polygon(polygon, s.position);
  Vec3 center = to_shading(s.frame, sight.to_center);
  Heights over = polygon_heights(polygon, s.position, s.frame.n);
  bool cut = triangle_may_cut(s, polygon);
  Vec3 front = front_shading(s);
  SmallShare small = no_small_share();
  // Uniform shortcut.
  if (!sight.large) {
    small = small_share(small_polygon(polygon, sight, center, s.frame), cosine_lobe(), cut, front);
  }

  // All crossings of the horizon are within a right angle of the foot of the polygon's plane there.
  Vec3 foot = to_shading(s.frame, normal) * sight.h;
  Real reach = sqrt(dot(center, center)) + sight.radius;
  ExactView view =
      exact_view(s.wo, s.alpha, select(over.low <= Real(k_in_horizon) * reach, foot, center));
  Vec3 diffuse = small.sum;
  ExactIntegral specular;
  specular.light = Real(0.0);
  specular.bias = Real(0.0);
  specular.direction = safe_direction(center);
  Mask lit = sight.side != Real(0.0) && over.high > Real(0.0);
  if (any_lane(lit)) {
    ExactPolygonSums sums;
    if (cut) {
      sums = sum_exact_edges_in_front(polygon, s, view, sight.h, front);
    } else {
      sums = sum_exact_edges(polygon, s, view, sight.h);
    }
    diffuse = diffuse + sums.diffuse * (sight.side * small.by_edges);
    specular = exact_integral(view, sums.contour, sight.side);
  }
  if (any_lane(lit && points > Real(0.0))) {
    ExactIntegral few = polygon_by_points(s, polygon, center, diffuse);
    specular = mix_points_in(specular, few, points);
  }

  specular.light = select(lit, specular.light, Real(0.0));
  LightIntegral integral = exact_light_integral(s, diffuse, specular);
  if (cut) {
    integral = unless_hidden(s, polygon_heights(polygon, s.position, s.geometric), integral);
  }
  return unless_in_plane(s, polygon_origin(polygon), normal, integral);
}

/// The integral where no triangle's plane cuts the polygon.
FN LightIntegral whole_polygon_integral(GIVEN(Surface) s, Polygon polygon) {
  LightIntegral integral;
  if (s.two) {
    TwoIntegrals both =
        integrate_polygon_twice(polygon, s.position, s.frame, s.fitted.lobe, s.second);
    integral = with_second_lobe(s, both.first, both.second);
  } else {
    integral = integrate_polygon(polygon, s.position, s.frame, s.fitted.lobe);
  }
  return unless_in_plane(s, polygon_origin(polygon), polygon_normal(polygon), integral);
}

/// The integral where triangle_may_cut, which most groups need not carry along.
FN LightIntegral cut_polygon_integral(GIVEN(Surface) s, Polygon polygon) {
  Heights heights = polygon_heights(polygon, s.position, s.geometric);
  if (all_lanes(heights.low >= Real(0.0))) {
    return whole_polygon_integral(s, polygon);
  }
  LightIntegral integral =
      integrate_polygon_in_front(polygon, s.position, s.frame, s.fitted.lobe, front_shading(s));
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_polygon_in_front(polygon, s.position, s.frame, s.second, front_shading(s)));
  }
  integral = unless_hidden(s, heights, integral);
  return unless_in_plane(s, polygon_origin(polygon), polygon_normal(polygon), integral);
}

/// Both in one lane, which passes over what it does not need.
FN LightIntegral polygon_integral_in_one_lane(GIVEN(Surface) s, Polygon polygon) {
  Vec3 front = front_shading(s);
  LightIntegral integral =
      integrate_polygon_part(polygon, s.position, s.frame, s.fitted.lobe, s.tilted, front);
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_polygon_part(polygon, s.position, s.frame, s.second, s.tilted, front));
  }
  if (s.tilted) {
    integral = unless_hidden(s, polygon_heights(polygon, s.position, s.geometric), integral);
  }
  return unless_in_plane(s, polygon_origin(polygon), polygon_normal(polygon), integral);
}

/// The integral by the lobes. Uniform shortcut: no lane's triangle reaches the light.
FN_INLINE LightIntegral lobes_polygon_integral(GIVEN(Surface) s, Polygon polygon) {
  if (one_lane()) {
    return polygon_integral_in_one_lane(s, polygon);
  }
  if (triangle_may_cut(s, polygon)) {
    return cut_polygon_integral(s, polygon);
  }
  return whole_polygon_integral(s, polygon);
}

/// Lambert's sum over the edges of a polygon above the horizon: see EdgeSums.
FN Vec3 sum_whole_diffuse(Polygon polygon, Vec3 position, Frame frame) {
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 a = to_shading(frame, polygon_point(polygon, 0) - position);
  Real inv_a = inverse_length(a);
  if (polygon_point_count(polygon) == k_quad_points) {
    Vec3 b = to_shading(frame, polygon_point(polygon, 1) - position);
    Vec3 c = to_shading(frame, polygon_point(polygon, 2) - position);
    Vec3 d = to_shading(frame, polygon_point(polygon, 3) - position);
    Real inv_b = inverse_length(b);
    Real inv_c = inverse_length(c);
    Real inv_d = inverse_length(d);
    return edge_term_scaled(a, b, b - a, inv_a, inv_b) +
           edge_term_scaled(b, c, c - b, inv_b, inv_c) +
           edge_term_scaled(c, d, d - c, inv_c, inv_d) +
           edge_term_scaled(d, a, a - d, inv_d, inv_a);
  }
  int count = polygon_point_count(polygon);
  for (int i = 1; i < count; ++i) {
    Vec3 b = to_shading(frame, polygon_point(polygon, i) - position);
    Real inv_b = inverse_length(b);
    if (!polygon_starts_ring(polygon, i)) {
      sum = sum + edge_term_scaled(a, b, b - a, inv_a, inv_b);
    }
    a = b;
    inv_a = inv_b;
  }
  return sum;
}

/// The integral over a polygon above the horizon, its specular part that of GGX itself at a few points.
FN LightIntegral polygon_integral_by_points(GIVEN(Surface) s, Polygon polygon) {
  PolygonSight sight = see_polygon(polygon, s.position);
  Vec3 center = to_shading(s.frame, sight.to_center);
  Vec3 diffuse = sum_whole_diffuse(polygon, s.position, s.frame) * sight.side;
  // Uniform shortcut.
  if (!sight.large) {
    SmallShare small = small_share(small_polygon(polygon, sight, center, s.frame), cosine_lobe(),
                                   false, s.frame.n);
    diffuse = diffuse * small.by_edges + small.sum;
  }
  ExactIntegral specular = polygon_by_points(s, polygon, center, diffuse);
  LightIntegral integral = exact_light_integral(s, diffuse, specular);
  return unless_in_plane(s, polygon_origin(polygon), polygon_normal(polygon), integral);
}

/// How much of a polygon is what, 0..1; the rest is lobes times their ratio.
struct PolygonWays {
  Real points; ///< GGX itself at a few points
  Real exact;  ///< GGX itself along the outline, where `points` does not say more
};

/// Of a surface that is exact.
FN PolygonWays ways_of_polygon(GIVEN(Surface) s, Polygon polygon) {
  Vec3 center = to_shading(s.frame, polygon_centroid(polygon) - s.position);
  Real radius = polygon_radius(polygon);
  PolygonWays ways;
  ways.points = share_of_points(s, center, radius, takes_nine_points(s, polygon));
  // What the triangle's plane may cut is no points, without a step.
  if (s.tilted) {
    Real before = dot(front_shading(s), center) * reciprocal(max(radius, Real(k_tiny))) - Real(1.0);
    ways.points = min(ways.points, max(before, Real(0.0)));
  }
  ways.exact = Real(1.0) - ways.points;
  if (s.adaptive) {
    ways.exact = min(exact_amount(s, center, radius), ways.exact);
  }
  return ways;
}

/// Whether some lane wants GGX itself of a polygon.
FN bool wants_exact(PolygonWays ways) {
  return any_lane(ways.points > Real(0.0) || ways.exact > Real(0.0));
}

/// The integral over a polygon as an exact surface wants it, where some lane does.
FN LightIntegral wanted_polygon_integral(GIVEN(Surface) s, Polygon polygon, PolygonWays ways) {
  LightIntegral ggx;
  if (any_lane(ways.exact > Real(0.0))) {
    Real all = ways.points + ways.exact;
    ggx = exact_polygon_integral(s, polygon, ways.points * reciprocal(max(all, Real(k_tiny))));
  } else {
    ggx = polygon_integral_by_points(s, polygon);
  }
  // Uniform shortcut: no lane has lobes.
  Real amount = ways.points + ways.exact;
  if (all_lanes(amount >= Real(1.0))) {
    return ggx;
  }
  return blend_exact(s, lobes_polygon_integral(s, polygon), ggx, amount);
}

/// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
/// without a side of the polygon.
FN LightIntegral surface_polygon_integral(GIVEN(Surface) s, Polygon polygon) {
  LightIntegral integral;
  if (s.exact) {
    PolygonWays ways = ways_of_polygon(s, polygon);
    if (wants_exact(ways)) {
      return wanted_polygon_integral(s, polygon, ways);
    }
    integral = lobes_polygon_integral(s, polygon);
    integral.weight = Real(-1.0);
    return integral;
  }
  return lobes_polygon_integral(s, polygon);
}

/// Light that a surface reflects of a polygon of radiance 1, without shadow.
FN ShadedLight shade_polygon_parts(GIVEN(Surface) s, Polygon polygon) {
  return shade_integral(s, surface_polygon_integral(s, polygon));
}

/// Light of a polygon that is a few points in all lanes.
FN Vec3 shade_polygon_by_points(GIVEN(Surface) s, Polygon polygon) {
  LightIntegral integral = polygon_integral_by_points(s, polygon);
  return s.diffuse * integral.diffuse +
         exact_reflectance(s, integral.weight, exact_light(s, integral));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
/// Not by way of shade_polygon_parts, nor of what it asks: where a compiler does not inline
/// these, each copies the surface, 3 % of a quad's instructions.
FN Vec3 shade_polygon(GIVEN(Surface) s, Polygon polygon) {
  if (s.exact) {
    PolygonWays ways = ways_of_polygon(s, polygon);
    if (all_lanes(ways.points >= Real(1.0))) {
      return shade_polygon_by_points(s, polygon);
    }
    if (wants_exact(ways)) {
      return both_parts(shade_integral(s, wanted_polygon_integral(s, polygon, ways)));
    }
  }
  Surface by_lobes = without_exact(s);
  if (one_lane()) {
    return both_parts(shade_integral(by_lobes, polygon_integral_in_one_lane(by_lobes, polygon)));
  }
  if (triangle_may_cut(by_lobes, polygon)) {
    return both_parts(shade_integral(by_lobes, cut_polygon_integral(by_lobes, polygon)));
  }
  return both_parts(shade_integral(by_lobes, whole_polygon_integral(by_lobes, polygon)));
}
