// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Inverse tangents, the same in every target: of any angle to the last digits, for the lights' outlines, and
// of half a turn to 2.5e-7 radians, by one polynomial and no choice of range, for the profiles of light.

/// atan(x) / x for |x| <= tan(pi/8), from x2 = x^2; relative error 2.2e-11 (Chebyshev interpolation).
FN Real atan_over_small(Real x2) {
  return Real(0.9999999999783847) +
         x2 * (Real(-0.3333333209692669) +
               x2 * (Real(0.19999883803916288) +
                     x2 * (Real(-0.14281587308807808) +
                           x2 * (Real(0.11040471028770685) +
                                 x2 * (Real(-0.08456089562356194) +
                                       x2 * Real(0.04707129830797903))))));
}

/// Angle of the vector (x, y) from the x axis, -pi..pi; 0 for the zero vector.
FN Real angle_of(Real x, Real y) {
  Real ax = abs(x);
  Real ay = abs(y);
  Real small = min(ax, ay);
  Real large = max(max(ax, ay), Real(k_tiny));
  // atan(t) = pi/4 + atan((t - 1)/(t + 1)) brings t from 0..1 to within tan(pi/8).
  Mask steep = small > Real(0.41421356237309503) * large;
  Real t = select(steep, small - large, small) / select(steep, small + large, large);
  Real angle = t * atan_over_small(t * t) + select(steep, Real(0.25) * k_pi, Real(0.0));
  angle = select(ay > ax, Real(0.5) * k_pi - angle, angle);
  angle = select(x < Real(0.0), k_pi - angle, angle);
  return select(y < Real(0.0), -angle, angle);
}

/// atan(x) / x, 1 at 0.
FN Real atan_over(Real x) {
  Real a = abs(x);
  Mask small = a < Real(0.4);
  return select(small, atan_over_small(min(a * a, Real(0.16))),
                angle_of(Real(1.0), a) / max(a, Real(0.4)));
}

/// atan(x) for x in [0, 1]: odd minimax polynomial of degree 13, absolute error 2.5e-7.
FN Real atan_unit(Real x) {
  Real y = x * x;
  return x *
         (Real(0.999996111549571) +
          y * (Real(-0.33317368054749336) +
               y * (Real(0.19807815564989179) +
                    y * (Real(-0.13233342095574632) +
                         y * (Real(0.07962367236561659) + y * (Real(-0.033604220565024996) +
                                                               y * Real(0.006811793290873252)))))));
}

/// Angle of (x, y) from the x axis for y >= 0, in [0, pi]; 0 where both vanish.
FN Real half_turn_angle(Real x, Real y) {
  Real ax = abs(x);
  Real larger = max(ax, y);
  Real angle = atan_unit(min(ax, y) / max(larger, Real(k_tiny)));
  angle = select(y > ax, Real(0.5) * k_pi - angle, angle);
  return select(x < Real(0.0), k_pi - angle, angle);
}
