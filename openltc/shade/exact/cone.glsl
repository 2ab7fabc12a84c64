// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself over the cone of an ellipse or a sphere: its outline as arcs of a circle's image, clipped to the
// surface's horizon. The sums along arcs: outline.glsl.

/// Unit vector of a cone's outline, from the cosine and sine of its parameter; see cone.glsl.
FN Vec3 cone_direction(Cone cone, Real c, Real s) {
  Real n2 = cone.c1 * cone.c1 * c * c + cone.c2 * cone.c2 * s * s;
  return cone.e1 * (cone.k1 * c) + cone.e2 * (cone.k2 * s) + cone.e3 * sqrt(n2);
}

/// The arc of the circle through the unit vectors a, c and b, c in its middle. It is a rational curve of degree 2,
/// as an edge is.
FN ContourSums add_circle_arc(GIVEN(ExactView) view, GIVEN(ContourSums) sums, Vec3 a, Vec3 c,
                              Vec3 b, Real sign) {
  Vec3 ac = c - a;
  Vec3 cb = b - c;
  Vec3 ab = b - a;
  Real halves = dot(ac, ac) + dot(cb, cb);
  Real scale = select(halves > Real(1.0e-12), Real(2.0) * dot(ab, ab) / max(halves, Real(1.0e-12)),
                      Real(4.0));
  ConicPoint m = conic_point(view, (c * scale - a - b) * Real(0.5), Real(0.5) * scale - Real(1.0));
  return add_arc(view, sums, conic_point(view, a, Real(1.0)), m, conic_point(view, b, Real(1.0)),
                 sign);
}

/// Along the outline from `first`, its point at the parameter `start`, to `last`, at `extent` more, in that many
/// arcs of circles, which the outline of a round cone is made of, times `sign`.
FN_CALL ContourSums add_cone_arcs(GIVEN(ExactView) view, GIVEN(ContourSums) so_far,
                                  GIVEN(Cone) cone, Real start, Real extent, Vec3 first, Vec3 last,
                                  int arcs, Real sign) {
  ContourSums sums = so_far;
  Real c = cos(start);
  Real n = sin(start);
  Real step = extent * Real(0.5 / float(arcs));
  Real step_c = cos(step);
  Real step_n = sin(step);
  Vec3 a = first;
  for (int i = 1; i <= arcs; ++i) {
    Real next_c = c * step_c - n * step_n;
    n = n * step_c + c * step_n;
    c = next_c;
    Vec3 middle = cone_direction(cone, c, n);
    next_c = c * step_c - n * step_n;
    n = n * step_c + c * step_n;
    c = next_c;
    Vec3 b = last;
    if (i < arcs) {
      b = cone_direction(cone, c, n);
    }
    sums = add_circle_arc(view, sums, a, middle, b, sign);
    a = b;
  }
  return sums;
}

/// Closes what begins at the direction a, and runs to b, by arcs of the horizon, times `sign`.
FN ContourSums close_at_horizon(GIVEN(ExactView) view, ContourSums sums, Vec3 a, Vec3 b,
                                Real sign) {
  sums = add_horizon_arc(view, sums, conic_point(view, a, Real(1.0)), sign);
  return add_horizon_arc(view, sums, conic_point(view, b, Real(1.0)), -sign);
}

/// The light of a cone of directions in that many arcs of circles, which a round one is made of.
FN_CALL ExactIntegral exact_cone(GIVEN(Surface) s, GIVEN(Cone) cone, int arcs) {
  Arc above = arc_above(cone, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  Mask whole = above.extent > Real(k_full_turn);
  // Of a whole outline that is its lowest point: the axes of a round cone are any, and would choose its arcs.
  Real start = above.start;
  Real extent = select(whole, Real(2.0) * k_pi, max(above.extent, Real(0.0)));
  Vec3 first = cone_direction(cone, start);
  Vec3 last = cone_direction(cone, start + extent);
  // On the horizon, where it cuts.
  Vec3 first_cut = Vec3(first.x, first.y, Real(0.0));
  Vec3 last_cut = Vec3(last.x, last.y, Real(0.0));
  first = select(whole, first, first_cut * inverse_length(first_cut));
  last = select(whole, first, last_cut * inverse_length(last_cut));
  ExactView view = exact_view(s.wo, s.alpha, select(whole, cone.e3, first + last));
  ContourSums sums =
      add_cone_arcs(view, no_contour(), cone, start, extent, first, last, arcs, Real(1.0));
  if (any_lane(!whole)) {
    sums = close_at_horizon(view, sums, first, last, select(whole, Real(0.0), Real(1.0)));
  }
  ExactIntegral result = exact_integral(view, sums, Real(1.0));
  Mask some = whole || above.extent > Real(0.0);
  result.light = select(some, result.light, Real(0.0));
  result.bias = select(some, result.bias, Real(0.0));

  Real exact = outline_exactness(s, cone.e3, cone.k1);
  // Uniform shortcut: no lane's cone is small.
  if (any_lane(exact < Real(1.0))) {
    Real k2 = cone.k1 * cone.k1 + cone.k2 * cone.k2;
    Real quarter = Real(0.25) * k_pi * cone.k1 * cone.k2 * (Real(1.0) + Real(0.125) * k2);
    Vec3 u = cone.e1 * (cone.k1 * Real(0.7071067811865476));
    Vec3 v = cone.e2 * (cone.k2 * Real(0.7071067811865476));
    ExactNodes parts = no_exact_nodes();
    parts = add_exact_node(s, parts, normalize(cone.e3 + u), quarter);
    parts = add_exact_node(s, parts, normalize(cone.e3 - u), quarter);
    parts = add_exact_node(s, parts, normalize(cone.e3 + v), quarter);
    parts = add_exact_node(s, parts, normalize(cone.e3 - v), quarter);
    result = mix_exact(s, result, parts, exact);
  }
  return result;
}

/// The integrals over a cone of directions, its specular part that of GGX itself for F = 1.
FN LightIntegral exact_cone_integral(GIVEN(Surface) s, Cone cone, int arcs) {
  Vec3 diffuse = clipped_cone(cone, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  ExactIntegral specular = exact_cone(s, cone, arcs);
  return exact_light_integral(s, diffuse, specular);
}
