// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/c_api/handles.h"
#include "openltc/c_api/status.h"
#include "openltc/table/lobe_check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

using namespace openltc;
using c_api::fail;

namespace {

constexpr std::size_t k_channels = 8;
constexpr std::size_t k_max_size = 512; // nodes per axis, as files and the fitter have it

/// Copies texels or terms that are finite; otherwise names the first that is not.
openltc_status copy_numbers(const float* numbers, std::size_t count, std::vector<float>& copy,
                            std::size_t channels = k_channels) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i]))
      return fail(
          OPENLTC_INVALID_ARGUMENT,
          fmt::format("lobes: channel {} of number {} is not finite", i % channels, i / channels));
  copy.assign(numbers, numbers + count);
  return OPENLTC_OK;
}

/// A table of one lobe, or of two where there is a second.
openltc_status create_table(const float* texels, const float* second, std::size_t columns,
                            std::size_t rows, openltc_lobes& made) {
  if (!texels) return fail(OPENLTC_INVALID_ARGUMENT, "texels is null");
  if (columns < 2 || columns > k_max_size || rows < 2 || rows > k_max_size)
    return fail(OPENLTC_INVALID_ARGUMENT,
                fmt::format("a table of {} x {} nodes; surfaces are shaded with 2 to {} of each",
                            columns, rows, k_max_size));
  table::LobeTable table;
  table.columns = int(columns);
  table.rows = int(rows);
  const std::size_t count = columns * rows;
  if (const openltc_status status = copy_numbers(texels, count * k_channels, table.texels))
    return status;
  if (second) {
    constexpr std::size_t channels = table::LobeTable::k_second_channels;
    if (const openltc_status status =
            copy_numbers(second, count * channels, table.second, channels))
      return status;
    for (std::size_t i = 0; i < count; ++i) {
      const float weight = texels[i * k_channels + 6];
      if (!(weight >= 0 && weight <= 1))
        return fail(
            OPENLTC_INVALID_ARGUMENT,
            fmt::format("lobes: the weight of texel {} is {:g}, not within 0 to 1", i, weight));
    }
  }
  if (const Status status = table::check_determinants(table, "lobes"); !status)
    return fail(OPENLTC_INVALID_ARGUMENT, status.error().message);
  made.numbers = std::move(table.texels);
  made.second = std::move(table.second);
  made.view.table = {made.numbers.data(), table.columns, table.rows,
                     second ? made.second.data() : nullptr};
  return OPENLTC_OK;
}

} // namespace

openltc_status openltc_lobes_create_built_in(int32_t form, openltc_lobes** lobes) {
  return c_api::create(lobes, [&](openltc_lobes& made) -> openltc_status {
    if (form == OPENLTC_TABLE)
      made.view = built_in_table();
    else if (form == OPENLTC_POLYNOMIAL)
      made.view = built_in_polynomial();
    else if (form == OPENLTC_TWO_LOBE_TABLE)
      made.view = built_in_two_lobe_table();
    else
      return fail(OPENLTC_INVALID_ARGUMENT, "form is none of OPENLTC_TABLE, OPENLTC_POLYNOMIAL and "
                                            "OPENLTC_TWO_LOBE_TABLE");
    return OPENLTC_OK;
  });
}

openltc_status openltc_lobes_create_table(const float* texels, size_t columns, size_t rows,
                                          openltc_lobes** lobes) {
  return c_api::create(lobes, [&](openltc_lobes& made) -> openltc_status {
    return create_table(texels, nullptr, columns, rows, made);
  });
}

openltc_status openltc_lobes_create_two_lobe_table(const float* texels, const float* second,
                                                   size_t columns, size_t rows,
                                                   openltc_lobes** lobes) {
  return c_api::create(lobes, [&](openltc_lobes& made) -> openltc_status {
    if (!second) return fail(OPENLTC_INVALID_ARGUMENT, "second is null");
    return create_table(texels, second, columns, rows, made);
  });
}

openltc_status openltc_lobes_create_polynomial(const float* terms, size_t degree,
                                               openltc_lobes** lobes) {
  return c_api::create(lobes, [&](openltc_lobes& made) -> openltc_status {
    if (!terms) return fail(OPENLTC_INVALID_ARGUMENT, "terms is null");
    table::LobePolynomial polynomial;
    if (degree < std::size_t(polynomial.k_min_degree) ||
        degree > std::size_t(polynomial.k_max_degree))
      return fail(OPENLTC_INVALID_ARGUMENT,
                  fmt::format("a polynomial of degree {}; it is {} to {}", degree,
                              polynomial.k_min_degree, polynomial.k_max_degree));
    polynomial.degree = int(degree);
    const std::size_t count = std::size_t(table::polynomial_terms(polynomial.degree)) * k_channels;
    if (const openltc_status status = copy_numbers(terms, count, polynomial.coefficients))
      return status;
    if (const Status status = table::check_determinants(polynomial, "lobes"); !status)
      return fail(OPENLTC_INVALID_ARGUMENT, status.error().message);
    made.numbers = std::move(polynomial.coefficients);
    made.view.polynomial = {made.numbers.data(), polynomial.degree};
    return OPENLTC_OK;
  });
}

void openltc_lobes_destroy(openltc_lobes* lobes) { delete lobes; }
