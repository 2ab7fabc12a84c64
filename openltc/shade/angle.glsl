// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Inverse tangents, the same in every target.

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
