// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/progress.h"
#include "openltc/brdf/choose.h"
#include "openltc/c_api/status.h"
#include "openltc/fit/fit_job.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/objective.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/fit/table_fit.h"
#include "openltc/fit/two_lobe_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

using namespace openltc;
using c_api::fail;

namespace {

constexpr std::size_t k_channels = 8;
constexpr std::size_t k_second_channels = 4;
constexpr std::size_t k_min_size = 2, k_max_size = 512;
// Of the progress: the rest is for measuring.
constexpr double k_fit_share = 0.9;

/// Options with their defaults in place.
struct Request {
  bool is_polynomial = false;
  int size = 64;
  int degree = 4;
  fit::Refine refine = fit::Refine::automatic;
  bool two_lobes = false;
};

openltc_status read_options(const openltc_fit_options& options, Request& request) {
  if (options.form != OPENLTC_TABLE && options.form != OPENLTC_POLYNOMIAL &&
      options.form != OPENLTC_TWO_LOBE_TABLE)
    return fail(OPENLTC_INVALID_ARGUMENT, "form is none of OPENLTC_TABLE, OPENLTC_POLYNOMIAL and "
                                          "OPENLTC_TWO_LOBE_TABLE");
  request.is_polynomial = options.form == OPENLTC_POLYNOMIAL;
  request.two_lobes = options.form == OPENLTC_TWO_LOBE_TABLE;
  if (request.two_lobes) request.size = fit::k_two_lobe_size;
  if (options.size != 0 && (options.size < k_min_size || options.size > k_max_size))
    return fail(OPENLTC_INVALID_ARGUMENT, fmt::format("size is {}; a table has {} to {} nodes per "
                                                      "axis",
                                                      options.size, k_min_size, k_max_size));
  if (options.size != 0) request.size = int(options.size);
  using table::LobePolynomial;
  if (options.degree != 0 && (options.degree < std::size_t(LobePolynomial::k_min_degree) ||
                              options.degree > std::size_t(LobePolynomial::k_max_degree)))
    return fail(OPENLTC_INVALID_ARGUMENT,
                fmt::format("degree is {}; it is {} to {}", options.degree,
                            LobePolynomial::k_min_degree, LobePolynomial::k_max_degree));
  if (options.degree != 0) request.degree = int(options.degree);
  if (options.refine < OPENLTC_REFINE_AUTOMATIC || options.refine > OPENLTC_REFINE_OFF)
    return fail(OPENLTC_INVALID_ARGUMENT, "refine is none of OPENLTC_REFINE_AUTOMATIC, _ON, _OFF");
  request.refine = options.refine == OPENLTC_REFINE_ON    ? fit::Refine::on
                   : options.refine == OPENLTC_REFINE_OFF ? fit::Refine::off
                                                          : fit::Refine::automatic;
  return OPENLTC_OK;
}

std::size_t polynomial_floats(int degree) {
  return std::size_t(table::polynomial_terms(degree)) * k_channels;
}

/// Of a texel, both lobes'.
std::size_t texel_floats(const Request& request) {
  return request.two_lobes ? k_channels + k_second_channels : k_channels;
}

/// Where the fit stands when it ends early.
struct Failure {
  bool was_stopped = false; ///< by the progress callback

