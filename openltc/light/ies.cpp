// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: ANSI/IES LM-63-2002, the meaning of the angles; LM-63-1995, horizontal angles from 90 to
// 270 degrees.
//
// Between the measured angles intensity is taken to be bilinear in the two angles. The flux is the
// exact integral of that: with M(t) the mean over the horizontal angle, linear from a at t0 to b at
// t1, an interval gives
//   2 pi int M sin = 2 pi (a cos t0 - b cos t1 + (b - a)/(t1 - t0) (sin t1 - sin t0)).
//
// The grid for shading takes the largest steps that meet all of the measured angles, so it
// interpolates the same function; where there are none, it has steps of half a degree. Where the
// measurement ends inside the sphere, at 90 degrees say, intensity falls to 0 within one step of
// the grid, at most a degree.

#include "openltc/light/ies.h"

#include "openltc/base/regular_file.h"
#include "openltc/light/ies_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace openltc::light {

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_angle_tolerance = 0.01; // degrees; files round their angles
constexpr std::uintmax_t k_max_bytes = 16u << 20;
constexpr int k_max_intervals = 720;

struct Place {
  std::size_t index; // of the angle below, one above which exists unless there is only one
  double fraction;
};

Place place_of(const std::vector<double>& angles, double angle) {
  if (angles.size() < 2) return {0, 0};
  const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, angle);
  const std::size_t index = std::size_t(above - angles.begin()) - 1;
  const double step = angles[index + 1] - angles[index];
  return {index, std::clamp((angle - angles[index]) / step, 0.0, 1.0)};
}

bool is_measured(const IesProfile& profile, double vertical_degrees) {
  return vertical_degrees >= profile.vertical_degrees.front() - 1e-9 &&
         vertical_degrees <= profile.vertical_degrees.back() + 1e-9;
}

// Intensity at the vertical place in row h.
double at_row(const IesProfile& profile, std::size_t h, Place v) {
  const std::size_t count = profile.vertical_degrees.size();
  const double* row = profile.candela.data() + h * count + v.index;
  return row[0] + (row[count > 1 ? 1 : 0] - row[0]) * v.fraction;
}

double eval_degrees(const IesProfile& profile, double vertical, double horizontal) {
  if (!is_measured(profile, vertical)) return 0;
  const Place v = place_of(profile.vertical_degrees, vertical);
  const Place h = place_of(profile.horizontal_degrees, horizontal);
  const double a = at_row(profile, h.index, v);
  if (profile.horizontal_degrees.size() < 2) return a;
  return a + (at_row(profile, h.index + 1, v) - a) * h.fraction;
}

double mean_degrees(const IesProfile& profile, double vertical) {
  if (!is_measured(profile, vertical)) return 0;
  const Place v = place_of(profile.vertical_degrees, vertical);
  const std::vector<double>& angles = profile.horizontal_degrees;
  if (angles.size() < 2) return at_row(profile, 0, v);
  double sum = 0;
  for (std::size_t h = 0; h + 1 < angles.size(); ++h)
    sum += 0.5 * (at_row(profile, h, v) + at_row(profile, h + 1, v)) * (angles[h + 1] - angles[h]);
  return sum / 360;
}

double flux_of(const IesProfile& profile) {
  const std::vector<double>& angles = profile.vertical_degrees;
  double sum = 0;
  for (std::size_t v = 0; v + 1 < angles.size(); ++v) {
    const double t0 = angles[v] * k_pi / 180, t1 = angles[v + 1] * k_pi / 180;
    const double a = mean_degrees(profile, angles[v]), b = mean_degrees(profile, angles[v + 1]);
    sum +=
        a * std::cos(t0) - b * std::cos(t1) + (b - a) / (t1 - t0) * (std::sin(t1) - std::sin(t0));
  }
  return 2 * k_pi * std::max(sum, 0.0);
}

// A whole circle of angles, each with the row of the file that belongs to it.
struct Circle {
  std::vector<double> degrees;
  std::vector<std::size_t> row;
  void add(double angle, std::size_t r) {
    degrees.push_back(angle);
    row.push_back(r);
  }
  // Appends the mirror image about the last angle.
  void unfold() {
    const double twice = 2 * degrees.back();
    for (std::size_t i = degrees.size() - 1; i-- > 0;)
      add(twice - degrees[i], row[i]);
  }
};

