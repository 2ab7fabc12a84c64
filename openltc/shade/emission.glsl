// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The emission of a light with a texture, as a lobe sees it: the texture's mean over the light,
// weighted by the lobe.
//
// Source: Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines", section 5.2, approximates the weight by one Gaussian in the light's plane
// and looks up a texture that was convolved by it beforehand. That blurs what a stretched lobe
// keeps sharp, and knows no horizon. The weight is known, though: a point x of the light's plane,
// seen in cosine space at p = M^-1 x, has
//   K(x) = D(x/|x|) times solid angle per area = constant * max(0, p.z) / |p|^4,
// because M^-1 is linear and |p|^4 takes up both D's own fall-off and the plane's. So we integrate
// it: a few points, each with its own exact weight, and the texture prefiltered to the width of the
// point's cell, so that it need only be K that they resolve.
//
// The cells. m is where the mean direction of the light, the vector irradiance of its closed form,
// meets the plane. About m, |p|^2 grows by a square over a width that is one radian in cosine space:
// along a unit vector e of the plane, |p_m| over the part of M^-1 e at right angles to p_m. The axes
// are those of that quadratic form, with a little of the light's own rectangle added so that a
// round lobe divides a rectangle along its sides. Along each axis 1/(1 + y^2)^2, seen from the side,
// is (1 + y^2)^-3/2, whose integral is t = y / sqrt(1 + y^2): cells are equal steps of t between
// the light's ends.
//
// The prelude of each target gives the texture, the same for all lanes; see light/emission_stack.h:
//   Vec4 emission_texel(EmissionTexture, Vec2 uv, Real level)  trilinear, uv in [0, 1] over the
//                                     light's bounding rectangle: r g b times the light's share of
//                                     the place, and that share
//   Vec2 emission_texel_count(EmissionTexture)    columns and rows of level 0
//   Vec3 emission_corner, emission_axis_u, emission_axis_v(EmissionTexture)   that rectangle, world
//                                     space; unit axes at right angles
//   Vec2 emission_extent(EmissionTexture)         its sides in metres

/// Cells along the narrow axis. 24 in all reach a third of the error of one look, 9 half of it; 96 an
/// eighth.
const int k_emission_narrow_cells = 4;
/// And along the wide one.
const int k_emission_wide_cells = 6;

/// Texels of a level to a cell's side. The error is flat from 0.5 to 0.7: a texel stands for a
/// Gaussian of 0.5 and the interpolation between texels.
CONSTANT k_emission_texels_per_cell = 0.65;

/// Share of the lobe's own axis in the direction of m. The vector irradiance weighs all of the light
/// alike; a little of the axis draws m towards where the lobe is dense, and more loses lights that
/// the axis misses.
CONSTANT k_emission_axis_share = 0.25;

/// Share of the light's rectangle in the form whose axes the cells follow.
CONSTANT k_emission_rectangle_share = 0.5;

/// 1 / (2 ln 2): half the binary logarithm, from the natural one.
CONSTANT k_half_inv_ln2 = 0.72134752044448170368;

/// Integral variable t = y / sqrt(1 + y^2).
FN Real emission_step_from_width(Real y) { return y * inversesqrt(Real(1.0) + y * y); }
/// Its inverse, y of t in (-1, 1).
FN Real emission_width_from_step(Real t) {
  return t * inversesqrt(max(Real(1.0) - t * t, Real(1.0e-10)));
}

/// Part of an axis that a cell takes, in metres from the middle of the kernel.
struct EmissionCell {
  Real center;  ///< where its middle lies
  Real side;    ///< length of the part that matters: no longer than its weight is
  Real measure; ///< length per step of t, times the step
};

/// Cell `cell` of `cells` that are even in t from `low` to `high`; `width`: metres for y = 1.
FN EmissionCell emission_cell(Real width, Real low, Real high, int cell, int cells) {
  Real step = (high - low) / Real(float(cells));
  Real t0 = low + step * Real(float(cell));
  Real t = t0 + step * Real(0.5);
  Real inv_root = inversesqrt(max(Real(1.0) - t * t, Real(1.0e-10)));
  EmissionCell result;
  result.center = width * emission_width_from_step(t);
  result.measure = width * step * inv_root * inv_root * inv_root;
  result.side = min(width * (emission_width_from_step(t0 + step) - emission_width_from_step(t0)),
                    result.measure);
  return result;
}

/// The part of a length that lies on a light.
struct EmissionOverlap {
  Real center; ///< of the part
  Real share;  ///< of the length, 0..1
};

