// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the fitter answers: requests with a "call".

#pragma once

#include "openltc/fit/fit_job.h"
#include "openltc/table/engine.h"
#include "requests.h"

namespace openltc::wasm {

/// A fit that is kept: the BRDF, what was asked and what came out.
struct Kept {
  brdf::Brdf brdf;
  fit::FitRequest request;
  const table::Engine* engine = nullptr;
  fit::FittedLobes fitted;
};

/// Fits and keeps it: "id" and what there is to say of it. fits.cpp has what a fit can be asked.
Result<Answer> make_fit(const Json& request);
/// Files of a kept fit by extension, or those of the engine it was made for.
Result<Answer> make_files(const Kept& kept, const Json& request);
/// The report of `openltc fit --report FILE.json`, as its text.
Result<Answer> make_report_text(const Kept& kept, const Json& request);
/// Lobes beside their BRDF, as `openltc plot fit` shows them.
Result<Answer> make_cells(const Kept& kept, const Json& request);
/// A polygon in both spaces, as `openltc plot polygon` shows it.
Result<Answer> make_polygon(const Kept& kept, const Json& request);

/// The fit of that "id", or an error.
Result<const Kept*> kept_fit(const Json& request);
/// Forgets the fit of that "id", if there is one.
void forget_fit(const Json& request);

/// A BRDF of the page's own: calls back for every batch of directions.
brdf::Brdf brdf_of_page(const Json& description);
/// Tells the page how far a fit is; false: stop.
bool tell_page(double share);

} // namespace openltc::wasm