// Empty when the angles are of no known symmetry. From 90 to 270 degrees the circle runs on to 450.
Circle unfold_circle(const std::vector<double>& angles) {
  Circle circle;
  const double first = angles.front(), last = angles.back();
  const auto near = [](double a, double b) { return std::abs(a - b) <= k_angle_tolerance; };
  for (std::size_t i = 0; i < angles.size(); ++i)
    circle.add(angles[i], i);
  if (angles.size() == 1) return near(first, 0) ? circle : Circle{};
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

void take_circle(const Circle& circle, const IesText& file, IesProfile& profile) {
  const std::size_t count = file.vertical_degrees.size();
  const auto append = [&](double degrees, std::size_t row) {
    const auto from = file.candela.begin() + std::ptrdiff_t(row * count);
    profile.horizontal_degrees.push_back(degrees);
    profile.candela.insert(profile.candela.end(), from, from + std::ptrdiff_t(count));
  };
  if (circle.degrees.back() <= 360) {
    for (std::size_t i = 0; i < circle.degrees.size(); ++i)
      append(circle.degrees[i], circle.row[i]);
    return;
  }
  // From 90 to 450 degrees: turn so that it begins at 0, with an angle made there if there is none.
  const auto split =
      std::size_t(std::lower_bound(circle.degrees.begin(), circle.degrees.end(), 360 - 1e-9) -
                  circle.degrees.begin());
  std::vector<double> seam(count);
  const double below = circle.degrees[split - 1], above = circle.degrees[split];
  const double fraction = std::clamp((360 - below) / (above - below), 0.0, 1.0);
  for (std::size_t v = 0; v < count; ++v) {
    const double a = file.candela[circle.row[split - 1] * count + v];
    seam[v] = a + (file.candela[circle.row[split] * count + v] - a) * fraction;
  }
  const auto append_seam = [&](double degrees) {
    profile.horizontal_degrees.push_back(degrees);
    profile.candela.insert(profile.candela.end(), seam.begin(), seam.end());
  };
  append_seam(0);
  for (std::size_t i = split; i < circle.degrees.size(); ++i)
    if (circle.degrees[i] - 360 > 1e-9) append(circle.degrees[i] - 360, circle.row[i]);
  // 450 degrees is 90 again.
  for (std::size_t i = 1; i < split; ++i)
    append(circle.degrees[i], circle.row[i]);
  append_seam(360);
}

// The least number of equal intervals of `span`, `least` or more, whose ends meet all angles.
int intervals_for(const std::vector<double>& angles, double span, int least) {
  for (int n = 1; n <= k_max_intervals; ++n) {
    const bool meets = std::all_of(angles.begin(), angles.end(), [&](double angle) {
      const double node = angle * n / span;
      return std::abs(node - std::round(node)) < 1e-3;
    });
    if (meets) return n * ((least + n - 1) / n);
  }
  return k_max_intervals;
}

void make_grid(IesProfile& profile) {
  const std::vector<double>& vertical = profile.vertical_degrees;
  const bool whole = vertical.front() <= 0 && vertical.back() >= 180;
  const int rows = intervals_for(vertical, 180, whole ? 1 : 180);
  const bool round = profile.horizontal_degrees.size() == 1;
  const int columns = round ? 0 : intervals_for(profile.horizontal_degrees, 360, 1);
  profile.grid_rows = rows + 1;
  profile.grid_columns = columns + 1;
  profile.grid.reserve(std::size_t(profile.grid_rows) * std::size_t(profile.grid_columns));
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double candela =
          eval_degrees(profile, 180.0 * j / rows, round ? 0 : 360.0 * i / columns);
      profile.grid.push_back(float(std::clamp(candela / profile.max_candela, 0.0, 1.0)));
    }
}

std::string name_of(const IesText& file, const std::string& path) {
  for (const char* key : {"LUMINAIRE", "LUMCAT"})
    for (const auto& keyword : file.keywords)
      if (keyword.first == key && !keyword.second.empty()) return keyword.second;
  if (!file.label.empty()) return file.label;
  return std::filesystem::path(path).stem().string();
}

} // namespace

double eval_candela(const IesProfile& profile, double vertical_rad, double horizontal_rad) {
  double horizontal = std::fmod(horizontal_rad * 180 / k_pi, 360);
  if (horizontal < 0) horizontal += 360;
  return eval_degrees(profile, vertical_rad * 180 / k_pi, horizontal);
}

double mean_candela(const IesProfile& profile, double vertical_rad) {
  return mean_degrees(profile, vertical_rad * 180 / k_pi);
}

Result<IesProfile> parse_ies(std::string_view text, const std::string& name) {
  const Result<IesText> file = parse_ies_text(text, name);
  if (!file.ok()) return file.error();
  const auto wrong = [&](const std::string& what) {
    return Error{fmt::format("{}: {}", name, what)};
  };
  if (file->vertical_degrees.size() < 2) return wrong("one vertical angle is too few");
  const Circle circle = unfold_circle(file->horizontal_degrees);
  if (circle.degrees.empty())
    return wrong(fmt::format("the horizontal angles run from {} to {}; they must be 0 alone or run "
                             "from 0 to 90, 180 or 360 or from 90 to 270",
                             file->horizontal_degrees.front(), file->horizontal_degrees.back()));
  // Rounding of the angles must not have put the ends out of order.
  for (std::size_t i = 1; i < circle.degrees.size(); ++i)
    if (!(circle.degrees[i] > circle.degrees[i - 1]))
      return wrong("horizontal angles are too close to each other");

  IesProfile profile;
  profile.name = name_of(*file, name);
  profile.version = file->version;
  profile.keywords = file->keywords;
  profile.lamp_lumens = file->lamp_lumens;
  profile.input_watts = file->input_watts;
  std::copy_n(file->size_metres, 3, profile.size_metres);
  profile.vertical_degrees = file->vertical_degrees;
  take_circle(circle, *file, profile);
  profile.max_candela = *std::max_element(profile.candela.begin(), profile.candela.end());
  // Below this a share of the maximum has no digits left.
  if (!(profile.max_candela > 1e-100)) return wrong("all intensities are zero");
  profile.flux_lumens = flux_of(profile);
  make_grid(profile);
  return profile;
}

Result<IesProfile> read_ies(const std::string& path) {
  const Result<std::string> text = read_regular_text(path, k_max_bytes);
  if (!text) return text.error();
  return parse_ies(*text, path);
}

} // namespace openltc::light
