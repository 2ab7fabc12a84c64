// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lobes without a table: polynomials of roughness and view angle, fitted jointly.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/measure/certificate.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/objective.h"
#include "openltc/table/lobe_polynomial.h"

#include <optional>

namespace openltc::fit {

/// How polynomials are fitted.
struct PolynomialFitOptions {
  int degree = 4; ///< total degree, table::LobePolynomial::k_min_degree to k_max_degree
  /// A second lobe beside the first, which is fitted anew with it; n1 and n5 stay.
  bool two_lobes = false;
  int samples = 32; ///< per axis, at the midpoints of equal parts of roughness and sqrt(1 - cos)
  std::optional<QuadratureSize> quadrature; ///< choose_quadrature's, if not given
  Objective objective;
};

struct PolynomialFit {
  table::LobePolynomial polynomial;
  Certificate certificate; ///< of the stored coefficients; its lower bound is positive
};

/// Fits A B C D, of both lobes where two are asked for, by the objective, and n1, n5 by least
/// squares. Coefficients are rounded to seven decimal digits. The result depends neither on the
/// number of threads nor on the instruction set.
///
/// Fails with one line when the BRDF does (make_quadrature) and when no polynomial of this degree
/// could be certified, and when `progress` asks it to stop.
Result<PolynomialFit> fit_polynomial(const brdf::Brdf& brdf, const PolynomialFitOptions& options,
                                     const Progress& progress = {});

/// The look-up of a polynomial, which must outlive the function.
LobeFunction lobes_of(const table::LobePolynomial& polynomial);

} // namespace openltc::fit
