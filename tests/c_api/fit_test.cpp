// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The fitter by the C API: the numbers of the library's own, a function of the caller's, progress.

#include "openltc/brdf/brdf.h"
#include "openltc/fit/fit_job.h"
#include "tests/c_api/c_lights.h"

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

using namespace openltc;
using namespace openltc::testing;

namespace {

openltc_fit_options small(std::size_t size = 8) {
  openltc_fit_options options{};
  options.size = size;
  return options;
}

/// Lambert's BRDF, and how often it was asked for.
double lambert(const double* wo, const double* wi, double, void* user) {
  ++*static_cast<std::atomic<int>*>(user);
  return wo[2] > 0 && wi[2] > 0 ? 1 / 3.14159265358979323846 : -1;
}
double not_a_number(const double*, const double*, double, void*) {
  return std::numeric_limits<double>::quiet_NaN();
}

struct Shares {
  std::vector<double> seen;
  double stop_at = 2;
};
int32_t note_share(double share, void* user) {
  Shares& shares = *static_cast<Shares*>(user);
  shares.seen.push_back(share);
  return share < shares.stop_at;
}

} // namespace

TEST_CASE("a_fitted_table_is_that_of_the_library") {
  for (const char* name : {"ggx", "charlie"}) {
    fit::FitRequest request;
    request.size = 8;
    const brdf::Brdf& brdf = *brdf::find_brdf(name);
    const Result<fit::FittedLobes> expected = fit::fit_lobes(brdf, request);
    REQUIRE(expected);
    const openltc_fit_options options = small();
    std::vector<float> numbers(openltc_fit_capacity(&options));
    REQUIRE(numbers.size() == 8 * 8 * 8);
    openltc_fit_result result;
    REQUIRE(openltc_fit(name, &options, numbers.data(), numbers.size(), &result) == OPENLTC_OK);
    CHECK(numbers == expected->nodes->texels);
    CHECK(result.columns == std::size_t(expected->nodes->columns));
    CHECK(result.rows == 8);
    CHECK(result.degree == 0);
    CHECK(result.float_count == numbers.size());
    CHECK((result.width == OPENLTC_WIDTH_ALPHA) == (brdf.width == brdf::LobeWidth::alpha));
  }
}

TEST_CASE("a_fitted_polynomial_is_the_built_in_one_and_says_its_error") {
  openltc_fit_options options{};
  options.form = OPENLTC_POLYNOMIAL;
  std::vector<float> numbers(openltc_fit_capacity(&options));
  REQUIRE(numbers.size() == sizeof(k_ggx_polynomial) / sizeof(float));
  openltc_fit_result result;
  REQUIRE(openltc_fit("ggx", &options, numbers.data(), numbers.size(), &result) == OPENLTC_OK);
  // Another maths library may move the last bits of a joint fit.
  for (std::size_t i = 0; i < numbers.size(); ++i)
    CHECK(std::abs(numbers[i] - k_ggx_polynomial[i]) < 5e-5f);
  CHECK(result.degree == 4);
  CHECK(result.columns == 0);
  CHECK(result.mean_tv == doctest::Approx(k_ggx_polynomial_metadata.mean_tv).epsilon(1e-3));
  CHECK(result.max_tv == doctest::Approx(k_ggx_polynomial_metadata.max_tv).epsilon(1e-3));
  openltc_lobes* lobes = nullptr;
  CHECK(openltc_lobes_create_polynomial(numbers.data(), result.degree, &lobes) == OPENLTC_OK);
  openltc_lobes_destroy(lobes);
}

TEST_CASE("two_lobes_are_fitted_as_the_built_in_ones") {
  openltc_fit_options options{};
  options.form = OPENLTC_TWO_LOBE_TABLE;
  std::vector<float> numbers(openltc_fit_capacity(&options));
  REQUIRE(numbers.size() == 32 * 32 * 12);
  REQUIRE(openltc_fit("ggx", &options, numbers.data(), numbers.size(), nullptr) == OPENLTC_OK);
  // Another maths library may move the last bits of a joint fit, and these its end.
  for (std::size_t i = 0; i < 32 * 32 * 8; ++i)
    CHECK(std::abs(numbers[i] - k_ggx_two_lobes[i]) < 5e-3f);
  openltc_lobes* lobes = nullptr;
  CHECK(openltc_lobes_create_two_lobe_table(numbers.data(), numbers.data() + 32 * 32 * 8, 32, 32,
                                            &lobes) == OPENLTC_OK);
  openltc_lobes_destroy(lobes);
}

