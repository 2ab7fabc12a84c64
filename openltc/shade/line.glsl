// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a straight line of vanishing width, exact, clipped to both horizons.
//
// Source: Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed
// Cosines": the integral of the cosine along a line, and the width that M^-1 gives it. Clipped here
// to the surface's horizon too, and kept as a vector for the mean direction.
//
// With f the foot of the perpendicular from the point to the line, at distance d, t the line's
// direction and b the angle from f, a strip of width w around the line has
//   2 pi times its vector irradiance = (w/d) ( f/d [b + sin b cos b] + t [sin^2 b] ),
// the brackets taken between its ends. M^-1 turns the width across the line of sight by
// det |p x q| / |p_o x q_o| for any two points p, q of the line: areas of triangles with the origin
// change by the cofactors of M^-1, volumes by its determinant.

/// A straight line without a width; see the intensity per metre of openltc::Line.
struct Line {
  Vec3 from; ///< one end, world space
  Vec3 to;   ///< the other
};

/// 2 pi times the vector irradiance of the strip of width 1 around the segment from p to q, seen
/// from the origin.
FN Vec3 line_term(Vec3 p, Vec3 q) {
  Vec3 axis = q - p;
  Real length2 = max(dot(axis, axis), Real(k_tiny));
  Vec3 t = axis * inversesqrt(length2);
  Real from = dot(p, t);
  Real to = dot(q, t);
  Vec3 foot = p - t * from;
  // The point on the line itself sees it end-on.
  Real d2 = max(dot(foot, foot), Real(1.0e-12) * (dot(p, p) + dot(q, q)) + Real(k_tiny));
  Real inv_d = inversesqrt(d2);
  Real d = d2 * inv_d;
  Real from_r2 = d2 + from * from;
  Real to_r2 = d2 + to * to;
  Real angle = angle_of(d2 + from * to, d * (to - from));
  Real along = to * to / to_r2 - from * from / from_r2;
  Real across = angle + to * d / to_r2 - from * d / from_r2;
  return (foot * (inv_d * across) + t * along) * inv_d;
}

/// The same of a segment in cosine space, clipped to both horizons; see clip_edge.
FN Vec3 clipped_line_term(Vec3 a_o, Vec3 b_o, Real a_z, Real b_z) {
  ClippedEdge edge = clip_edge(a_o, b_o, a_z, b_z);
  return select(edge.outside, Vec3(Real(0.0), Real(0.0), Real(0.0)), line_term(edge.p0, edge.p1));
}

/// 2 pi times the vector irradiance of a strip of width 1 in shading space around the segment from a
/// to b, also shading space, in the space that `lobe` leads to.
FN_CALL Vec3 sum_line(Vec3 a, Vec3 b, GIVEN(Lobe) lobe) {
  Vec3 a_o = to_cosine(lobe, a);
  Vec3 b_o = to_cosine(lobe, b);
  Vec3 triangle = cross(a, b - a);
  Vec3 triangle_o = cross(a_o, b_o - a_o);
  Real ratio2 = dot(triangle, triangle) / max(dot(triangle_o, triangle_o), Real(k_tiny));
  return clipped_line_term(a_o, b_o, a.z, b.z) * (lobe.det * sqrt(ratio2));
}

/// Integrals over the segment from a to b, shading space; see integrate_line.
FN LightIntegral integrate_segment(Vec3 a, Vec3 b, Lobe lobe) {
  Vec3 diffuse = sum_line(a, b, cosine_lobe());
  Vec3 specular = sum_line(a, b, lobe);
  LightIntegral result;
  result.diffuse = min(max(diffuse.z * k_half_inv_pi, Real(0.0)), Real(1.0e15));
  result.specular = min(max(specular.z * k_half_inv_pi, Real(0.0)), Real(1.0e15));
  result.diffuse_direction = safe_direction(diffuse);
  result.specular_direction = safe_direction(from_cosine(lobe, safe_direction(specular)));
  result.second = Real(0.0);
  result.concentration = Real(0.0); // it has none; see segment_ratio
  return result;
}

/// Integrals over a line seen from `position` (world space), per metre of its width: without an
/// upper bound.
FN LightIntegral integrate_line(Line line, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_segment(to_shading(frame, line.from - position),
                           to_shading(frame, line.to - position), lobe);
}

