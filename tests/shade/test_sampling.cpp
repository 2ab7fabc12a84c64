// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Pearson's chi-square test of every sampler against its density.

#include "openltc/target/shade_f64.h"
#include "tests/shade/chi_square.h"
#include "tests/shade/random.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace openltc;
using testing::chi_square_p;
using testing::p_of_counts;
using testing::Random;
using testing::SphereMap;

namespace {

// p-value of `count` samples against `pdf`, in 20 x 20 bins around `axis`. What the density lacks
// to 1 is expected where the samples' z is not positive if `loses_below`.
template <class Sample, class Pdf>
double p_value(Vec3d axis, double width, Sample sample, Pdf pdf, bool loses_below,
               std::uint64_t seed) {
  const int bins = 20, sub = 24, count = 200000;
  const SphereMap map(axis, width);
  std::vector<double> expected(bins * bins), observed(bins * bins);
  double mass = 0;
  for (int i = 0; i < bins * sub; ++i) {
    double s = (i + 0.5) / (bins * sub), ds = 1.0 / (bins * sub);
    if (i / sub == bins - 1) {
      // The last ring reaches to the axis's antipode: points crowd towards it.
      const double x = 1 - (i % sub + 0.5) / sub;
      s = 1 - x * x * x * x / bins;
      ds = 4 * x * x * x / (bins * sub);
    }
    for (int j = 0; j < bins * sub; ++j) {
      const double phi = 2 * f64::k_pi * (j + 0.5) / (bins * sub);
      const double p =
          pdf(map.direction(s, phi)) * map.solid_angle(s) * ds * 2 * f64::k_pi / (bins * sub);
      expected[std::size_t(i / sub * bins + j / sub)] += p * count;
      mass += p;
    }
  }
  Random random(seed);
  double lost = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3d w = sample(random.square());
    if (loses_below && w.z <= 0) {
      ++lost;
      continue;
    }
    const int a = std::min(int(map.s_of(w) * bins), bins - 1);
    const int b = std::min(int(map.phi_of(w) / (2 * f64::k_pi) * bins), bins - 1);
    observed[std::size_t(a * bins + b)] += 1;
  }
  expected.push_back(count * std::max(0.0, 1 - mass));
  observed.push_back(lost);

  // Bins that expect fewer than 10 are pooled.
  double x = 0, pooled_expected = 0, pooled_observed = 0;
  int degrees = -1;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (expected[k] < 10) {
      pooled_expected += expected[k];
      pooled_observed += observed[k];
      continue;
    }
    const double d = observed[k] - expected[k];
    x += d * d / expected[k];
    ++degrees;
  }
  if (pooled_expected > 1) {
    const double d = pooled_observed - pooled_expected;
    x += d * d / pooled_expected;
    ++degrees;
  } else if (pooled_observed > 10) {
    return 0; // samples where there should be none
  }
  return chi_square_p(x, degrees);
}

// Thirty-odd tests at this level: a right sampler fails one of them once in 300 seeds, and the
// seeds are fixed. A wrong one gives 1e-20 and less.
constexpr double k_level = 1e-4;

} // namespace

TEST_CASE("GGX samples follow their density") {
  for (const double alpha : {0.01, 0.1, 0.4, 1.0}) {
    for (const double theta : {0.0, 0.6, 1.2, 1.5}) {
      const Vec3d wo(std::sin(theta), 0, std::cos(theta));
      const double p = p_value(
          Vec3d(-wo.x, 0, wo.z), alpha, [&](Vec2d u) { return f64::sample_ggx(wo, alpha, u); },
          [&](Vec3d w) { return f64::pdf_ggx(wo, w, alpha); }, true, 51);
      CAPTURE(alpha);
      CAPTURE(theta);
      CHECK(p > k_level);
    }
  }
}

TEST_CASE("lobe samples follow their density") {
  Random random(52);
  for (const double alpha : {0.01, 0.1, 0.4, 1.0}) {
    for (const double cos_theta : {1.0, 0.7, 0.2}) {
      const Vec4d abcd(cos_theta + 0.1, cos_theta - 1, 1 - cos_theta, 2 * cos_theta + 0.1);
      const f64::Lobe lobe = f64::lobe_from_mirror(abcd, alpha, cos_theta);
      const Vec3d axis = normalize(f64::from_cosine(lobe, Vec3d(0, 0, 1)));
      const double p = p_value(
          axis, alpha, [&](Vec2d u) { return f64::sample_lobe(lobe, u); },
          [&](Vec3d w) { return f64::pdf_lobe(lobe, w); }, false, 53);
      CAPTURE(alpha);
      CAPTURE(cos_theta);
      CHECK(p > k_level);
    }
  }
}

