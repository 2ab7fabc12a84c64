// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A fit for a layout, as any front end asks for it.

#include "openltc/brdf/choose.h"
#include "openltc/fit/fit_job.h"

#include <doctest/doctest.h>

using namespace openltc;

namespace {

brdf::Brdf ggx() { return *brdf::choose_brdf("ggx"); }

fit::FitRequest small(table::Layout layout) {
  fit::FitRequest request;
  request.size = 8;
  request.layout = layout;
  request.tool_version = "1.2";
  request.command = "make this";
  return request;
}

} // namespace

TEST_CASE("a fit for an engine's layout is one for its horizon and says who made it") {
  for (const bool clip_aware : {false, true}) {
    fit::FitRequest request = small(table::Layout::ltc_code);
    request.clip_aware = clip_aware;
    Result<fit::FittedLobes> fitted = fit::fit_lobes(ggx(), request);
    REQUIRE(fitted);
    CHECK(std::get<table::PackedTable>(fitted->stored).layout == table::Layout::ltc_code);
    CHECK(fitted->horizon == (clip_aware ? fit::Horizon::clipped : fit::Horizon::leaking));
    CHECK(fitted->metadata().command == "make this");
    fit::TableError error;
    error.mean.tv = 0.12345;
    fit::state_error(*fitted, error);
    CHECK(fitted->metadata().mean_tv == doctest::Approx(0.1235));
    CHECK(fitted->metadata().tool_version == "1.2");
    CHECK(fitted->metadata().command == "make this");
    CHECK(fit::candidate_of(*fitted, request).label == "balanced, 8");
  }
}

TEST_CASE("every form of a fit can be stopped") {
  for (const table::LobeForm form :
       {table::LobeForm::table, table::LobeForm::polynomial, table::LobeForm::two_lobe,
        table::LobeForm::two_lobe_polynomial}) {
    fit::FitRequest request = small(table::Layout::native);
    request.form = form;
    request.degree = 3;
    const auto fitted = fit::fit_lobes(ggx(), request, [](double) { return false; });
    REQUIRE_FALSE(fitted);
    CHECK(fitted.error().message == "cancelled");
  }
}

TEST_CASE("what a file cannot hold is said before the work") {
  const fit::FitRequest request = small(table::Layout::unity);
  CHECK_FALSE(fit::check_outputs(ggx(), request, {"a.cpp"}));
  CHECK(fit::check_outputs(ggx(), small(table::Layout::native), {"a.cpp"}));
  CHECK_FALSE(fit::check_extensions(request, {"a.dds", "a.xyz"}));
  const auto files = fit::check_outputs(ggx(), small(table::Layout::ltc_code), {"a.dds"});
  REQUIRE(files);
  CHECK(files->size() == 3); // two textures and the description that .dds has no room for
}
