// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The numbers of two figures: of fits and of a polygon.

#include "fits.h"
#include "openltc/fit/measure/polygon_integral.h"
#include "openltc/plot/fit_cells.h"
#include "openltc/plot/polygon_equivalence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace openltc::wasm {

namespace {

constexpr int k_most_side = 512;
constexpr int k_most_samples = 5000;

Status check_place(double roughness, double theta_degrees) {
  if (!(roughness >= 0 && roughness <= 1))
    return Error{fmt::format("roughness is {}; it is 0 to 1", roughness)};
  if (!(theta_degrees >= 0 && theta_degrees < 90))
    return Error{fmt::format("thetaDegrees is {}; it is 0 to less than 90", theta_degrees)};
  return Success{};
}

Json points_of(const std::vector<Vec3d>& points) {
  Json list = Json::array();
  for (const Vec3d& p : points)
    list.push_back({p.x, p.y, p.z});
  return list;
}

// Over a simple polygon, convex or not: the triangles of a fan, each with the sign of its turn.
double light_by_brdf(const brdf::Brdf& brdf, double roughness, double cos_theta, double scale,
                     const std::vector<Vec3d>& corners) {
  Vec3d normal(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  double light = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d triangle[] = {corners[0], corners[i], corners[i + 1]};
    const double turn = dot(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]), normal);
    if (turn == 0) continue;
    const double part =
        fit::integrate_brdf_over_polygon(brdf, roughness, cos_theta, scale, triangle);
    light += turn > 0 ? part : -part;
  }
  return light;
}

Json space_of(const plot::PolygonSpace& space) {
  return {{"corners", points_of(space.corners)},
          {"kept", points_of(space.kept)},
          {"samples", points_of(space.samples)},
          {"inside", space.inside},
          {"integral", space.integral}};
}

} // namespace

Result<Answer> make_cells(const Kept& kept, const Json& request) {
  fit::MeasureAxes axes{numbers_of(request, "roughness"), numbers_of(request, "thetaDegrees")};
  for (const double roughness : axes.roughness)
    for (const double theta : axes.theta_degrees)
      if (Status status = check_place(roughness, theta); !status) return status.error();
  const int side = int(number_of(request, "side", 120));
  if (side < 8 || side > k_most_side)
    return Error{fmt::format("side is {}; it is 8 to {} pixels", side, k_most_side)};
  const fit::MeasuredLobes lobes{"", kept.fitted.lobes(), kept.fitted.horizon};
  const Result<std::vector<plot::FitCell>> cells =
      plot::make_fit_cells(kept.brdf, lobes, axes, side);
  if (!cells) return cells.error();
  Answer answer;
  answer.json["cells"] = Json::array();
  for (const plot::FitCell& cell : *cells) {
    Json error = Json::object();
    for (const fit::LobeErrorField& field : fit::lobe_error_fields())
      error[field.name] = cell.error.*field.member;
    answer.json["cells"].push_back(
        {{"roughness", cell.roughness},
         {"thetaDegrees", cell.theta_degrees},
         {"error", error},
         {"albedo", cell.albedo},
         {"window", {{"centerX", cell.window.center_x}, {"half", cell.window.half}}},
         {"mirrorX", fit::mirror_in_disc(std::cos(cell.theta_degrees * f64::k_pi / 180))},
         {"brightest", cell.brightest},
         {"brdf", answer.add_floats(cell.brdf)},
         {"lobe", answer.add_floats(cell.lobe)}});
  }
  return answer;
}

Result<Answer> make_polygon(const Kept& kept, const Json& request) {
  const double roughness = number_of(request, "roughness", 0.5);
  const double theta = number_of(request, "thetaDegrees", 45);
  if (Status status = check_place(roughness, theta); !status) return status.error();
  const std::vector<double> given = numbers_of(request, "corners");
  std::vector<Vec3d> corners;
  for (std::size_t i = 0; i + 2 < given.size(); i += 3)
    corners.push_back({given[i], given[i + 1], given[i + 2]});
  plot::PolygonSampling sampling;
  sampling.samples = std::clamp(int(number_of(request, "samples", 400)), 0, k_most_samples);
  const double cos_theta = std::cos(theta * f64::k_pi / 180);
  const fit::MeasuredLobe read = kept.fitted.lobes()(roughness, cos_theta);
  const Result<plot::PolygonEquivalence> spaces =
      plot::compare_spaces(read.lobe, corners, "corners", sampling);
  if (!spaces) return spaces.error();

  // The light itself, of radiance 1: n1 times the lobes' share of it, and the BRDF's.
  const fit::HalfVectors half_vectors = fit::find_half_vectors(kept.brdf, roughness);
  const Result<fit::Quadrature> rule = fit::make_quadrature(
      kept.brdf, roughness, cos_theta, half_vectors, fit::MeasureOptions{}.quadrature);
  if (!rule) return rule.error();
  const double weight = read.second.weight;
  const fit::Horizon horizon = kept.fitted.horizon;
  double share = (1 - weight) * fit::horizon_scale(read.lobe, horizon) * spaces->cosine.integral;
  if (read.two())
    share += weight * fit::horizon_scale(read.second.lobe, horizon) *
             fit::integrate_lobe_over_polygon(read.second.lobe, spaces->shading.corners);
  Answer answer;
  answer.json["shading"] = space_of(spaces->shading);
  answer.json["cosine"] = space_of(spaces->cosine);
  answer.json["matrix"] = {read.lobe.m00, 0, read.lobe.m02, 0, 1, 0,
                           read.lobe.m20, 0, read.lobe.m22};
  answer.json["horizonInCosine"] = points_of({spaces->horizon_normal_cosine})[0];
  answer.json["horizonOfLobe"] = points_of({spaces->horizon_normal_shading})[0];
  answer.json["albedo"] = rule->n1;
  answer.json["lightByLobe"] = read.n1 * share;
  answer.json["lightByBrdf"] =
      light_by_brdf(kept.brdf, roughness, cos_theta, half_vectors.scale, spaces->shading.corners);
  return answer;
}

} // namespace openltc::wasm
