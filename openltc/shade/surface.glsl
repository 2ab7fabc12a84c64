// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A shaded point: the reflectance equation for the lights of this project.
//
//   L_o = integral of (k_d c/pi + f_s) L_i cos_i,   f_s = D V F (GGX, Smith, Schlick).
//
// The diffuse part is what the specular one leaves, k_d = (1 - metallic)(1 - E_spec(wo)), with
// E_spec the specular albedo that comes with the lobe: it does not depend on wi, so Lambert stays a
// cosine and its polygon integral exact.
//
// The lobe integrates to 1 over the sphere and may reach below the surface, where no light comes
// from. f_s cos_i is therefore n1 F times the lobe divided by its share above the horizon: what
// light from all sides reflects is n1 F, the albedo, and nothing leaks. Of two lobes each has its own
// share above the horizon, and a weight of the whole.

/// A point of a surface, ready to be shaded by any light.
struct Surface {
  Vec3 position; ///< world space
  /// Square of the metres within which it is known; make_surface assumes single precision.
  Real position_error2;
  Frame frame;       ///< shading space
  Vec3 wo;           ///< shading space: (sin theta, 0, cos theta)
  Real alpha;        ///< microfacet width, roughness^2
  Vec3 diffuse;      ///< k_d c, albedo of the Lambertian part
  Vec3 f0;           ///< specular reflectance at normal incidence
  Vec3 f90;          ///< and at grazing incidence
  FittedLobe fitted; ///< the lobe for this roughness and view
  Vec3 specular;     ///< F0 n1 + (F90 - F0) n5, the specular albedo
  Real axis_weight;  ///< n5/n1 less Schlick's weight in the lobe's mean direction
  Real inv_share;    ///< weight of the lobe, 1 if it is the only one, over its share_above_horizon
  /// Whether there is a second lobe in any lane.
  bool two;
  Lobe second;           ///< the second lobe
  Real second_inv_share; ///< its weight over its share above the horizon
  /// Of the triangle, unit, world space, on the viewer's side; make_surface assumes the shading normal.
  Vec3 geometric;
  /// Whether the two differ in any lane: then what lies behind the triangle's plane is hidden by it.
  bool tilted;
  /// Whether lights take the BRDF's own value in their mean direction: see blended_ratio.
  bool corrected;
  Real max_ratio; ///< most that this may multiply a light by
  /// Whether the specular part of lights is GGX itself instead of the lobe: see exact/half_vector.glsl.
  bool exact;
  /// Whether polygons are that only where the lobes with their ratio err: see exact_amount.
  bool adaptive;
};

/// Schlick's weight at the microfacet that reflects wo, which has no y, into wi.
FN Real fresnel_weight(Vec3 wo, Vec3 wi) {
  return schlick_weight_between(wo.x * wi.x + wo.z * wi.z);
}

/// Prepares a point for shading. `fitted` is the lobe of alpha_from_roughness(roughness) and
/// dot(normal, wo_world), from a table or a polynomial. `normal` and `wo_world` are unit; `albedo`
/// is (1 - metallic) c.
FN_INLINE Surface make_surface(FittedLobe fitted, Vec3 position, Vec3 normal, Vec3 wo_world,
                               Vec3 albedo, Vec3 f0, Vec3 f90, Real roughness) {
  ASSERT_THAT(is_unit(normal) && is_unit(wo_world));
  Surface s;
  s.position = position;
  s.position_error2 = Real(k_position_rounding * k_position_rounding) * dot(position, position);
  s.frame = shading_frame(normal, wo_world);
  s.wo = Vec3(dot(s.frame.t1, wo_world), Real(0.0), dot(normal, wo_world));
  s.alpha = alpha_from_roughness(roughness);
  s.f0 = f0;
  s.f90 = f90;
  s.fitted = fitted;
  s.specular = specular_amplitude(fitted, f0, f90);
  s.inv_share = reciprocal(max(share_above_horizon(fitted.lobe), Real(k_min_share)));
  Vec3 mean = safe_direction(mean_above_horizon(fitted.lobe));
  s.axis_weight = fitted.n5 * reciprocal(max(fitted.n1, Real(k_tiny))) - fresnel_weight(s.wo, mean);
  Real taken = max(max(s.specular.x, s.specular.y), s.specular.z);
  s.diffuse = albedo * max(Real(1.0) - taken, Real(0.0));
  s.geometric = normal;
  s.two = false;
  s.second = fitted.lobe;
  s.second_inv_share = Real(0.0);
  s.tilted = false;
  s.corrected = false;
  s.max_ratio = Real(1.0);
  s.exact = false;
  s.adaptive = false;
  return s;
}