/// The part of [center - half_length, center + half_length] that lies in [0, end], metres.
FN EmissionOverlap emission_overlap(Real center, Real half_length, Real end) {
  Real low = min(max(center - half_length, Real(0.0)), end);
  Real high = min(max(center + half_length, Real(0.0)), end);
  EmissionOverlap result;
  result.center = Real(0.5) * (low + high);
  result.share = (high - low) * Real(0.5) / max(half_length, Real(k_tiny));
  return result;
}

/// The share of a cell above a plane: `height` of its middle, `rise` from side to side.
FN Real emission_share_above(Real height, Real rise) {
  return min(max(Real(0.5) + height / max(rise, Real(k_tiny)), Real(0.0)), Real(1.0));
}

/// Mean of the texture over the light, weighted by `lobe` and clipped to both horizons, as seen
/// from `position` (world space). `mean_direction` (shading space, unit) is that of the light's
/// closed form for the same lobe: LightIntegral.diffuse_direction or specular_direction. It only
/// places the cells. Times the light's radiance, this is what the lobe's integral is multiplied by.
/// Where `cut`, the mean over what is in front of the plane with unit normal `front` (shading space).
FN_CALL Vec3 emission_seen_part(EmissionTexture emission, Vec3 position, GIVEN(Frame) frame,
                                GIVEN(Lobe) lobe, Vec3 mean_direction, Vec3 front, bool cut) {
  ASSERT_THAT(is_unit(mean_direction));
  ASSERT_THAT(!cut || all_lanes(is_unit(front)));
  Vec2 extent = emission_extent(emission);
  Vec3 axis_u = to_shading(frame, emission_axis_u(emission));
  Vec3 axis_v = to_shading(frame, emission_axis_v(emission));
  Vec3 corner = to_shading(frame, emission_corner(emission) - position);

  // Where the mean direction meets the plane, within the light's rectangle; its middle where it
  // does not.
  Vec3 mean_cosine = safe_direction(to_cosine(lobe, mean_direction));
  mean_cosine.z = mean_cosine.z + Real(k_emission_axis_share);
  Vec3 aim = safe_direction(from_cosine(lobe, mean_cosine));
  Vec3 normal = cross(axis_u, axis_v);
  Real height = dot(corner, normal);
  Real slope = dot(aim, normal);
  Mask meets = slope * height > Real(0.0) && abs(slope) > Real(1.0e-6);
  Vec3 on_plane = aim * (height / select(meets, slope, Real(1.0))) - corner;
  Real m_u =
      select(meets, min(max(dot(on_plane, axis_u), Real(0.0)), extent.x), extent.x * Real(0.5));
  Real m_v =
      select(meets, min(max(dot(on_plane, axis_v), Real(0.0)), extent.y), extent.y * Real(0.5));
  Vec3 m = corner + axis_u * m_u + axis_v * m_v;

  // The quadratic form about m, in 1 / metre^2, and its axes.
  Vec3 m_cosine = to_cosine(lobe, m);
  Vec3 u_cosine = to_cosine(lobe, axis_u);
  Vec3 v_cosine = to_cosine(lobe, axis_v);
  Real inv_m2 = Real(1.0) / max(dot(m_cosine, m_cosine), Real(k_tiny));
  Real along_u = dot(m_cosine, u_cosine) * inv_m2;
  Real along_v = dot(m_cosine, v_cosine) * inv_m2;
  // No cell is narrower than a micrometre, which also keeps squares in range.
  Real form_uu = dot(u_cosine, u_cosine) * inv_m2 - along_u * along_u;
  Real form_vv = dot(v_cosine, v_cosine) * inv_m2 - along_v * along_v;
  Real form_uv = dot(u_cosine, v_cosine) * inv_m2 - along_u * along_v;
  form_uu = min(max(form_uu, Real(1.0e-12)), Real(1.0e12));
  form_vv = min(max(form_vv, Real(1.0e-12)), Real(1.0e12));
  form_uv = min(max(form_uv, Real(-1.0e12)), Real(1.0e12));
  Real half_difference =
      Real(0.5) * (form_uu - form_vv) + Real(0.5) * Real(k_emission_rectangle_share) *
                                            (Real(1.0) / max(extent.x * extent.x, Real(1.0e-12)) -
                                             Real(1.0) / max(extent.y * extent.y, Real(1.0e-12)));
  Real cos_double =
      half_difference *
      inversesqrt(max(half_difference * half_difference + form_uv * form_uv, Real(k_tiny)));
  Real c = sqrt(max(Real(0.5) + Real(0.5) * cos_double, Real(0.0)));
  Real s = sqrt(max(Real(0.5) - Real(0.5) * cos_double, Real(0.0)));
  s = select(form_uv < Real(0.0), -s, s);
  Real cross_form = Real(2.0) * c * s * form_uv;
  Real narrow_width =
      inversesqrt(max(c * c * form_uu + s * s * form_vv + cross_form, Real(1.0e-12)));
  Real wide_width = inversesqrt(max(s * s * form_uu + c * c * form_vv - cross_form, Real(1.0e-12)));

  // How far the light reaches from m along them.
  Real middle_u = Real(0.5) * extent.x - m_u;
  Real middle_v = Real(0.5) * extent.y - m_v;
  Real narrow_middle = c * middle_u + s * middle_v;
  Real narrow_reach = Real(0.5) * (c * extent.x + abs(s) * extent.y);
  Real wide_middle = c * middle_v - s * middle_u;
  Real wide_reach = Real(0.5) * (abs(s) * extent.x + c * extent.y);
  Real narrow_low = emission_step_from_width((narrow_middle - narrow_reach) / narrow_width);
  Real narrow_high = emission_step_from_width((narrow_middle + narrow_reach) / narrow_width);
  Real wide_low = emission_step_from_width((wide_middle - wide_reach) / wide_width);
  Real wide_high = emission_step_from_width((wide_middle + wide_reach) / wide_width);

  Vec2 count = emission_texel_count(emission);
  Real inv_u = Real(1.0) / max(extent.x, Real(k_tiny));
  Real inv_v = Real(1.0) / max(extent.y, Real(k_tiny));
  // Texels per cell, squared, over the cell's area; the level is half its logarithm.
  Real density = Real(k_emission_texels_per_cell) * Real(k_emission_texels_per_cell) * count.x *
                 count.y * inv_u * inv_v;
  Real narrow_rise = abs(axis_u.z * c + axis_v.z * s);
  Real wide_rise = abs(axis_v.z * c - axis_u.z * s);
  Real narrow_front = Real(0.0);
  Real wide_front = Real(0.0);
  if (cut) {
    Real front_u = dot(front, axis_u);
    Real front_v = dot(front, axis_v);
    narrow_front = abs(front_u * c + front_v * s);
    wide_front = abs(front_v * c - front_u * s);
  }
  Real inv_m = sqrt(inv_m2);
  Vec4 sum = emission_texel(emission, Vec2(Real(0.5), Real(0.5)), Real(99.0)) * Real(1.0e-25);
  for (int i = 0; i < k_emission_narrow_cells; ++i) {
    EmissionCell narrow =
        emission_cell(narrow_width, narrow_low, narrow_high, i, k_emission_narrow_cells);
    for (int j = 0; j < k_emission_wide_cells; ++j) {
      EmissionCell wide = emission_cell(wide_width, wide_low, wide_high, j, k_emission_wide_cells);
      // The cell's box along the rectangle's sides, as far as it lies in the rectangle.
      EmissionOverlap in_u =
          emission_overlap(m_u + c * narrow.center - s * wide.center,
                           Real(0.5) * (c * narrow.side + abs(s) * wide.side), extent.x);
      EmissionOverlap in_v =
          emission_overlap(m_v + s * narrow.center + c * wide.center,
                           Real(0.5) * (abs(s) * narrow.side + c * wide.side), extent.y);
      // K there, and the share of the cell above the surface's horizon.
      Vec3 x = corner + axis_u * in_u.center + axis_v * in_v.center;
      Vec3 p = to_cosine(lobe, x) * inv_m;
      Real inv_p2 = Real(1.0) / max(dot(p, p), Real(k_tiny));
      Real above = emission_share_above(x.z, narrow_rise * narrow.side + wide_rise * wide.side);
      if (cut) {
        above = above * emission_share_above(dot(front, x),
                                             narrow_front * narrow.side + wide_front * wide.side);
      }
      Real weight = max(p.z, Real(0.0)) * inv_p2 * inv_p2 * above * in_u.share * in_v.share *
                    narrow.measure * wide.measure;
      Real level =
          Real(k_half_inv_ln2) * log(max(density * narrow.side * wide.side, Real(1.0e-12)));
      sum = sum + emission_texel(emission, Vec2(in_u.center * inv_u, in_v.center * inv_v), level) *
                      weight;
    }
  }
  Real inv_share = Real(1.0) / max(sum.w, Real(k_tiny));
  return Vec3(sum.x * inv_share, sum.y * inv_share, sum.z * inv_share);
}

/// emission_seen_part of the whole light, above the horizon alone.
FN Vec3 emission_seen(EmissionTexture emission, Vec3 position, Frame frame, Lobe lobe,
                      Vec3 mean_direction) {
  return emission_seen_part(emission, position, frame, lobe, mean_direction,
                            Vec3(Real(0.0), Real(0.0), Real(1.0)), false);
}
