// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a page may ask a module for: a JSON object, answered by JSON and arrays of bytes. index.js
// and lights.js make the requests and index.d.ts documents them; nobody else calls this.

#pragma once

#include "openltc/base/result.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace openltc::wasm {

using Json = nlohmann::ordered_json;

/// An answer. What is long goes as bytes, in the order in which the JSON names it.
struct Answer {
  Json json = Json::object();
  std::vector<std::vector<std::uint8_t>> bytes;

  /// Adds numbers as little-endian floats; their place among `bytes`.
  std::size_t add_floats(const std::vector<double>& numbers);
};

/// Answers a request; each module has its own.
Result<Answer> answer(const Json& request);

/// Members of a request. `otherwise` where there is none; another type is an error of index.js.
std::string text_of(const Json& object, const char* name, const std::string& otherwise = "");
double number_of(const Json& object, const char* name, double otherwise);
std::vector<double> numbers_of(const Json& object, const char* name);

} // namespace openltc::wasm
