// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polar coordinates (t, phi) about q = M z / |M z|, without the change of variables to cosine space
// that would make the results true by construction. Along the meridian of direction u at q,
// w = q cos t + u sin t; a plane N.w = 0 is met at tan t = -N.q / N.u: the cosine's horizon, with
// N the last row of M^-1, or an edge of a polygon. Before that D is smooth.
//
// A polygon is the sum of the triangles from q over its edges, those wound the other way negative:
// q need not lie inside.

#include "openltc/plot/lobe_quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace openltc::plot {

namespace {

LobeMoments operator+(LobeMoments a, LobeMoments b) { return {a.mass + b.mass, a.first + b.first}; }
LobeMoments operator*(LobeMoments a, double s) { return {a.mass * s, a.first * s}; }

// Gauss-Legendre with 8 points on [-1, 1]; Abramowitz, Stegun 1964, table 25.4.
constexpr std::array<std::array<double, 2>, 4> k_rule = {
    {{0.1834346424956498, 0.3626837833783620},
     {0.5255324099163290, 0.3137066458778873},
     {0.7966664774136267, 0.2223810344533745},
     {0.9602898564975363, 0.1012285362903763}}};
// Of an interval along a meridian and of one in azimuth; the latter's must stay above the noise
// that the former leaves.
constexpr double k_tolerance_along = 1e-13, k_tolerance_around = 1e-11;
constexpr int k_least_depth = 3, k_most_depth = 16;

// Halved until halves and whole agree, and thrice at least, so that nothing narrow is overlooked.
template <class F> LobeMoments integrate(const F& f, double from, double to, double tolerance) {
  const auto interval = [&](double a, double b) {
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    LobeMoments sum;
    for (const auto& [node, weight] : k_rule)
      sum = sum + (f(middle - half * node) + f(middle + half * node)) * (weight * half);
    return sum;
  };
  const auto refine = [&](const auto& self, double a, double b, LobeMoments whole,
                          int depth) -> LobeMoments {
    const double middle = 0.5 * (a + b);
    const LobeMoments first = interval(a, middle), second = interval(middle, b);
    const LobeMoments both = first + second;
    const double change = std::abs(both.mass - whole.mass) + length(both.first - whole.first);
    const bool good = change < tolerance * std::max(1.0, std::abs(both.mass));
    if (depth >= k_most_depth || (depth >= k_least_depth && good)) return both;
    return self(self, a, middle, first, depth + 1) + self(self, middle, b, second, depth + 1);
  };
  return refine(refine, from, to, interval(from, to), 0);
}

struct Polar {
  const f64::Lobe& lobe;
  Vec3d q, e; // (e, y, q) is right-handed

  explicit Polar(const f64::Lobe& l)
      : lobe(l), q(normalize(f64::from_cosine(l, {0, 0, 1}))), e(q.z, 0, -q.x) {}

  // From phi_a to phi_b, along each meridian up to the plane with this normal.
  LobeMoments sector(Vec3d normal, double phi_a, double phi_b) const {
    return integrate(
        [&](double phi) {
          const Vec3d u = e * std::cos(phi) + Vec3d(0, std::sin(phi), 0);
          const double side = dot(normal, q) < 0 ? -1 : 1;
          const double end = std::atan2(side * dot(normal, q), -side * dot(normal, u));
          // t = end s^3: the lobe may be narrow, and it is at t = 0.
          return integrate(
              [&](double s) {
                const double t = end * s * s * s;
                const Vec3d w = q * std::cos(t) + u * std::sin(t);
                const double mass = f64::eval_lobe(lobe, w) * std::sin(t) * 3 * end * s * s;
                return LobeMoments{mass, w * mass};
              },
              0, 1, k_tolerance_along);
        },
        phi_a, phi_b, k_tolerance_around);
  }
};

} // namespace

LobeMoments integrate_over_sphere(const f64::Lobe& lobe) {
  const Polar polar(lobe);
  return polar.sector({lobe.m20, 0, lobe.m22}, -f64::k_pi, f64::k_pi);
}

LobeMoments integrate_over_polygon(const f64::Lobe& lobe, std::span<const Vec3d> corners) {
  const Polar polar(lobe);
  LobeMoments sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = normalize(corners[i]), b = normalize(corners[(i + 1) % corners.size()]);
    const Vec3d normal = cross(a, b);
    // An edge through q has a triangle of no area.
    if (std::abs(dot(normal, polar.q)) <= 1e-14 * length(normal)) continue;
    const double ax = dot(a, polar.e), bx = dot(b, polar.e);
    const double from = std::atan2(a.y, ax);
    const double turn = std::atan2(ax * b.y - a.y * bx, ax * bx + a.y * b.y);
    sum = sum + polar.sector(normal, from, from + turn);
  }
  return sum.mass < 0 ? sum * -1 : sum;
}

} // namespace openltc::plot