/// The same over what is in front of the plane with unit normal `front` (shading space).
FN LightIntegral integrate_line_in_front(Line line, Vec3 position, Frame frame, Lobe lobe,
                                         Vec3 front) {
  ASSERT_THAT(is_unit(front));
  FrontSegment part = segment_in_front(to_shading(frame, line.from - position),
                                       to_shading(frame, line.to - position), front);
  LightIntegral integral = integrate_segment(part.a, part.b, lobe);
  integral.diffuse = select(part.some, integral.diffuse, Real(0.0));
  integral.specular = select(part.some, integral.specular, Real(0.0));
  return integral;
}

/// Of a line over the plane through `position` with that unit normal, world space.
FN Heights line_heights(Line line, Vec3 position, Vec3 normal) {
  Real from = dot(normal, line.from - position);
  Real to = dot(normal, line.to - position);
  Heights heights;
  heights.low = min(from, to);
  heights.high = max(from, to);
  return heights;
}

/// The integral over a line as a surface sees it; see surface_polygon_integral.
FN LightIntegral surface_line_integral(GIVEN(Surface) s, Line line) {
  Heights heights = no_heights();
  bool cut = false;
  if (s.tilted) {
    heights = line_heights(line, s.position, s.geometric);
    cut = any_lane(heights.low < Real(0.0));
  }
  if (!cut) {
    LightIntegral integral = integrate_line(line, s.position, s.frame, s.fitted.lobe);
    if (s.two) {
      integral = with_second_lobe(s, integral, integrate_line(line, s.position, s.frame, s.second));
    }
    return integral;
  }
  LightIntegral integral =
      integrate_line_in_front(line, s.position, s.frame, s.fitted.lobe, front_shading(s));
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_line_in_front(line, s.position, s.frame, s.second, front_shading(s)));
  }
  return unless_hidden(s, heights, integral);
}

/// Pieces into which the ratio to the BRDF divides a segment.
const int k_line_pieces = 6;

/// Means over a segment, weighted by the lobe.
struct SegmentRatio {
  Real scale;  ///< of blended_ratio
  Real bias;   ///< of blended_ratio times Schlick's weight
  Real direct; ///< Schlick's weight in the mean direction of the whole segment
};

/// blended_ratio of a long light: a mean over pieces that span equal angles in cosine space, each taken in
/// its own mean direction. a, b: its ends, shading space; w: see blended_ratio.
///
/// A long light has no one direction, least of all one low over the horizon, where the BRDF vanishes and
/// the lobe does not. The weights are line_term's, whose angles are steps of a rotation.
FN_CALL SegmentRatio segment_ratio(GIVEN(Surface) s, GIVEN(Lobe) lobe, Vec3 a, Vec3 b, Real w) {
  ClippedEdge edge = clip_edge(to_cosine(lobe, a), to_cosine(lobe, b), a.z, b.z);
  Vec3 t = safe_direction(edge.p1 - edge.p0);
  Real from = dot(edge.p0, t);
  Real to = dot(edge.p1, t);
  Vec3 foot = edge.p0 - t * from;
  Real d2 = max(dot(foot, foot),
                Real(1.0e-12) * (dot(edge.p0, edge.p0) + dot(edge.p1, edge.p1)) + Real(k_tiny));
  Real inv_d = inversesqrt(d2);
  Real d = d2 * inv_d;
  Vec3 f = foot * inv_d;
  Real step = angle_of(d2 + from * to, d * (to - from)) * Real(1.0 / float(k_line_pieces));
  Real step_cos = cos(step);
  Real step_sin = sin(step);
  Real inv_r = inversesqrt(d2 + from * from);
  Real c = d * inv_r;
  Real n = from * inv_r;
  Real total = Real(k_tiny);
  SegmentRatio mean;
  mean.scale = Real(0.0);
  mean.bias = Real(0.0);
  Vec3 all = Vec3(Real(0.0), Real(0.0), Real(0.0));
  for (int i = 0; i < k_line_pieces; ++i) {
    Real next_c = c * step_cos - n * step_sin;
    Real next_n = n * step_cos + c * step_sin;
    Vec3 sum = f * (step + next_n * next_c - n * c) + t * (next_n * next_n - n * n);
    Real weight = max(sum.z, Real(0.0));
    Vec3 wi = safe_direction(from_cosine(lobe, sum));
    Real part = weight * blended_ratio(s, wi, w);
    mean.scale = mean.scale + part;
    mean.bias = mean.bias + part * fresnel_weight(s.wo, wi);
    total = total + weight;
    all = all + sum;
    c = next_c;
    n = next_n;
  }
  Real inv_total = select(edge.outside, Real(0.0), Real(1.0) / total);
  mean.scale = mean.scale * inv_total;
  mean.bias = mean.bias * inv_total;
  mean.direct = fresnel_weight(s.wo, safe_direction(from_cosine(lobe, all)));
  return mean;
}

