// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// GGX itself over the outline of a light, as an integral along its edges: no fitted lobe.
//
// Source: derived in docs/method.md, section 11. What it starts from:
//   Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs" (visible normals);
//   Heitz 2018, "Sampling the GGX Distribution of Visible Normals" (the ellipsoid that is stretched to a
//     sphere, whose visible normals are a cosine).
//
// With h the half vector and B = diag(1, 1, alpha), GGX's visible normals are a cosine about n = B^-1 wo in
// g = B h. So Lambert's edge sum gives the share of them that a light fills,
//   integral of G1 D / (4 cos_o) = n.V / (pi (root + cos_o)),   V = contour integral of g x dg / |g|^2,
// n = (alpha sin_o, 0, cos_o), root = |n|. The edge from a to b becomes an arc of a conic, g = B (q + |q| wo):
// as a curve of degree 2, q = u^2 a + 2 u t m + t^2 b and |q| = u^2 + 2 u t w + t^2 with m the unit bisector of
// a and b and w the cosine of half their angle, both are polynomials, and so is g.
//
// alpha V.x is the same integral times h.x / (wo.h), since the cosine about n is alpha (wo.h) / |g|, that about the x
// axis h.x / |g|. So what turns like sin_o h.x / (wo.h) = 1 - cos_o h.z / (wo.h), which is 0 in the mirror direction,
// is known, too.
//
// What remains is the masking of wi, which depends on its height z alone: see masking_ring.glsl, which
// is summed at the same nodes.

/// What the sums along the edges of a light want to know of the view.
struct ExactView {
  Real sin_o;    ///< wo = (sin_o, 0, cos_o)
  Real cos_o;    ///< positive
  Real alpha;    ///< microfacet width
  Real alpha2;   ///< its square
  Real root_o;   ///< sqrt(cos_o^2 (1 - alpha^2) + alpha^2)
  Real start_x;  ///< cosine of the azimuth at which rings begin, from the mirror's
  Real start_y;  ///< and its sine
  Real half_cos; ///< of half that azimuth
  Real half_sin; ///< of half that azimuth
  // What of masking_of_height visible normals have: masking - lean sin_o h.x / (wo.h).
  Real masking;        ///< masking_of_height of the mirror direction
  Real lean;           ///< how it turns there
  Real biased_masking; ///< the same with Schlick's weight
  Real biased_lean;    ///< likewise
  /// pi times D of wi along the normal, times what masking_of_height has there beyond that.
  Real more_at_normal;
  Real biased_at_normal; ///< the same with Schlick's weight
  Real peak;   ///< how wide in height the peak of rings is, which is at cos_o: see ring_at
  Real gather; ///< how far from that height the nodes of an arc gather: see ring_nodes
};

/// A unit vector at half the angle of another.
struct HalfTurn {
  Real c; ///< its cosine, 0..1
  Real s; ///< its sine, -1..1
};

/// Half of the angle of the unit vector (x, y) from the x axis, -pi..pi; a half turn is on the side that y's sign
/// tells.
FN HalfTurn half_turn(Real x, Real y) {
  Real larger2 = Real(0.5) + Real(0.5) * min(abs(x), Real(1.0));
  Real inv_larger = inversesqrt(larger2);
  Real larger = larger2 * inv_larger;
  Real smaller = Real(0.5) * abs(y) * inv_larger;
  Mask back = x < Real(0.0);
  Real s = select(back, larger, smaller);
  HalfTurn turn;
  turn.c = select(back, smaller, larger);
  turn.s = select(y < Real(0.0), -s, s);
  return turn;
}

/// Smallest cosine of the view.
CONSTANT k_least_view_cos = 1.0e-4;
/// Least width of the peak of rings.
CONSTANT k_least_peak = 0.01;
/// Heights over which nodes gather: this much of the peak's,
CONSTANT k_gather_by_peak = 1.0;
/// and of the mirror direction's, over which masking turns: by alpha
CONSTANT k_gather_by_cos = 10.0;
/// to so much.
CONSTANT k_most_gather_by_cos = 1.5;

/// Square of the tangent of the angle from the normal within which a direction has no azimuth.
CONSTANT k_overhead_tan2 = 1.0e-6;

