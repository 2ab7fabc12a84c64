// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: ANSI/IES LM-63-2002, section 3, photometric planes, zero and horizontal, and the senses
// of the angles; CIE 121-1996, the relations between planes:
//   tan B = tan gamma cos C,  sin beta  = sin gamma sin C    (its B: V; its beta: -H)
//   tan A = tan gamma sin C,  sin alpha = sin gamma cos C    (its A: -H; its alpha: V)
// which follow from the directions in ies.h.

#include "openltc/light/photometry/ies.h"

#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

constexpr double k_degree = std::numbers::pi / 180;

} // namespace

ProfileAxes profile_axes(PhotometricType type, Vec3f x, Vec3f y, Vec3f z) {
  switch (type) {
  case PhotometricType::a: // the pole is V = 90; azimuth H, 0 at the aim, 90 at -y
    return {z, -y, x};
  case PhotometricType::b: // the pole is H = -90; azimuth V, 0 at the aim, 90 at x
    return {z, x, y};
  default:
    return {x, y, z};
  }
}

Vec3d direction_of(PhotometricType type, PhotometricAngles angles) {
  const double v = angles.vertical * k_degree, h = angles.horizontal * k_degree;
  switch (type) {
  case PhotometricType::a:
    return {std::sin(v), -std::cos(v) * std::sin(h), std::cos(v) * std::cos(h)};
  case PhotometricType::b:
    return {std::sin(v) * std::cos(h), -std::sin(h), std::cos(v) * std::cos(h)};
  default:
    return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), std::cos(v)};
  }
}

PhotometricAngles angles_of(PhotometricType type, Vec3d d) {
  switch (type) {
  case PhotometricType::a:
    return {std::atan2(d.x, std::hypot(d.y, d.z)) / k_degree, std::atan2(-d.y, d.z) / k_degree};
  case PhotometricType::b:
    return {std::atan2(d.x, d.z) / k_degree, std::atan2(-d.y, std::hypot(d.x, d.z)) / k_degree};
  default: {
    // At the poles every angle is as good as 0.
    const double across = std::hypot(d.x, d.y);
    const double h = across > 1e-14 * std::abs(d.z) ? std::atan2(d.y, d.x) / k_degree : 0;
    return {std::atan2(across, d.z) / k_degree, h < 0 ? h + 360 : h};
  }
  }
}

PhotometricAngles node_angles(const IesProfile& profile, std::size_t azimuth, std::size_t polar) {
  const double a = profile.azimuth_degrees[azimuth], p = profile.polar_degrees[polar];
  switch (profile.type) {
  case PhotometricType::a:
    return {90 - p, a};
  case PhotometricType::b:
    return {a, p - 90};
  default:
    return {p, a};
  }
}

} // namespace openltc::light
