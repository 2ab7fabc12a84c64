// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself over a tube: two edges and two arcs of cones, as in tube.glsl, clipped to the surface's horizon; a thin
// one is a line and its ends, by nodes of the BRDF.

/// Arcs of circles into which an end's outline is divided.
const int k_tube_arcs = 4;

/// An end's part of the outline, as far as it is above the horizon, closed by arcs of that wherever a piece begins
/// or ends.
FN_CALL ContourSums add_clipped_end(GIVEN(ExactView) view, GIVEN(ContourSums) so_far,
                                    GIVEN(TubeEnd) end) {
  ContourSums sums = so_far;
  Real turn = Real(2.0) * k_pi;
  Arc above = arc_above(end.cone, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  Real begin = select(above.extent > Real(k_full_turn), Real(0.0),
                      wrapped_turn(above.start - end.part.start));
  // Intervals on a circle meet themselves again after a turn.
  for (int i = 0; i < 2; ++i) {
    Real a = begin - turn * Real(float(i));
    Real low = max(a, Real(0.0));
    Real high = min(a + above.extent, end.part.extent);
    Mask some = high > low && end.sign != Real(0.0);
    if (any_lane(some)) {
      Real start = end.part.start + low;
      Real extent = max(high - low, Real(0.0));
      Vec3 first = cone_direction(end.cone, start);
      Vec3 last = cone_direction(end.cone, start + extent);
      Real sign = select(some, end.sign, Real(0.0));
      sums = add_cone_arcs(view, sums, end.cone, start, extent, first, last, k_tube_arcs, sign);
      sums = close_at_horizon(view, sums, first, last, sign);
    }
  }
  return sums;
}

/// An edge of the outline from a to b, unit, closed likewise, times `sign`.
FN ContourSums add_clipped_side(GIVEN(ExactView) view, ContourSums sums, Vec3 a, Vec3 b,
                                Real sign) {
  sums = add_edge(view, sums, a, b, sign);
  Real from = select(a.z > Real(k_in_horizon), sign, Real(0.0));
  Real to = select(b.z > Real(k_in_horizon), sign, Real(0.0));
  sums = add_horizon_arc(view, sums, conic_point(view, a, Real(1.0)), from);
  return add_horizon_arc(view, sums, conic_point(view, b, Real(1.0)), -to);
}

/// The light of a tube by its outline.
FN_CALL ExactIntegral exact_tube_outline(GIVEN(Surface) s, GIVEN(Tube) tube, GIVEN(TubeView) at) {
  TubeEnd first = tube_end(tube, at, at.from, -at.axis, true,
                           sees_end(tube, at.from, dot(at.from, at.axis)), cosine_lobe());
  TubeEnd second = tube_end(tube, at, at.to, at.axis, false,
                            sees_end(tube, at.to, -dot(at.to, at.axis)), cosine_lobe());
  Vec3 up = Vec3(Real(0.0), Real(0.0), Real(1.0));
  FrontSegment part = segment_in_front(at.from, at.to, up);
  ExactView view = exact_view(s.wo, s.alpha, safe_direction(part.a) + safe_direction(part.b));
  Real edges = select(at.beside, Real(1.0), Real(0.0));
  ContourSums sums = no_contour();
  // Uniform shortcut: no lane needs to clip.
  if (all_lanes(cone_is_above(first.cone, up) && cone_is_above(second.cone, up))) {
    Real end = first.part.start + first.part.extent;
    sums = add_cone_arcs(view, sums, first.cone, first.part.start, first.part.extent,
                         cone_direction(first.cone, first.part.start),
                         cone_direction(first.cone, end), k_tube_arcs, first.sign);
    end = second.part.start + second.part.extent;
    sums = add_cone_arcs(view, sums, second.cone, second.part.start, second.part.extent,
                         cone_direction(second.cone, second.part.start),
                         cone_direction(second.cone, end), k_tube_arcs, second.sign);
    sums = add_whole_edge(view, sums, first.left, second.left, edges);
    sums = add_whole_edge(view, sums, second.right, first.right, edges);
  } else {
    sums = add_clipped_end(view, sums, first);
    sums = add_clipped_end(view, sums, second);
    sums = add_clipped_side(view, sums, first.left, second.left, edges);
    sums = add_clipped_side(view, sums, second.right, first.right, edges);
  }
  return exact_integral(view, sums, Real(1.0));
}

/// Half of an end, as a small light.
FN ExactNodes add_exact_end(GIVEN(Surface) s, ExactNodes sum, Tube tube, Vec3 center, Vec3 away) {
  Real inv_r = inversesqrt(max(dot(center, center), Real(k_tiny)));
  Real area = thin_end_area(tube, dot(center, away) * inv_r);
  return add_exact_node(s, sum, center * inv_r, area * (inv_r * inv_r));
}

/// A thin tube: the line along its axis, in the middle of what stands out of the surface, and the halves of its
/// ends.
FN_CALL ExactNodes exact_thin_tube(GIVEN(Surface) s, GIVEN(Tube) tube, GIVEN(TubeView) at) {
  Vec3 a = at.from;
  Vec3 b = at.to;
  a.z = a.z + tube.radius * lift_share(a.z, tube.radius);
  b.z = b.z + tube.radius * lift_share(b.z, tube.radius);
  FrontSegment part = segment_in_front(a, b, Vec3(Real(0.0), Real(0.0), Real(1.0)));
  ExactNodes sum = exact_line(s, part.a, part.b);
  Real width = select(part.some, Real(2.0) * tube.radius, Real(0.0));
  sum.scale = sum.scale * width;
  sum.bias = sum.bias * width;
  sum.h = sum.h * width;
  sum = add_exact_end(s, sum, tube, a, -at.axis);
  return add_exact_end(s, sum, tube, b, at.axis);
}

/// How much of the integral along its outline a tube wants, 0 to 1, see outline_exactness: as much as any of four
/// places on its axis does.
FN Real tube_exactness(GIVEN(Surface) s, Tube tube, TubeView at) {
  Vec3 axis = at.to - at.from;
  Real inv_length2 = Real(1.0) / max(dot(axis, axis), Real(k_tiny));
  Real nearest = min(max(-dot(at.from, axis) * inv_length2, Real(0.0)), Real(1.0));
  // Where B (p + (p.mirror) wo) is least, p on the axis: see exact_line.
  Vec3 mirror = Vec3(-s.wo.x, Real(0.0), s.wo.z);
  Vec3 l0 = at.from + s.wo * dot(at.from, mirror);
  Vec3 l1 = axis + s.wo * dot(axis, mirror);
  l0.z = l0.z * s.alpha;
  l1.z = l1.z * s.alpha;
  Real reflected = min(max(-dot(l0, l1) / max(dot(l1, l1), Real(k_tiny)), Real(0.0)), Real(1.0));
  Real exact =
      max(outline_exactness(s, at.from, tube.radius), outline_exactness(s, at.to, tube.radius));
  exact = max(exact, outline_exactness(s, at.from + axis * nearest, tube.radius));
  exact = max(exact, outline_exactness(s, at.from + axis * reflected, tube.radius));
  // Edges that nearly cancel are worse than a line.
  Real thickness = tube_thickness(tube, at, cosine_lobe());
  Real apart = (thickness - Real(k_wholly_thin_cut)) * Real(k_inv_thin_range_cut);
  return min(exact, min(max(apart, Real(0.0)), Real(1.0)));
}

/// The integral over a tube, its specular part that of GGX itself for F = 1.
FN_CALL LightIntegral exact_tube_integral(GIVEN(Surface) s, GIVEN(Tube) tube) {
  TubeView at = tube_view(tube, s.position, s.frame);
  Vec3 up = Vec3(Real(0.0), Real(0.0), Real(1.0));
  Real seen = tube_seen_above(tube, at);
  Vec3 diffuse = sum_tube(tube, at, cosine_lobe(), up, no_heights(), false) * seen;
  Real exact = tube_exactness(s, tube, at);
  ExactIntegral specular;
  specular.light = Real(0.0);
  specular.bias = Real(0.0);
  specular.direction = up;
  // Uniform shortcuts: no lane has one form or the other.
  if (any_lane(exact > Real(0.0))) {
    specular = exact_tube_outline(s, tube, at);
  }
  if (any_lane(exact < Real(1.0))) {
    specular = mix_exact(s, specular, exact_thin_tube(s, tube, at), exact);
  }
  specular.light = specular.light * seen;
  return exact_light_integral(s, diffuse, specular);
}
