// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Beam angle: between the directions in a plane through the axis where intensity is half of the
// maximum; field angle: a tenth (ANSI/IES RP-16, CIE S 017). Here the maximum is that of the plane,
// so that a light that is aimed off its axis has both, and the directions are the nearest ones on
// either side of it.

#include "openltc/light/photometry/photometry_summary.h"

#include "openltc/light/photometry/ies_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

Vec3d node_direction(const IesProfile& profile, std::size_t a, std::size_t p) {
  return direction_of(profile.type, node_angles(profile, a, p));
}

// Largest difference between the intensity at nodes and what eval finds for their angles.
template <class Eval> double difference(const IesProfile& profile, const Eval& eval) {
  const std::size_t count = profile.polar_degrees.size();
  double most = 0;
  for (std::size_t a = 0; a < profile.azimuth_degrees.size(); ++a)
    for (std::size_t p = 0; p < count; ++p)
      most = std::max(most, std::abs(profile.candela[a * count + p] - eval(a, p)));
  return most;
}

// Mirrored on the profile's own sphere, so that it is exact and the poles, where an azimuth means
// nothing, count as they are written. Either the polar angle
// about the equator or the azimuth about half of `twice_center`.
double mirrored_difference(const IesProfile& profile, bool over_polar, double twice_center = 0) {
  return difference(profile, [&](std::size_t a, std::size_t p) {
    const double polar = profile.polar_degrees[p], azimuth = profile.azimuth_degrees[a];
    return over_polar ? eval_own(profile, 180 - polar, azimuth)
                      : eval_own(profile, polar, twice_center - azimuth);
  });
}

bool is_round(const IesProfile& profile, double tolerance_candela) {
  const std::size_t count = profile.polar_degrees.size();
  const std::vector<double>& around = profile.azimuth_degrees;
  if (profile.type != PhotometricType::c) {
    // Another sphere's nodes: as good as the interpolation between them.
    for (const double turn_degrees : {17.0, 45.0, 90.0, 181.0}) {
      const double c = std::cos(turn_degrees * std::numbers::pi / 180),
                   s = std::sin(turn_degrees * std::numbers::pi / 180);
      const auto turned = [&](std::size_t a, std::size_t p) {
        const Vec3d d = node_direction(profile, a, p);
        return eval_candela(profile, Vec3d(c * d.x - s * d.y, s * d.x + c * d.y, d.z));
      };
      if (difference(profile, turned) > tolerance_candela) return false;
    }
    return true;
  }
  const bool is_circle = around.size() < 2 || around.back() - around.front() >= 360 - 1e-9;
  for (std::size_t i = 0; is_circle && i < profile.candela.size(); ++i)
    if (std::abs(profile.candela[i] - profile.candela[i % count]) > tolerance_candela) return false;
  return is_circle;
}

double downward_share(const IesProfile& profile) {
  // Rings of equal solid angle. Both halves alike, so that what is even is so.
  constexpr int rings = 1000;
  double down = 0, up = 0;
  for (int i = 0; i < rings; ++i) {
    const double c = (i + 0.5) / rings;
    down += mean_candela(profile, std::acos(c));
    up += mean_candela(profile, std::acos(-c));
  }
  return down + up > 0 ? down / (down + up) : 0;
}

} // namespace

PhotometricSymmetry symmetry_of(const IesProfile& profile, double tolerance) {
  const double most = tolerance * profile.max_candela;
  if (is_round(profile, most)) return PhotometricSymmetry::axis;
  // The pole of A is x, that of B is y: ies.h.
  const bool is_b = profile.type == PhotometricType::b;
  const bool is_a = profile.type == PhotometricType::a;
  const bool c0 = mirrored_difference(profile, is_b) <= most;
  const bool c90 = mirrored_difference(profile, is_a, is_b ? 0 : 180) <= most;
  return c0 && c90 ? PhotometricSymmetry::both
         : c0      ? PhotometricSymmetry::plane_c0
         : c90     ? PhotometricSymmetry::plane_c90
                   : PhotometricSymmetry::none;
}

std::vector<PlanePoint> plane_curve(const IesProfile& profile, double azimuth_degrees,
                                    double step_degrees) {
  const int half = std::max(1, int(std::lround(180 / step_degrees)));
  std::vector<PlanePoint> curve;
  for (int i = -half; i <= half; ++i) {
    const double degrees = 180.0 * i / half;
    const double azimuth = degrees < 0 ? azimuth_degrees + 180 : azimuth_degrees;
    const double candela = eval_candela(profile, std::abs(degrees) * std::numbers::pi / 180,
                                        azimuth * std::numbers::pi / 180);
    curve.push_back({degrees, candela});
  }
  return curve;
}

double angle_within(const std::vector<PlanePoint>& curve, double share) {
  // The last point is the first again.
  const int count = int(curve.size()) - 1;
  if (count < 2) return 0;
  // Of equal maxima the one nearest to the axis.
  int peak = 0;
  for (int i = 1; i < count; ++i) {
    const PlanePoint &a = curve[std::size_t(i)], &b = curve[std::size_t(peak)];
    const bool is_more = a.candela > b.candela * (1 + 1e-12);
    const bool is_equal = a.candela >= b.candela * (1 - 1e-12);
    if (is_more || (is_equal && std::abs(a.degrees) < std::abs(b.degrees))) peak = i;
  }
  if (!(curve[std::size_t(peak)].candela > 0)) return 0;
  const double level = share * curve[std::size_t(peak)].candela;
  const double step = 360.0 / count;
  const auto at = [&](int i) { return curve[std::size_t(((i % count) + count) % count)].candela; };
  double width = 0;
  for (const int way : {1, -1}) {
    int n = 0;
    while (n < count && at(peak + way * (n + 1)) >= level)
      ++n;
    if (n >= count) return 360;
    const double inside = at(peak + way * n), outside = at(peak + way * (n + 1));
    width += step * (n + (inside - level) / (inside - outside));
  }
  return std::min(width, 360.0);
}

PhotometricSummary summarise(const IesProfile& profile) {
  PhotometricSummary summary;
  summary.flux_lumens = profile.flux_lumens;
  summary.downward_share = downward_share(profile);
  summary.peak_candela = profile.max_candela;
  const std::size_t count = profile.polar_degrees.size();
  double nearest = -2;
  for (std::size_t a = 0; a < profile.azimuth_degrees.size(); ++a)
    for (std::size_t p = 0; p < count; ++p) {
      if (profile.candela[a * count + p] < profile.max_candela * (1 - 1e-12)) continue;
      const Vec3d direction = node_direction(profile, a, p);
      if (direction.z <= nearest + 1e-12) continue;
      nearest = direction.z;
      summary.peak = node_angles(profile, a, p);
      summary.peak_c = angles_of(PhotometricType::c, direction);
    }
  for (int i = 0; i < 2; ++i) {
    const std::vector<PlanePoint> curve = plane_curve(profile, 90 * i, 0.05);
    summary.beam_degrees[i] = angle_within(curve, 0.5);
    summary.field_degrees[i] = angle_within(curve, 0.1);
  }
  summary.symmetry = symmetry_of(profile);
  return summary;
}

} // namespace openltc::light
