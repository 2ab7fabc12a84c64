// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The integral of a lobe over a flat ellipse or disk, exact, clipped to both horizons: a cone in
// shading space for Lambert, and its image under M^-1 for the lobe. See cone.glsl.

/// A flat ellipse in world space; emits along half_u x half_v.
struct Ellipse {
  Vec3 center;    ///< world space
  Vec3 half_u;    ///< semi-axes, perpendicular, metres
  Vec3 half_v;    ///< the other one
  Real two_sided; ///< 0 or 1
};

/// Unit, to the emitting side.
FN Vec3 ellipse_normal(Ellipse ellipse) {
  Vec3 normal = cross(ellipse.half_u, ellipse.half_v);
  return normal * inversesqrt(max(dot(normal, normal), Real(k_tiny)));
}

/// Square metres.
FN Real ellipse_area(Ellipse ellipse) {
  Vec3 normal = cross(ellipse.half_u, ellipse.half_v);
  return sqrt(dot(normal, normal)) * k_pi;
}

/// 2 pi times the vector irradiances of a cone of directions.
struct ConeSums {
  Vec3 diffuse;  ///< in shading space, clipped to the horizon
  Vec3 specular; ///< in cosine space, clipped to both horizons
  Real outline2; ///< see light_concentration
};

/// Those of the cone of directions to a flat ellipse, all in shading space; where `cut`, of its part
/// in front of the plane with unit normal `front`.
FN ConeSums sum_ellipse_cone(Vec3 center, Vec3 u, Vec3 v, Lobe lobe, Vec3 front, bool cut) {
  ConeSums sums;
  sums.specular = Vec3(Real(0.0), Real(0.0), Real(0.0));
  Lobe now = cosine_lobe();
  for (int i = 0; i < 2; ++i) {
    Cone cone = make_cone(to_cosine(now, center), to_cosine(now, u), to_cosine(now, v));
    Vec3 up = horizon_normal_cosine(now);
    sums.diffuse = sums.specular;
    sums.outline2 = cone_outline2(cone);
    if (cut) {
      sums.specular = clipped_cone_in_front(cone, up, plane_normal_cosine(now, front));
    } else {
      sums.specular = clipped_cone(cone, up);
    }
    now = lobe;
  }
  return sums;
}

/// 1 where an ellipse, shading space, shines on the point, 0 elsewhere.
FN Real ellipse_side(Vec3 center, Vec3 u, Vec3 v, Real two_sided) {
  Vec3 normal = cross(u, v);
  Real h = dot(center, normal) * inversesqrt(max(dot(normal, normal), Real(k_tiny)));
  Real side = select(h < Real(0.0), Real(1.0), two_sided);
  side = select(lies_in_plane(h, center, Real(0.0)), Real(0.0), side);
  // Its highest point: an ellipse below the horizon gives nothing, rounding or not.
  Real reach = sqrt(u.z * u.z + v.z * v.z);
  return select(center.z + reach > Real(0.0), side, Real(0.0));
}

/// integrate_ellipse; where `cut`, over what is in front of the plane with unit normal `front`
/// (shading space).
FN LightIntegral integrate_ellipse_part(Ellipse ellipse, Vec3 position, Frame frame, Lobe lobe,
                                        Vec3 front, bool cut) {
  ASSERT_THAT(!cut || all_lanes(is_unit(front)));
  Vec3 center = to_shading(frame, ellipse.center - position);
  Vec3 u = to_shading(frame, ellipse.half_u);
  Vec3 v = to_shading(frame, ellipse.half_v);
  ConeSums sums = sum_ellipse_cone(center, u, v, lobe, front, cut);
  Real side = ellipse_side(center, u, v, ellipse.two_sided);
  return light_integral(sums.diffuse * side, sums.specular * side, lobe, sums.outline2);
}

/// Integrals over an ellipse seen from `position` (world space), for Lambert and for `lobe`. Zero
/// behind a one-sided ellipse and in the plane of any.
FN LightIntegral integrate_ellipse(Ellipse ellipse, Vec3 position, Frame frame, Lobe lobe) {
  return integrate_ellipse_part(ellipse, position, frame, lobe,
                                Vec3(Real(0.0), Real(0.0), Real(1.0)), false);
}

/// Of an ellipse over the plane through `position` with that unit normal, world space.
FN Heights ellipse_heights(Ellipse ellipse, Vec3 position, Vec3 normal) {
  Real middle = dot(normal, ellipse.center - position);
  Real u = dot(normal, ellipse.half_u);
  Real v = dot(normal, ellipse.half_v);
  Real reach = sqrt(u * u + v * v);
  Heights heights;
  heights.low = middle - reach;
  heights.high = middle + reach;
  return heights;
}

