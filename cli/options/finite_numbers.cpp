// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/options/finite_numbers.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace openltc::cli {

namespace {

// What is no number at all is left to CLI11.
std::string check_finite(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = end != text.c_str() && *end == '\0';
  if (!whole || (std::isfinite(value) && std::isfinite(float(value)))) return "";
  return "must be a finite number, not '" + text + "'";
}

} // namespace

void require_finite_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    // "FLOAT:FLOAT in [0 - 1]" where CLI11 names the type; our own words for fractions and lists.
    const std::string type = option->get_type_name();
    const auto names = [&](const char* word) { return type.find(word) != std::string::npos; };
    if (!names("FLOAT") && !names("FRACTION") && !names("A,B")) continue;
    option->check(CLI::Validator(check_finite, ""));
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    require_finite_numbers(*command);
}

} // namespace openltc::cli
