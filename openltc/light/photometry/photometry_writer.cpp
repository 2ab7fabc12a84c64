// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: ANSI/IESNA LM-63-2002: required keywords, no line longer than 256 characters with its
// end, horizontal angles from 0 to 0, 90, 180 or 360 degrees for type C, from 0 or -90 for A and B.

#include "openltc/light/photometry/ies_table.h"
#include "openltc/light/photometry/photometry.h"
#include "openltc/light/photometry/photometry_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::light {

namespace {

constexpr std::size_t k_line = 120;

void put_keyword(std::string& out, const std::string& key, const std::string& text) {
  std::string_view rest = text;
  std::string name = key;
  do {
    std::size_t length = std::min(rest.size(), k_line);
    if (length < rest.size())
      if (const std::size_t blank = rest.rfind(' ', length);
          blank != std::string_view::npos && blank > 0)
        length = blank;
    out += fmt::format("[{}] {}\r\n", name, trimmed(rest.substr(0, length)));
    rest.remove_prefix(length);
    name = "MORE";
  } while (!trimmed(rest).empty());
}

void put_keywords(std::string& out, const IesProfile& profile) {
  const auto has = [&](const std::string& key) {
    return std::any_of(profile.keywords.begin(), profile.keywords.end(),
                       [&](const auto& keyword) { return keyword.first == key; });
  };
  for (const char* required : {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"})
    if (!has(required)) put_keyword(out, required, "unknown");
  for (const auto& [key, text] : profile.keywords)
    put_keyword(out, key, printable(text, 4096));
  if (!has("LUMINAIRE") && !profile.name.empty()) put_keyword(out, "LUMINAIRE", profile.name);
}

void put_numbers(std::string& out, const std::vector<double>& numbers) {
  std::size_t column = 0;
  for (const double number : numbers) {
    // No -0, and no digits that only rounding has put there.
    const std::string text = fmt::format("{:.10g}", number == 0 ? 0 : number);
    if (column > 0 && column + 1 + text.size() > k_line) {
      out += "\r\n";
      column = 0;
    }
    if (column > 0) out += ' ';
    out += text;
    column += text.size() + 1;
  }
  out += "\r\n";
}

// Which of ascending angles, that are alike on both sides, have to be written: those from `low` to
// `high`, if there are angles at both.
std::vector<std::size_t> between(const std::vector<double>& angles, double low, double high) {
  std::vector<std::size_t> chosen;
  const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (angles[i] >= low - 1e-9 && angles[i] <= high + 1e-9) chosen.push_back(i);
  const bool is_bounded = chosen.size() > 1 && is_near(angles[chosen.front()], low) &&
                          (high >= angles.back() || is_near(angles[chosen.back()], high));
  return is_bounded ? chosen : std::vector<std::size_t>{};
}

} // namespace

std::string to_lm63(const IesProfile& profile) {
  const std::vector<double>& polar = profile.polar_degrees;
  const std::vector<double>& azimuth = profile.azimuth_degrees;
  const bool is_b = profile.type == PhotometricType::b;
  const std::vector<double>& sideways = is_b ? polar : azimuth; // what H follows from
  const PhotometricSymmetry symmetry = symmetry_of(profile, 1e-12);
  const bool is_mirrored = symmetry == PhotometricSymmetry::plane_c0 ||
                           symmetry == PhotometricSymmetry::both ||
                           symmetry == PhotometricSymmetry::axis;
  std::vector<std::size_t> chosen;
  if (profile.type != PhotometricType::c) {
    if (is_mirrored) chosen = between(sideways, is_b ? 90 : 0, sideways.back());
  } else if (symmetry == PhotometricSymmetry::axis) {
    chosen = {0};
  } else {
    if (symmetry == PhotometricSymmetry::both) chosen = between(azimuth, 0, 90);
    if (chosen.empty() && is_mirrored) chosen = between(azimuth, 0, 180);
  }
  if (chosen.empty())
    for (std::size_t i = 0; i < sideways.size(); ++i)
      chosen.push_back(i);

  // V ascends: of type A, that is with the polar angle descending.
  const std::size_t vertical_count = is_b ? azimuth.size() : polar.size();
  std::vector<double> vertical, horizontal;
  const auto node = [&](std::size_t v, std::size_t h) {
    const std::size_t row = profile.type == PhotometricType::a ? vertical_count - 1 - v : v;
    return is_b ? std::pair(row, h) : std::pair(h, row);
  };
  for (std::size_t v = 0; v < vertical_count; ++v) {
    const auto [a, p] = node(v, chosen[0]);
    vertical.push_back(node_angles(profile, a, p).vertical);
  }
  for (const std::size_t h : chosen) {
    const auto [a, p] = node(0, h);
    horizontal.push_back(chosen.size() == 1 ? 0 : node_angles(profile, a, p).horizontal);
  }

  std::string out = "IESNA:LM-63-2002\r\n";
  put_keywords(out, profile);
  const double lumens = profile.lamp_lumens > 0 ? profile.lamp_lumens / profile.lamp_count : -1;
  out += "TILT=NONE\r\n";
  out += fmt::format("{} {:.10g} 1 {} {} {} 2 {:.10g} {:.10g} {:.10g}\r\n",
                     std::max(profile.lamp_count, 1), lumens, vertical.size(), horizontal.size(),
                     int(profile.type), profile.size_metres[0], profile.size_metres[1],
                     profile.size_metres[2]);
  out += fmt::format("1 1 {:.10g}\r\n", profile.input_watts);
  put_numbers(out, vertical);
  put_numbers(out, horizontal);
  for (const std::size_t h : chosen) {
    std::vector<double> values;
    for (std::size_t v = 0; v < vertical_count; ++v) {
      const auto [a, p] = node(v, h);
      values.push_back(profile.candela[a * polar.size() + p]);
    }
    put_numbers(out, values);
  }
  return out;
}

} // namespace openltc::light
