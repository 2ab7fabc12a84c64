// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a round tube: a cylinder, open or closed, or a capsule. Exact, clipped
// to both horizons.
//
// From outside, a closed tube is convex, and its outline is made of two straight edges, where planes
// through the point touch the whole length, and of an arc around each end: of the end's disk, or of
// the sphere that rounds it off. Under M^-1 planes stay planes and cones stay elliptic cones
// (cone.glsl), so the outline keeps its form, and the integral is the sum of two edges and two arcs.
// An open tube shows its lateral surface alone: at an end whose disk one would look into, the near
// half of the rim bounds it instead of the far one.
//
// In shading space, with u the axis, w the unit vector from the point to the axis' line at distance
// h, and v = u x w, the touching planes have the normals g = -sin a w +- cos a v, sin a = radius / h,
// and touch the ends at their centres + radius g, disks and spheres alike.

/// A round tube along a straight axis, which emits outwards.
struct Tube {
  Vec3 from;   ///< ends of the axis, world space
  Vec3 to;     ///< the other end
  Real radius; ///< metres
  Real caps;   ///< 0: none, the lateral surface alone; 1: flat; 2: round, a capsule
};

/// Whether its ends are closed.
FN Mask has_caps(Tube tube) { return tube.caps > Real(0.5); }
/// Whether its ends are hemispheres.
FN Mask has_round_caps(Tube tube) { return tube.caps > Real(1.5); }

/// A tube around the origin of shading space.
struct TubeView {
  Vec3 from;   ///< one end of the axis
  Vec3 to;     ///< the other
  Vec3 axis;   ///< unit
  Vec3 w;      ///< unit, from the origin to the axis' line
  Vec3 v;      ///< axis x w
  Real height; ///< distance to the axis' line
  Vec3 left;   ///< radius times the normal of one touching plane
  Vec3 right;  ///< and of the other
  Mask beside; ///< outside of the infinite cylinder
};

/// A tube as `position`, world space, sees it.
FN TubeView tube_view(Tube tube, Vec3 position, Frame frame) {
  ASSERT_THAT(tube.radius >= Real(0.0));
  TubeView view;
  view.from = to_shading(frame, tube.from - position);
  view.to = to_shading(frame, tube.to - position);
  view.axis = safe_direction(view.to - view.from);
  Vec3 foot = view.from - view.axis * dot(view.from, view.axis);
  Real height2 = dot(foot, foot);
  Mask on_axis = height2 <= Real(1.0e-12) * dot(view.from, view.from) + Real(k_tiny);
  view.w =
      select(on_axis, any_perpendicular(view.axis), foot * inversesqrt(max(height2, Real(k_tiny))));
  view.v = cross(view.axis, view.w);
  view.height = sqrt(height2);
  view.beside = view.height > tube.radius && !on_axis;
  Real sine = min(tube.radius / max(view.height, Real(k_tiny)), Real(1.0));
  Real cosine = sqrt(max((Real(1.0) - sine) * (Real(1.0) + sine), Real(0.0)));
  view.left = (view.v * cosine - view.w * sine) * tube.radius;
  view.right = (-(view.v * cosine) - view.w * sine) * tube.radius;
  return view;
}

/// Which part of the outline of an end's cone bounds the tube.
struct TubeEnd {
  Cone cone;  ///< of directions to the end, cosine space
  Arc part;   ///< of its outline
  Real sign;  ///< -1: followed clockwise, 0: not at all
  Vec3 left;  ///< where it meets the edges, on the cone, unit, cosine space
  Vec3 right; ///< and where it meets the other one
};

