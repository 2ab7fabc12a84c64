// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The surface of a tube: its area, what it emits as seen from afar, and points of it: met by a ray, drawn
// from its area, and drawn by the solid angle that it fills, with their densities.

/// Area of the emitting surface, square metres.
FN Real tube_area(Tube tube) {
  Vec3 axis = tube.to - tube.from;
  Real side = Real(2.0) * k_pi * tube.radius * sqrt(dot(axis, axis));
  // Two disks, or two hemispheres.
  return side + Real(2.0) * k_pi * tube.radius * tube.radius * tube.caps;
}

/// Mean of the emission cos^power over what one sees of a tube from afar, by projected area; `toward`
/// is the unit direction to it. side_mean: that of its side seen at a right angle to the axis.
///
/// With g the angle to the axis, the side shows 2 r l sin g, its cosines sin g times those at a right
/// angle; a round end pi r^2 of a sphere, whose mean is 2 / (power + 2); a flat one pi r^2 cos g at
/// the cosine cos g.
FN Real tube_emission(Tube tube, Vec3 toward, Real power, Real side_mean) {
  Vec3 axis = tube.to - tube.from;
  Real length2 = max(dot(axis, axis), Real(k_tiny));
  Real cos_axis = min(abs(dot(axis, toward)) * inversesqrt(length2), Real(1.0));
  Real sin_axis = sqrt(max(Real(1.0) - cos_axis * cos_axis, Real(0.0)));
  Real side = Real(2.0) * sqrt(length2) * sin_axis;
  Mask round = has_round_caps(tube);
  Mask closed = has_caps(tube);
  Real end = select(closed, k_pi * tube.radius * select(round, Real(1.0), cos_axis), Real(0.0));
  Real end_mean = select(round, Real(2.0) / (power + Real(2.0)), cosine_emission(cos_axis, power));
  Real sum = side * side_mean * cosine_emission(sin_axis, power) + end * end_mean;
  return sum / max(side + end, Real(k_tiny));
}

/// Whether `position`, world space, is inside of a tube or on it.
FN Mask inside_tube(Tube tube, Vec3 position) {
  Vec3 d = position - tube.from;
  Vec3 axis = tube.to - tube.from;
  Real length2 = max(dot(axis, axis), Real(k_tiny));
  Real along = dot(d, axis) / length2;
  Mask between = along >= Real(0.0) && along <= Real(1.0);
  Mask round = has_round_caps(tube);
  Real nearest = min(max(along, Real(0.0)), Real(1.0));
  Vec3 off = d - axis * select(round, nearest, along);
  return dot(off, off) <= tube.radius * tube.radius && (round || between);
}

/// Where a ray from `position` along the unit `direction` meets the tube from outside. The density
/// is that of sample_tube_by_area.
FN_CALL LightPoint intersect_tube_by_area(GIVEN(Tube) tube, Vec3 position, Vec3 direction) {
  ASSERT_THAT(tube.radius >= Real(0.0));
  ASSERT_THAT(is_unit(direction));
  Vec3 from = tube.from - position;
  Vec3 to = tube.to - position;
  Vec3 axis = safe_direction(to - from);
  Real slope = dot(direction, axis);
  Real r2 = tube.radius * tube.radius;
  Vec3 foot = from - axis * dot(from, axis);
  Vec3 across = direction - axis * slope;
  Real a = max(dot(across, across), Real(1.0e-12));
  Vec3 c = cross(across, foot);
  Real root2 = a * r2 - dot(c, c);
  Real t_side = (dot(across, foot) - sqrt(max(root2, Real(0.0)))) / a;
  Real along = dot(direction * t_side - from, axis);
  Mask on_side = root2 > Real(0.0) && t_side > Real(0.0) && along >= Real(0.0) &&
                 along <= dot(to - from, axis);
  Vec3 side_normal = (direction * t_side - from - axis * along) / tube.radius;

  // The end that the ray comes to: of a disk the one that faces it, of a ball the one beyond which it
  // enters the infinite cylinder.
  Mask round = has_round_caps(tube);
  Mask first = (round && along < Real(0.0)) || (!round && slope > Real(0.0));
  Vec3 end = select(first, from, to);
  Vec3 out_of_end = select(first, -axis, axis);
  Real t_disk = dot(end, axis) / never_zero(slope);
  Vec3 off = direction * t_disk - end;
  Mask on_disk = slope != Real(0.0) && dot(off, off) <= r2;
  Real b = dot(direction, end);
  Vec3 miss = end - direction * b;
  Real chord2 = r2 - dot(miss, miss);
  Real t_ball = b - sqrt(max(chord2, Real(0.0)));
  Vec3 ball_normal = (direction * t_ball - end) / tube.radius;
  Mask on_ball = chord2 > Real(0.0) && dot(ball_normal, out_of_end) >= Real(0.0);
  Mask closed = has_caps(tube);
  Mask on_end = closed && ((round && on_ball) || (!round && on_disk));

  Real t = select(on_side, t_side, select(round, t_ball, t_disk));
  Vec3 normal = select(on_side, side_normal, select(round, ball_normal, out_of_end));
  LightPoint result = area_light_point(direction * t, normal, tube_area(tube), Real(0.0),
                                       inside_tube(tube, position));
  result.hit = result.hit && t > Real(0.0) && (on_side || on_end);
  result.direction = direction;
  return result;
}

