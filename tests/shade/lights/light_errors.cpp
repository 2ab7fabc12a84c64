// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shade/lights/light_errors.h"

#include "openltc/base/parallel.h"
#include "tests/shade/lights/light_reference.h"
#include "tests/shade/lights/published_formulas.h"

#include <algorithm>
#include <cmath>

namespace openltc::testing {

namespace {

struct Differences {
  float roughness = 0;
  double diffuse = 0, specular = 0, published = 0, leaking = 0, fit = 0, integral = 0;
};

double distance_to_line(const LightCase& light) {
  const Vec3d a = to_double(light.a), p = to_double(light.position), ab = to_double(light.b) - a;
  const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
  return length(p - a - ab * t);
}

Differences compare(const LightCase& light) {
  const CaseView view = view_of(light);
  const CaseAnswer answer = evaluate(light);
  const double exact = contour_integral(light, view, view.lobe).z;
  double scale = 1;
  if (light.shape == LightShape::line) {
    scale = 0.1 * distance_to_line(light);
    scale /= std::max(scale * exact, 1.0);
  }
  const double leaking = contour_integral(light, view, view.lobe, false).z;
  const double published = published_integral(light, view, view.lobe);
  Differences d;
  d.roughness = light.roughness;
  d.diffuse = scale * std::abs(double(answer.diffuse) -
                               contour_integral(light, view, f64::cosine_lobe()).z);
  d.specular = scale * std::abs(double(answer.specular) - exact);
  d.published = scale * std::abs(published - leaking);
  d.leaking = scale * std::abs(published - exact);
  if (is_polygon(light.shape))
    d.fit = std::abs(published_polygon_fit(light, view, view.lobe) - leaking);
  d.integral = scale * exact;
  return d;
}

ErrorFigures figures(const std::vector<Differences>& all, double Differences::*which, bool rough) {
  ErrorFigures f;
  std::vector<double> values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((all[i].roughness >= 0.2f) != rough) continue;
    const double value = all[i].*which;
    values.push_back(value);
    f.mean += value;
    if (!(value <= f.largest)) { // a NaN counts as the largest
      f.largest = value;
      f.worst = i;
    }
    if (!(value <= 1e-5)) {
      ++f.noticeable;
      f.noticeable_below = std::max(f.noticeable_below, all[i].roughness);
    }
  }
  f.count = std::int64_t(values.size());
  if (values.empty()) return f;
  f.mean /= double(values.size());
  const auto rank = values.begin() + std::ptrdiff_t(0.99 * double(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  f.p99 = *rank;
  return f;
}

} // namespace

LightCase error_case(LightShape shape, std::uint64_t index) {
  Random random(0x9e3779b97f4a7c15u * (index + 1) + std::uint64_t(shape));
  return random_light(shape, random);
}

std::vector<ShapeErrors> measure_light_errors(LightShape shape, std::int64_t count, int threads) {
  std::vector<Differences> all;
  all.resize(std::size_t(count));
  constexpr std::int64_t chunk = 64;
  parallel_for((count + chunk - 1) / chunk, threads, [&](std::int64_t k) {
    for (std::int64_t i = k * chunk; i < std::min((k + 1) * chunk, count); ++i)
      all[std::size_t(i)] = compare(error_case(shape, std::uint64_t(i)));
  });
  std::vector<ShapeErrors> result;
  for (const bool rough : {true, false}) {
    ShapeErrors e;
    e.shape = shape;
    e.surfaces = rough ? "rough" : "smooth";
    e.diffuse = figures(all, &Differences::diffuse, rough);
    e.specular = figures(all, &Differences::specular, rough);
    e.published = figures(all, &Differences::published, rough);
    e.published_leaking = figures(all, &Differences::leaking, rough);
    e.published_fit = figures(all, &Differences::fit, rough);
    e.mean_integral = figures(all, &Differences::integral, rough).mean;
    result.push_back(e);
  }
  return result;
}

} // namespace openltc::testing
