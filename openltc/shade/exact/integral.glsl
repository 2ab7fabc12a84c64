// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself over a light: from the sums along its outline, or by nodes where it is too small or too thin for that.

/// The light of the outline and where it comes from.
struct ExactIntegral {
  Real light;     ///< integral of f_s cos_i for F = 1
  Real bias;      ///< the same times Schlick's weight
  Vec3 direction; ///< its mean direction, shading space, unit
};

/// From the sums along an outline that runs counter-clockwise for side = 1, clockwise for -1.
FN ExactIntegral exact_integral(GIVEN(ExactView) view, GIVEN(ContourSums) sums, Real side) {
  Vec3 v = sums.visible * side;
  Real visible = max(view.alpha * view.sin_o * v.x + view.cos_o * v.z, Real(0.0));
  // B^-1 V, times alpha.
  Vec3 h = safe_direction(Vec3(view.alpha * v.x, view.alpha * v.y, v.z));
  Real o_h = h.x * view.sin_o + h.z * view.cos_o;
  h = select(o_h < Real(0.0), -h, h);
  Vec3 wo = Vec3(view.sin_o, Real(0.0), view.cos_o);
  ExactIntegral result;
  result.direction = safe_direction(h * (Real(2.0) * abs(o_h)) - wo);
  Real leaning = view.alpha * view.sin_o * v.x;
  Real known = Real(2.0) * (view.masking * visible - view.lean * leaning);
  Real rest = (sums.masked + view.more_at_normal * sums.solid) * side;
  result.light = max((known + rest) * k_inv_pi, Real(0.0));
  known = Real(2.0) * (view.biased_masking * visible - view.biased_lean * leaning);
  rest = (sums.biased + view.biased_at_normal * sums.solid) * side;
  result.bias = min(max((known + rest) * k_inv_pi, Real(0.0)), result.light);
  return result;
}

/// What is too small or too thin for its outline: light by nodes, of GGX itself.
struct ExactNodes {
  Real scale; ///< for F = 1
  Real bias;  ///< the same times Schlick's weight
  Vec3 h;     ///< sum of the half vectors, unit ones, by what they have of `scale`
};

/// Nothing yet.
FN ExactNodes no_exact_nodes() {
  ExactNodes nodes;
  nodes.scale = Real(0.0);
  nodes.bias = Real(0.0);
  nodes.h = Vec3(Real(0.0), Real(0.0), Real(0.0));
  return nodes;
}

/// Adds what of f_s cos_i comes from the direction wi, shading space, in that solid angle.
FN ExactNodes add_exact_node(GIVEN(Surface) s, ExactNodes nodes, Vec3 wi, Real solid_angle) {
  GgxTerms terms = eval_ggx_terms(s.wo, wi, s.alpha);
  Real scale = terms.scale * solid_angle;
  nodes.scale = nodes.scale + scale;
  nodes.bias = nodes.bias + terms.bias * solid_angle;
  nodes.h = nodes.h + safe_direction(wi + s.wo) * scale;
  return nodes;
}

/// What of a light is its outline and what, 1 - exact, nodes.
FN ExactIntegral mix_exact(GIVEN(Surface) s, ExactIntegral outline, ExactNodes nodes, Real exact) {
  Real rest = Real(1.0) - exact;
  Mask some = rest > Real(0.0);
  Mask all = exact <= Real(0.0);
  Vec3 h = safe_direction(nodes.h);
  Vec3 direction = h * (Real(2.0) * dot(h, s.wo)) - s.wo;
  ExactIntegral result;
  result.light = select(all, Real(0.0), outline.light * exact) +
                 select(some, max(nodes.scale, Real(0.0)) * rest, Real(0.0));
  result.bias = select(all, Real(0.0), outline.bias * exact) +
                select(some, max(nodes.bias, Real(0.0)) * rest, Real(0.0));
  result.direction =
      select(all, direction,
             select(some, safe_direction(direction * rest + outline.direction * exact),
                    outline.direction));
  return result;
}

