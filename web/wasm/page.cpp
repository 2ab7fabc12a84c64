// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the fitter wants of the page.

#include "fits.h"

#include <cstdlib>
#include <span>

#define OPENLTC_IMPORT(name)                                                                       \
  extern "C" __attribute__((import_module("openltc"), import_name(#name)))

// count directions at wi, x y z each; f of each goes to values.
OPENLTC_IMPORT(brdf)
void page_brdf(double x, double y, double z, const double* wi, int count, double roughness,
               double* values);
OPENLTC_IMPORT(progress) int page_progress(double share);

// The fitter is compiled without exceptions: what would throw, for lack of memory, ends the module.
extern "C" {
void* __cxa_allocate_exception(std::size_t) { std::abort(); }
void __cxa_throw(void*, void*, void (*)(void*)) { std::abort(); }
}

namespace openltc::wasm {

static_assert(sizeof(Vec3d) == 3 * sizeof(double));

brdf::Brdf brdf_of_page(const Json& description) {
  const bool wide = text_of(description, "width") == "one";
  brdf::Brdf brdf = brdf::brdf_from_batch(
      text_of(description, "name", "function"),
      [](Vec3d wo, std::span<const Vec3d> wi, double roughness, std::span<double> values) {
        page_brdf(wo.x, wo.y, wo.z, &wi.data()->x, int(wi.size()), roughness, values.data());
      },
      wide ? brdf::LobeWidth::one : brdf::LobeWidth::alpha);
  if (number_of(description, "parameter", 1) == 0) brdf.parameter.clear();
  return brdf;
}

bool tell_page(double share) { return page_progress(share) != 0; }

} // namespace openltc::wasm
