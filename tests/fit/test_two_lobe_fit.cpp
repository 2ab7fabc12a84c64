// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Tables of two lobes: the objective and its derivatives, the certificate, how close the lobes come
// to the BRDF, and that the built-in is what the fit makes.

#include "openltc/fit/fit_job.h"
#include "openltc/fit/lobe_fit.h"
#include "openltc/fit/lobe_sums.h"
#include "openltc/fit/measure/certificate.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/measure/light_error.h"
#include "openltc/fit/objective.h"
#include "openltc/fit/two_lobe_fit.h"
#include "openltc/table/table_file.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

fit::Quadrature rule_of(double roughness, double cos_theta) {
  return *fit::make_quadrature(ggx(), roughness, cos_theta, {20, 20});
}

constexpr fit::TwoLobes k_lobes = {0.5, -0.4, 1.1, 0.9, 0.7, -1.2, 2.5, 1.4, 0.35};

fit::MeasureOptions region(double from, double to) {
  fit::MeasureOptions options;
  options.horizon = fit::Horizon::clipped;
  options.roughness_from = from;
  options.roughness_to = to;
  return options;
}

table::LobeTable fitted(const char* brdf, int size, int radial = 16) {
  fit::TableFitOptions options;
  options.size = size;
  options.quadrature = {radial, radial};
  Result<table::LobeTable> result = fit::fit_two_lobe_table(*brdf::find_brdf(brdf), options);
  REQUIRE(result);
  return *result;
}

// A table of one cell of width one, whose lobes differ in B and C alone.
table::LobeTable one_cell(float b_left, float c_right) {
  table::LobeTable t;
  t.columns = t.rows = 2;
  t.width = brdf::LobeWidth::one;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      const float texel[8] = {1, column == 0 ? b_left : 0, column == 0 ? 0 : c_right, 1, 1, 0, 0,
                              0};
      t.texels.insert(t.texels.end(), texel, texel + 8);
    }
  return t;
}

} // namespace

TEST_CASE("two lobes: the objective is the sum of its distances over the quadrature") {
  const fit::Quadrature q = rule_of(0.5, 0.4);
  // Densities by shading's own lobes, each over its share.
  const auto lobe = [&](int at) {
    return f64::lobe_from_mirror({k_lobes[std::size_t(at)], k_lobes[std::size_t(at) + 1],
                                  k_lobes[std::size_t(at) + 2], k_lobes[std::size_t(at) + 3]},
                                 q.width, q.cos_theta);
  };
  const f64::Lobe first = lobe(0), second = lobe(4);
  const double w = k_lobes[8], c = q.cos_theta, s = std::sqrt(1 - c * c);
  double missing = 0, squares = 0, cubes = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Vec3d wi(c * q.x_mirror[i] - s * q.z_mirror[i], q.y[i],
                   s * q.x_mirror[i] + c * q.z_mirror[i]);
    const double d = (1 - w) * f64::eval_lobe(first, wi) / f64::share_above_horizon(first) +
                     w * f64::eval_lobe(second, wi) / f64::share_above_horizon(second);
    const double r = d - q.density[i];
    missing += q.weight[i] * std::max(-r, 0.0);
    squares += q.weight[i] * r * r;
    cubes += q.weight[i] * std::abs(r) * r * r;
  }
  fit::Objective objective;
  objective.rounding = 1e-9;
  const double want = objective.tv * missing + objective.l2 * std::sqrt(squares / q.norm2) +
                      objective.l3 * std::cbrt(cubes / q.norm3);
  CHECK(fit::evaluate_objective(q, k_lobes, objective).value ==
        doctest::Approx(want).epsilon(1e-6));
}

