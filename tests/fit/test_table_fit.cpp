// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Whole tables: the built-in comes from this fitter, its errors are as stated, threads do not
// matter.

#include "openltc/fit/measure/error.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/table_fit.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/table_file.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

using namespace openltc;

namespace {

const brdf::Brdf& ggx() { return *brdf::find_brdf("ggx"); }

// How our shading reads tables.
fit::MeasureOptions clipped() {
  fit::MeasureOptions options;
  options.horizon = fit::Horizon::clipped;
  return options;
}

} // namespace

TEST_CASE("the built-in table regenerates byte for byte") {
  Result<table::LobeTable> fitted = fit::fit_table(ggx(), {});
  REQUIRE(fitted);
  // A release raises the version without making the table anew.
  const std::string version = table::builtin_ggx_table().metadata.tool_version;
  fit::complete_metadata(fitted->metadata,
                         *fit::measure_lobes(ggx(), fit::lobes_of(*fitted), clipped()),
                         version.c_str(), "openltc fit --brdf ggx --size 64");
  std::ifstream file(OPENLTC_SOURCE_DIR "/openltc/api/ggx_table.inc", std::ios::binary);
  const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  REQUIRE(!source.empty());
  // Not CHECK(a == b): the message would be 230 kB.
  const bool same = table::to_builtin_source(*fitted) == source;
  CHECK_MESSAGE(same, "run tools/make_builtin_lobes.sh, or undo what changed the fit");
}

TEST_CASE("the built-in polynomial regenerates byte for byte") {
  const Result<fit::PolynomialFit> fitted = fit::fit_polynomial(ggx(), {});
  REQUIRE(fitted);
  table::LobePolynomial polynomial = fitted->polynomial;
  const std::string version = table::builtin_ggx_polynomial().metadata.tool_version;
  fit::complete_metadata(polynomial.metadata,
                         *fit::measure_lobes(ggx(), fit::lobes_of(polynomial), clipped()),
                         version.c_str(), "openltc fit --brdf ggx --form polynomial --degree 4");
  std::ifstream file(OPENLTC_SOURCE_DIR "/openltc/api/ggx_polynomial.inc", std::ios::binary);
  const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // Its joint fit stops within a relative 1e-5 of the optimum, where the last bits of a maths
  // library still show: byte for byte where the built-in was made, Debian 12, close everywhere.
  const table::LobePolynomial& builtin = table::builtin_ggx_polynomial();
  REQUIRE(polynomial.coefficients.size() == builtin.coefficients.size());
  double apart = 0;
  for (std::size_t i = 0; i < builtin.coefficients.size(); ++i)
    apart = std::max(
        apart, std::abs(double(polynomial.coefficients[i]) - double(builtin.coefficients[i])));
  CHECK_MESSAGE(apart < 5e-5, "run tools/make_builtin_lobes.sh, or undo what changed the fit");
  const bool same = table::to_builtin_source(polynomial) == source;
#ifdef __GLIBC__
  const bool debian_12 = std::string(gnu_get_libc_version()) == "2.36";
#else
  const bool debian_12 = false;
#endif
  if (debian_12)
    CHECK_MESSAGE(same, "run tools/make_builtin_lobes.sh, or undo what changed the fit");
  else
    MESSAGE("largest difference from the built-in ", apart);
}

TEST_CASE("the built-in's errors between the nodes stay within their bounds") {
  const table::LobeTable& t = table::builtin_ggx_table();
  const fit::TableError rough = *fit::measure_lobes(ggx(), fit::lobes_of(t), clipped());
  fit::MeasureOptions options = clipped();
  options.roughness_from = 0.01;
  options.roughness_to = 0.06;
  const fit::TableError sharp = *fit::measure_lobes(ggx(), fit::lobes_of(t), options);
  MESSAGE("mean TV ", rough.mean.tv, " and ", sharp.mean.tv, ", largest ", rough.max.tv, " and ",
          sharp.max.tv);
  CHECK(rough.mean.tv < 0.0375);
  CHECK(rough.max.tv < 0.33);
  CHECK(rough.mean.l2 < 0.0555);
  CHECK(rough.mean.l3 < 0.0550);
  CHECK(rough.p95.peak < 0.105);
  CHECK(rough.mean.leak < 0.005);
  CHECK(rough.mean.n1 < 4e-4);
  CHECK(rough.p95.n1 < 1e-3);
  CHECK(sharp.mean.tv < 0.0015);
  CHECK(sharp.max.tv < 0.06);
  CHECK(sharp.p95.n5 < 3e-3);
}

