// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX along rings of one height z around the normal: where the masking of wi is the same everywhere.
//
// Source: derived in docs/method.md, section 11.
//
// At a height z and an azimuth phi from the mirror's, with c = |wo + wi|^2 and u = cos_o + z,
//   D = alpha^2 / pi (c / e)^2,   e = c - (1 - alpha^2) u^2 = A - b cos phi,
//   A = sin_o^2 + sin_i^2 + alpha^2 u^2,   b = 2 sin_o sin_i,
// whose integral over phi is elementary. f_s cos_i = W(z) D with W = G2 / (4 cos_o) of Smith, so that
//   integral over a light = contour integral of -W(z) Psi(z, phi) dz,   Psi = integral of D from some phi0 to phi.
// An arc along the horizon has no dz and counts nothing. Where a light encloses the normal, what is between the
// outline and the normal at the azimuth opposite of phi0 has to be added. Counted is what W(z) has beyond what visible
// normals have of it: masking - lean sin_o h.x / (wo.h), which is W in the mirror direction and near it. On a ring
// sin_o h.x / (wo.h) = 1 - 2 cos_o u / c. Near the normal azimuths turn fast: D there times what is counted there is
// taken out of the rings, and added as so much per solid angle.
//
// Schlick's weight is a function of c = |wo + wi|^2 alone, and the integrals of D / c and D c over a part of a ring
// are as elementary as that of D. Its mean there is taken from two values of c that have the same means of 1 / c and
// c. What counts is W(z) times it, beyond what visible normals have of that.

/// W(z) = f_s cos_i / D of Smith's height-correlated masking.
FN Real masking_of_height(GIVEN(ExactView) view, Real z) {
  Real root2 = z * z * (Real(1.0) - view.alpha2) + view.alpha2;
  Real root = root2 * inversesqrt(root2);
  return Real(0.5) * z * reciprocal(max(z * view.root_o + view.cos_o * root, Real(k_tiny)));
}

/// The coefficients of e on a ring.
struct Ring {
  Real mean;    ///< A
  Real less;    ///< A - b
  Real more;    ///< A + b
  Real product; ///< A^2 - b^2
  Real k;       ///< (1 - alpha^2) u^2
};

/// The ring at height z, where the sine is sin_i. Nothing cancels:
///   A^2 - b^2 = u^2 ((z - cos_o)^2 + 2 alpha^2 (sin_o^2 + sin_i^2) + alpha^4 u^2).
FN Ring ring_at(GIVEN(ExactView) view, Real z, Real sin_i) {
  Real u = view.cos_o + z;
  Real u2 = u * u;
  Real sin2 = view.sin_o * view.sin_o + sin_i * sin_i;
  Real d = z - view.cos_o;
  Real both = view.sin_o + sin_i;
  Ring ring;
  ring.mean = sin2 + view.alpha2 * u2;
  ring.more = both * both + view.alpha2 * u2;
  ring.product = u2 * (d * d + view.alpha2 * (Real(2.0) * sin2 + view.alpha2 * u2));
  ring.less = ring.product * reciprocal(ring.more);
  ring.k = (Real(1.0) - view.alpha2) * u2;
  return ring;
}

/// From the azimuth at which rings begin to another.
struct RingPart {
  Real angle;    ///< between the two
  Real inverse;  ///< integral of 1 / e over it
  Real end;      ///< e at its end
  Real begin;    ///< and at its beginning
  Real turned;   ///< sine at the end times e at the beginning less the reverse, over b
  Real inv_root; ///< 1 / sqrt(A^2 - b^2)
  Real inv_ends; ///< 1 / (end begin)
  HalfTurn turn; ///< half of the angle
  HalfTurn at;   ///< half of the azimuth of its end, from the mirror's
};

/// (x, y): the azimuth of the end, from the axis at which rings begin, unit.
///
/// The integral of 1 / e is the angle between (sqrt(A - b) cos, sqrt(A + b) sin) of half the azimuths of either end,
/// whose squared lengths are e there.
FN RingPart ring_part(GIVEN(ExactView) view, Ring ring, Real x, Real y) {
  RingPart part;
  part.turn = half_turn(x, y);
  part.angle = Real(2.0) * part.turn.s * acute_over_sin(part.turn.c);
  part.at.c = view.half_cos * part.turn.c - view.half_sin * part.turn.s;
  part.at.s = view.half_sin * part.turn.c + view.half_cos * part.turn.s;
  Real less_c = ring.less * part.at.c;
  Real more_s = ring.more * part.at.s;
  part.end = less_c * part.at.c + more_s * part.at.s;
  part.begin =
      ring.less * (view.half_cos * view.half_cos) + ring.more * (view.half_sin * view.half_sin);
  part.inv_root = inversesqrt(max(ring.product, Real(k_tiny)));
  Real inv_both = inversesqrt(max(part.end * part.begin, Real(k_tiny)));
  part.inv_ends = inv_both * inv_both;
  part.inverse = Real(2.0) * part.inv_root *
                 angle_of_unit((less_c * view.half_cos + more_s * view.half_sin) * inv_both,
                               ring.product * part.inv_root * part.turn.s * inv_both);
  part.turned = Real(2.0) * part.turn.s * (less_c * view.half_cos - more_s * view.half_sin);
  return part;
}