/// A point evenly distributed over the tube's surface, from two numbers in [0, 1). Half of them lie
/// on the far side and do not count as hit.
FN_CALL LightPoint sample_tube_by_area(GIVEN(Tube) tube, Vec3 position, Vec2 u) {
  ASSERT_THAT(tube.radius >= Real(0.0));
  ASSERT_THAT(in_unit_square(u));
  Vec3 from = tube.from - position;
  Vec3 span = tube.to - tube.from;
  Real length2 = max(dot(span, span), Real(k_tiny));
  Vec3 axis = span * inversesqrt(length2);
  Vec3 e1 = any_perpendicular(axis);
  Vec3 e2 = cross(axis, e1);
  Real phi = Real(2.0) * k_pi * u.y;
  Vec3 around = e1 * cos(phi) + e2 * sin(phi);
  Real area = tube_area(tube);
  Real side_share = Real(2.0) * k_pi * tube.radius * sqrt(length2) / max(area, Real(k_tiny));
  Mask on_side = u.x < side_share;
  // What is left of u.x: along the side, or -1..1 from one end to the other.
  Real x = u.x / max(side_share, Real(1.0e-12));
  Real y = min((u.x - side_share) / max(Real(1.0) - side_share, Real(1.0e-7)), Real(1.0));
  y = Real(2.0) * max(y, Real(0.0)) - Real(1.0);
  Mask round = has_round_caps(tube);
  // Of a sphere's surface the height is evenly distributed, of a disk's the square of the radius.
  Real height = abs(y);
  Real ring = sqrt(max(Real(1.0) - select(round, height * height, height), Real(0.0)));
  Vec3 out_of_end = select(y < Real(0.0), -axis, axis);
  Vec3 ball = around * ring + out_of_end * height;
  Vec3 end = select(y < Real(0.0), from, from + span);
  Vec3 offset = select(on_side, from + span * x + around * tube.radius,
                       end + select(round, ball, around * ring) * tube.radius);
  Vec3 normal = select(on_side, around, select(round, ball, out_of_end));
  return area_light_point(offset, normal, area, Real(0.0), inside_tube(tube, position));
}

/// How a point sees a tube, for sampling it by solid angle.
///
/// Seen along the tube's axis, its side fills the azimuths up to psi = asin(radius / distance) to
/// either side of the axis, for planes that touch a cylinder hold the axis' direction. At each
/// azimuth it lies at a distance of its own from the parallel through the point, and fills an
/// interval of sines over that: azimuths and sines are an equal-area map of directions. A direction
/// is even in the azimuth and then in the sine. Round ends are drawn as their balls, a flat one that
/// faces the point as a disk; each part with the share that its solid angle has, roughly. The
/// density is exact, the sum over what may have drawn a direction, within a factor of 5 of even where
/// round ends are drawn twice. (Gamito 2016, "Solid Angle
/// Sampling of Disk and Cylinder Lights", bounds a cylinder by a rectangle and throws away what
/// misses.)
struct SeenTube {
  Vec3 axis;     ///< orthonormal, world space: along the tube,
  Vec3 toward;   ///< to the foot of the perpendicular on the axis,
  Vec3 across;   ///< and axis x toward
  Real distance; ///< of the axis, metres
  Real radius;   ///< metres
  Real tangent2; ///< square of the distance at which planes through the point touch
  Real from;     ///< places of the ends along the axis, from the foot
  Real to;       ///< and of the other end
  Real psi; ///< half of the azimuths that the side fills, radians; 0 where the side is not seen
  Real side_share;       ///< of all samples, of the side
  Real end_share;        ///< of the end at `from`, or of the flat end that faces the point
  Real other_share;      ///< of the other round end
  SeenSphere from_ball;  ///< the ball of the end at `from`
  SeenSphere to_ball;    ///< and of the other one
  Mask round;            ///< whether the ends are balls
  Mask sees_disk;        ///< whether a flat end faces the point
  Ellipse disk;          ///< that end
  SeenEllipse seen_disk; ///< as the point sees it
  Mask known;            ///< whether single precision can place directions on it
};

/// The sines over the plane across the axis between which the side lies, at an azimuth.
struct TubeInterval {
  Real low;  ///< -1..1
  Real high; ///< not below `low`, to 1
};

