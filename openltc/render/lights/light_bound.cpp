// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Interval arithmetic over the reflectance equation.
//
// With d = y - x from a point x of the batch to a point y of the lights, both in boxes, d lies in a
// box too. Of it follow the least and the largest distance and, by interval products, how far above
// the horizon the lights can stand and how far they can be turned to the points:
//   solid angle          W <= A cos_light / d_min^2
//   form factor          E <= W cos_surface / pi
//   share of the lobe    S <= W D_max / share above the horizon.
// D_max is the largest density of any point's lobe over the directions of that box, in the mirror
// frame, where a narrow lobe's matrix is well conditioned (see BoundField):
//   o_x = A x' + aB z',   o_y = y,   o_z = aC x' + aD z',   D ~ o_z / (o_x^2 + o_y^2 + o_z^2)^2.
// For a given least q of o_x^2 + o_y^2 this is largest at o_z^2 = q/3, or at the end of o_z's range
// that is nearest to it.
//
// The far form takes all lights for one patch in their centre, with moments. A small patch of area
// vector m at d has the form factor f = (n.d)(m.d) / (pi |d|^4), and in cosine space so has the
// lobe's share, with n = z, M^-1 d instead of d and det M^T m instead of m. The far form is
// Taylor's series of f around the centre up to second order. It errs by what the moments are off by
// (see FarLight), times the derivative at the centre, and by the remainder, which is bounded by the
// largest third derivative on the way and falls with the fifth power of the least distance.

#include "openltc/render/lights/light_bound.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace openltc::render {