/// Integrals over a part of a ring.
struct RingPowers {
  Real less2; ///< of 1 / e^2
  Real less1; ///< of 1 / e
  Real angle; ///< of 1
  Real more1; ///< of e
  Real low;   ///< least e on it
  Real high;  ///< and most
};

/// Over that part.
FN RingPowers part_powers(GIVEN(ExactView) view, Ring ring, RingPart part) {
  Real b = Real(0.5) * (ring.more - ring.less);
  RingPowers powers;
  powers.less2 = (ring.mean * part.inverse + b * (part.turned * part.inv_ends)) *
                 (part.inv_root * part.inv_root);
  powers.less1 = part.inverse;
  powers.angle = part.angle;
  powers.more1 = ring.mean * part.angle - b * (Real(2.0) * part.at.s * part.at.c - view.start_y);
  Mask past_mirror = (part.at.s < Real(0.0)) != (view.half_sin < Real(0.0));
  powers.low = select(past_mirror, ring.less, min(part.begin, part.end));
  powers.high = select(part.at.c < Real(0.0), ring.more, max(part.begin, part.end));
  return powers;
}

/// Over the whole ring.
FN RingPowers whole_powers(Ring ring) {
  Real turn = Real(2.0) * k_pi;
  Real inv_root = inversesqrt(max(ring.product, Real(k_tiny)));
  RingPowers powers;
  powers.less2 = turn * ring.mean * (inv_root * inv_root) * inv_root;
  powers.less1 = turn * inv_root;
  powers.angle = turn;
  powers.more1 = turn * ring.mean;
  powers.low = ring.less;
  powers.high = ring.more;
  return powers;
}

/// Schlick's weight where c = |wo + wi|^2 has this value: wo.h is half of its root.
FN Real weight_of_square(Real c) {
  return schlick_weight(Real(0.5) * c * inversesqrt(max(c, Real(k_tiny))));
}

/// Mean of Schlick's weight over c from its means of 1 / c and of c, where c is between `low` and `high`: two
/// values, one of them that at `low`, which have these means and, so, positive shares.
FN Real mean_weight(Real inverse, Real mean, Real low, Real high) {
  Real over = max(mean - low, Real(0.0));
  Real x = min(max(over * reciprocal(max(Real(1.0) - low * inverse, Real(k_tiny))), low), high);
  Real share = min(over * reciprocal(max(x - low, Real(k_tiny))), Real(1.0));
  Real first = weight_of_square(low);
  return first + (weight_of_square(x) - first) * share;
}

/// What a ring adds to the visible normals: its masking beyond theirs, by itself and with Schlick's weight; pi Psi
/// times that.
struct RingLight {
  Real scale; ///< by itself
  Real bias;  ///< with the weight
};

/// From the integrals over a part of a ring of height z. pi D / alpha^2 = (c / e)^2, c = e + k.
FN RingLight ring_light(GIVEN(ExactView) view, Ring ring, RingPowers powers, Real z) {
  Real k = ring.k;
  Real c1 = powers.less1 + k * powers.less2;        // of c / e^2
  Real c2 = powers.angle + k * (powers.less1 + c1); // of c^2 / e^2
  Real c3 =
      powers.more1 + k * (powers.angle + k * powers.less1 + powers.angle + c2); // of c^3 / e^2
  Real inv_c2 = select(abs(c2) > Real(k_tiny), reciprocal(c2), Real(0.0));
  Real weight = mean_weight(c1 * inv_c2, c3 * inv_c2, powers.low + k, powers.high + k);
  Real masking = masking_of_height(view, z);
  Real d = view.alpha2 * c2;
  Real leaning = view.alpha2 * (c2 - Real(2.0) * view.cos_o * (view.cos_o + z) * c1);
  RingLight light;
  light.scale = d * (masking - view.masking) + leaning * view.lean;
  light.bias = d * (masking * weight - view.biased_masking) + leaning * view.biased_lean;
  return light;
}

/// Where x, in widths of the peak of rings, is on a scale on which that is even: -1..1.
FN Real peak_place(Real x) {
  Real square = Real(1.0) + x * x;
  return x * reciprocal(Real(1.0) + square * inversesqrt(square));
}