/// The part of a line that a surface sees: above its horizon and in front of its triangle;
/// where nothing is, a point.
FN Line line_seen(GIVEN(Surface) s, Line line) {
  bool below = any_lane(line_heights(line, s.position, s.frame.n).low < Real(0.0));
  bool behind = s.tilted && any_lane(line_heights(line, s.position, s.geometric).low < Real(0.0));
  if (!below && !behind) {
    return line;
  }
  FrontSegment part = segment_in_front(line.from - s.position, line.to - s.position, s.frame.n);
  if (behind) {
    part = segment_in_front(part.a, part.b, s.geometric);
  }
  Line seen;
  seen.from = s.position + part.a;
  seen.to = s.position + part.b;
  return seen;
}

/// Parts into which exact_line divides a line, each of four nodes of Gauss.
const int k_line_parts = 3;

/// GGX itself over the line from a to b, shading space, per metre of its width. A line has no outline; it is
/// summed by nodes that are even in the angle at which g of exact/half_vector.glsl would pass it, were the line's
/// directions the linear ones around the mirror direction.
FN_CALL ExactNodes exact_line(GIVEN(Surface) s, Vec3 a, Vec3 b) {
  Vec3 axis = b - a;
  Real length2 = dot(axis, axis);
  Vec3 t = axis * inversesqrt(max(length2, Real(k_tiny)));
  Real from = dot(a, t);
  Real to = dot(b, t);
  Vec3 foot = a - t * from;
  Real d = sqrt(max(dot(foot, foot), Real(1.0e-12) * (dot(a, a) + dot(b, b)) + Real(k_tiny)));
  // B (p + (p.mirror) wo) = l0 + l1 x.
  Vec3 mirror = Vec3(-s.wo.x, Real(0.0), s.wo.z);
  Vec3 l0 = foot + s.wo * dot(foot, mirror);
  Vec3 l1 = t + s.wo * dot(t, mirror);
  l0.z = l0.z * s.alpha;
  l1.z = l1.z * s.alpha;
  Vec3 across = cross(l0, l1);
  Real inv_l1 = inversesqrt(max(dot(l1, l1), Real(k_tiny)));
  Real nearest = -dot(l0, l1) * (inv_l1 * inv_l1);
  // Seen end-on, from far beyond its end, the line has no such angle left.
  Real gap = max(max(from - nearest, nearest - to), Real(0.0));
  Real width =
      max(max(sqrt(dot(across, across)) * (inv_l1 * inv_l1), Real(0.02) * gap), Real(1.0e-6) * d);
  Real start = angle_of(width, from - nearest);
  // Rounding must not turn it.
  Real whole = max(angle_of(width, to - nearest) - start, Real(0.0));
  Real part = whole * Real(1.0 / float(k_line_parts));
  ExactNodes sum = no_exact_nodes();
  for (int i = 0; i < k_line_parts; ++i) {
    for (int k = 0; k < 4; ++k) {
      bool outer = k == 0 || k == 3;
      Real place = Real(k < 2 ? -0.5 : 0.5) * Real(outer ? 0.8611363115940526 : 0.3399810435848563);
      Real angle = start + part * (Real(float(i)) + Real(0.5) + place);
      Real c = max(cos(angle), Real(1.0e-6));
      Real tangent = sin(angle) / c;
      Real weight =
          Real(outer ? 0.17392742256872693 : 0.32607257743127307) * part * width / (c * c);
      Vec3 p = foot + t * (nearest + width * tangent);
      Real inv_r = inversesqrt(max(dot(p, p), Real(k_tiny)));
      sum = add_exact_node(s, sum, p * inv_r, weight * d * inv_r * (inv_r * inv_r));
    }
  }
  Mask some = length2 > Real(k_tiny);
  sum.scale = select(some, sum.scale, Real(0.0));
  sum.bias = select(some, sum.bias, Real(0.0));
  return sum;
}

