// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The look-up of fitted lobes by itself, compiled once per instruction set.

#pragma once

#include "openltc/target/resources.h"

namespace openltc::bench {

/// Looks up `count` lobes, a multiple of 16, from the polynomial, or from the table when it has no
/// coefficients, and writes all six numbers of each so that none is left out.
using Lookup = void (*)(const LobeTableView& table, const LobePolynomialView& polynomial,
                        const float* roughness, const float* cos_theta, int count, float* out);

void lookup_scalar(const LobeTableView&, const LobePolynomialView&, const float*, const float*, int,
                   float*);
void lookup_sse4(const LobeTableView&, const LobePolynomialView&, const float*, const float*, int,
                 float*);
void lookup_avx2(const LobeTableView&, const LobePolynomialView&, const float*, const float*, int,
                 float*);
void lookup_avx512(const LobeTableView&, const LobePolynomialView&, const float*, const float*, int,
                   float*);
void lookup_neon(const LobeTableView&, const LobePolynomialView&, const float*, const float*, int,
                 float*);

} // namespace openltc::bench