TEST_CASE("two lobes: derivatives are those of differences, and one lobe is a case of two") {
  const fit::Quadrature q = rule_of(0.4, 0.3);
  for (const char* name : {"balanced", "tv", "l2", "l3"}) {
    CAPTURE(std::string(name));
    const fit::Objective objective = *fit::find_objective(name);
    const fit::TwoLobeObjectiveValue at = fit::evaluate_objective(q, k_lobes, objective);
    for (std::size_t k = 0; k < 9; ++k) {
      CAPTURE(k);
      fit::TwoLobes low = k_lobes, high = k_lobes;
      const double h = 1e-6;
      low[k] -= h;
      high[k] += h;
      const double slope = (fit::evaluate_objective(q, high, objective, false).value -
                            fit::evaluate_objective(q, low, objective, false).value) /
                           (2 * h);
      CHECK(at.gradient[k] == doctest::Approx(slope).epsilon(1e-4).scale(1e-2));
    }
    fit::TwoLobes twice = k_lobes;
    std::copy_n(twice.begin(), 4, twice.begin() + 4);
    const fit::ObjectiveValue one =
        fit::evaluate_objective(q, Vec4d(twice[0], twice[1], twice[2], twice[3]), objective);
    CHECK(fit::evaluate_objective(q, twice, objective).value ==
          doctest::Approx(one.value).epsilon(1e-12));
  }
  fit::TwoLobes outside = k_lobes;
  outside[8] = 1.1;
  CHECK(std::isinf(fit::evaluate_objective(q, outside, {}).value));
  outside = k_lobes;
  outside[7] = -1;
  CHECK(std::isinf(fit::evaluate_objective(q, outside, {}).value));
}

TEST_CASE("two lobes: every instruction set gives the same bits") {
  const fit::Quadrature q = rule_of(0.3, 0.5);
  fit::TwoLobeSumsInput in;
  in.points.x = q.x_mirror.data();
  in.points.y = q.y.data();
  in.points.z = q.z_mirror.data();
  in.points.weight = q.weight.data();
  in.points.density = q.density.data();
  in.points.count = q.size();
  in.points.rounding = 0.05;
  in.points.floor = 1e-4;
  in.points.tv = 1;
  in.points.squares = 0.2;
  in.points.cubes = 0.1;
  for (int part = 0; part < 2; ++part) {
    auto& p = in.parts[part];
    for (int k = 0; k < 4; ++k) {
      p.m[k] = k_lobes[std::size_t(4 * part + k)] * (k == 0 ? 1 : q.width);
      p.log_slope[k] = 0.3 * k - 0.5 + part;
    }
    p.det = 0.2 + part;
    p.weight = part == 0 ? 0.65 : 0.35;
  }
  const std::vector<fit::LobeSums> variants = fit::all_lobe_sums();
  fit::LobeDistances distances[2] = {};
  fit::TwoLobeDerivatives derivatives[2] = {};
  variants[0].two_distances(in, distances[0]);
  variants[0].two_derivatives(in, derivatives[0]);
  CHECK(distances[0].squares > 0);
  for (const fit::LobeSums& other : variants) {
    other.two_distances(in, distances[1]);
    other.two_derivatives(in, derivatives[1]);
    CHECK(std::memcmp(&distances[0], &distances[1], sizeof(distances[0])) == 0);
    CHECK(std::memcmp(&derivatives[0], &derivatives[1], sizeof(derivatives[0])) == 0);
  }
}

TEST_CASE("the certificate finds what happens between nodes, in either lobe") {
  // Half way A D - B C = 1 - (b/2)(c/2): 0.0975 at 1.9, below 0 from 2 on. All nodes have 1.
  table::LobeTable good = one_cell(1.9f, 1.9f), bad = one_cell(2.1f, 2.1f);
  const double least = fit::certify_determinants(good).lower_bound;
  CHECK(least > 0);
  CHECK(least <= 0.0975 + 1e-6);
  CHECK(fit::certify_determinants(bad).lower_bound < 0);
  for (int texel = 0; texel < 4; ++texel)
    for (int k = 0; k < 4; ++k)
      good.second.push_back(bad.texels[std::size_t(8 * texel + k)]);
  CHECK(fit::certify_determinants(good).lower_bound < 0);
  // With the width alpha, x^2, the least is 1 - b c x^3 (1 - x) at x = 3/4, 0.535.
  bad.width = brdf::LobeWidth::alpha;
  CHECK(fit::certify_determinants(bad).lower_bound > 0.4);
  CHECK(fit::certify_determinants(bad).lower_bound < 0.536);
}