/// Angular radius, of half vectors and of what masking sees, below which a light is four points of it,
CONSTANT k_four_points_radius = 0.03;
/// and 1 over what lies between that and where it is its outline.
CONSTANT k_inv_four_points_range = 50.0;

/// How much of the integral along its outline a light wants, 0 to 1, of that centre, shading space, and radius:
/// see small_share.
FN Real outline_exactness(GIVEN(Surface) s, Vec3 center, Real radius) {
  Real inv_length = inverse_length(center);
  Vec3 sum = center * inv_length + s.wo;
  Real g2 = sum.x * sum.x + sum.y * sum.y + s.alpha * s.alpha * sum.z * sum.z;
  Real z = max(center.z * inv_length, Real(0.0));
  Real masking = min(sum.z * sum.z, z * z + s.alpha * s.alpha);
  Real reach = radius * inv_length * inversesqrt(max(min(Real(0.25) * g2, masking), Real(k_tiny)));
  Real exact =
      min(max((reach - Real(k_four_points_radius)) * Real(k_inv_four_points_range), Real(0.0)),
          Real(1.0));
  return select(center.z > radius, exact, Real(1.0));
}

/// Width of a lobe below which Schlick's weight is that of a light's mean direction,
CONSTANT k_narrow_lobe = 0.005;
/// and 1 over how much more it takes to be the integrated one alone, from a roughness of 0.12 on.
CONSTANT k_inv_narrow_lobe_range = 100.0;

/// From the diffuse vector irradiance times 2 pi and the exact specular light.
FN LightIntegral exact_light_integral(GIVEN(Surface) s, Vec3 diffuse, ExactIntegral specular) {
  LightIntegral integral;
  integral.diffuse = min(max(diffuse.z * k_half_inv_pi, Real(0.0)), Real(1.0));
  integral.diffuse_direction = safe_direction(diffuse);
  // The same of either lobe, so that together they have this share.
  Real all = s.fitted.n1 * (s.inv_share + s.second_inv_share);
  integral.specular = specular.light * reciprocal(max(all, Real(k_tiny)));
  integral.second = integral.specular;
  integral.specular_direction = specular.direction;
  integral.first_direction = specular.direction;
  integral.second_direction = specular.direction;
  integral.concentration = Real(0.0); // nothing to correct: see ratio_weight
  // Over a narrow lobe the weight hardly turns, and rings have few nodes for its peak.
  Real wide = min(max((s.alpha - Real(k_narrow_lobe)) * Real(k_inv_narrow_lobe_range), Real(0.0)),
                  Real(1.0));
  Real at_mean = part_weight(s, specular.direction, filled_share(s, integral));
  Real mean = min(specular.bias * reciprocal(max(specular.light, Real(k_tiny))), Real(1.0));
  integral.weight = max(at_mean + (mean - at_mean) * wide, Real(0.0));
  return integral;
}

/// The integral of the lobe where the mask is set, the exact one elsewhere.
FN LightIntegral lobe_where(Mask m, LightIntegral lobe, LightIntegral exact) {
  LightIntegral integral;
  integral.diffuse = select(m, lobe.diffuse, exact.diffuse);
  integral.specular = select(m, lobe.specular, exact.specular);
  integral.diffuse_direction = select(m, lobe.diffuse_direction, exact.diffuse_direction);
  integral.specular_direction = select(m, lobe.specular_direction, exact.specular_direction);
  integral.second = select(m, lobe.second, exact.second);
  integral.first_direction = select(m, lobe.first_direction, exact.first_direction);
  integral.second_direction = select(m, lobe.second_direction, exact.second_direction);
  integral.concentration = select(m, lobe.concentration, exact.concentration);
  integral.weight = select(m, Real(-1.0), exact.weight);
  return integral;
}
