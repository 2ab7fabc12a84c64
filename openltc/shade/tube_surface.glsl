// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A tube as a surface sees it, and the light that it reflects of it: of a long light neither the ratio to the
// BRDF nor Schlick's weight is that of one direction.

/// The integral over a tube as a surface sees it; see surface_polygon_integral.
FN LightIntegral surface_tube_integral(GIVEN(Surface) s, Tube tube) {
  Heights heights = no_heights();
  bool cut = false;
  if (s.tilted) {
    heights = tube_heights(tube, s.position, s.geometric);
    cut = any_lane(heights.low < Real(0.0));
  }
  if (s.exact && !cut) {
    return exact_tube_integral(s, tube);
  }
  LightIntegral integral =
      integrate_tube_part(tube, s.position, s.frame, s.fitted.lobe, front_shading(s), heights, cut);
  if (s.two) {
    integral = with_second_lobe(
        s, integral,
        integrate_tube_part(tube, s.position, s.frame, s.second, front_shading(s), heights, cut));
  }
  if (s.exact) {
    // What a triangle cuts keeps the lobe.
    integral = lobe_where(heights.low < Real(0.0), integral, exact_tube_integral(s, tube));
  }
  if (cut) {
    return unless_hidden(s, heights, integral);
  }
  return integral;
}

/// Radii by which a round end lengthens the segment that stands for a tube.
CONSTANT k_round_reach = 0.7;

/// An end of the segment that stands for a tube: in the middle of what stands out of the surface there, and
/// over the lobe's own horizon, with unit normal `horizon`, for as long as some of the tube is.
FN Vec3 segment_end(Vec3 end, Vec3 horizon, Real radius) {
  Vec3 p = end;
  p.z = p.z + radius * lift_share(p.z, radius);
  Real below = lift_share(dot(p, horizon), radius);
  return p + horizon * (radius * below * below * below);
}

/// segment_ratio of that segment, whose ends, not yet lifted, are `from` and `to`, shading space.
FN SegmentRatio tube_ratio(GIVEN(Surface) s, Lobe lobe, Vec3 from, Vec3 to, Real radius, Real w) {
  Vec3 horizon = safe_direction(Vec3(lobe.m20, Real(0.0), lobe.m22));
  return segment_ratio(s, lobe, segment_end(from, horizon, radius),
                       segment_end(to, horizon, radius), w);
}

/// What the light of a tube is multiplied by, and what Schlick's weight has beyond that in its mean direction.
struct TubeRatio {
  Real scale;  ///< mean of blended_ratio
  Real beyond; ///< see fresnel_weight
};

/// Both by the pieces of its axis.
FN TubeRatio ratio_of_tube(GIVEN(Surface) s, Tube tube, LightIntegral integral, Real share) {
  Real w = ratio_weight(integral, share);
  Vec3 axis = safe_direction(tube.to - tube.from);
  Real reach = select(has_round_caps(tube), Real(k_round_reach) * tube.radius, Real(0.0));
  Vec3 from = to_shading(s.frame, tube.from - axis * reach - s.position);
  Vec3 to = to_shading(s.frame, tube.to + axis * reach - s.position);
  SegmentRatio ratio = tube_ratio(s, s.fitted.lobe, from, to, tube.radius, w);
  if (s.two) {
    // Each lobe's own, in proportion to what it has of the light.
    SegmentRatio second = tube_ratio(s, s.second, from, to, tube.radius, w);
    Real part = integral.second * s.second_inv_share;
    Real mix = part * reciprocal(max(integral.specular * s.inv_share + part, Real(k_tiny)));
    ratio.scale = ratio.scale + (second.scale - ratio.scale) * mix;
    ratio.bias = ratio.bias + (second.bias - ratio.bias) * mix;
    ratio.direct = ratio.direct + (second.direct - ratio.direct) * mix;
  }
  Mask along = ratio.scale > Real(0.0);
  TubeRatio result;
  result.beyond =
      select(along, ratio.bias / max(ratio.scale, Real(k_tiny)) - ratio.direct, Real(0.0));
  result.scale = select(along, ratio.scale, Real(1.0));
  return result;
}

/// Reflected light of a tube of radiance 1: shade_integral, but for the ratio to the BRDF, which is the
/// mean along it, and so is what Schlick's weight has beyond that in the mean direction. Of that direction
/// the outline tells more: the thicker the tube, the less its axis.
FN ShadedLight shade_tube_integral(GIVEN(Surface) s, Tube tube, LightIntegral integral) {
  if (!s.corrected) {
    return shade_integral(s, integral);
  }
  if (s.exact) {
    // Uniform shortcut, as there.
    if (all_lanes(integral.weight >= Real(0.0))) {
      return shade_integral(s, integral);
    }
  }
  Real share = filled_share(s, integral);
  TubeRatio ratio = ratio_of_tube(s, tube, integral, share);
  Real weight = part_weight(s, integral.specular_direction, share) + ratio.beyond;
  return shade_filled(s, integral, weight, min(share * ratio.scale, Real(1.0)));
}

/// Light that a surface reflects of a tube of radiance 1, without shadow.
FN ShadedLight shade_tube_parts(GIVEN(Surface) s, Tube tube) {
  return shade_tube_integral(s, tube, surface_tube_integral(s, tube));
}

/// Light that a surface reflects of it, for radiance 1 and without shadow: shade_tube_parts, both together.
FN Vec3 shade_tube(GIVEN(Surface) s, Tube tube) { return both_parts(shade_tube_parts(s, tube)); }