TEST_CASE("the built-in table of two lobes regenerates byte for byte, and keeps its promises") {
  fit::TableFitOptions options;
  options.size = fit::k_two_lobe_size;
  Result<table::LobeTable> fit = fit::fit_two_lobe_table(ggx(), options);
  REQUIRE(fit);
  const table::LobeTable& builtin = table::builtin_ggx_two_lobe_table();
  const fit::LobeFunction lobes = fit::lobes_of(*fit);
  const Result<fit::TableError> rough = fit::measure_lobes(ggx(), lobes, region(0.06, 1));
  const Result<fit::TableError> sharp = fit::measure_lobes(ggx(), lobes, region(0.01, 0.06));
  REQUIRE((rough && sharp));
  fit::complete_metadata(fit->metadata, *rough, builtin.metadata.tool_version.c_str(),
                         "openltc fit --brdf ggx --form two-lobe --size 32");
  std::ifstream file(OPENLTC_SOURCE_DIR "/openltc/api/ggx_two_lobes.inc", std::ios::binary);
  const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const bool same = table::to_builtin_source(*fit) == source;
  CHECK_MESSAGE(same, "run tools/make_builtin_lobes.sh, or undo what changed the fit");

  CHECK(rough->mean.tv < 0.0165);
  CHECK(rough->p95.tv < 0.065);
  CHECK(rough->mean.l2 < 0.026);
  CHECK(rough->mean.l3 < 0.029);
  CHECK(sharp->mean.tv < 0.00125);
  CHECK(fit::certify_determinants(*fit).lower_bound > 0);
  for (int row = 0; row < options.size; ++row)
    for (int column = 0; column < options.size; ++column) {
      CHECK(fit->texel(column, row)[6] >= 0);
      CHECK(fit->texel(column, row)[6] <= 1);
    }
}

TEST_CASE("lights by the built-in table of two lobes err by half, and keep to the bound") {
  const fit::MeasuredLobes own[2] = {
      {"two", fit::lobes_of(table::builtin_ggx_two_lobe_table()), fit::Horizon::clipped},
      {"one", fit::lobes_of(table::builtin_ggx_table()), fit::Horizon::clipped}};
  fit::LightFamily family;
  family.count = 500;
  const auto errors = fit::measure_lights(ggx(), own, family);
  REQUIRE(errors);
  CHECK((*errors)[0].violations == 0);
  CHECK((*errors)[0].rmse < 0.5 * (*errors)[1].rmse);
  CHECK((*errors)[0].rmse < 0.004);
}

TEST_CASE("two lobes: the number of threads does not matter") {
  std::string results[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, k == 0 ? 1 : 4);
    results[k] = table::to_json(fitted("ggx", 7, 12));
  }
  CHECK((results[0] == results[1]));
}

TEST_CASE("two lobes fit every kind of BRDF better than one, from few nodes to many") {
  const std::pair<const char*, int> cases[] = {
      {"eon", 7}, {"charlie", 7}, {"beckmann", 7}, {"ggx", 26}};
  for (const auto& one_case : cases) {
    const char* name = one_case.first;
    const int size = one_case.second;
    CAPTURE(std::string(name));
    const brdf::Brdf& brdf = *brdf::find_brdf(name);
    fit::TableFitOptions options;
    options.size = size;
    const Result<table::LobeTable> one = fit::fit_table(brdf, options);
    REQUIRE(one);
    const table::LobeTable two = fitted(name, size);
    CHECK(two.two_lobes());
    fit::MeasureOptions where = region(0.06, 1);
    where.points = 12;
    const double before = fit::measure_lobes(brdf, fit::lobes_of(*one), where)->mean.tv;
    const double after = fit::measure_lobes(brdf, fit::lobes_of(two), where)->mean.tv;
    CHECK(after < 0.9 * before);
    CHECK(fit::certify_determinants(two).lower_bound > 0);
  }
}

TEST_CASE("two lobes: a fit can be stopped, and refuses what a table refuses") {
  fit::TableFitOptions options;
  options.size = 5;
  options.quadrature = {12, 12};
  int calls = 0;
  const auto stopped =
      fit::fit_two_lobe_table(ggx(), options, [&](double) { return ++calls < 12; });
  REQUIRE_FALSE(stopped);
  CHECK(calls == 12);
  options.size = 1;
  CHECK_FALSE(fit::fit_two_lobe_table(ggx(), options));
}
