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
FN ExactPolygonSums add_both_edges(ExactView view, ExactPolygonSums sums, Vec3 a, Vec3 b,
                                   Real inv_a, Real inv_b, Real apex, Real sign) {
  sums.diffuse = sums.diffuse + edge_term_above(a, b, apex, inv_a, inv_b) * sign;
  sums.contour = add_edge(view, sums.contour, a * inv_a, b * inv_b, sign);
  return sums;
}

/// Over the edges of a polygon at signed distance h along its normal.
FN_CALL ExactPolygonSums sum_exact_edges(Polygon polygon, Surface s, ExactView view, Real h) {
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
FN_CALL ExactPolygonSums sum_exact_edges_in_front(Polygon polygon, Surface s, ExactView view,
                                                  Real h, Vec3 front) {
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

/// Adds a part of a small polygon around p.
FN ExactNodes add_exact_part(Surface s, ExactNodes nodes, Vec3 p, Real area_height) {
  Real inv_p = inverse_length(p);
  return add_exact_node(s, nodes, p * inv_p, (area_height * inv_p) * (inv_p * inv_p));
}

/// The integral over a polygon as a surface sees it, its specular part that of GGX itself for F = 1.
FN_CALL LightIntegral exact_polygon_integral(Surface s, Polygon polygon) {
  Vec3 normal = polygon_normal(polygon);
  Vec3 to_origin = polygon_origin(polygon) - s.position;
  Real h = dot(to_origin, normal);
  Real side = lit_side(polygon, h, to_origin);
  Vec3 center = to_shading(s.frame, polygon_centroid(polygon) - s.position);
  Real radius = polygon_radius(polygon);
  Heights over = polygon_heights(polygon, s.position, s.frame.n);
  bool cut = triangle_may_cut(s, polygon);
  Vec3 front = front_shading(s);
  Real exact_diffuse = polygon_exactness(center, radius, cosine_lobe());
  Real exact_specular = outline_exactness(s, center, radius);
  if (cut) {
    Mask in_front = dot(front, center) > radius;
    exact_diffuse = select(in_front, exact_diffuse, Real(1.0));
    exact_specular = select(in_front, exact_specular, Real(1.0));
  }

  // All crossings of the horizon are within a right angle of the foot of the polygon's plane there.
  Vec3 foot = to_shading(s.frame, normal) * h;
  Real reach = sqrt(dot(center, center)) + radius;
  ExactView view =
      exact_view(s.wo, s.alpha, select(over.low <= Real(k_in_horizon) * reach, foot, center));
  Vec3 diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  ExactIntegral specular;
  specular.light = Real(0.0);
  specular.bias = Real(0.0);
  specular.direction = safe_direction(center);
  Mask lit = side != Real(0.0) && over.high > Real(0.0);
  if (any_lane(lit && (exact_diffuse > Real(0.0) || exact_specular > Real(0.0)))) {
    ExactPolygonSums sums;
    if (cut) {
      sums = sum_exact_edges_in_front(polygon, s, view, h, front);
    } else {
      sums = sum_exact_edges(polygon, s, view, h);
    }
    diffuse = sums.diffuse * (side * exact_diffuse);
    specular = exact_integral(view, sums.contour, side);
  }
  if (any_lane(lit && (exact_diffuse < Real(1.0) || exact_specular < Real(1.0)))) {
    SmallPolygon small;
    small.center = center;
    small.u = to_shading(s.frame, polygon_spread_u(polygon));
    small.v = to_shading(s.frame, polygon_spread_v(polygon));
    small.area_height = polygon_area(polygon) * abs(h) * abs(side);
    Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
    diffuse = diffuse +
              select(exact_diffuse < Real(1.0),
                     sum_small_polygon(small, cosine_lobe()) * (Real(1.0) - exact_diffuse), none);
    Real quarter = Real(0.25) * small.area_height;
    ExactNodes parts = no_exact_nodes();
    parts = add_exact_part(s, parts, center + small.u, quarter);
    parts = add_exact_part(s, parts, center - small.u, quarter);
    parts = add_exact_part(s, parts, center + small.v, quarter);
    parts = add_exact_part(s, parts, center - small.v, quarter);
    specular = mix_exact(s, specular, parts, exact_specular);
  }

  specular.light = select(lit, specular.light, Real(0.0));
  LightIntegral integral = exact_light_integral(s, diffuse, specular);
  if (cut) {
    integral = unless_hidden(s, polygon_heights(polygon, s.position, s.geometric), integral);
  }
  return unless_in_plane(s, polygon_origin(polygon), normal, integral);
}

/// The integral where no triangle's plane cuts the polygon.
FN LightIntegral whole_polygon_integral(Surface s, Polygon polygon) {
  LightIntegral integral = integrate_polygon(polygon, s.position, s.frame, s.fitted.lobe);
  if (s.two) {
    integral =
        with_second_lobe(s, integral, integrate_polygon(polygon, s.position, s.frame, s.second));
  }
  return unless_in_plane(s, polygon_origin(polygon), polygon_normal(polygon), integral);
}

/// The integral where triangle_may_cut, which most groups need not carry along.
FN LightIntegral cut_polygon_integral(Surface s, Polygon polygon) {
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
FN LightIntegral polygon_integral_in_one_lane(Surface s, Polygon polygon) {
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

/// The integral over a polygon as an adaptive surface sees it: see exact_amount.
FN LightIntegral adaptive_polygon_integral(Surface s, Polygon polygon) {
  Vec3 center = to_shading(s.frame, polygon_centroid(polygon) - s.position);
  Real amount = exact_amount(s, center, polygon_radius(polygon));
  // Uniform shortcuts: all lanes are GGX itself, or none is.
  if (all_lanes(amount >= Real(1.0))) {
    return exact_polygon_integral(s, polygon);
  }
  LightIntegral lobes;
  if (one_lane()) {
    lobes = polygon_integral_in_one_lane(s, polygon);
  } else if (triangle_may_cut(s, polygon)) {
    lobes = cut_polygon_integral(s, polygon);
  } else {
    lobes = whole_polygon_integral(s, polygon);
  }
  lobes.weight = Real(-1.0);
  if (any_lane(amount > Real(0.0))) {
    return blend_exact(s, lobes, exact_polygon_integral(s, polygon), amount);
  }
  return lobes;
}

/// The integral over a polygon as a surface sees it: what its triangle hides is left out, and all of it
/// without a side of the polygon. Uniform shortcut: no lane's triangle reaches the light.
FN LightIntegral surface_polygon_integral(Surface s, Polygon polygon) {
  if (s.exact) {
    if (s.adaptive) {
      return adaptive_polygon_integral(s, polygon);
    }
    return exact_polygon_integral(s, polygon);
  }
  if (one_lane()) {
    return polygon_integral_in_one_lane(s, polygon);
  }
  if (triangle_may_cut(s, polygon)) {
    return cut_polygon_integral(s, polygon);
  }
  return whole_polygon_integral(s, polygon);
}

/// Light that a surface reflects of a polygon of radiance 1, without shadow.
FN ShadedLight shade_polygon_parts(Surface s, Polygon polygon) {
  return shade_integral(s, surface_polygon_integral(s, polygon));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_polygon_parts, both together.
/// Not by way of shade_polygon_parts, nor of surface_polygon_integral: where a compiler does not inline
/// these, each copies the surface, 3 % of a quad's instructions.
FN Vec3 shade_polygon(Surface s, Polygon polygon) {
  if (s.exact) {
    return both_parts(shade_integral(s, surface_polygon_integral(s, polygon)));
  }
  if (one_lane()) {
    return both_parts(shade_integral(s, polygon_integral_in_one_lane(s, polygon)));
  }
  if (triangle_may_cut(s, polygon)) {
    return both_parts(shade_integral(s, cut_polygon_integral(s, polygon)));
  }
  return both_parts(shade_integral(s, whole_polygon_integral(s, polygon)));
}
