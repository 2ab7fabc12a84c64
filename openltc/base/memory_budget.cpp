// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/memory_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace openltc {

MemoryBudget& memory_budget() {
  static MemoryBudget budget(default_memory_limit());
  return budget;
}

std::uint64_t MemoryBudget::left() const {
  const std::uint64_t limit = limit_, in_use = in_use_;
  return limit > in_use ? limit - in_use : 0;
}

Status MemoryBudget::check(std::uint64_t bytes, const std::string& what) const {
  if (bytes <= left()) return Success{};
  return refusal(bytes, what);
}

Error MemoryBudget::refusal(std::uint64_t bytes, const std::string& what) const {
  const std::uint64_t in_use = in_use_;
  return Error{fmt::format(
      "{}: asks for {} of memory{}; the limit for what files ask is {}, reduce the file or raise "
      "it with --memory",
      what, memory_size_text(bytes),
      in_use == 0 ? "" : fmt::format(", beside {} in use", memory_size_text(in_use)),
      memory_size_text(limit_))};
}

Status MemoryBudget::take(std::uint64_t bytes, const std::string& what) {
  std::uint64_t in_use = in_use_;
  do {
    const std::uint64_t limit = limit_;
    if (in_use > limit || bytes > limit - in_use) return refusal(bytes, what);
  } while (!in_use_.compare_exchange_weak(in_use, in_use + bytes));
  return Success{};
}

Result<std::uint64_t> parse_memory_size(std::string_view text) {
  const Error wrong{fmt::format("\"{}\" is no amount of memory; write a number of bytes, or one "
                                "with K, M, G or T, such as 4G",
                                text.substr(0, 40))};
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return wrong;
  std::string_view unit = text.substr(std::size_t(end - text.data()));
  while (!unit.empty() && unit.front() == ' ')
    unit.remove_prefix(1);
  double factor = 1;
  if (!unit.empty()) {
    constexpr std::string_view letters = "KMGT";
    const std::size_t power = letters.find(char(unit[0] & ~0x20)); // either case
    if (power != std::string_view::npos) {
      factor = std::exp2(10.0 * double(power + 1));
      unit.remove_prefix(1);
    }
    if (unit != "" && unit != "B" && unit != "iB") return wrong;
  }
  const double bytes = number * factor;
  if (!(bytes >= 1) || !(bytes <= std::exp2(60.0))) return wrong;
  return std::uint64_t(bytes);
}

std::string memory_size_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  double value = double(bytes) / 1024;
  std::size_t unit = 0;
  for (; value >= 1000 && unit < 5; ++unit)
    value /= 1024;
  return fmt::format("{:.3g} {}", value, units[unit]);
}

} // namespace openltc