TEST_CASE("cosine samples follow their density") {
  const double p = p_value(
      Vec3d(0, 0, 1), 0.7, [](Vec2d u) { return f64::sample_lambert(u); },
      [](Vec3d w) { return f64::pdf_lambert(w); }, false, 54);
  CHECK(p > k_level);
}

TEST_CASE("the test itself tells a wrong density") {
  // The same samples against the density of another alpha, 5 % away.
  const Vec3d wo(std::sin(0.6), 0, std::cos(0.6));
  const double p = p_value(
      Vec3d(-wo.x, 0, wo.z), 0.4, [&](Vec2d u) { return f64::sample_ggx(wo, 0.4, u); },
      [&](Vec3d w) { return f64::pdf_ggx(wo, w, 0.42); }, true, 55);
  CHECK(p < 1e-10);
}

TEST_CASE("triangles are sampled evenly over their solid angle") {
  Random random(57);
  constexpr int rows = 8, count = 100000;
  int tested = 0;
  for (int i = 0; i < 20; ++i) {
    const double size = i < 5 ? 4.0 : random.log_uniform(0.05, 2);
    const Vec3d a = random.sphere(), ab = random.sphere() * size, ac = random.sphere() * size;
    const f64::SphericalTriangle whole = f64::spherical_triangle(a, ab, ac);
    if (whole.solid_angle < 1e-4) continue;
    // Cut along both edges into rows * rows small ones, upright and turned, each with its share.
    const auto part = [&](double y, double z, double step) {
      return f64::spherical_triangle(a + ab * y + ac * z, ab * step, ac * step).solid_angle /
             whole.solid_angle;
    };
    const double step = 1.0 / rows;
    std::vector<double> expected(2 * rows * rows), observed(2 * rows * rows);
    for (int y = 0; y < rows; ++y)
      for (int z = 0; y + z < rows; ++z) {
        const auto bin = std::size_t(2 * (y * rows + z));
        expected[bin] = count * part(y * step, z * step, step);
        if (y + z + 1 < rows)
          expected[bin + 1] = count * part((y + 1) * step, (z + 1) * step, -step);
      }
    const double det = dot(a, cross(ab, ac));
    for (int k = 0; k < count; ++k) {
      // w = a x + ab y x + ac z x.
      const Vec3d w = f64::sample_spherical_triangle(whole, random.square());
      const double x = dot(w, cross(ab, ac)) / det;
      const double y = dot(w, cross(ac, a)) / (det * x) * rows,
                   z = dot(w, cross(a, ab)) / (det * x) * rows;
      CHECK(x > 0);
      const int yi = std::clamp(int(y), 0, rows - 1), zi = std::clamp(int(z), 0, rows - 1);
      const auto bin = std::size_t(2 * (yi * rows + zi) + (y - yi + z - zi > 1 ? 1 : 0));
      observed[bin] += 1;
    }
    CAPTURE(i);
    CAPTURE(whole.solid_angle);
    CHECK(p_of_counts(expected, observed) > k_level);
    ++tested;
  }
  CHECK(tested > 10);
}

TEST_CASE("the solid angle of a triangle: an octant, additive, small ones are area over distance") {
  const f64::SphericalTriangle octant =
      f64::spherical_triangle(Vec3d(1, 0, 0), Vec3d(-1, 1, 0), Vec3d(-1, 0, 1));
  CHECK(octant.solid_angle == doctest::Approx(f64::k_pi / 2));
  Random random(59);
  for (int i = 0; i < 100; ++i) {
    const Vec3d a = random.sphere(), ab = random.sphere(), ac = random.sphere();
    const double share = random.uniform();
    const Vec3d cut = ab + (ac - ab) * share;
    CHECK(f64::spherical_triangle(a, ab, cut).solid_angle +
              f64::spherical_triangle(a, cut, ac).solid_angle ==
          doctest::Approx(f64::spherical_triangle(a, ab, ac).solid_angle));
    const f64::SphericalTriangle small = f64::spherical_triangle(a, ab * 1e-6, ac * 1e-6);
    CHECK(small.solid_angle ==
          doctest::Approx(0.5e-12 * std::abs(dot(a, cross(ab, ac)))).epsilon(1e-4));
  }
}

