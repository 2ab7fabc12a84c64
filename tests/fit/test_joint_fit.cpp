// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fits of many lobes at once: what refinement wins, and that it finds what is known.

#include "openltc/fit/joint/joint_fit.h"
#include "openltc/fit/table_fit.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <cmath>

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

// Two unknowns at the ends of a line of roughness, samples between them.
std::vector<fit::JointSample> line_of_samples() {
  std::vector<fit::JointSample> samples;
  for (int i = 0; i < 9; ++i) {
    const double t = (i + 0.5) / 9;
    fit::JointSample sample;
    sample.rule = *fit::make_quadrature(ggx(), 0.4 + 0.2 * t, 0.6, {16, 16});
    sample.terms = {{0, 1 - t}, {1, t}};
    samples.push_back(sample);
  }
  return samples;
}

// What balanced minimises, between the nodes.
double mean_objective(const table::LobeTable& table, double from, double to) {
  fit::MeasureOptions options;
  options.roughness_from = from;
  options.roughness_to = to;
  options.horizon = fit::Horizon::clipped;
  const fit::LobeError mean = fit::measure_lobes(ggx(), fit::lobes_of(table), options)->mean;
  const fit::Objective balanced;
  return balanced.tv * mean.tv + balanced.l2 * mean.l2 + balanced.l3 * mean.l3;
}

} // namespace

TEST_CASE("a joint fit with one unknown is the fit of its one sample") {
  fit::JointSample sample;
  sample.rule = *fit::make_quadrature(ggx(), 0.5, 0.4, {20, 20});
  sample.terms = {{0, 1.0}};
  const Vec4d start = fit::cosine_start(sample.rule.width, 0.4);
  fit::JointFitOptions joint;
  joint.max_iterations = 200;
  joint.tolerance = 1e-12;
  fit::LobeFitOptions alone;
  alone.tolerance = 1e-12;
  const fit::JointFit together = fit::fit_jointly({sample}, {start}, joint);
  const fit::LobeFit single = fit::fit_lobe(sample.rule, start, alone);
  CHECK(together.objective == doctest::Approx(single.objective).epsilon(1e-7));
  CHECK(together.unknowns[0].x == doctest::Approx(single.mirror.x).epsilon(1e-3));
  CHECK(together.unknowns[0].w == doctest::Approx(single.mirror.w).epsilon(1e-3));
}

TEST_CASE("no unknown of a joint fit can be moved for the better") {
  const std::vector<fit::JointSample> samples = line_of_samples();
  const Vec4d start = fit::cosine_start(0.25, 0.6);
  fit::JointFitOptions options;
  options.max_iterations = 200;
  options.tolerance = 1e-10;
  const fit::JointFit best = fit::fit_jointly(samples, {start, start}, options);
  fit::JointFitOptions look = options;
  look.max_iterations = 0;
  for (int unknown = 0; unknown < 2; ++unknown) {
    for (const double change : {-0.01, 0.01}) {
      for (int k = 0; k < 4; ++k) {
        std::vector<Vec4d> other = best.unknowns;
        Vec4d& v = other[std::size_t(unknown)];
        (k == 0 ? v.x : k == 1 ? v.y : k == 2 ? v.z : v.w) += change;
        CHECK(fit::fit_jointly(samples, other, look).objective > best.objective);
      }
    }
  }
}

TEST_CASE("a projection of lobes that the terms can represent gives them back") {
  const std::vector<fit::JointSample> samples = line_of_samples();
  const Vec4d a(0.6, -0.3, 0.5, 1.2), b(0.7, -0.2, 0.4, 1.0);
  std::vector<Vec4d> wanted;
  std::vector<double> values;
  for (const fit::JointSample& s : samples) {
    const double t = s.terms[1].factor;
    wanted.emplace_back(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
                        a.w + (b.w - a.w) * t);
    values.push_back(0.9 - 0.2 * t);
  }
  const std::vector<Vec4d> found = fit::project_jointly(samples, wanted, 2, {});
  CHECK(found[0].x == doctest::Approx(a.x).epsilon(1e-3));
  CHECK(found[0].y == doctest::Approx(a.y).epsilon(1e-3));
  CHECK(found[1].z == doctest::Approx(b.z).epsilon(1e-3));
  CHECK(found[1].w == doctest::Approx(b.w).epsilon(1e-3));
  const std::vector<double> line = fit::interpolate_jointly(samples, values, {}, {0, 0});
  CHECK(line[0] == doctest::Approx(0.9));
  CHECK(line[1] == doctest::Approx(0.7));
}

TEST_CASE("refinement pays in small tables and leaves the mean of large ones as it is") {
  for (const int size : {8, 16, 64}) {
    fit::TableFitOptions options;
    options.size = size;
    options.refine = fit::Refine::off;
    const Result<table::LobeTable> plain = fit::fit_table(ggx(), options);
    options.refine = fit::Refine::on;
    const Result<table::LobeTable> refined = fit::fit_table(ggx(), options);
    REQUIRE(plain);
    REQUIRE(refined);
    const double rough[2] = {mean_objective(*plain, 0.06, 1), mean_objective(*refined, 0.06, 1)};
    const double sharp[2] = {mean_objective(*plain, 0.01, 0.06),
                             mean_objective(*refined, 0.01, 0.06)};
    MESSAGE(size, " nodes: mean objective ", rough[0], " to ", rough[1], ", low roughness ",
            sharp[0], " to ", sharp[1]);
    CHECK(rough[1] < rough[0] * 1.001);
    CHECK(sharp[1] < sharp[0] * 1.1);
    if (size <= 16) CHECK(sharp[1] < 0.8 * sharp[0]);
  }
}

TEST_CASE("joint fits do not depend on the number of threads") {
  fit::TableFitOptions options;
  options.size = 6;
  options.refine = fit::Refine::on;
  std::vector<float> texels[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, k == 0 ? 1 : 4);
    texels[k] = fit::fit_table(ggx(), options)->texels;
  }
  CHECK((texels[0] == texels[1]));
}
