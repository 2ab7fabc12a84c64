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
  Cone cone;          ///< of directions to the end, cosine space
  Arc part;           ///< of its outline
  Real sign;          ///< -1: followed clockwise, 0: not at all
  Vec3 left;          ///< where it meets the edges, on the cone, unit, cosine space
  Vec3 right;         ///< and where it meets the other one
  Vec3 left_touched;  ///< where the planes through the point touch it there, cosine space
  Vec3 right_touched; ///< and on the other side
};

/// No end: sign 0.
FN TubeEnd no_tube_end() {
  Vec3 none = Vec3(Real(0.0), Real(0.0), Real(0.0));
  TubeEnd end;
  end.cone.e1 = none;
  end.cone.e2 = none;
  end.cone.e3 = none;
  end.cone.k1 = Real(0.0);
  end.cone.k2 = Real(0.0);
  end.cone.c1 = Real(1.0);
  end.cone.c2 = Real(1.0);
  end.part.start = Real(0.0);
  end.part.extent = Real(0.0);
  end.sign = Real(0.0);
  end.left = none;
  end.right = none;
  end.left_touched = none;
  end.right_touched = none;
  return end;
}

/// The same end with left and right exchanged: as the outline comes by on its way back.
FN TubeEnd turned_end(TubeEnd end) {
  TubeEnd turned = end;
  turned.left = end.right;
  turned.right = end.left;
  turned.left_touched = end.right_touched;
  turned.right_touched = end.left_touched;
  return turned;
}