/// One end. `center`, `away`: its centre and the unit direction out of it along the axis, shading
/// space; `first`: whether it is the one at Tube.from, through which the outline runs from right to
/// left; `whole`: whether this end is what points that are not beside the tube see.
FN_CALL TubeEnd tube_end(Tube tube, TubeView view, Vec3 center, Vec3 away, bool first, Mask whole,
                         Lobe lobe) {
  Mask round = has_round_caps(tube);
  Real distance2 = dot(center, center);
  Vec3 direction = center * inversesqrt(max(distance2, Real(k_tiny)));
  Vec3 u = any_perpendicular(direction);
  Real radius = select(round, tangent_disk_radius(distance2, tube.radius), tube.radius);
  Vec3 a = select(round, u, view.w) * radius;
  Vec3 b = select(round, cross(direction, u), view.v) * radius;
  TubeEnd result;
  result.cone = make_cone(to_cosine(lobe, center), to_cosine(lobe, a), to_cosine(lobe, b));
  Real left = outline_parameter(result.cone, to_cosine(lobe, center + view.left));
  Real right = outline_parameter(result.cone, to_cosine(lobe, center + view.right));
  result.left = cone_direction(result.cone, left);
  result.right = cone_direction(result.cone, right);
  // An open end that one looks into: the other arc, backwards.
  Mask into = !has_caps(tube) && dot(center, away) < Real(0.0);
  Real forth = wrapped_turn(first ? left - right : right - left);
  Real back = wrapped_turn(first ? right - left : left - right);
  Real begin = first ? right : left;
  Real end = first ? left : right;
  result.part.start = select(into, end, begin);
  result.part.extent = select(view.beside, select(into, back, forth), Real(2.0) * k_pi);
  result.sign =
      select(view.beside, select(into, Real(-1.0), Real(1.0)), select(whole, Real(1.0), Real(0.0)));
  return result;
}

/// Area of half of an end of a thin tube, which bulges out beyond the strip around its axis, at a right angle to
/// the view; less than 0 for an open end that one looks into. `facing`: the cosine between its direction and that
/// out of it along the axis.
FN Real thin_end_area(Tube tube, Real facing) {
  Mask into = !has_caps(tube) && facing < Real(0.0);
  return Real(0.5) * k_pi * tube.radius * tube.radius *
         select(has_round_caps(tube), Real(1.0), abs(facing)) * select(into, Real(-1.0), Real(1.0));
}

/// 2 pi times the vector irradiance of that, as a small light (density times solid angle: docs/method.md,
/// section 9).
FN Vec3 thin_end_term(Tube tube, Vec3 center, Vec3 away, Lobe lobe) {
  Real distance2 = max(dot(center, center), Real(k_tiny));
  Real distance = sqrt(distance2);
  Real area = thin_end_area(tube, dot(center, away) / distance);
  // Solid angle area / r^2, in cosine space det / |M^-1 w|^3 times that, w = center / r.
  Vec3 o = to_cosine(lobe, center);
  Real inv_o = inversesqrt(max(dot(o, o), Real(k_tiny)));
  Real solid_angle_o = area * lobe.det * (distance * inv_o) * (inv_o * inv_o);
  Mask above = center.z > Real(0.0) && o.z > Real(0.0);
  return select(above, o * (Real(2.0) * solid_angle_o * inv_o),
                Vec3(Real(0.0), Real(0.0), Real(0.0)));
}

/// Angular radius of a tube in the space that `lobe` leads to, at most, where it is closest.
FN Real tube_thickness(Tube tube, TubeView view, Lobe lobe) {
  Vec3 a = to_cosine(lobe, view.from);
  Vec3 d = to_cosine(lobe, view.to) - a;
  Real t = min(max(-dot(a, d) / max(dot(d, d), Real(k_tiny)), Real(0.0)), Real(1.0));
  Vec3 nearest = a + d * t;
  return tube.radius * sqrt(lobe_stretch2(lobe) / max(dot(nearest, nearest), Real(k_tiny)));
}

/// Whether a point that is not beside the tube is in front of its closed end at `center`, shading space: that lies
/// `along` metres ahead, on the way into the tube.
FN Mask sees_end(Tube tube, Vec3 center, Real along) {
  return along > Real(0.0) && has_caps(tube) &&
         (!has_round_caps(tube) || dot(center, center) > tube.radius * tube.radius);
}

