// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "requests.h"

#include <cstring>

namespace openltc::wasm {

std::size_t Answer::add_floats(const std::vector<double>& numbers) {
  std::vector<std::uint8_t> raw(numbers.size() * sizeof(float));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float number = float(numbers[i]);
    std::memcpy(raw.data() + i * sizeof(float), &number, sizeof(float));
  }
  bytes.push_back(std::move(raw));
  return bytes.size() - 1;
}

std::string text_of(const Json& object, const char* name, const std::string& otherwise) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

double number_of(const Json& object, const char* name, double otherwise) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (found->is_boolean()) return found->get<bool>() ? 1 : 0;
  return found->is_number() ? found->get<double>() : otherwise;
}

std::vector<double> numbers_of(const Json& object, const char* name) {
  std::vector<double> numbers;
  const auto found = object.find(name);
  if (found != object.end() && found->is_array())
    for (const Json& number : *found)
      if (number.is_number()) numbers.push_back(number.get<double>());
  return numbers;
}

} // namespace openltc::wasm