namespace {

constexpr float k_pi = std::numbers::pi_v<float>;
// By this much unit vectors and their products are widened, for the rounding of the kernel and of
// the arithmetic here, which is single precision.
constexpr float k_slack = 4.0e-6f;
constexpr float k_margin = 1.0001f; // the same for a product of a dozen factors

// Of f(d) = (n.d)(m.d) / |d|^4 for unit n, at |d| = 1, in a step u with k = d.u: by Gegenbauer's
// series |d + t u|^-4 = 1 - 4k t + (12 k^2 - 2) t^2 + (12 k - 32 k^3) t^3 + ... The coefficients of
// f:
//   t    linear in m u^T, with the matrix d n^T + (n.d) (1 - 4 d d^T), whose squared Frobenius norm
//        is 1 + 5 (n.d)^2;
//   t^2  linear in the tensor m u u^T, with the Frobenius norm sqrt(26) at most, at n = d; for one
//   m
//        and one u of norm 3 at most, at n = m = d = u;
//   t^3  bilinear in n and m, with the matrix (12 k - 32 k^3) d d^T + (12 k^2 - 2)(d u^T + u d^T) -
//   4 k
//        u u^T, of norm 4 at most, at k = 1.
const float k_first_order = std::sqrt(6.0f);
const float k_second_order = std::sqrt(26.0f);
constexpr float k_second_one = 3;
constexpr float k_third_order = 4;

struct Interval {
  float lower = 0, upper = 0;
};

Interval operator+(Interval a, Interval b) { return {a.lower + b.lower, a.upper + b.upper}; }

Interval operator*(Interval a, Interval b) {
  const float p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower,
              s = a.upper * b.upper;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

/// Least square of a number in the interval.
float least_square(Interval a) {
  const float m = std::max(std::max(a.lower, -a.upper), 0.0f);
  return m * m;
}

float square(float a) { return a * a; }

/// Largest absolute value.
float magnitude(Interval a) { return std::max(std::abs(a.lower), std::abs(a.upper)); }

struct Box {
  Interval x, y, z;
};

Interval dot(const Box& a, const Box& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Interval field(const BatchBounds& b, int i) { return {b.lower[i], b.upper[i]}; }
Box field3(const BatchBounds& b, int i) { return {field(b, i), field(b, i + 1), field(b, i + 2)}; }

/// Directions from the batch to the lights, not normalised.
struct Reach {
  Box d;
  float inv_nearest, inv_farthest; ///< of the distance
};

/// Cosine between a unit vector of `axis` and the directions.
Interval cosine(const Box& axis, const Reach& reach) {
  const Interval a = dot(axis, reach.d);
  const float low = a.lower * (a.lower > 0 ? reach.inv_farthest : reach.inv_nearest);
  const float high = a.upper * (a.upper > 0 ? reach.inv_nearest : reach.inv_farthest);
  return {std::max(low - k_slack, -1.0f), std::min(high + k_slack, 1.0f)};
}

/// Four floats, for which compilers have operators.
using Float4 = float __attribute__((vector_size(16)));

Float4 load4(const float* p) {
  Float4 v;
  std::memcpy(&v, p, sizeof(v));
  return v;
}

Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }

/// cosine() of the four directions of a batch at once.
void cosines(const PreparedBatch& batch, const Reach& reach, Interval* result) {
  const Interval d[3] = {reach.d.x, reach.d.y, reach.d.z};
  Float4 low = {0, 0, 0, 0}, high = {0, 0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Float4 a = load4(batch.lower[i]), b = load4(batch.upper[i]);
    const Float4 p = a * d[i].lower, q = a * d[i].upper, r = b * d[i].lower, s = b * d[i].upper;
    low += min4(min4(p, q), min4(r, s));
    high += max4(max4(p, q), max4(r, s));
  }
  // A positive end is largest over the least distance, a negative one over the largest.
  low = min4(low * reach.inv_nearest, low * reach.inv_farthest);
  high = max4(high * reach.inv_nearest, high * reach.inv_farthest);
  const Float4 one = {1, 1, 1, 1};
  low = max4(low - k_slack, -one);
  high = min4(high + k_slack, one);
  for (int i = 0; i < 4; ++i)
    result[i] = {low[i], high[i]};
}

struct LobeBound {
  float density =
      0; ///< at least that of any point towards the lights, over its share above the horizon
  float least_density = 0; ///< at most that of any point towards any of them
  float least_length2 = 0; ///< at most |o|^2 of any of these directions
  float most_length2 = 0;  ///< and at least
  bool above = false;      ///< all of them are above the cosine's horizon
};

// Of the lobe whose fields begin at `first`, k_bound_a or k_bound_second.
LobeBound bound_lobe(const BatchBounds& batch, int first, Interval x, Interval y, Interval z) {
  const int offset = first - k_bound_a;
  const Interval a = field(batch, first), ab = field(batch, k_bound_ab + offset);
  const Interval ox = a * x + ab * z;
  const Interval oz = field(batch, k_bound_ac + offset) * x + field(batch, k_bound_ad + offset) * z;
  LobeBound lobe;
  if (oz.upper <= 0) return lobe;
  lobe.most_length2 = square(magnitude(ox)) + square(magnitude(y)) + square(oz.upper);
  lobe.least_density = std::max(oz.lower - k_slack, 0.0f) * batch.lower[k_bound_density + offset] /
                       (k_margin * square(lobe.most_length2));

  float q = least_square(ox) + least_square(y);
  // Around normal incidence the frames may be turned against one another by any angle. What stays
  // is the distance from z': |(A x', y)| >= min(|A|, 1) sqrt(1 - z'^2).
  const float z_largest = magnitude(z);
  const float least_a = std::min(std::sqrt(least_square(a)), 1.0f);
  const float radial = least_a * std::sqrt(std::max(1 - z_largest * z_largest, 0.0f)) -
                       magnitude(ab) * z_largest - k_slack;
  if (radial > 0) q = std::max(q, radial * radial);

  lobe.above = oz.lower > k_slack;
  lobe.least_length2 = q + least_square(oz);
  const float peak = batch.upper[k_bound_peak + offset];
  const float best = std::clamp(std::sqrt(q * (1.0f / 3)), std::max(oz.lower, 0.0f), oz.upper);
  const float length2 = q + best * best;
  lobe.density = peak;
  if (length2 < 1.0e-12f) return lobe; // as good as nothing is known of o
  lobe.density =
      std::min(peak, batch.upper[k_bound_density + offset] * (best / (length2 * length2)));
  return lobe;
}

// At least GGX's D V cos_i of any point towards the lights. With m the mirror direction and P the
// projection on the surface P(wo) = -P(m), so that the half vector has
//   sin_h = |P(wi - m)| / |wo + wi|,
//   P(wi - m) = (x' cos_o + (1 - z') sin_o, y)   in the mirror frame,
// in which lights near m are well conditioned. Around normal incidence, where frames may be turned
// against one another, |P(wi - m)| >= |sin_i - sin_o| stays. D falls with sin_h and has its largest
// value over alpha at alpha^2 = tan_h^2; V cos_i = cos_i / (2 (cos_i root_o + cos_o root_i)) rises
// with cos_i and falls with cos_o and alpha.
float bound_ggx(const BatchBounds& batch, const Interval* mirror, Interval cos_surface,
                float cos_view_most) {
  const Interval c = field(batch, k_bound_cos_view), alpha = field(batch, k_bound_alpha);
  const auto sine = [](float cosine) { return std::sqrt(std::max(1 - cosine * cosine, 0.0f)); };
  const Interval sin_o = {sine(c.upper), sine(c.lower)};
  const Interval less_z = {1 - mirror[2].upper, 1 - mirror[2].lower};
  float across = least_square(mirror[0] * c + less_z * sin_o) + least_square(mirror[1]);
  const float cos_i = std::clamp(cos_surface.upper, 0.0f, 1.0f);
  const float least_sin_i = sine(cos_i), most_sin_i = sine(std::max(cos_surface.lower, 0.0f));
  const float apart =
      std::max(std::max(least_sin_i - sin_o.upper, sin_o.lower - most_sin_i) - k_slack, 0.0f);
  across = std::max(across, apart * apart);
  const float sin2_h = std::clamp(across / (2 + 2 * cos_view_most), 0.0f, 1.0f);

  const float least = square(alpha.lower), most = square(alpha.upper);
  const float worst = sin2_h < 0.999f ? std::clamp(sin2_h / (1 - sin2_h), least, most) : most;
  const float denominator = sin2_h + worst * (1 - sin2_h);
  const float d = worst / (k_pi * square(denominator));
  const auto root = [&](float cosine) { return std::sqrt(cosine * cosine * (1 - least) + least); };
  return d * 0.5f * cos_i / std::max(cos_i * root(c.lower) + c.lower * root(cos_i), 1.0e-12f);
}

/// At least the distance between two points of the box.
float spread(const LightExtent& e) { return length(e.upper - e.lower); }

} // namespace

PreparedBatch::PreparedBatch(const BatchBounds& b) : bounds(b) {
  const int directions[4] = {k_bound_mirror_x, k_bound_mirror_y, k_bound_mirror_z, k_bound_normal};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 4; ++i) {
      lower[axis][i] = b.lower[directions[i] + axis];
      upper[axis][i] = b.upper[directions[i] + axis];
    }
}