/// Specular light of a line from a to b, shading space, of which the lobes have these shares. Each lobe is
/// divided by itself, against the density of both: the balance heuristic of importance sampling.
FN Vec3 segment_reflectance(GIVEN(Surface) s, Vec3 a, Vec3 b, Real first, Real second) {
  SegmentRatio ratio = segment_ratio(s, s.fitted.lobe, a, b, Real(1.0));
  Real scale = ratio.scale * first;
  Real bias = ratio.bias * first;
  if (s.two) {
    ratio = segment_ratio(s, s.second, a, b, Real(1.0));
    scale = scale + ratio.scale * second;
    bias = bias + ratio.bias * second;
  }
  return (s.f0 * scale + (s.f90 - s.f0) * bias) * s.fitted.n1;
}

/// Reflected light of a light of no width, whose integral is per metre of it and has no upper bound.
FN ShadedLight shade_line_integral(GIVEN(Surface) s, Line line, LightIntegral integral) {
  Real first = s.inv_share * integral.specular;
  Real second = s.second_inv_share * integral.second;
  ShadedLight shaded;
  shaded.diffuse = s.diffuse * integral.diffuse;
  if (s.exact) {
    Line seen = line_seen(s, line);
    ExactNodes exact = exact_line(s, to_shading(s.frame, seen.from - s.position),
                                  to_shading(s.frame, seen.to - s.position));
    shaded.specular = s.f0 * exact.scale + (s.f90 - s.f0) * exact.bias;
  } else if (s.corrected) {
    shaded.specular = segment_reflectance(s, to_shading(s.frame, line.from - s.position),
                                          to_shading(s.frame, line.to - s.position), first, second);
  } else {
    Vec3 fresnel = s.f0 + (s.f90 - s.f0) * fresnel_weight(s.wo, integral.specular_direction);
    shaded.specular = fresnel * (s.fitted.n1 * (first + second));
  }
  return shaded;
}

/// Light that a surface reflects of a line of 1 cd/m, without shadow.
FN ShadedLight shade_line_parts(GIVEN(Surface) s, Line line) {
  return shade_line_integral(s, line, surface_line_integral(s, line));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_line_parts, both together.
FN Vec3 shade_line(GIVEN(Surface) s, Line line) { return both_parts(shade_line_parts(s, line)); }

/// A point of the line, evenly distributed over the angle that it spans at `position`, from a number
/// in [0, 1) (equi-angular sampling: Kulla and Fajardo 2012, "Importance Sampling Techniques for Path
/// Tracing in Participating Media"). `solid_angle` is per metre of width, and no ray meets a line.
FN LightPoint sample_line(Line line, Vec3 position, Real u) {
  Vec3 p = line.from - position;
  Vec3 axis = line.to - line.from;
  Real length2 = max(dot(axis, axis), Real(k_tiny));
  Vec3 t = axis * inversesqrt(length2);
  Real from = dot(p, t);
  Real to = from + length2 * inversesqrt(length2);
  Vec3 foot = p - t * from;
  Real d2 = max(dot(foot, foot), Real(1.0e-12) * (dot(p, p) + to * to) + Real(k_tiny));
  Real d = sqrt(d2);
  Real start = angle_of(d, from);
  Real angle = angle_of(d2 + from * to, d * (to - from));
  Real b = start + u * angle;
  Real l = min(max(d * sin(b) / max(cos(b), Real(1.0e-7)), from), to);
  Vec3 offset = foot + t * l;
  Real distance2 = max(dot(offset, offset), Real(k_tiny));
  Real inv_distance = inversesqrt(distance2);
  LightPoint result;
  result.hit = distance2 > Real(k_tiny);
  result.direction = offset * inv_distance;
  result.distance = distance2 * inv_distance;
  result.cos_light = Real(1.0);
  // w dl sin / r^2 with dl = r^2/d db and sin = d/r.
  result.solid_angle = angle * inv_distance;
  return result;
}
