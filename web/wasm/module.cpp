// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The functions that a module exports.

#include "requests.h"

#include <cstdlib>
#include <utility>

#define OPENLTC_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace openltc::wasm {

namespace {

Answer last;
std::string last_json;

} // namespace

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
