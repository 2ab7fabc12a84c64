// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The functions that the module exports, and those that it wants of the page.

#include "requests.h"

#include <cstdlib>
#include <optional>
#include <utility>

#define OPENLTC_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#define OPENLTC_IMPORT(name)                                                                       \
  extern "C" __attribute__((import_module("openltc"), import_name(#name)))

// count directions at wi, x y z each; f of each goes to values.
OPENLTC_IMPORT(brdf)
void page_brdf(double x, double y, double z, const double* wi, int count, double roughness,
               double* values);
OPENLTC_IMPORT(progress) int page_progress(double share);

// The library is compiled without exceptions: what would throw, for lack of memory, ends the
// module.
extern "C" {
void* __cxa_allocate_exception(std::size_t) { std::abort(); }
void __cxa_throw(void*, void*, void (*)(void*)) { std::abort(); }
}

namespace openltc::wasm {

namespace {

Answer last;
std::string last_json;

static_assert(sizeof(Vec3d) == 3 * sizeof(double));

} // namespace

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

using namespace openltc::wasm;

OPENLTC_EXPORT(openltc_take) void* openltc_take(std::size_t bytes) { return std::malloc(bytes); }
OPENLTC_EXPORT(openltc_give) void openltc_give(void* at) { std::free(at); }

// Answers the request; the answer, {"error": text} if it failed, is there until the next one.
OPENLTC_EXPORT(openltc_ask) void openltc_ask(const char* text, std::size_t size) {
  last = {};
  const Json request = Json::parse(text, text + size, nullptr, false);
  openltc::Result<Answer> found = openltc::wasm::answer(request);
  if (found)
    last = std::move(*found);
  else
    last.json = {{"error", found.error().message}};
  last_json = last.json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

OPENLTC_EXPORT(openltc_answer) const char* openltc_answer() { return last_json.data(); }
OPENLTC_EXPORT(openltc_answer_size) std::size_t openltc_answer_size() { return last_json.size(); }
OPENLTC_EXPORT(openltc_bytes) const std::uint8_t* openltc_bytes(std::size_t i) {
  return last.bytes[i].data();
}
OPENLTC_EXPORT(openltc_bytes_size) std::size_t openltc_bytes_size(std::size_t i) {
  return last.bytes[i].size();
}
