// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/options/number.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace openltc::cli {

namespace {

// All of `text`, without blanks, other bases or signs before a plus.
template <class T> bool read_whole(const std::string& text, T& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

} // namespace

CLI::Validator whole_number(std::int64_t least, std::int64_t most) {
  return CLI::Validator(
      [least, most](std::string& text) -> std::string {
        std::int64_t value = 0;
        if (!read_whole(text, value) || value < least || value > most)
          return fmt::format("must be a whole number from {} to {}, not '{}'", least, most, text);
        text = std::to_string(value); // 010 is ten
        return "";
      },
      "");
}

CLI::Validator number(double least, double most) {
  return CLI::Validator(
      [least, most](std::string& text) -> std::string {
        double value = 0;
        // A NaN is in no range.
        if (!read_whole(text, value) || !(value >= least && value <= most))
          return fmt::format("must be a number from {} to {}, not '{}'", least, most, text);
        return "";
      },
      "");
}

} // namespace openltc::cli