/// `start`: the direction, shading space, at whose azimuth rings begin.
FN ExactView exact_view(Vec3 wo, Real alpha, Vec3 start) {
  ExactView view;
  view.cos_o = min(max(wo.z, Real(k_least_view_cos)), Real(1.0));
  view.sin_o = sqrt(max(Real(1.0) - view.cos_o * view.cos_o, Real(0.0)));
  view.alpha = alpha;
  view.alpha2 = alpha * alpha;
  view.root_o = sqrt(view.cos_o * view.cos_o * (Real(1.0) - view.alpha2) + view.alpha2);
  Real length2 = start.x * start.x + start.y * start.y;
  Real inv_length = inversesqrt(max(length2, Real(k_tiny)));
  // Right above the point rounding alone tells an azimuth. The mirror's is best there: on either side of it is half
  // of the peak.
  Mask usable = length2 > Real(k_overhead_tan2) * (start.z * start.z) + Real(k_tiny);
  view.start_x = select(usable, -start.x * inv_length, Real(1.0));
  view.start_y = select(usable, start.y * inv_length, Real(0.0));
  HalfTurn turn = half_turn(view.start_x, view.start_y);
  view.half_cos = turn.c;
  view.half_sin = turn.s;
  // masking_of_height at cos_o, where both roots are the same.
  view.masking = Real(0.25) / view.root_o;
  // As it turns in the plane of the view, over how cos_o h.z / (wo.h) does. Where the view grazes it turns less right
  // beside it.
  Real still = alpha / view.root_o;
  view.lean = -view.masking * (still * still) * (view.cos_o / (view.cos_o + alpha));
  // Schlick's weight, of the mirror direction, turns with wo.h.
  Real weight = schlick_weight(view.cos_o);
  Real away2 = (Real(1.0) - view.cos_o) * (Real(1.0) - view.cos_o);
  view.biased_masking = view.masking * weight;
  view.biased_lean = view.lean * weight + Real(5.0) * view.masking * view.cos_o * (away2 * away2);
  // c / e with c = 2 u and e = u (1 - cos_o + alpha^2 u), u = 1 + cos_o.
  Real e = Real(1.0) - view.cos_o + view.alpha2 * (Real(1.0) + view.cos_o);
  Real ratio = Real(2.0) / max(e, Real(k_tiny));
  Real d = view.alpha2 * ratio * ratio;
  Real masking = Real(0.5) / (view.root_o + view.cos_o);
  Real off = Real(1.0) - view.cos_o; // sin_o h.x / (wo.h)
  view.more_at_normal = d * (masking - view.masking + view.lean * off);
  view.biased_at_normal = d * (masking * schlick_weight_between(view.cos_o) - view.biased_masking +
                               view.biased_lean * off);
  view.peak =
      max(Real(2.0) * alpha * sqrt(view.sin_o * view.sin_o + view.alpha2 * view.cos_o * view.cos_o),
          Real(k_least_peak));
  view.gather = Real(k_gather_by_peak) * view.peak +
                min(Real(k_gather_by_cos) * alpha, Real(k_most_gather_by_cos)) * view.cos_o;
  return view;
}

/// A point of an edge or a control point of it, up to a scale.
struct ConicPoint {
  Vec3 r; ///< direction from the axis at which rings begin: along it, across, up
  Real l; ///< length of the direction, if it is a point
  Vec3 g; ///< B (direction + l wo)
};

/// The point in the direction q, shading space, whose length is l.
FN ConicPoint conic_point(GIVEN(ExactView) view, Vec3 q, Real l) {
  ConicPoint p;
  p.r = Vec3(q.y * view.start_y - q.x * view.start_x, q.y * view.start_x + q.x * view.start_y, q.z);
  p.l = l;
  p.g = Vec3(q.x + l * view.sin_o, q.y, view.alpha * (q.z + l * view.cos_o));
  return p;
}

/// a (1 - t) + b t, as a sum of two parts of one sign where a and b are.
FN ConicPoint mix_points(ConicPoint a, ConicPoint b, Real t) {
  Real u = Real(1.0) - t;
  ConicPoint p;
  p.r = a.r * u + b.r * t;
  p.l = a.l * u + b.l * t;
  p.g = a.g * u + b.g * t;
  return p;
}

/// a times s.
FN ConicPoint scale_point(ConicPoint a, Real s) {
  a.r = a.r * s;
  a.l = a.l * s;
  a.g = a.g * s;
  return a;
}

/// Sums along the outline of a light.
struct ContourSums {
  Vec3 visible; ///< of g x dg / |g|^2
  Real masked;  ///< pi times what masking adds, see masking_ring.glsl, but for `solid`
  Real biased;  ///< the same with Schlick's weight, and what that adds
  Real solid;   ///< solid angle
};

/// Nothing yet.
FN ContourSums no_contour() {
  ContourSums sums;
  sums.visible = Vec3(Real(0.0), Real(0.0), Real(0.0));
  sums.masked = Real(0.0);
  sums.biased = Real(0.0);
  sums.solid = Real(0.0);
  return sums;
}