  openltc_status operator()(const Error& error) const {
    return fail(was_stopped ? OPENLTC_CANCELLED : OPENLTC_FIT_FAILED, error.message);
  }
};

openltc_status fit_brdf(const brdf::Brdf& brdf, const openltc_fit_options* given, float* numbers,
                        std::size_t capacity, openltc_fit_result* result) {
  const openltc_fit_options options = given ? *given : openltc_fit_options{};
  Request request;
  if (const openltc_status status = read_options(options, request)) return status;
  const Result<fit::Objective> objective =
      fit::find_objective(options.objective ? options.objective : "balanced");
  if (!objective) return fail(OPENLTC_UNKNOWN_NAME, objective.error().message);

  openltc_fit_result made{};
  made.width = brdf.width == brdf::LobeWidth::alpha ? OPENLTC_WIDTH_ALPHA : OPENLTC_WIDTH_ONE;
  if (request.is_polynomial) {
    made.degree = std::size_t(request.degree);
    made.float_count = polynomial_floats(request.degree);
  } else {
    made.rows = std::size_t(request.size);
    made.columns = brdf.has_parameter() ? made.rows : 1;
    made.float_count = made.columns * made.rows * texel_floats(request);
  }
  if (capacity < made.float_count) {
    if (result) *result = made;
    return fail(OPENLTC_BUFFER_TOO_SMALL,
                fmt::format("numbers has room for {} floats, the lobes are {}", capacity,
                            made.float_count));
  }
  if (!numbers) return fail(OPENLTC_INVALID_ARGUMENT, "numbers is null");

  Failure failure;
  Progress progress;
  if (options.progress)
    progress = [&options, &failure](double share) {
      if (options.progress(share, options.progress_user) == 0) failure.was_stopped = true;
      return !failure.was_stopped;
    };

  std::vector<float> fitted;
  Result<fit::TableError> error = fit::TableError{};
  fit::MeasureOptions region;
  region.horizon = objective->horizon;
  const Progress fitting = part_of(progress, 0, k_fit_share);
  if (request.is_polynomial) {
    fit::PolynomialFitOptions how;
    how.degree = request.degree;
    how.objective = *objective;
    Result<fit::PolynomialFit> fit = fit::fit_polynomial(brdf, how, fitting);
    if (!fit) return failure(fit.error());
    if (result) error = fit::measure_lobes(brdf, fit::lobes_of(fit->polynomial), region);
    fitted = std::move(fit->polynomial.coefficients);
  } else {
    fit::TableFitOptions how;
    how.size = request.size;
    how.refine = request.refine;
    how.lobe.objective = *objective;
    Result<table::LobeTable> fit = request.two_lobes ? fit::fit_two_lobe_table(brdf, how, fitting)
                                                     : fit::fit_table(brdf, how, fitting);
    if (!fit) return failure(fit.error());
    if (result) error = fit::measure_lobes(brdf, fit::lobes_of(*fit), region);
    fitted = std::move(fit->texels);
    fitted.insert(fitted.end(), fit->second.begin(), fit->second.end());
  }
  if (!error) return failure(error.error());
  if (progress && !progress(1.0)) return failure(cancelled());
  if (fitted.size() != made.float_count)
    return fail(OPENLTC_INTERNAL_ERROR, "the lobes are not as many as was foreseen");

  std::copy(fitted.begin(), fitted.end(), numbers);
  made.mean_tv = error->mean.tv;
  made.max_tv = error->max.tv;
  if (result) *result = made;
  return OPENLTC_OK;
}

} // namespace

size_t openltc_brdf_count(void) {
  std::size_t count = 0;
  c_api::guarded([&]() -> openltc_status {
    count = brdf::all_brdfs().size();
    return OPENLTC_OK;
  });
  return count;
}

const char* openltc_brdf_name(size_t index) {
  const char* name = nullptr;
  c_api::guarded([&]() -> openltc_status {
    const std::span<const brdf::Brdf> all = brdf::all_brdfs();
    if (index < all.size()) name = all[index].name.c_str();
    return OPENLTC_OK;
  });
  return name;
}

size_t openltc_fit_capacity(const openltc_fit_options* options) {
  std::size_t count = 0;
  c_api::guarded([&]() -> openltc_status {
    Request request;
    if (options)
      if (const openltc_status status = read_options(*options, request)) return status;
    count = request.is_polynomial
                ? polynomial_floats(request.degree)
                : std::size_t(request.size) * std::size_t(request.size) * texel_floats(request);
    return OPENLTC_OK;
  });
  return count;
}

openltc_status openltc_fit(const char* brdf, const openltc_fit_options* options, float* numbers,
                           size_t capacity, openltc_fit_result* result) {
  return c_api::guarded([&]() -> openltc_status {
    if (result) *result = openltc_fit_result{};
    if (!brdf) return fail(OPENLTC_INVALID_ARGUMENT, "brdf is null");
    const Result<brdf::Brdf> chosen = brdf::choose_brdf(brdf);
    if (!chosen) {
      const bool is_file = std::string_view(brdf).ends_with(".binary");
      return fail(is_file ? OPENLTC_FILE_ERROR : OPENLTC_UNKNOWN_NAME, chosen.error().message);
    }
    return fit_brdf(*chosen, options, numbers, capacity, result);
  });
}

openltc_status openltc_fit_function(openltc_brdf_function function, void* user, int32_t width,
                                    const openltc_fit_options* options, float* numbers,
                                    size_t capacity, openltc_fit_result* result) {
  return c_api::guarded([&]() -> openltc_status {
    if (result) *result = openltc_fit_result{};
    if (!function) return fail(OPENLTC_INVALID_ARGUMENT, "function is null");
    if (width != OPENLTC_WIDTH_ALPHA && width != OPENLTC_WIDTH_ONE)
      return fail(OPENLTC_INVALID_ARGUMENT,
                  "width is neither OPENLTC_WIDTH_ALPHA nor OPENLTC_WIDTH_ONE");
    const brdf::Brdf brdf = brdf::brdf_from_function(
        "function",
        [function, user](Vec3d wo, Vec3d wi, double roughness) {
          const double to_viewer[3] = {wo.x, wo.y, wo.z}, to_light[3] = {wi.x, wi.y, wi.z};
          return function(to_viewer, to_light, roughness, user);
        },
        width == OPENLTC_WIDTH_ALPHA ? brdf::LobeWidth::alpha : brdf::LobeWidth::one);
    return fit_brdf(brdf, options, numbers, capacity, result);
  });
}