TEST_CASE("a_function_of_the_callers_is_fitted") {
  // A clamped cosine is Lambert's lobe itself: nothing is left to err.
  std::atomic<int> calls = 0;
  const openltc_fit_options options = small(4);
  std::vector<float> numbers(openltc_fit_capacity(&options));
  openltc_fit_result result;
  REQUIRE(openltc_fit_function(lambert, &calls, OPENLTC_WIDTH_ONE, &options, numbers.data(),
                               numbers.size(), &result) == OPENLTC_OK);
  CHECK(calls > 1000);
  CHECK(result.width == OPENLTC_WIDTH_ONE);
  CHECK(result.mean_tv < 0.01);
  for (std::size_t i = 0; i < numbers.size(); i += 8)
    CHECK(numbers[i + 4] == doctest::Approx(1.0f).epsilon(0.01)); // n1, the albedo
}

TEST_CASE("what_cannot_be_fitted_says_why_and_writes_nothing") {
  const openltc_fit_options options = small();
  std::vector<float> numbers(512, -7.0f);
  openltc_fit_result result;
  CHECK(openltc_fit("gxx", &options, numbers.data(), numbers.size(), &result) ==
        OPENLTC_UNKNOWN_NAME);
  CHECK(last_error_says("ggx, "));
  CHECK(openltc_fit("no/such.binary", &options, numbers.data(), numbers.size(), nullptr) ==
        OPENLTC_FILE_ERROR);
  CHECK(openltc_fit("ggx", &options, numbers.data(), 511, &result) == OPENLTC_BUFFER_TOO_SMALL);
  CHECK(result.float_count == 512);
  CHECK(openltc_fit("ggx", &options, nullptr, 0, &result) == OPENLTC_BUFFER_TOO_SMALL);
  CHECK(result.float_count == 512);
  CHECK(openltc_fit("ggx", &options, nullptr, 512, nullptr) == OPENLTC_INVALID_ARGUMENT);
  CHECK(openltc_fit_function(not_a_number, nullptr, OPENLTC_WIDTH_ALPHA, &options, numbers.data(),
                             numbers.size(), &result) == OPENLTC_FIT_FAILED);
  CHECK(openltc_fit_function(not_a_number, nullptr, 5, &options, numbers.data(), numbers.size(),
                             nullptr) == OPENLTC_INVALID_ARGUMENT);
  openltc_fit_options wrong = options;
  wrong.objective = "best";
  CHECK(openltc_fit("ggx", &wrong, numbers.data(), numbers.size(), nullptr) ==
        OPENLTC_UNKNOWN_NAME);
  CHECK(last_error_says("balanced"));
  for (const auto spoil :
       {+[](openltc_fit_options& o) { o.form = 3; }, +[](openltc_fit_options& o) { o.size = 1; },
        +[](openltc_fit_options& o) { o.size = 513; },
        +[](openltc_fit_options& o) { o.degree = 7; },
        +[](openltc_fit_options& o) { o.refine = -1; }}) {
    wrong = options;
    spoil(wrong);
    CHECK(openltc_fit("ggx", &wrong, numbers.data(), numbers.size(), nullptr) ==
          OPENLTC_INVALID_ARGUMENT);
    CHECK(openltc_fit_capacity(&wrong) == 0);
  }
  for (const float x : numbers)
    REQUIRE(x == -7.0f);
}

TEST_CASE("progress_rises_to_one_and_stops_a_fit") {
  openltc_fit_options options = small(16);
  Shares shares;
  options.progress = note_share;
  options.progress_user = &shares;
  std::vector<float> numbers(openltc_fit_capacity(&options), -7.0f);
  REQUIRE(openltc_fit("ggx", &options, numbers.data(), numbers.size(), nullptr) == OPENLTC_OK);
  REQUIRE(shares.seen.size() > 2);
  for (std::size_t i = 1; i < shares.seen.size(); ++i)
    CHECK(shares.seen[i] >= shares.seen[i - 1]);
  CHECK(shares.seen.back() == 1);

  for (const double stop_at : {0.0, 0.3, 1.0}) {
    CAPTURE(stop_at);
    shares = {{}, stop_at};
    numbers.assign(numbers.size(), -7.0f);
    CHECK(openltc_fit("ggx", &options, numbers.data(), numbers.size(), nullptr) ==
          OPENLTC_CANCELLED);
    CHECK(last_error_says("cancelled"));
    CHECK(numbers[0] == -7.0f);
  }
}

TEST_CASE("brdfs_have_their_names") {
  REQUIRE(openltc_brdf_count() == brdf::all_brdfs().size());
  for (std::size_t i = 0; i < openltc_brdf_count(); ++i)
    CHECK(openltc_brdf_name(i) == brdf::all_brdfs()[i].name);
  CHECK(openltc_brdf_name(openltc_brdf_count()) == nullptr);
  CHECK(openltc_brdf_name(SIZE_MAX) == nullptr);
}