/// One end. `center`, `away`: its centre and the unit direction out of it along the axis, shading
/// space; `first`: whether it is the one at Tube.from, through which the outline runs from right to
/// left; `whole`: whether this end is what points that are not beside the tube see.
FN_CALL TubeEnd tube_end(GIVEN(Tube) tube, GIVEN(TubeView) view, Vec3 center, Vec3 away, bool first,
                         Mask whole, GIVEN(Lobe) lobe) {
  Mask round = has_round_caps(tube);
  Real distance2 = dot(center, center);
  Vec3 direction = center * inversesqrt(max(distance2, Real(k_tiny)));
  Vec3 u = any_perpendicular(direction);
  Real radius = select(round, tangent_disk_radius(distance2, tube.radius), tube.radius);
  Vec3 a = select(round, u, view.w) * radius;
  Vec3 b = select(round, cross(direction, u), view.v) * radius;
  TubeEnd result;
  result.cone = make_cone(to_cosine(lobe, center), to_cosine(lobe, a), to_cosine(lobe, b));
  result.left_touched = to_cosine(lobe, center + view.left);
  result.right_touched = to_cosine(lobe, center + view.right);
  Real left = outline_parameter(result.cone, result.left_touched);
  Real right = outline_parameter(result.cone, result.right_touched);
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

/// Both ends of a tube.
struct TubeEnds {
  TubeEnd first;  ///< at Tube.from
  TubeEnd second; ///< at Tube.to
};

/// Those of a tube in the space that `lobe` leads to; see_from, see_to: see tube_end's `whole`.
FN TubeEnds tube_ends(Tube tube, TubeView view, Mask see_from, Mask see_to, Lobe lobe) {
  TubeEnds ends;
  ends.second = no_tube_end();
  for (int i = 0; i < 2; ++i) {
    bool first = i == 0;
    ends.first = ends.second;
    ends.second = tube_end(tube, view, first ? view.from : view.to, first ? -view.axis : view.axis,
                           first, first ? see_from : see_to, lobe);
  }
  return ends;
}

/// One end after the other, along the outline: that one first, and left what was right.
FN TubeEnds turned_ends(TubeEnds ends) {
  TubeEnds turned;
  turned.first = turned_end(ends.second);
  turned.second = turned_end(ends.first);
  return turned;
}

/// Some point where the outline crosses the plane with unit normal `front`, if it does. inside: a point within the
/// end that one sees who is not beside the tube; beside: 1 or 0.
FN Vec3 tube_crossing(TubeEnds ends, Mask beside, Vec3 inside, Vec3 front) {
  TubeEnds now = ends;
  Vec3 q = select(beside, ends.first.left, inside);
  for (int i = 0; i < 2; ++i) {
    q = select(now.first.sign != Real(0.0), arc_crossing(now.first.cone, now.first.part, front, q),
               q);
    now = turned_ends(now);
  }
  for (int j = 0; j < 2; ++j) {
    q = select(beside, edge_crossing(now.first.left, now.second.left, front, q), q);
    now = turned_ends(now);
  }
  return q;
}

/// Vector irradiance times 2 pi of a tube in the space that `lobe` leads to, by its outline; where
/// `cut`, of its part in front of the plane with unit normal `front` (that space).
FN_CALL Vec3 sum_tube_outline(GIVEN(Tube) tube, GIVEN(TubeView) view, GIVEN(Lobe) lobe, Vec3 front,
                              bool cut) {
  // Not beside the tube: in front of one of its ends.
  Mask see_from = sees_end(tube, view.from, dot(view.from, view.axis));
  Mask see_to = sees_end(tube, view.to, -dot(view.to, view.axis));
  TubeEnds ends = tube_ends(tube, view, see_from, see_to, lobe);
  Real edges = select(view.beside, Real(1.0), Real(0.0));
  Vec3 up = horizon_normal_cosine(lobe);
  Mask whole = cone_is_above(ends.first.cone, up) && cone_is_above(ends.second.cone, up);
  if (cut) {
    whole =
        whole && cone_is_above(ends.first.cone, front) && cone_is_above(ends.second.cone, front);
  }
  // The apex is on the side where the y axis comes closest to the tube's line: if it meets the tube,
  // it does so around there. A point that is not beside the tube sees one end alone.
  Real along = -(view.from.x * view.axis.x + view.from.z * view.axis.z) /
               max(view.axis.x * view.axis.x + view.axis.z * view.axis.z, Real(1.0e-12));
  Vec3 inside = select(see_from, ends.first.cone.e3, ends.second.cone.e3);
  Real y = select(view.beside, view.from.y + view.axis.y * along, inside.y);
  Real s = select(y < Real(0.0), Real(-1.0), Real(1.0));
  // Uniform shortcut: no lane needs to clip.
  bool clip = !all_lanes(whole);
  Vec3 q = inside;
  if (cut) {
    if (clip) {
      q = tube_crossing(ends, view.beside, inside, front);
    }
  }
  Vec3 all = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 clipped = all;
  // The edge from one end to the other and the arc around the one, then back again.
  for (int i = 0; i < 2; ++i) {
    Vec3 a = ends.first.left_touched;
    Vec3 b = ends.second.left_touched;
    all = all + edge_term(a, b, b - a) * edges +
          arc_term(ends.first.cone, ends.first.part) * ends.first.sign;
    if (clip) {
      // Between the very points where the arcs end, so that all is one closed outline.
      a = ends.first.left;
      b = ends.second.left;
      if (cut) {
        clipped = clipped + edge_in_front(a, b, q, up, front, s) * edges +
                  arc_in_front(ends.first.cone, ends.first.part, q, up, front, s) * ends.first.sign;
      } else {
        clipped = clipped + closed_edge_term(a, b, dot(up, a), dot(up, b), s) * edges +
                  clipped_arc_term(ends.first.cone, ends.first.part, up, s) * ends.first.sign;
      }
    }
    ends = turned_ends(ends);
  }
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
FN_CALL Vec3 sum_tube(GIVEN(Tube) tube, GIVEN(TubeView) view, GIVEN(Lobe) lobe, Vec3 front,
                      GIVEN(Heights) heights, bool cut) {
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
  Vec3 diffuse = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Vec3 specular = diffuse;
  Lobe now = cosine_lobe();
  for (int i = 0; i < 2; ++i) {
    diffuse = specular;
    specular = sum_tube(tube, view, now, front, heights, cut) * seen;
    now = lobe;
  }
  return light_integral(diffuse, specular, lobe, tube_outline2(tube, view, lobe));
}

/// Integrals over a tube seen from `position` (world space), for Lambert and for `lobe`. Zero
/// inside: it emits outwards.
FN LightIntegral integrate_tube(Tube tube, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_tube_part(tube, position, frame, lobe, Vec3(Real(0.0), Real(0.0), Real(1.0)),
                             no_heights(), false);
}