/// Vector irradiance times 2 pi of a tube in the space that `lobe` leads to, by its outline; where
/// `cut`, of its part in front of the plane with unit normal `front` (that space).
FN_CALL Vec3 sum_tube_outline(Tube tube, TubeView view, Lobe lobe, Vec3 front, bool cut) {
  // Not beside the tube: in front of one of its ends.
  Mask see_from = sees_end(tube, view.from, dot(view.from, view.axis));
  Mask see_to = sees_end(tube, view.to, -dot(view.to, view.axis));

  TubeEnd first = tube_end(tube, view, view.from, -view.axis, true, see_from, lobe);
  TubeEnd second = tube_end(tube, view, view.to, view.axis, false, see_to, lobe);

  Vec3 from_left_o = to_cosine(lobe, view.from + view.left);
  Vec3 from_right_o = to_cosine(lobe, view.from + view.right);
  Vec3 to_left_o = to_cosine(lobe, view.to + view.left);
  Vec3 to_right_o = to_cosine(lobe, view.to + view.right);
  Real edges = select(view.beside, Real(1.0), Real(0.0));
  Vec3 up = horizon_normal_cosine(lobe);
  Mask whole = cone_is_above(first.cone, up) && cone_is_above(second.cone, up);
  if (cut) {
    whole = whole && cone_is_above(first.cone, front) && cone_is_above(second.cone, front);
  }
  Vec3 all = edge_term(from_left_o, to_left_o, to_left_o - from_left_o) * edges +
             edge_term(to_right_o, from_right_o, from_right_o - to_right_o) * edges +
             arc_term(first.cone, first.part) * first.sign +
             arc_term(second.cone, second.part) * second.sign;
  // Uniform shortcut: no lane needs to clip.
  if (all_lanes(whole)) {
    return all;
  }
  // The apex is on the side where the y axis comes closest to the tube's line: if it meets the tube,
  // it does so around there. A point that is not beside the tube sees one end alone.
  Real along = -(view.from.x * view.axis.x + view.from.z * view.axis.z) /
               max(view.axis.x * view.axis.x + view.axis.z * view.axis.z, Real(1.0e-12));
  Real y_end = select(see_from, first.cone.e3.y, second.cone.e3.y);
  Real y = select(view.beside, view.from.y + view.axis.y * along, y_end);
  Real s = select(y < Real(0.0), Real(-1.0), Real(1.0));
  // Edges run between the very points where the arcs end, so that all is one closed outline.
  Vec3 a = first.left;
  Vec3 b = second.left;
  Vec3 c = second.right;
  Vec3 d = first.right;
  if (cut) {
    // Some point where the outline crosses the plane, if it does.
    Vec3 q = select(view.beside, a, select(see_from, first.cone.e3, second.cone.e3));
    q = select(first.sign != Real(0.0), arc_crossing(first.cone, first.part, front, q), q);
    q = select(second.sign != Real(0.0), arc_crossing(second.cone, second.part, front, q), q);
    q = select(view.beside, edge_crossing(a, b, front, q), q);
    q = select(view.beside, edge_crossing(c, d, front, q), q);
    Vec3 part = edge_in_front(a, b, q, up, front, s) * edges +
                edge_in_front(c, d, q, up, front, s) * edges +
                arc_in_front(first.cone, first.part, q, up, front, s) * first.sign +
                arc_in_front(second.cone, second.part, q, up, front, s) * second.sign;
    return select(whole, all, part);
  }
  Vec3 clipped = closed_edge_term(a, b, dot(up, a), dot(up, b), s) * edges +
                 closed_edge_term(c, d, dot(up, c), dot(up, d), s) * edges +
                 clipped_arc_term(first.cone, first.part, up, s) * first.sign +
                 clipped_arc_term(second.cone, second.part, up, s) * second.sign;
  return select(whole, all, clipped);
}

/// light_concentration's outline2 of a tube, whose length segment_ratio sees to: of the two points that
/// are across from each other where it is nearest.
FN Real tube_outline2(Tube tube, TubeView view, Lobe lobe) {
  Vec3 a = to_cosine(lobe, view.from);
  Vec3 d = to_cosine(lobe, view.to) - a;
  Real t = min(max(-dot(a, d) / max(dot(d, d), Real(k_tiny)), Real(0.0)), Real(1.0));
  Vec3 nearest = a + d * t;
  Vec3 across = to_cosine(lobe, view.v) * tube.radius;
  Real distance2 = dot(nearest, nearest);
  return distance2 / max(distance2 + dot(across, across), Real(k_tiny));
}

/// Angular radius below which a tube is its strip and ends alone.
CONSTANT k_wholly_thin = 0.004;
/// 1 over how much more it takes to be its outline alone, from 0.008 on.
CONSTANT k_inv_thin_range = 250.0;
/// k_wholly_thin where a plane cuts the tube.
CONSTANT k_wholly_thin_cut = 0.0005;
/// And k_inv_thin_range there: its outline alone from 0.001 on.
CONSTANT k_inv_thin_range_cut = 2000.0;