/// Where a place of that scale is.
struct PeakPoint {
  Real x;     ///< in widths of the peak
  Real slope; ///< how much of x there is to the scale
};

/// The reverse of peak_place.
FN PeakPoint peak_point(Real v) {
  Real inv = reciprocal(max(Real(1.0) - v * v, Real(1.0e-6)));
  PeakPoint point;
  point.x = Real(2.0) * v * inv;
  point.slope = Real(2.0) * (Real(1.0) + v * v) * inv * inv;
  return point;
}

/// A node of the integral from an edge to the normal at v, see peak_place, of weight w.
FN ContourSums add_cap_node(GIVEN(ExactView) view, ContourSums sums, Real v, Real w) {
  PeakPoint point = peak_point(v);
  Real z = min(max(view.cos_o + view.peak * point.x, Real(0.0)), Real(1.0));
  Real sin2 = max(Real(1.0) - z * z, Real(k_tiny));
  Ring ring = ring_at(view, z, sin2 * inversesqrt(sin2));
  Real dz = view.peak * point.slope * w;
  RingLight light = ring_light(view, ring, whole_powers(ring), z);
  Real turn = Real(2.0) * k_pi;
  sums.masked = sums.masked + (light.scale - turn * view.more_at_normal) * dz;
  sums.biased = sums.biased + (light.bias - turn * view.biased_at_normal) * dz;
  return sums;
}

/// The integral of whole rings from height z to the normal, times `sign`: 8 nodes of Gauss.
FN_CALL ContourSums add_cap(GIVEN(ExactView) view, GIVEN(ContourSums) so_far, Real z, Real sign) {
  ContourSums sums = so_far;
  Real from = peak_place((z - view.cos_o) / view.peak);
  Real to = peak_place((Real(1.0) - view.cos_o) / view.peak);
  Real middle = Real(0.5) * (from + to);
  Real reach = Real(0.5) * (to - from);
  ContourSums cap = no_contour();
  for (int side = -1; side <= 1; side = side + 2) {
    Real h = reach * Real(float(side));
    cap = add_cap_node(view, cap, middle + h * Real(0.1834346424956498), Real(0.362683783378362));
    cap = add_cap_node(view, cap, middle + h * Real(0.525532409916329), Real(0.3137066458778873));
    cap = add_cap_node(view, cap, middle + h * Real(0.7966664774136267), Real(0.2223810344533745));
    cap = add_cap_node(view, cap, middle + h * Real(0.9602898564975363), Real(0.1012285362903763));
  }
  sums.masked = sums.masked + cap.masked * reach * sign;
  sums.biased = sums.biased + cap.biased * reach * sign;
  return sums;
}

/// The contour integral of g x dg / |g|^2 along the horizon from the azimuth at which rings begin to that of q.
FN_CALL ContourSums add_horizon_arc(GIVEN(ExactView) view, GIVEN(ContourSums) so_far,
                                    GIVEN(ConicPoint) q, Real sign) {
  ContourSums sums = so_far;
  Ring ring = ring_at(view, Real(0.0), Real(1.0));
  Real inv_r = inversesqrt(max(q.r.x * q.r.x + q.r.y * q.r.y, Real(k_tiny)));
  RingPart part = ring_part(view, ring, q.r.x * inv_r, q.r.y * inv_r);
  // Of cos and sin over e. Looking along the normal e is constant, and the quotients lose their digits.
  Real cos_part = Real(0.5) * (ring.mean * part.inverse - part.angle); // times sin_o
  Mask straight = view.sin_o < Real(0.01);
  Real inv_sin = Real(1.0) / max(view.sin_o, Real(0.01));
  Real c = part.at.c;
  Real s = part.at.s;
  Real c0 = view.half_cos;
  Real s0 = view.half_sin;
  Real inv_mean = Real(1.0) / ring.mean;
  Real along = select(straight, Real(2.0) * (s * c - s0 * c0) * inv_mean, cos_part * inv_sin);
  Real across = select(straight, Real(2.0) * (s * s - s0 * s0) * inv_mean,
                       Real(0.5) * inv_sin *
                           log(max(part.end, Real(k_tiny)) / max(part.begin, Real(k_tiny))));
  Real up = view.alpha * view.cos_o;
  // Of (sin_o cos - 1) over e. The mean of e is nearly 2, and cos_part nearly part.inverse, at grazing views.
  Real less = view.cos_o * view.cos_o * (Real(1.0) - view.alpha2);
  Real upward = Real(-0.5) * (part.angle + less * part.inverse);
  sums.visible = sums.visible + Vec3(-up * along, up * across, upward) * sign;
  sums.solid = sums.solid - part.angle * sign;
  return sums;
}
