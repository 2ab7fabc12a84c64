// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: ANSI/IES LM-63-2002, the meaning of the angles; LM-63-1995, horizontal angles from 90 to
// 270 degrees.

#include "openltc/light/photometry/ies.h"

#include "openltc/light/photometry/ies_table.h"
#include "openltc/light/photometry/ies_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace openltc::light {

namespace {

constexpr double k_angle_tolerance = 0.01; // degrees; files round their angles

bool near(double a, double b) { return std::abs(a - b) <= k_angle_tolerance; }

// Empty when the angles are of no known symmetry. From 90 to 270 degrees the circle runs on to 450.
AngleRows unfold_circle(const std::vector<double>& angles) {
  AngleRows circle;
  const double first = angles.front(), last = angles.back();
  for (std::size_t i = 0; i < angles.size(); ++i)
    circle.add(angles[i], i);
  if (angles.size() == 1) return near(first, 0) ? circle : AngleRows{};
  circle.degrees.front() = near(first, 90) ? 90 : 0;
  if (near(first, 90) && near(last, 270)) {
    circle.degrees.back() = 270;
    circle.unfold();
    return circle;
  }
  if (!near(first, 0)) return {};
  double largest_step = 0;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    largest_step = std::max(largest_step, angles[i + 1] - angles[i]);
  if (near(last, 90)) {
    circle.degrees.back() = 90;
    circle.unfold();
    circle.unfold();
  } else if (near(last, 180)) {
    circle.degrees.back() = 180;
    circle.unfold();
  } else if (near(last, 360)) {
    circle.degrees.back() = 360;
  } else if (last > 180 && 360 - last <= 1.5 * largest_step) {
    circle.add(360, 0);
  } else {
    return {};
  }
  return circle;
}

// Types A and B: from -last to last where the angles begin at 0. Ascending.
AngleRows unfold_sides(const std::vector<double>& angles) {
  AngleRows sides;
  if (near(angles.front(), 0))
    for (std::size_t i = angles.size(); i-- > 1;)
      sides.add(-angles[i], i);
  for (std::size_t i = 0; i < angles.size(); ++i)
    sides.add(i == 0 && near(angles[0], 0) ? 0 : angles[i], i);
  return sides;
}

// The polar angle of A is 90 - V, so that the order turns over.
void take_type_a(const IesText& file, IesProfile& profile) {
  const std::size_t count = file.vertical_degrees.size();
  std::vector<double> polar, rows;
  for (std::size_t v = count; v-- > 0;)
    polar.push_back(90 - file.vertical_degrees[v]);
  for (std::size_t h = 0; h < file.horizontal_degrees.size(); ++h)
    for (std::size_t v = count; v-- > 0;)
      rows.push_back(file.candela[h * count + v]);
  take_rows(polar, unfold_sides(file.horizontal_degrees), rows, profile);
}

// That of B is 90 + H, so that rows and columns change places.
void take_type_b(const IesText& file, IesProfile& profile) {
  const std::size_t count = file.vertical_degrees.size();
  const AngleRows sides = unfold_sides(file.horizontal_degrees);
  std::vector<double> polar, rows;
  for (const double h : sides.degrees)
    polar.push_back(90 + h);
  AngleRows azimuth;
  for (std::size_t v = 0; v < count; ++v) {
    azimuth.add(file.vertical_degrees[v], v);
    for (const std::size_t h : sides.row)
      rows.push_back(file.candela[h * count + v]);
  }
  take_rows(polar, azimuth, rows, profile);
}

std::string name_of(const IesText& file, const std::string& path) {
  for (const char* key : {"LUMINAIRE", "LUMCAT"})
    for (const auto& keyword : file.keywords)
      if (keyword.first == key && !keyword.second.empty()) return keyword.second;
  if (!file.label.empty()) return file.label;
  return std::filesystem::path(path).stem().string();
}

} // namespace

Result<IesProfile> parse_ies(std::string_view text, const std::string& name) {
  const Result<IesText> file = parse_ies_text(text, name);
  if (!file.ok()) return file.error();
  const auto wrong = [&](const std::string& what) {
    return Error{fmt::format("{}: {}", name, what)};
  };
  if (file->vertical_degrees.size() < 2) return wrong("one vertical angle is too few");
  const bool is_c = file->type == PhotometricType::c;
  if (!is_c && file->horizontal_degrees.size() < 2)
    return wrong(fmt::format("one horizontal angle is too few for photometric type {}",
                             file->type == PhotometricType::a ? "A" : "B"));

  IesProfile profile;
  profile.name = name_of(*file, name);
  profile.version = file->version;
  profile.type = file->type;
  profile.keywords = file->keywords;
  profile.lamp_lumens = file->lamp_lumens;
  profile.lamp_count = file->lamp_count;
  profile.input_watts = file->input_watts;
  profile.warnings = file->warnings;
  std::copy_n(file->size_metres, 3, profile.size_metres);
  if (is_c) {
    const AngleRows circle = unfold_circle(file->horizontal_degrees);
    if (circle.degrees.empty())
      return wrong(fmt::format("the horizontal angles run from {} to {}; they must be 0 alone or "
                               "run from 0 to 90, 180 or 360 or from 90 to 270",
                               file->horizontal_degrees.front(), file->horizontal_degrees.back()));
    // Rounding of the angles must not have put the ends out of order.
    for (std::size_t i = 1; i < circle.degrees.size(); ++i)
      if (!(circle.degrees[i] > circle.degrees[i - 1]))
        return wrong("horizontal angles are too close to each other");
    take_rows(file->vertical_degrees, circle, file->candela, profile);
  } else if (file->type == PhotometricType::a) {
    take_type_a(*file, profile);
  } else {
    take_type_b(*file, profile);
  }
  if (Status ok = finish_profile(profile, name); !ok) return ok.error();
  return profile;
}

} // namespace openltc::light