TEST_CASE("ellipses are sampled by solid angle: their density, and how even it is") {
  Random random(58);
  constexpr int rings = 8, parts = 16, count = 100000, fine = 16;
  double farthest = 1;
  int tested = 0;
  for (int i = 0; i < 24; ++i) {
    // Disks and ellipses from far to near.
    const f64::Frame frame = f64::shading_frame(random.sphere(), random.sphere());
    const Vec3d center = random.sphere() * (i < 6 ? 0.5 : 1.0);
    const double size = random.log_uniform(0.1, 2);
    const f64::Ellipse ellipse{center, frame.t1 * size,
                               frame.t2 * (size * (i % 2 == 0 ? 1.0 : random.uniform(0.2, 1))), 1};
    const f64::SeenEllipse seen = f64::ellipse_seen(ellipse, Vec3d(0, 0, 0), 0.0);
    if (!seen.known) continue;
    // Cells even in the ellipse's own area, each the share that the density gives it.
    const double area = f64::k_pi * length(ellipse.half_u) * length(ellipse.half_v);
    std::vector<double> expected(rings * parts), observed(rings * parts);
    double solid_angle = 0;
    for (int r = 0; r < rings * fine; ++r)
      for (int k = 0; k < parts * fine; ++k) {
        const double radius = std::sqrt((r + 0.5) / (rings * fine));
        const double phi = 2 * f64::k_pi * (k + 0.5) / (parts * fine);
        const Vec3d to = center + ellipse.half_u * (radius * std::cos(phi)) +
                         ellipse.half_v * (radius * std::sin(phi));
        const f64::LightPoint point =
            f64::intersect_ellipse(ellipse, seen, Vec3d(0, 0, 0), normalize(to));
        const double cell = area / (rings * parts * fine * fine) * point.cos_light / dot(to, to);
        solid_angle += cell;
        expected[std::size_t(r / fine * parts + k / fine)] += count * cell / point.solid_angle;
      }
    double mean = 0;
    for (int k = 0; k < count; ++k) {
      const f64::LightPoint point =
          f64::sample_ellipse(ellipse, seen, Vec3d(0, 0, 0), random.square());
      REQUIRE(point.hit);
      mean += point.solid_angle / count;
      farthest =
          std::max({farthest, point.solid_angle / solid_angle, solid_angle / point.solid_angle});
      const Vec3d at = point.direction * point.distance - center;
      const double x = dot(at, ellipse.half_u) / dot(ellipse.half_u, ellipse.half_u);
      const double y = dot(at, ellipse.half_v) / dot(ellipse.half_v, ellipse.half_v);
      const double phi = std::atan2(y, x) / (2 * f64::k_pi);
      const int ring = std::clamp(int((x * x + y * y) * rings), 0, rings - 1);
      const int part = std::clamp(int((phi < 0 ? phi + 1 : phi) * parts), 0, parts - 1);
      observed[std::size_t(ring * parts + part)] += 1;
    }
    CAPTURE(i);
    CAPTURE(solid_angle);
    CHECK(mean == doctest::Approx(solid_angle).epsilon(2e-3));
    CHECK(p_of_counts(expected, observed) > k_level);
    ++tested;
  }
  MESSAGE("density over that of even samples: within a factor of ", farthest);
  CHECK(farthest < 1.05);
  CHECK(tested > 15);
}

// What a tube shows at a place of its surface: a cell of its side, or of an end.
struct TubeCell {
  Vec3d to;
  double projected; // area times cosine, 0 where it faces away
};

