// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "second_unit.h"

#if defined(FN) || defined(FN_INLINE) || defined(FN_CALL) || defined(CONSTANT)
#error "the public header leaves macros behind"
#endif

namespace openltc::testing {

const float* table_of_second_unit() { return k_ggx_table; }
const float* polynomial_of_second_unit() { return k_ggx_polynomial; }
double all_of_it_in_second_unit() { return sum_of_all(); }

} // namespace openltc::testing
