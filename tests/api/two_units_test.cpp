// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Two translation units include the whole API: they link, and share its constants.

#include "second_unit.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;

TEST_CASE("two_units_share_the_built_in_lobes_and_agree") {
  CHECK(testing::table_of_second_unit() == k_ggx_table);
  CHECK(testing::polynomial_of_second_unit() == k_ggx_polynomial);
  const double sum = testing::sum_of_all();
  CHECK(std::isfinite(sum));
  CHECK(sum > 0);
  CHECK(testing::all_of_it_in_second_unit() == sum);
}