/// Adds a second lobe to what make_surface made.
FN Surface add_second_lobe(Surface s, SecondLobe second) {
  Real weight = min(max(second.weight, Real(0.0)), Real(1.0));
  Real first = Real(1.0) - weight;
  s.two = true;
  s.second = second.lobe;
  s.second_inv_share =
      weight * reciprocal(max(share_above_horizon(second.lobe), Real(k_min_share)));
  s.inv_share = first * s.inv_share;
  Vec3 mean = safe_direction(safe_direction(mean_above_horizon(s.fitted.lobe)) * first +
                             safe_direction(mean_above_horizon(second.lobe)) * weight);
  s.axis_weight =
      s.fitted.n5 * reciprocal(max(s.fitted.n1, Real(k_tiny))) - fresnel_weight(s.wo, mean);
  return s;
}

/// Density of all the lobes above the horizon, 1 over the hemisphere.
FN Real eval_lobes(GIVEN(Surface) s, Vec3 wi) {
  Real density = s.inv_share * eval_lobe(s.fitted.lobe, wi);
  if (s.two) {
    density = density + s.second_inv_share * eval_lobe(s.second, wi);
  }
  return density;
}

/// The share that a light fills of all that the lobes have above the horizon, 0..1.
FN Real filled_share(GIVEN(Surface) s, LightIntegral integral) {
  Real share = integral.specular * s.inv_share;
  if (s.two) {
    share = share + integral.second * s.second_inv_share;
  }
  return min(share, Real(1.0));
}

/// What an integral of GGX itself has for F = 1, 0..1: the table's n1, which it is given as a share of, is no bound
/// of it.
FN Real exact_light(GIVEN(Surface) s, LightIntegral integral) {
  Real share = integral.specular * s.inv_share + integral.second * s.second_inv_share;
  return min(s.fitted.n1 * share, Real(1.0));
}

/// The integrals over a light with those of the second lobe, from an integral of that one as if it were
/// the first. Mean direction and concentration are means, weighted by what each lobe has.
FN LightIntegral with_second_lobe(GIVEN(Surface) s, LightIntegral first, LightIntegral second) {
  Real a = first.specular * s.inv_share;
  Real b = second.specular * s.second_inv_share;
  Real inv = reciprocal(max(a + b, Real(k_tiny)));
  LightIntegral both = first;
  both.second = second.specular;
  both.first_direction = first.specular_direction;
  both.second_direction = second.specular_direction;
  both.specular_direction =
      safe_direction(first.specular_direction * (a * inv) + second.specular_direction * (b * inv));
  both.concentration = (first.concentration * a + second.concentration * b) * inv;
  return both;
}

/// Asks for the ratio at the mean direction: see blended_ratio.
FN Surface correct_at_mean(Surface s) {
  s.corrected = true;
  s.max_ratio = Real(k_max_ratio);
  return s;
}

/// Asks for GGX itself, and for the ratio at the mean direction where it cannot be had: round lights that a tilted
/// triangle cuts, and the mean of a light's picture.
FN Surface make_exact(Surface s) {
  s = correct_at_mean(s);
  s.exact = true;
  return s;
}

/// Asks for GGX itself, of small polygons at four points, but of large ones where the view does not graze: these the
/// lobes give nearly as well, times their ratio. Other shapes take no longer by GGX itself than by two lobes.
FN Surface make_adaptive(Surface s) {
  s = make_exact(s);
  s.adaptive = true;
  return s;
}

/// The same surface where no lane is GGX itself: one that asks its lobes alone.
FN Surface without_exact(Surface s) {
  s.exact = false;
  s.adaptive = false;
  return s;
}

/// Makes known the normal of the triangle that the point is on: unit, world space, on the viewer's side.
FN Surface set_geometric_normal(Surface s, Vec3 geometric) {
  ASSERT_THAT(is_unit(geometric));
  Vec3 d = geometric - s.frame.n;
  s.geometric = geometric;
  s.tilted = any_lane(dot(d, d) > Real(k_normal_rounding * k_normal_rounding));
  return s;
}

/// Whether the triangle hides a point at `offset` from the shaded one, world space: it lies behind the
/// triangle's plane, or in it as far as the shaded point is known. Nothing is hidden where the normals do
/// not differ; there the horizon does it.
FN Mask hidden_by_triangle(GIVEN(Surface) s, Vec3 offset) {
  if (!s.tilted) {
    return Real(1.0) < Real(0.0);
  }
  Real height = dot(s.geometric, offset);
  return height <= Real(0.0) || height * height <= s.position_error2;
}

/// Whether the point has a side of a flat light, whose plane holds `origin`: not on the emitter itself
/// or on a wall flush with it, as far as its position is known. Without a side there is no light.
FN Mask has_side(GIVEN(Surface) s, Vec3 origin, Vec3 normal) {
  Vec3 to_origin = origin - s.position;
  return !lies_in_plane(dot(to_origin, normal), to_origin, s.position_error2);
}