/// Those at the azimuth psi from the axis, by its sine and cosine.
FN TubeInterval tube_interval(SeenTube seen, Real sin_psi, Real cos_psi) {
  Real off = seen.distance * sin_psi;
  // D cos psi - sqrt(r^2 - off^2), the nearer of two crossings, of which the product does not cancel.
  Real root = sqrt(max(seen.radius * seen.radius - off * off, Real(0.0)));
  Real depth = seen.tangent2 / max(seen.distance * cos_psi + root, Real(k_tiny));
  Real depth2 = max(depth * depth, Real(k_tiny));
  TubeInterval interval;
  interval.low = seen.from * inversesqrt(seen.from * seen.from + depth2);
  interval.high = seen.to * inversesqrt(seen.to * seen.to + depth2);
  return interval;
}

/// What `position`, world space, sees of a tube.
FN_CALL SeenTube tube_seen(GIVEN(Tube) tube, Vec3 position) {
  ASSERT_THAT(tube.radius >= Real(0.0));
  SeenTube seen;
  Vec3 from = tube.from - position;
  Vec3 to = tube.to - position;
  seen.axis = safe_direction(to - from);
  seen.from = dot(from, seen.axis);
  seen.to = dot(to, seen.axis);
  Vec3 foot = from - seen.axis * seen.from;
  Real distance2 = dot(foot, foot);
  Mask on_axis = distance2 <= Real(k_tiny);
  seen.toward = select(on_axis, any_perpendicular(seen.axis),
                       foot * inversesqrt(max(distance2, Real(k_tiny))));
  seen.across = cross(seen.axis, seen.toward);
  seen.distance = sqrt(distance2);
  seen.radius = tube.radius;
  seen.tangent2 = max((seen.distance - tube.radius) * (seen.distance + tube.radius), Real(0.0));
  Real tangent = sqrt(seen.tangent2);
  seen.psi = select(tangent > Real(0.0), angle_of(tangent, tube.radius), Real(0.0));

  // Half of what it has in the middle and half of what it has at its rims.
  TubeInterval middle = tube_interval(seen, Real(0.0), Real(1.0));
  Real rim2 = max(seen.tangent2, Real(k_tiny));
  Real rims = seen.to * inversesqrt(seen.to * seen.to + rim2) -
              seen.from * inversesqrt(seen.from * seen.from + rim2);
  Real side = seen.psi * (middle.high - middle.low + rims);
  Real end = Real(0.0);
  Real other = Real(0.0);
  Sphere ball;
  ball.radius = tube.radius;
  ball.center = tube.from;
  seen.from_ball = sphere_seen(ball, position);
  ball.center = tube.to;
  seen.to_ball = sphere_seen(ball, position);
  seen.round = has_round_caps(tube);
  end = select(seen.round, Real(2.0) * k_pi * seen.from_ball.one_minus_cos, end);
  other = select(seen.round, Real(2.0) * k_pi * seen.to_ball.one_minus_cos, other);

  Mask beyond_to = seen.to < Real(0.0);
  seen.disk.center = select(beyond_to, tube.to, tube.from);
  seen.disk.half_u = seen.toward * tube.radius;
  seen.disk.half_v = seen.across * tube.radius;
  seen.disk.two_sided = Real(1.0);
  seen.sees_disk = has_caps(tube) && !seen.round && (seen.from > Real(0.0) || beyond_to);
  // Uniform shortcut: no lane sees a flat end.
  if (any_lane(seen.sees_disk)) {
    seen.seen_disk = ellipse_seen(seen.disk, position, Real(0.0));
    Real mid = Real(0.5);
    end = select(
        seen.sees_disk && seen.seen_disk.known,
        ellipse_solid_angle(seen.seen_disk, mid, mid, ellipse_reach(seen.seen_disk, mid, mid)),
        end);
  }
  Real all = side + end + other;
  Real inv_all = Real(1.0) / max(all, Real(k_tiny));
  seen.side_share = side * inv_all;
  seen.end_share = end * inv_all;
  seen.other_share = other * inv_all;
  // A flat end too narrow for its directions leaves all to the area.
  seen.known = all > Real(1.0e-4) && tube.radius > Real(0.003) * seen.distance &&
               !(seen.sees_disk && end <= Real(0.0));
  return seen;
}

