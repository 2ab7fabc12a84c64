// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::fit {

namespace {

constexpr std::size_t k_name_width = 10, k_column_width = 33;

// Characters on the screen: bytes that do not continue a UTF-8 sequence.
std::size_t width_of(const std::string& text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string pad(const std::string& text, std::size_t width) {
  const std::size_t used = width_of(text);
  return text + std::string(used < width ? width - used : 0, ' ');
}

std::string number(double x) {
  if (!std::isfinite(x)) return "      –";
  return x != 0 && std::abs(x) < 5e-4 ? fmt::format("{:7.1e}", x) : fmt::format("{:7.4f}", x);
}

std::string row(const std::string& name, const std::vector<std::string>& columns) {
  std::string text = pad(name, k_name_width);
  for (const std::string& column : columns) {
    text += ' ';
    text += pad(column, k_column_width);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

template <class Column> std::string row_of(const Report& report, const char* name, Column column) {
  std::vector<std::string> columns;
  for (std::size_t c = 0; c < report.candidates.size(); ++c)
    columns.push_back(column(c));
  return row(name, columns);
}

} // namespace

std::string to_text(const Report& report) {
  std::string text = row_of(report, "", [&](std::size_t c) { return report.candidates[c].label; });
  text += row_of(report, "horizon", [&](std::size_t c) {
    return std::string(report.candidates[c].horizon == Horizon::clipped ? "clipped" : "leaking");
  });
  text += "bound: no light of radiance 0 to L errs by more than bound * L where F = 1\n";
  for (const RegionReport& region : report.regions) {
    const MeasureOptions& o = region.region;
    text += fmt::format("{}, theta to {}°, {} × {} points on a grid of its own\n", region.name,
                        o.theta_to_degrees, o.points, o.points);
    text += row_of(report, "",
                   [](std::size_t) { return std::string("   mean  median     p95     max"); });
    for (const LobeErrorField& field : lobe_error_fields()) {
      text += row_of(report, field.name, [&](std::size_t c) {
        const TableError& e = region.errors[c];
        return fmt::format("{} {} {} {}", number(e.mean.*field.member),
                           number(e.median.*field.member), number(e.p95.*field.member),
                           number(e.max.*field.member));
      });
    }
  }
  if (report.lights.count > 0) {
    text += fmt::format("integrals over {} random rectangles, radiance 1, albedo 1\n",
                        report.lights.count);
    text += row_of(report, "",
                   [](std::size_t) { return std::string("   rmse    mean     p95     max"); });
    text += row_of(report, "error", [&](std::size_t c) {
      const LightError& e = report.candidates[c].lights;
      return fmt::format("{} {} {} {}", number(e.rmse), number(e.mean), number(e.p95),
                         number(e.max));
    });
    text += row_of(report, "beyond", [&](std::size_t c) {
      return fmt::format("{:7} of them beyond their bound", report.candidates[c].lights.violations);
    });
  }
  text += "mean second difference of M^-1 over the axes\n";
  text += row_of(report, "", [&](std::size_t c) {
    const std::optional<double>& d = report.candidates[c].second_difference;
    return d && std::isfinite(*d) ? fmt::format("{:7.2e}", *d) : std::string("      –");
  });
  return text;
}

} // namespace openltc::fit