TEST_CASE("tubes are sampled by solid angle: their density, and how even it is") {
  Random random(59);
  constexpr int count = 100000, rows = 16, columns = 16, fine = 16;
  double farthest = 1;
  int tested = 0;
  for (int i = 0; i < 30; ++i) {
    const double caps = i % 3;
    const Vec3d axis = random.sphere();
    const double length_ = random.log_uniform(0.2, 4), radius = random.log_uniform(0.03, 0.4);
    const f64::Frame frame = f64::shading_frame(axis, random.sphere());
    // From the side, and from beyond an end.
    const double off = radius * random.log_uniform(i % 5 == 4 ? 0.2 : 1.3, 8);
    const double along = i % 2 == 0 ? random.uniform(-0.3, 1.3) : random.uniform(1.2, 2) + radius;
    const Vec3d from = frame.t1 * off - axis * (along * length_ + (i % 2 == 0 ? 0 : radius));
    const f64::Tube tube{from, from + axis * length_, radius, caps};
    if (f64::inside_tube(tube, Vec3d(0, 0, 0))) continue;
    const f64::SeenTube seen = f64::tube_seen(tube, Vec3d(0, 0, 0));
    if (!seen.known) continue;

    // Rows along the tube, the first and last of them its ends.
    const auto cell_at = [&](double row, double column) {
      const double phi = 2 * f64::k_pi * column / columns;
      const Vec3d around = frame.t1 * std::cos(phi) + frame.t2 * std::sin(phi);
      Vec3d normal = around, to;
      double area;
      if (row >= 1 && row < rows - 1) {
        to = from + axis * (length_ * (row - 1) / (rows - 2)) + around * radius;
        area = 2 * f64::k_pi * radius * length_ / ((rows - 2) * columns);
      } else {
        const double h = row < 1 ? row : row - (rows - 1); // even in area either way
        const Vec3d outwards = row < 1 ? axis * -1.0 : axis;
        const Vec3d end = row < 1 ? from : from + axis * length_;
        const double ring = caps > 1.5 ? std::sqrt(1 - h * h) : std::sqrt(h);
        normal = caps > 1.5 ? around * ring + outwards * h : outwards;
        to = end + around * (ring * radius) + (caps > 1.5 ? outwards * (h * radius) : Vec3d(0.0));
        area = caps * f64::k_pi * radius * radius / columns;
      }
      return TubeCell{to, area * std::max(-dot(normal, normalize(to)), 0.0)};
    };
    std::vector<double> expected(rows * columns), observed(rows * columns);
    double solid_angle = 0;
    for (int r = 0; r < rows * fine; ++r)
      for (int c = 0; c < columns * fine; ++c) {
        const TubeCell cell = cell_at((r + 0.5) / fine, (c + 0.5) / fine);
        if (cell.projected <= 0) continue;
        const double angle = cell.projected / (dot(cell.to, cell.to) * fine * fine);
        const f64::LightPoint point =
            f64::intersect_tube(tube, seen, Vec3d(0, 0, 0), normalize(cell.to));
        solid_angle += angle;
        expected[std::size_t(r / fine * columns + c / fine)] += count * angle / point.solid_angle;
      }
    double mean = 0;
    for (int k = 0; k < count; ++k) {
      const f64::LightPoint point = f64::sample_tube(tube, seen, Vec3d(0, 0, 0), random.square());
      REQUIRE(point.hit);
      mean += point.solid_angle / count;
      farthest =
          std::max({farthest, point.solid_angle / solid_angle, solid_angle / point.solid_angle});
      const Vec3d at = point.direction * point.distance - from;
      const double z = dot(at, axis), x = dot(at, frame.t1), y = dot(at, frame.t2);
      const double phi = std::atan2(y, x) / (2 * f64::k_pi);
      double row = 1 + z / length_ * (rows - 2);
      const double beyond = z < length_ / 2 ? -z : z - length_,
                   rest2 = (x * x + y * y) / (radius * radius);
      if (beyond > 1e-9 || (caps == 1 && beyond > -1e-9 && rest2 < 1 - 1e-9)) {
        const double h = caps > 1.5 ? beyond / radius : rest2;
        row = z < length_ / 2 ? std::min(h, 0.9999) : rows - 1 + h;
      }
      const int r = std::clamp(int(row), 0, rows - 1);
      const int c = std::clamp(int((phi < 0 ? phi + 1 : phi) * columns), 0, columns - 1);
      observed[std::size_t(r * columns + c)] += 1;
    }
    CAPTURE(i);
    CAPTURE(caps);
    CAPTURE(solid_angle);
    CHECK(mean == doctest::Approx(solid_angle).epsilon(4e-3));
    CHECK(p_of_counts(expected, observed) > k_level);
    ++tested;
  }
  MESSAGE("density over that of even samples: within a factor of ", farthest);
  CHECK(farthest < 5);
  CHECK(tested > 15);
}