/// Density per solid angle with which sample_tube draws a unit direction.
FN_CALL Real tube_density(GIVEN(SeenTube) seen, Vec3 position, Vec3 direction) {
  Real along = dot(direction, seen.axis);
  Real x = dot(direction, seen.toward);
  Real y = dot(direction, seen.across);
  Real inv_across = inversesqrt(max(x * x + y * y, Real(k_tiny)));
  Real cos_psi = x * inv_across;
  Real sin_psi = y * inv_across;
  TubeInterval interval = tube_interval(seen, sin_psi, cos_psi);
  Mask on_side = seen.psi > Real(0.0) && cos_psi > Real(0.0) &&
                 abs(sin_psi) * seen.distance <= seen.radius && along >= interval.low &&
                 along <= interval.high;
  Real side_angle = Real(2.0) * seen.psi * (interval.high - interval.low);
  Real density = select(on_side, seen.side_share / max(side_angle, Real(k_tiny)), Real(0.0));
  // |direction - axis|^2 = 2 (1 - cos), exact where the cosine itself is not.
  Vec3 d = direction - seen.from_ball.axis;
  Mask on_from = seen.round && Real(0.5) * dot(d, d) <= seen.from_ball.one_minus_cos;
  d = direction - seen.to_ball.axis;
  Mask on_to = seen.round && Real(0.5) * dot(d, d) <= seen.to_ball.one_minus_cos;
  Real turn = Real(2.0) * k_pi;
  density = density +
            select(on_from, seen.end_share / max(turn * seen.from_ball.one_minus_cos, Real(k_tiny)),
                   Real(0.0));
  density = density +
            select(on_to, seen.other_share / max(turn * seen.to_ball.one_minus_cos, Real(k_tiny)),
                   Real(0.0));
  // Uniform shortcut: no lane sees a flat end.
  if (any_lane(seen.sees_disk)) {
    LightPoint on_disk = intersect_ellipse(seen.disk, seen.seen_disk, position, direction);
    density = density + select(seen.sees_disk && on_disk.hit,
                               seen.end_share / max(on_disk.solid_angle, Real(k_tiny)), Real(0.0));
  }
  return density;
}

/// Where a ray meets the tube, with the density of sample_tube.
FN LightPoint intersect_tube(Tube tube, SeenTube seen, Vec3 position, Vec3 direction) {
  LightPoint point = intersect_tube_by_area(tube, position, direction);
  // Uniform shortcut: no lane samples by solid angle.
  if (!any_lane(seen.known)) {
    return point;
  }
  Real density = tube_density(seen, position, direction);
  point.solid_angle =
      select(seen.known, Real(1.0) / max(density, Real(1.0e-12)), point.solid_angle);
  point.hit = point.hit && (!seen.known || density > Real(0.0));
  return point;
}

/// A point of the tube, from two numbers in [0, 1): by solid angle, or where that is not known over
/// its area.
FN_CALL LightPoint sample_tube(GIVEN(Tube) tube, GIVEN(SeenTube) seen, Vec3 position, Vec2 u) {
  LightPoint by_area = sample_tube_by_area(tube, position, u);
  // Uniform shortcut: no lane samples by solid angle.
  if (!any_lane(seen.known)) {
    return by_area;
  }
  // A part by its share, and what is left of the number.
  Mask on_side = u.x < seen.side_share;
  Real sides_and_end = seen.side_share + seen.end_share;
  Mask on_end = !on_side && u.x < sides_and_end;
  Real before = select(on_side, Real(0.0), select(on_end, seen.side_share, sides_and_end));
  Real share = select(on_side, seen.side_share, select(on_end, seen.end_share, seen.other_share));
  Real x = min(max((u.x - before) / max(share, Real(k_tiny)), Real(0.0)), Real(1.0));

  Real psi = seen.psi * (Real(2.0) * u.y - Real(1.0));
  Real sin_psi = sin(psi);
  Real cos_psi = cos(psi);
  TubeInterval interval = tube_interval(seen, sin_psi, cos_psi);
  Real along = interval.low + (interval.high - interval.low) * x;
  Real cos_along = sqrt(max(Real(1.0) - along * along, Real(0.0)));
  Vec3 direction =
      seen.axis * along + seen.toward * (cos_along * cos_psi) + seen.across * (cos_along * sin_psi);

  Sphere ball;
  ball.radius = tube.radius;
  ball.center = select(on_end, tube.from, tube.to);
  Vec3 to_ball = sample_sphere(ball, sphere_seen(ball, position), Vec2(x, u.y)).direction;
  direction = select(seen.round && !on_side, to_ball, direction);
  // Uniform shortcut: no lane sees a flat end.
  if (any_lane(seen.sees_disk)) {
    Vec3 to_disk = sample_ellipse(seen.disk, seen.seen_disk, position, Vec2(x, u.y)).direction;
    direction = select(seen.sees_disk && !on_side, to_disk, direction);
  }
  direction = normalize(direction);
  return select_point(seen.known, intersect_tube(tube, seen, position, direction), by_area);
}

/// Density per solid angle with which sample_tube draws a unit direction.
FN Real pdf_tube(Tube tube, SeenTube seen, Vec3 position, Vec3 direction) {
  return pdf_of_point(intersect_tube(tube, seen, position, direction));
}
