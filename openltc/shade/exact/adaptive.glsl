// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polygons of an adaptive surface: a few points of GGX, GGX itself along the outline, or lobes times their ratio,
// whichever is exact enough for the least, and mixtures of them so that nothing steps. All of them are the same
// integral.

/// Cosine of the view angle from which on no light is GGX itself on an adaptive dielectric,
CONSTANT k_lobes_cos = 0.4;
/// how much later that is on a white metal, where more is seen of it,
CONSTANT k_lobes_cos_of_f0 = 0.26;
/// and 1 over what lies between that and where large lights are nothing else.
CONSTANT k_inv_exact_cos_range = 5.0;
/// Angular radius of a light, over how far half vectors turn before the distribution falls, up to which none is,
CONSTANT k_large_light = 0.5;
/// and 1 over what lies between that and where all of it is.
CONSTANT k_inv_large_light_range = 2.0;
/// Cosine of the view angle below which smaller lights are, too: at a twentieth less all that are too large for
/// points,
CONSTANT k_grazing_cos = 0.35;
/// and 1 over that twentieth.
CONSTANT k_inv_grazing_range = 20.0;

/// How much of a light is to be GGX itself along its outline on an adaptive surface, 0..1, of that centre, shading
/// space, and radius: large lights where the view grazes, and all too large for points where it grazes more.
/// What the lobes do not know of the distribution shows there.
FN Real exact_amount(GIVEN(Surface) s, Vec3 center, Real radius) {
  Real f0 = max(max(s.f0.x, s.f0.y), s.f0.z);
  Real lobes_cos = Real(k_lobes_cos) + Real(k_lobes_cos_of_f0) * f0;
  Real grazing = (lobes_cos - s.wo.z) * Real(k_inv_exact_cos_range);
  Real inv_length = inverse_length(center);
  Real square = turn_square(s, center * inv_length);
  Real reach = radius * inv_length * inversesqrt(max(square, Real(k_tiny)));
  Real large = (reach - Real(k_large_light)) * Real(k_inv_large_light_range);
  large = large + max((Real(k_grazing_cos) - s.wo.z) * Real(k_inv_grazing_range), Real(0.0));
  return min(max(min(grazing, large), Real(0.0)), Real(1.0));
}

/// The lobes' integral, times their ratio, as far as it is not that amount of the exact one: an exact one where
/// there is any amount, and else the lobes' own.
FN LightIntegral blend_exact(GIVEN(Surface) s, LightIntegral lobes, LightIntegral exact,
                             Real amount) {
  Real rest = Real(1.0) - amount;
  Real share = filled_share(s, lobes);
  Real ratio = blended_ratio(s, lobes.specular_direction, ratio_weight(lobes, share));
  Real of_lobes = s.fitted.n1 * min(share * ratio, Real(1.0)) * rest;
  Real of_exact = exact_light(s, exact) * amount;
  Real both = of_lobes + of_exact;
  Real inv = reciprocal(max(both, Real(k_tiny)));
  LightIntegral blend;
  blend.diffuse = lobes.diffuse * rest + exact.diffuse * amount;
  blend.diffuse_direction =
      safe_direction(lobes.diffuse_direction * rest + exact.diffuse_direction * amount);
  blend.specular = both / max(s.fitted.n1 * (s.inv_share + s.second_inv_share), Real(k_tiny));
  blend.second = blend.specular;
  blend.specular_direction = safe_direction(lobes.specular_direction * (of_lobes * inv) +
                                            exact.specular_direction * (of_exact * inv));
  blend.first_direction = blend.specular_direction;
  blend.second_direction = blend.specular_direction;
  blend.concentration = Real(0.0);
  Real weight = max(part_weight(s, lobes.specular_direction, share), Real(0.0));
  blend.weight = (weight * of_lobes + exact.weight * of_exact) * inv;
  return lobe_where(amount <= Real(0.0), lobes, blend);
}
