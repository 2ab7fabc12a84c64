// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The figures that the project promises of its fits, beside those of the table that most engines
// ship, on the same points and lights.

#include "openltc/fit/measure/light_error.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/layout.h"
#include "published_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

fit::TableError measure(const fit::LobeFunction& lobes, fit::Horizon horizon, bool sharp = false,
                        table::AngleAxis axis = table::AngleAxis::sqrt_one_minus_cos) {
  fit::MeasureOptions options;
  options.horizon = horizon;
  options.angle_axis = axis;
  if (sharp) {
    options.roughness_from = 0.01;
    options.roughness_to = 0.06;
  }
  return *fit::measure_lobes(ggx(), lobes, options);
}

table::LobeTable fitted(const char* objective, int size,
                        fit::Horizon horizon = fit::Horizon::clipped) {
  fit::TableFitOptions options;
  options.size = size;
  options.lobe.objective = *fit::find_objective(objective);
  options.lobe.objective.horizon = horizon;
  return *fit::fit_table(ggx(), options);
}

} // namespace

TEST_CASE("mean total variation: tables of 64 and 16 nodes, the ltc_code layout, polynomials") {
  struct Bound {
    std::string objective;
    double native, layout, sharp, small, polynomial, polynomial_sharp;
  };
  for (const Bound& bound : {Bound{"tv", 0.0370, 0.0375, 0.0015, 0.0380, 0.0375, 0.0060},
                             Bound{"balanced", 0.0420, 0.0425, 0.0020, 0.0430, 0.0430, 0.0070}}) {
    CAPTURE(bound.objective);
    const fit::Horizon clipped = fit::Horizon::clipped, leaking = fit::Horizon::leaking;
    const table::LobeTable native = fitted(bound.objective.c_str(), 64);
    const table::LobeTable small = fitted(bound.objective.c_str(), 16);
    const table::PackedTable layout =
        *table::pack(fitted(bound.objective.c_str(), 64, leaking), table::Layout::ltc_code,
                     table::Precision::float32);
    fit::PolynomialFitOptions options;
    options.objective = *fit::find_objective(bound.objective);
    const fit::PolynomialFit polynomial = *fit::fit_polynomial(ggx(), options);

    const double of_native = measure(fit::lobes_of(native), clipped).mean.tv;
    const double sharp = measure(fit::lobes_of(native), clipped, true).mean.tv;
    const double of_layout = measure(fit::lobes_of(layout), leaking).mean.tv;
    const double of_small = measure(fit::lobes_of(small), clipped).mean.tv;
    const fit::LobeFunction lobes = fit::lobes_of(polynomial.polynomial);
    const double of_polynomial = measure(lobes, clipped).mean.tv;
    const double polynomial_sharp = measure(lobes, clipped, true).mean.tv;
    const double by_theta =
        measure(fit::lobes_of(native), clipped, false, table::AngleAxis::theta).mean.tv;
    MESSAGE(bound.objective, ": native ", of_native, " (uniform in theta ", by_theta,
            "), low roughness ", sharp, ", ltc_code ", of_layout, ", 16 nodes ", of_small,
            ", degree 4 ", of_polynomial, " and ", polynomial_sharp);
    CHECK(of_native <= bound.native);
    CHECK(sharp <= bound.sharp);
    CHECK(of_layout <= bound.layout);
    CHECK(of_small <= bound.small);
    CHECK(of_polynomial <= bound.polynomial);
    CHECK(polynomial_sharp <= bound.polynomial_sharp);
  }
}

// What docs/fitting.md says: better in every figure of its table at once, with thirty per cent less
// L2 and L3. The published table is read both with the light below the horizon and without, and the
// reading that is better for it counts. With points uniform in theta instead, which the docs speak
// of as a variant, no margin is asked, and the largest twentieth of the peaks is compared with its
// own reading alone.
TEST_CASE("balanced beats the published table in every figure at once") {
  const auto published = testing::published_lobes();
  if (!published) {
    MESSAGE("skipped: the published table is not there, see tests/CMakeLists.txt");
    return;
  }
  const table::LobeTable native = fitted("balanced", 64), tv = fitted("tv", 64);
  const fit::LobeFunction ours = fit::lobes_of(native), theirs = *published;
  for (const table::AngleAxis axis :
       {table::AngleAxis::sqrt_one_minus_cos, table::AngleAxis::theta}) {
    const fit::TableError a = measure(ours, fit::Horizon::clipped, false, axis);
    // Theirs in the reading that is better for it, figure by figure.
    const fit::TableError lost = measure(theirs, fit::Horizon::leaking, false, axis);
    const fit::TableError cut = measure(theirs, fit::Horizon::clipped, false, axis);
    MESSAGE("TV ", a.mean.tv, " for ", lost.mean.tv, " and ", cut.mean.tv, "; L2 ", a.mean.l2,
            " for ", lost.mean.l2, "; L3 ", a.mean.l3, " for ", lost.mean.l3, "; peak p95 ",
            a.p95.peak, " for ", lost.p95.peak, " and ", cut.p95.peak, "; leak ", a.mean.leak,
            " for ", lost.mean.leak);
    const bool documented = axis == table::AngleAxis::sqrt_one_minus_cos;
    const double share = documented ? 0.7 : 1;
    CHECK(a.mean.tv < std::min(lost.mean.tv, cut.mean.tv));
    CHECK(a.mean.l1 < std::min(lost.mean.l1, cut.mean.l1));
    CHECK(a.mean.l2 < share * std::min(lost.mean.l2, cut.mean.l2));
    CHECK(a.mean.l3 < share * std::min(lost.mean.l3, cut.mean.l3));
    CHECK(a.median.peak < std::min(lost.median.peak, cut.median.peak));
    CHECK(a.p95.peak < lost.p95.peak);
    if (documented) CHECK(a.p95.peak < cut.p95.peak);
    // Clipped, nothing is left to leak.
    CHECK(a.mean.leak < lost.mean.leak);
    CHECK(a.max.leak < lost.max.leak);
  }
  const double our_bends = fit::mean_second_difference(ours, 64);
  const double their_bends = fit::mean_second_difference(theirs, 64);
  MESSAGE("second differences ", our_bends, " for ", their_bends);
  CHECK(our_bends < their_bends);

  const std::vector<fit::MeasuredLobes> candidates = {
      {"balanced", ours, fit::Horizon::clipped},
      {"tv", fit::lobes_of(tv), fit::Horizon::clipped},
      {"published", theirs, fit::Horizon::leaking}};
  const std::vector<fit::LightError> lights = *fit::measure_lights(ggx(), candidates, {});
  MESSAGE("random rectangles, RMSE: balanced ", lights[0].rmse, ", tv ", lights[1].rmse,
          ", published ", lights[2].rmse);
  CHECK(lights[0].rmse < 0.6 * lights[2].rmse);
  CHECK(lights[1].rmse < 0.45 * lights[2].rmse);
  CHECK(lights[1].rmse < lights[0].rmse);
}