/// The integral over an ellipse with its specular part exact, but for what replaces its outline by arcs of circles.
FN_CALL LightIntegral exact_ellipse_integral(GIVEN(Surface) s, GIVEN(Ellipse) ellipse) {
  Vec3 center = to_shading(s.frame, ellipse.center - s.position);
  Vec3 u = to_shading(s.frame, ellipse.half_u);
  Vec3 v = to_shading(s.frame, ellipse.half_v);
  LightIntegral integral = exact_cone_integral(s, make_cone(center, u, v), 8);
  Real side = ellipse_side(center, u, v, ellipse.two_sided);
  integral.diffuse = integral.diffuse * side;
  integral.specular = integral.specular * side;
  integral.second = integral.second * side;
  return integral;
}

/// The integral over an ellipse as a surface sees it; see surface_polygon_integral.
FN LightIntegral surface_ellipse_integral(GIVEN(Surface) s, Ellipse ellipse) {
  Heights heights = no_heights();
  bool cut = false;
  if (s.tilted) {
    heights = ellipse_heights(ellipse, s.position, s.geometric);
    cut = any_lane(heights.low < Real(0.0));
  }
  if (s.exact && !cut) {
    return unless_in_plane(s, ellipse.center, ellipse_normal(ellipse),
                           exact_ellipse_integral(s, ellipse));
  }
  LightIntegral integral =
      integrate_ellipse_part(ellipse, s.position, s.frame, s.fitted.lobe, front_shading(s), cut);
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_ellipse_part(ellipse, s.position, s.frame, s.second, front_shading(s), cut));
  }
  if (s.exact) {
    // What a triangle cuts keeps the lobe.
    integral = lobe_where(heights.low < Real(0.0), integral, exact_ellipse_integral(s, ellipse));
  }
  if (cut) {
    integral = unless_hidden(s, heights, integral);
  }
  return unless_in_plane(s, ellipse.center, ellipse_normal(ellipse), integral);
}