/// An integral without what lanes have without a side of a flat light.
FN_INLINE LightIntegral unless_in_plane(GIVEN(Surface) s, Vec3 origin, Vec3 normal,
                                        LightIntegral integral) {
  Mask sided = has_side(s, origin, normal);
  integral.diffuse = select(sided, integral.diffuse, Real(0.0));
  integral.specular = select(sided, integral.specular, Real(0.0));
  integral.second = select(sided, integral.second, Real(0.0));
  return integral;
}

/// An integral without what lanes have that see nothing of the light in front of the triangle's plane.
FN LightIntegral unless_hidden(GIVEN(Surface) s, Heights heights, LightIntegral integral) {
  Mask seen = heights.high > Real(0.0) && heights.high * heights.high > s.position_error2;
  integral.diffuse = select(seen, integral.diffuse, Real(0.0));
  integral.specular = select(seen, integral.specular, Real(0.0));
  integral.second = select(seen, integral.second, Real(0.0));
  return integral;
}

/// A part of the hemisphere reflects no more than the whole, s.specular.
FN Vec3 within_albedo(GIVEN(Surface) s, Vec3 part) {
  return Vec3(min(part.x, s.specular.x), min(part.y, s.specular.y), min(part.z, s.specular.z));
}

/// The normal of the triangle in shading space.
FN Vec3 front_shading(GIVEN(Surface) s) { return to_shading(s.frame, s.geometric); }

/// The share `filled` of n1 with this weight of F90 over F0, within the albedo.
FN Vec3 reflectance_of_weight(GIVEN(Surface) s, Real weight, Real filled) {
  Vec3 fresnel = s.f0 + (s.f90 - s.f0) * min(max(weight, Real(0.0)), Real(1.0));
  return within_albedo(s, fresnel * (s.fitted.n1 * filled));
}

/// What a light that fills this share of the lobe has of Schlick's weight beyond that in its mean
/// direction: all of the whole lobe's, axis_weight, for one that fills it, and by the square of the share
/// less for others, since it comes from the lobe's rim, which a light around its middle does not reach.
FN Real weight_of_rim(GIVEN(Surface) s, Real share) { return share * share * s.axis_weight; }

/// Schlick's weight in the light of a share of what the lobe has above the horizon, 0..1, which comes from around
/// wi.
///
/// F0 n1 + (F90 - F0) n5 is the albedo of the whole lobe. Spread evenly over it, it gives light far
/// from the mirror direction the Fresnel reflectance of the mirror direction: twice too much and
/// more on a dielectric seen at an angle. So Schlick's weight is taken at wi instead, plus weight_of_rim:
/// exact for a small light, w(wi), and for one that fills the hemisphere, n5/n1.
FN Real part_weight(GIVEN(Surface) s, Vec3 wi, Real share) {
  return fresnel_weight(s.wo, wi) + weight_of_rim(s, share);
}

/// The reflectance of such a part by the lobe itself.
FN Vec3 specular_reflectance(GIVEN(Surface) s, Vec3 wi, Real share) {
  return reflectance_of_weight(s, part_weight(s, wi, share), share);
}

/// What the specular part of a light is multiplied by so that a small one is exact: near its mean
/// direction wi the BRDF is larger than the lobe by
///   r = rho / (n1 D),  rho = D V cos of GGX, D the lobe's density above the horizon.
/// A light that fills the whole lobe has n1 whatever its shape, so 1 is right for that. Between the two,
/// with w the light's concentration times what it leaves of the lobe, their harmonic mean
///   1 / (1 - w + w / r):
/// at most 1 / (1 - w), so that a quotient of two small numbers does no harm where a light is large, and
/// nearly r where the lobe glows and the BRDF does not. It is not additive: see docs/method.md.
FN Real blended_ratio(GIVEN(Surface) s, Vec3 wi, Real w) {
  Real lobe = s.fitted.n1 * eval_lobes(s, wi);
  Real rho = min(eval_ggx_scale(s.wo, wi, s.alpha), s.max_ratio * lobe);
  // 1 where both vanish.
  return (rho + Real(k_tiny)) * reciprocal(max(rho + w * (lobe - rho), Real(0.0)) + Real(k_tiny));
}

/// The weight of the BRDF in that: of a light that fills `share` of the lobe.
FN Real ratio_weight(LightIntegral integral, Real share) {
  return integral.concentration * max(Real(1.0) - share, Real(0.0));
}

/// Reflected light of a light of radiance 1.
struct ShadedLight {
  Vec3 diffuse;  ///< by the Lambertian part
  Vec3 specular; ///< by the lobe
};

/// Their sum.
FN Vec3 both_parts(ShadedLight shaded) { return shaded.diffuse + shaded.specular; }

/// What the n1 of a table may be off by, of itself: 5 % at 89 degrees from the normal.
CONSTANT k_error_of_n1 = 0.06;