/// The same for tubes of any thickness.
///
/// The two edges of a thin tube nearly cancel, of which rounding makes 1e-7 over its angular radius.
/// So from a hundredth downwards it is handed over, without a step, to the strip around its axis and
/// the halves of its ends, which is wrong by the square of that radius. `heights`: over the plane with
/// unit normal `front` (shading space); where that cuts it, `cut`, the strip would vanish all at once,
/// and the outline, though less exact, serves for thinner ones.
FN_CALL Vec3 sum_tube(Tube tube, TubeView view, Lobe lobe, Vec3 front, Heights heights, bool cut) {
  Real thickness = tube_thickness(tube, view, lobe);
  Real exact =
      min(max((thickness - Real(k_wholly_thin)) * Real(k_inv_thin_range), Real(0.0)), Real(1.0));
  Vec3 from = view.from;
  Vec3 to = view.to;
  Mask from_seen = Real(0.0) < Real(1.0);
  Mask to_seen = from_seen;
  Mask strip_seen = from_seen;
  if (cut) {
    Real thinner =
        min(max((thickness - Real(k_wholly_thin_cut)) * Real(k_inv_thin_range_cut), Real(0.0)),
            Real(1.0));
    exact = select(heights.low < Real(0.0) && heights.high > Real(0.0), thinner, exact);
    FrontSegment part = segment_in_front(from, to, front);
    from_seen = dot(front, from) > Real(0.0);
    to_seen = dot(front, to) > Real(0.0);
    strip_seen = part.some;
    from = part.a;
    to = part.b;
  }
  Vec3 sum = Vec3(Real(0.0), Real(0.0), Real(0.0));
  // Uniform shortcuts: no lane has one form or the other.
  if (any_lane(exact > Real(0.0))) {
    sum = sum_tube_outline(tube, view, lobe, plane_normal_cosine(lobe, front), cut) * exact;
  }
  if (any_lane(exact < Real(1.0))) {
    Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
    Vec3 thin = select(strip_seen, sum_line(from, to, lobe) * (Real(2.0) * tube.radius), none) +
                select(from_seen, thin_end_term(tube, view.from, -view.axis, lobe), none) +
                select(to_seen, thin_end_term(tube, view.to, view.axis, lobe), none);
    sum = sum + select(exact < Real(1.0), thin * (Real(1.0) - exact), none);
  }
  return sum;
}

/// Of a tube over the plane through `position` with that unit normal, world space.
FN Heights tube_heights(Tube tube, Vec3 position, Vec3 normal) {
  Real from = dot(normal, tube.from - position);
  Real to = dot(normal, tube.to - position);
  Vec3 axis = safe_direction(tube.to - tube.from);
  Real along = dot(normal, axis);
  Real reach = tube.radius * select(has_round_caps(tube), Real(1.0),
                                    sqrt(max(Real(1.0) - along * along, Real(0.0))));
  Heights heights;
  heights.low = min(from, to) - reach;
  heights.high = max(from, to) + reach;
  return heights;
}

/// How far a plane lifts an end of a tube's axis, in radii: 0 where the tube stands out of it whole, 1 where it
/// is below; the end is `height` over the plane.
FN Real lift_share(Real height, Real radius) {
  Real share = Real(0.5) * (radius - height) / max(radius, Real(k_tiny));
  return min(max(share, Real(0.0)), Real(1.0));
}

/// 1 where a tube's highest point is above the horizon: below it gives nothing, rounding or not; else 0.
FN Real tube_seen_above(Tube tube, TubeView view) {
  Real reach = tube.radius * select(has_round_caps(tube), Real(1.0),
                                    sqrt(max(Real(1.0) - view.axis.z * view.axis.z, Real(0.0))));
  return select(max(view.from.z, view.to.z) + reach > Real(0.0), Real(1.0), Real(0.0));
}

/// integrate_tube; where `cut`, over what is in front of the plane with unit normal `front` (shading
/// space), over which the tube has these heights.
FN LightIntegral integrate_tube_part(Tube tube, Vec3 position, Frame frame, Lobe lobe, Vec3 front,
                                     Heights heights, bool cut) {
  TubeView view = tube_view(tube, position, frame);
  Real seen = tube_seen_above(tube, view);
  return light_integral(sum_tube(tube, view, cosine_lobe(), front, heights, cut) * seen,
                        sum_tube(tube, view, lobe, front, heights, cut) * seen, lobe,
                        tube_outline2(tube, view, lobe));
}

/// Integrals over a tube seen from `position` (world space), for Lambert and for `lobe`. Zero
/// inside: it emits outwards.
FN LightIntegral integrate_tube(Tube tube, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_tube_part(tube, position, frame, lobe, Vec3(Real(0.0), Real(0.0), Real(1.0)),
                             no_heights(), false);
}