/// Light that a surface reflects of an ellipse of radiance 1, without shadow.
FN ShadedLight shade_ellipse_parts(GIVEN(Surface) s, Ellipse ellipse) {
  return shade_integral(s, surface_ellipse_integral(s, ellipse));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_ellipse_parts, both together.
FN Vec3 shade_ellipse(GIVEN(Surface) s, Ellipse ellipse) {
  return both_parts(shade_ellipse_parts(s, ellipse));
}

/// Where a ray from `position` along the unit `direction` meets the ellipse. The density is that of
/// sample_ellipse_by_area.
FN LightPoint intersect_ellipse_by_area(Ellipse ellipse, Vec3 position, Vec3 direction) {
  ASSERT_THAT(is_unit(direction));
  Vec3 normal = ellipse_normal(ellipse);
  Vec3 to_center = ellipse.center - position;
  Real h = dot(to_center, normal);
  Real slope = dot(direction, normal);
  Real t = h / never_zero(slope);
  Vec3 on_plane = direction * t - to_center;
  Real x = dot(on_plane, ellipse.half_u) / max(dot(ellipse.half_u, ellipse.half_u), Real(k_tiny));
  Real y = dot(on_plane, ellipse.half_v) / max(dot(ellipse.half_v, ellipse.half_v), Real(k_tiny));
  LightPoint result = area_light_point(direction * t, normal, ellipse_area(ellipse),
                                       ellipse.two_sided, lies_in_plane(h, to_center, Real(0.0)));
  result.hit = result.hit && t > Real(0.0) && x * x + y * y <= Real(1.0);
  result.direction = direction;
  return result;
}

/// A point evenly distributed over the ellipse, from two numbers in [0, 1).
FN LightPoint sample_ellipse_by_area(Ellipse ellipse, Vec3 position, Vec2 u) {
  ASSERT_THAT(in_unit_square(u));
  Vec3 normal = ellipse_normal(ellipse);
  Real radius = sqrt(u.x);
  Real phi = Real(2.0) * k_pi * u.y;
  Vec3 to_center = ellipse.center - position;
  Vec3 offset =
      to_center + ellipse.half_u * (radius * cos(phi)) + ellipse.half_v * (radius * sin(phi));
  return area_light_point(offset, normal, ellipse_area(ellipse), ellipse.two_sided,
                          lies_in_plane(dot(to_center, normal), to_center, Real(0.0)));
}

/// How a point sees an ellipse, for sampling it by solid angle.
///
/// In the frame of the cone's axes, at azimuth phi, the ellipse reaches from the axis to the polar angle
/// with cot^2 = (c1/k1 cos phi)^2 + (c2/k2 sin phi)^2. Directions are even in 1 - cos between the two,
/// and phi is that of (cos t, ratio sin t) for an even t. For a small ellipse ratio = k2/k1 makes them
/// even over its solid angle; a large one has the ratio with which its density is right on both
/// axes, and in between it is within 5 in 100 of even. The density is known exactly everywhere, so
/// that estimates are right whatever it is; to make it even would take the inverse of elliptic
/// integrals (Guillen et al. 2017, "Area-Preserving Parameterizations for Spherical Ellipses").
struct SeenEllipse {
  Cone cone;   ///< world space
  Real cot2_1; ///< square of the cotangent of the half angle along e1
  Real cot2_2; ///< and along e2
  Real ratio;  ///< of the two axes by which the azimuth is drawn
  Mask known;  ///< whether single precision can place directions in it
  Mask sided;  ///< whether the point has a side of it
};

/// error2: square of the metres within which the position is known.
FN SeenEllipse ellipse_seen(Ellipse ellipse, Vec3 position, Real error2) {
  Vec3 to_center = ellipse.center - position;
  SeenEllipse seen;
  seen.sided = !lies_in_plane(dot(to_center, ellipse_normal(ellipse)), to_center, error2);
  seen.cone = make_cone(to_center, ellipse.half_u, ellipse.half_v);
  Real cot_1 = seen.cone.c1 / max(seen.cone.k1, Real(k_tiny));
  Real cot_2 = seen.cone.c2 / max(seen.cone.k2, Real(1.0e-6));
  seen.cot2_1 = cot_1 * cot_1;
  seen.cot2_2 = cot_2 * cot_2;
  seen.ratio = seen.cone.k2 / max(seen.cone.k1, Real(k_tiny)) *
               sqrt((Real(1.0) + seen.cone.c1) / (Real(1.0) + seen.cone.c2));
  seen.known = seen.cone.k2 > Real(0.02);
  return seen;
}

/// 1 - cos of the polar angle that the ellipse reaches to; cos2, sin2: of the azimuth.
FN Real ellipse_reach(SeenEllipse seen, Real cos2, Real sin2) {
  Real cot2 = seen.cot2_1 * cos2 + seen.cot2_2 * sin2;
  Real inv = Real(1.0) / (Real(1.0) + cot2);
  return inv / (Real(1.0) + sqrt(cot2 * inv));
}

/// 1 over the density per solid angle of sample_ellipse at that azimuth.
FN Real ellipse_solid_angle(SeenEllipse seen, Real cos2, Real sin2, Real reach) {
  return Real(2.0) * k_pi * reach * (seen.ratio * cos2 + sin2 / max(seen.ratio, Real(k_tiny)));
}

/// Where a ray meets an ellipse that is `known`, with the density of sample_ellipse.
FN LightPoint intersect_ellipse(Ellipse ellipse, SeenEllipse seen, Vec3 position, Vec3 direction) {
  LightPoint point = intersect_ellipse_by_area(ellipse, position, direction);
  Real x = dot(direction, seen.cone.e1);
  Real y = dot(direction, seen.cone.e2);
  Real sin2 = y * y / max(x * x + y * y, Real(k_tiny));
  Real cos2 = Real(1.0) - sin2;
  Real solid_angle = ellipse_solid_angle(seen, cos2, sin2, ellipse_reach(seen, cos2, sin2));
  point.hit = point.hit && seen.sided;
  point.solid_angle = select(seen.known, solid_angle, point.solid_angle);
  return point;
}

/// A point of the ellipse, from two numbers in [0, 1): by solid angle, or where that is not known
/// over its area.
FN LightPoint sample_ellipse(Ellipse ellipse, SeenEllipse seen, Vec3 position, Vec2 u) {
  LightPoint by_area = sample_ellipse_by_area(ellipse, position, u);
  by_area.hit = by_area.hit && seen.sided;
  // Uniform shortcut: no lane samples by solid angle.
  if (!any_lane(seen.known)) {
    return by_area;
  }
  Real t = Real(2.0) * k_pi * u.y;
  Real x = cos(t);
  Real y = seen.ratio * sin(t);
  Real inv_length = inversesqrt(max(x * x + y * y, Real(k_tiny)));
  x = x * inv_length;
  y = y * inv_length;
  Real reach = ellipse_reach(seen, x * x, y * y);
  Real one_minus_cos = u.x * reach;
  Real across = sqrt(max(one_minus_cos * (Real(2.0) - one_minus_cos), Real(0.0)));
  Vec3 direction = normalize(seen.cone.e3 * (Real(1.0) - one_minus_cos) +
                             seen.cone.e1 * (across * x) + seen.cone.e2 * (across * y));

  Vec3 normal = ellipse_normal(ellipse);
  Vec3 to_center = ellipse.center - position;
  Real h = dot(to_center, normal);
  Real slope = dot(direction, normal);
  LightPoint by_angle;
  by_angle.direction = direction;
  by_angle.distance = h / never_zero(slope);
  by_angle.cos_light = select(ellipse.two_sided > Real(0.0), abs(slope), -slope);
  by_angle.solid_angle = ellipse_solid_angle(seen, x * x, y * y, reach);
  by_angle.hit = by_angle.cos_light > Real(1.0e-6) && by_angle.distance > Real(0.0) &&
                 !lies_in_plane(h, to_center, Real(0.0)) && seen.sided;
  return select_point(seen.known, by_angle, by_area);
}

/// Density per solid angle with which sample_ellipse draws a unit direction.
FN Real pdf_ellipse(Ellipse ellipse, SeenEllipse seen, Vec3 position, Vec3 direction) {
  return pdf_of_point(intersect_ellipse(ellipse, seen, position, direction));
}