/// Reflectance by GGX itself of what it has for F = 1, with this weight of F90 over F0: no more than the albedo with
/// what the table's n1 may be off by, nor than the base leaves.
FN Vec3 exact_reflectance(GIVEN(Surface) s, Real weight, Real light) {
  Vec3 fresnel = s.f0 + (s.f90 - s.f0) * min(max(weight, Real(0.0)), Real(1.0));
  Vec3 exact = fresnel * light;
  Vec3 most = s.specular + s.f0 * (s.fitted.n1 * Real(k_error_of_n1));
  return Vec3(min(exact.x, min(most.x, Real(1.0) - s.diffuse.x)),
              min(exact.y, min(most.y, Real(1.0) - s.diffuse.y)),
              min(exact.z, min(most.z, Real(1.0) - s.diffuse.z)));
}

/// Light of radiance 1 whose specular part has this weight of F90 over F0, and the share `filled` of n1; where the
/// integral is that of GGX itself, its own.
FN_INLINE ShadedLight shade_filled(GIVEN(Surface) s, LightIntegral integral, Real weight,
                                   Real filled) {
  ShadedLight shaded;
  shaded.diffuse = s.diffuse * integral.diffuse;
  shaded.specular = reflectance_of_weight(s, weight, filled);
  if (s.exact) {
    Vec3 exact = exact_reflectance(s, integral.weight, exact_light(s, integral));
    shaded.specular = select(integral.weight >= Real(0.0), exact, shaded.specular);
  }
  return shaded;
}

/// Light of radiance 1 in closed form, without shadow: its diffuse and its specular part.
FN ShadedLight shade_integral(GIVEN(Surface) s, LightIntegral integral) {
  Real share = filled_share(s, integral);
  if (s.exact) {
    // Uniform shortcut: no lane's light is that of a lobe.
    if (all_lanes(integral.weight >= Real(0.0))) {
      return shade_filled(s, integral, integral.weight, share);
    }
  }
  Real filled = share;
  if (s.corrected) {
    Real w = ratio_weight(integral, share);
    filled = min(share * blended_ratio(s, integral.specular_direction, w), Real(1.0));
  }
  return shade_filled(s, integral, part_weight(s, integral.specular_direction, share), filled);
}

/// The BRDF times cos_i for a direction of shading space: what the reference integrates. Exact but
/// for k_d, whose definition holds the table's albedo.
FN Vec3 eval_surface(GIVEN(Surface) s, Vec3 wi_shading) {
  return s.diffuse * eval_lambert(wi_shading) + eval_ggx(s.wo, wi_shading, s.alpha, s.f0, s.f90);
}

/// The LTC approximation of eval_surface, the limit of shade_polygon for a small light: Fresnel
/// times n1 times the lobe's density above the horizon (docs/method.md, section 9).
FN Vec3 eval_surface_ltc(GIVEN(Surface) s, Vec3 wi_shading) {
  // Clipped to the surface's horizon like the polygon integral.
  Real density = select(wi_shading.z > Real(0.0), eval_lobes(s, wi_shading), Real(0.0));
  Vec3 fresnel = s.f0 + (s.f90 - s.f0) * fresnel_weight(s.wo, wi_shading);
  return s.diffuse * eval_lambert(wi_shading) + fresnel * (s.fitted.n1 * density);
}

/// Probability with which sample_surface draws from GGX rather than from the cosine.
FN Real specular_probability(GIVEN(Surface) s) {
  Real specular = max(max(s.specular.x, s.specular.y), s.specular.z);
  Real diffuse = max(max(s.diffuse.x, s.diffuse.y), s.diffuse.z);
  // Neither technique may starve while it has something to find.
  Real p = specular / max(specular + diffuse, Real(k_tiny));
  return select(diffuse > Real(0.0), min(max(p, Real(0.1)), Real(0.9)), Real(1.0));
}

/// Direction of shading space drawn from the BRDF; u.x also chooses between its two parts.
FN Vec3 sample_surface(GIVEN(Surface) s, Vec2 u) {
  Real p = specular_probability(s);
  Mask specular = u.x < p;
  Real x = select(specular, u.x / p, (u.x - p) / max(Real(1.0) - p, Real(1.0e-6)));
  Vec2 v = Vec2(min(max(x, Real(0.0)), Real(0.99999994)), u.y);
  return select(specular, sample_ggx(s.wo, s.alpha, v), sample_lambert(v));
}

/// Density of sample_surface per solid angle.
FN Real pdf_surface(GIVEN(Surface) s, Vec3 wi_shading) {
  Real p = specular_probability(s);
  return p * pdf_ggx(s.wo, wi_shading, s.alpha) + (Real(1.0) - p) * pdf_lambert(wi_shading);
}