LightBound bound_light(const PreparedBatch& prepared, const LightExtent& extent,
                       const FarError& far) {
  const BatchBounds& batch = prepared.bounds;
  LightBound bound;
  const Box position = field3(batch, k_bound_position);
  Reach reach;
  reach.d = {{extent.lower.x - position.x.upper, extent.upper.x - position.x.lower},
             {extent.lower.y - position.y.upper, extent.upper.y - position.y.lower},
             {extent.lower.z - position.z.upper, extent.upper.z - position.z.lower}};
  const Box& d = reach.d;
  const float near2 = std::max(least_square(d.x) + least_square(d.y) + least_square(d.z), 1.0e-12f);
  const float far_x = magnitude(d.x), far_y = magnitude(d.y), far_z = magnitude(d.z);
  const float far2 = std::max(far_x * far_x + far_y * far_y + far_z * far_z, 1.0e-12f);
  const float inv_near2 = 1 / near2;
  reach.inv_nearest = std::sqrt(inv_near2);
  reach.inv_farthest = 1 / std::sqrt(far2);

  // Are the lights above any point's horizon, and do they face any?
  const Box normal = {{extent.normal_lower.x, extent.normal_upper.x},
                      {extent.normal_lower.y, extent.normal_upper.y},
                      {extent.normal_lower.z, extent.normal_upper.z}};
  const Interval cosines_light = cosine(normal, reach);
  const float cos_light = -cosines_light.lower;
  if (cos_light <= 0) return bound;

  Interval cosine_to[4];
  cosines(prepared, reach, cosine_to);
  const Interval cos_surface = cosine_to[3];
  if (cos_surface.upper <= 0) return bound;
  // Where the triangles are tilted against the shading normals, they hide what lies behind them.
  const float tilt = batch.upper[k_bound_tilt];
  bool behind_some = false;
  if (tilt > k_slack) {
    const Interval cos_triangle = cosine(field3(batch, k_bound_geometric), reach);
    if (cos_triangle.upper <= 0) return bound;
    behind_some = cos_triangle.lower <= 0;
  }
  const LobeBound lobe = bound_lobe(batch, k_bound_a, cosine_to[0], cosine_to[1], cosine_to[2]);
  // Of two lobes the densities add, with the weights that they have in them.
  const bool two = batch.upper[k_bound_second_peak] > 0;
  float density = lobe.density;
  float least_density = lobe.least_density;
  if (two) {
    const LobeBound second =
        bound_lobe(batch, k_bound_second, cosine_to[0], cosine_to[1], cosine_to[2]);
    density += second.density;
    least_density += second.least_density;
  }
  const float form = cos_light * inv_near2;
  const float share = std::min(extent.area * form * density, 1.0f);

  // Schlick's weight grows with the angle between the viewer and the light.
  const Interval cos_view = cosine(field3(batch, k_bound_view), reach);
  const float m = 1 - std::sqrt(std::max(0.5f + 0.5f * cos_view.lower, 0.0f));
  const float axis_weight = share * batch.upper[k_bound_axis_weight];
  const float weight = std::min(m * m * m * m * m + axis_weight, 1.0f);
  const float narrow = extent.cosine_power > 0 ? std::pow(cos_light, extent.cosine_power) : 1.0f;

  // The far form stands where every light faces a point or none does. Where a horizon may cut one,
  // it errs by what is on the other side, (n.d)(m.d) / |d|^4 < |p - centre| / |d|^3 for the diffuse
  // part, and the same in cosine space at the lobe's own horizon; where the surface's cuts off the
  // specular part, that is left out.
  const bool far_diffuse = far.valid && (far.planar || cosines_light.upper < 0);
  // Between a triangle's plane and its horizon n.d is at most |d| times the tilt; what the centre
  // or a light wrongly has there is that, beside what the horizon would cut.
  const bool cut = cos_surface.lower <= 0 || behind_some;
  const float hidden = behind_some ? tilt : 0.0f;
  // The far form knows nothing of the ratio to the BRDF, which turns with the direction, nor of a
  // second lobe.
  const float ratio = batch.upper[k_bound_ratio];
  const bool far_specular = far_diffuse && !cut && ratio == 1.0f && !two;
  // The ratio multiplies the lobe's light L by at most BRDF over lobe D in its mean direction w, or
  // by
  // 1. In cosine space L is the height of the vector irradiance and D(w) that of its direction,
  // times J = det / |o|^3, what directions are magnified by: L / D(w) is at most the solid angle
  // times J over J(w), which is finite at the lobe's own horizon, too. Of two lobes w is that of
  // neither, and D itself is what is uneven. GGX itself is within that as well.
  float filled = density;
  if (ratio > 1) {
    const float ggx = bound_ggx(batch, cosine_to, cos_surface, cos_view.upper) /
                      std::max(batch.lower[k_bound_amplitude], 1.0e-6f);
    float uneven = k_unbounded;
    if (two) {
      if (least_density > 0) uneven = density / least_density;
    } else if (lobe.least_length2 > 0) {
      const float longer = lobe.most_length2 / lobe.least_length2;
      uneven = k_margin * longer * std::sqrt(longer);
    }
    filled = std::max(std::max(std::min(ggx * uneven, density * ratio), density), ggx);
  }
  const float inv_near = reach.inv_nearest, inv_near3 = inv_near * inv_near2;
  const float inv_near4 = inv_near2 * inv_near2, inv_near5 = inv_near4 * inv_near;
  const float inv_o2 = 1 / std::max(lobe.least_length2, 1.0e-8f);
  const float inv_o3 = inv_o2 * std::sqrt(inv_o2);
  // Schlick's weight turns by at most this per radian: 5 (1 - cos h)^4 sin h, h half the angle.
  const float turned =
      std::min(2.5f * m * m * m * m * spread(extent) * inv_near, 1.0f) + axis_weight;

  const float stretch = batch.upper[k_bound_stretch], longest = batch.upper[k_bound_longest];
  const float inv_o4 = inv_o2 * inv_o2, inv_o5 = inv_o2 * inv_o3;
  float all = 0, likely = 0, specular_left_out = 0;
  struct {
    float diffuse = 0, specular = 0;
  } moments, plain; // the errors of both far forms
  const auto channel = [&](float radiance, float intensity, float first, float first_error,
                           float second_error, float second, float third, int c) {
    const float flux = std::min(intensity * form, 2 * k_pi * radiance); // radiance, solid angle
    const float diffuse = batch.upper[k_bound_diffuse + c] *
                          std::min(flux * cos_surface.upper * (1 / k_pi), radiance);
    const float grazing = std::max(batch.upper[k_bound_grazing + c], 0.0f);
    const float fresnel = std::max(batch.upper[k_bound_specular + c] + grazing * weight, 0.0f);
    const float lobe_light = std::min(flux * filled, radiance);
    all = std::max(all, diffuse + fresnel * lobe_light);
    likely = std::max(likely, diffuse + fresnel * std::min(flux * density, radiance));
    specular_left_out = std::max(specular_left_out, fresnel * lobe_light);
    if (!far_diffuse) return;

    const float beyond = std::sqrt(second * intensity) * inv_near3; // what a horizon may cut
    const float first1 = k_first_order * first * inv_near3,
                second1 = k_second_one * second * inv_near4;
    const float first2 = k_first_order * first_error * inv_near3,
                second2 = k_second_order * second_error * inv_near4,
                third2 = k_third_order * third * inv_near5;
    const float albedo = batch.upper[k_bound_diffuse + c] * (1 / k_pi);
    const float cut_off = (cut ? beyond : 0.0f) + hidden * flux;
    plain.diffuse = std::max(plain.diffuse, albedo * (cut_off + first1 + second1));
    moments.diffuse = std::max(moments.diffuse, albedo * (cut_off + first2 + second2 + third2));
    if (!far_specular) return;
    const float below = lobe.above ? 0.0f : beyond * inv_o3;
    const float change = std::max(grazing, -batch.lower[k_bound_grazing + c]) * turned * lobe_light;
    plain.specular = std::max(
        plain.specular,
        fresnel * stretch * (below + first1 * inv_o3 + longest * second1 * inv_o4) + change);
    moments.specular = std::max(moments.specular,
                                fresnel * stretch *
                                        (below + first2 * inv_o3 +
                                         longest * (second2 * inv_o4 + longest * third2 * inv_o5)) +
                                    change);
  };
  channel(extent.radiance.x, extent.intensity.x, far.first.x, far.first_error.x, far.second_error.x,
          far.second.x, far.third.x, 0);
  channel(extent.radiance.y, extent.intensity.y, far.first.y, far.first_error.y, far.second_error.y,
          far.second.y, far.third.y, 1);
  channel(extent.radiance.z, extent.intensity.z, far.first.z, far.first_error.z, far.second_error.z,
          far.second.z, far.third.z, 2);

  const auto limited = [&](float v) {
    v *= k_margin;
    return v < k_unbounded ? v : k_unbounded;
  };
  bound.all = limited(all * narrow);
  bound.likely = limited(likely * narrow);
  bound.far_error = bound.plain_error = k_unbounded;
  if (!far_diffuse) return bound;
  bound.far_specular = far_specular && moments.specular < specular_left_out;
  if (!bound.far_specular) moments.specular = plain.specular = specular_left_out;
  bound.far_error = limited(moments.diffuse + moments.specular);
  bound.plain_error = limited(plain.diffuse + plain.specular);
  return bound;
}

} // namespace openltc::render