TEST_CASE("the number of threads does not matter") {
  fit::TableFitOptions options;
  options.size = 9;
  options.quadrature = {12, 12};
  std::string results[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, k == 0 ? 1 : 4);
    Result<table::LobeTable> fitted = fit::fit_table(ggx(), options);
    REQUIRE(fitted);
    fit::MeasureOptions measure;
    measure.points = 6;
    measure.quadrature = {12, 12};
    fit::complete_metadata(
        fitted->metadata, *fit::measure_lobes(ggx(), fit::lobes_of(*fitted), measure), "0", "test");
    results[k] = table::to_json(*fitted);
  }
  CHECK((results[0] == results[1]));
}

TEST_CASE("progress runs to 1 and wrong sizes are refused") {
  fit::TableFitOptions options;
  options.size = 4;
  options.quadrature = {8, 8};
  double last = 0;
  bool rising = true;
  CHECK(fit::fit_table(ggx(), options, [&](double share) {
          rising = rising && share > last;
          last = share;
          return true;
        }).ok());
  CHECK(rising);
  CHECK(last == 1.0);
  options.size = 1;
  CHECK_FALSE(fit::fit_table(ggx(), options).ok());
}

TEST_CASE("a fit can be stopped at any time that it reports") {
  for (const fit::Refine refine : {fit::Refine::off, fit::Refine::on}) {
    fit::TableFitOptions options;
    options.size = 4;
    options.quadrature = {8, 8};
    options.refine = refine;
    int reports = 0;
    const auto count = [&](double) { return ++reports > 0; };
    REQUIRE(fit::fit_table(ggx(), options, count).ok());
    for (int stop = 1; stop <= reports; ++stop) {
      int calls = 0;
      const auto fitted = fit::fit_table(ggx(), options, [&](double) { return ++calls < stop; });
      REQUIRE_FALSE(fitted);
      CHECK(fitted.error().message == "cancelled");
      CHECK(calls == stop); // asked once, it is not asked again
    }
  }
}

TEST_CASE("a BRDF that is not finite, negative or black is refused in one line") {
  fit::TableFitOptions options;
  options.size = 4;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -0.5, 0.0}) {
    const auto broken = brdf::brdf_from_function("broken", [bad](Vec3d, Vec3d wi, double) {
      return wi.z < 0.5 || bad == 0 ? bad : 0.3; // wrong in some directions only, or black
    });
    const Result<table::LobeTable> fitted = fit::fit_table(broken, options);
    REQUIRE_FALSE(fitted);
    const std::string& message = fitted.error().message;
    CHECK(message.find("brdf broken: ") == 0);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find(bad == 0 ? "reflects nothing" : "must be finite and not negative") !=
          std::string::npos);
  }
}

TEST_CASE("what a BRDF throws does not cross fit_table") {
  const auto throws = brdf::brdf_from_function("throws", [](Vec3d, Vec3d wi, double) -> double {
    if (wi.x != 0 && wi.z < 0.7) throw 1; // also where only the scale of half vectors is looked for
    return f64::k_inv_pi;
  });
  fit::TableFitOptions options;
  options.size = 4;
  options.quadrature = fit::QuadratureSize{8, 8};
  const Result<table::LobeTable> fitted = fit::fit_table(throws, options);
  REQUIRE_FALSE(fitted);
  CHECK(fitted.error().message == "brdf throws: its function threw");
}

TEST_CASE("a BRDF without a parameter gets one column") {
  brdf::Brdf plain = brdf::brdf_from_function(
      "plain",
      [](Vec3d wo, Vec3d wi, double) { return f64::eval_ggx_terms(wo, wi, 0.09).scale / wi.z; },
      brdf::LobeWidth::one);
  plain.parameter.clear();
  fit::TableFitOptions options;
  options.size = 24;
  const Result<table::LobeTable> fitted = fit::fit_table(plain, options);
  REQUIRE(fitted);
  CHECK(fitted->columns == 1);
  CHECK(fitted->rows == 24);
  const fit::TableError error = *fit::measure_lobes(plain, fit::lobes_of(*fitted), {});
  // The same GGX as in a table with roughness: alpha .09 is roughness .3.
  const fit::TableError same = [] {
    fit::MeasureOptions slice;
    slice.roughness_from = 0.2999;
    slice.roughness_to = 0.3001;
    return *fit::measure_lobes(ggx(), fit::lobes_of(table::builtin_ggx_table()), slice);
  }();
  MESSAGE("mean TV ", error.mean.tv, ", the built-in's there ", same.mean.tv);
  CHECK(error.mean.tv < 1.03 * same.mean.tv);
}
