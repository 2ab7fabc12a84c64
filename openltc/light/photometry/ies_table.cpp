// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Between the measured angles intensity is taken to be bilinear in the two angles. The flux is the
// exact integral of that: with M(t) the mean over the azimuth, linear from a at t0 to b at t1, an
// interval of the polar angle gives
//   2 pi int M sin = 2 pi (a cos t0 - b cos t1 + (b - a)/(t1 - t0) (sin t1 - sin t0)).
// All three systems are polar angles and azimuths of a sphere, so this holds for each.
//
// The grid for shading takes the largest steps that meet all of the measured angles, so it
// interpolates the same function, down to a quarter of a degree; where there are none, it has 720
// steps. Where the measurement ends inside the sphere, at 90 degrees say, intensity falls to 0
// within one step of the grid, at most a degree.

#include "openltc/light/photometry/ies_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::light {

namespace {

constexpr int k_steps_per_degree = 4, k_intervals_otherwise = 720;
constexpr double k_noise = 0.01; // of the largest value
constexpr double k_edge = 1e-9;  // degrees by which rounding may leave the measured range

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

bool is_measured(const std::vector<double>& angles, double angle) {
  return angle >= angles.front() - k_edge && angle <= angles.back() + k_edge;
}

// Intensity at the polar place in row a.
double at_row(const IesProfile& profile, std::size_t a, Place p) {
  const std::size_t count = profile.polar_degrees.size();
  const double* row = profile.candela.data() + a * count + p.index;
  return row[0] + (row[count > 1 ? 1 : 0] - row[0]) * p.fraction;
}

// The same azimuth within the circle that begins where the measurement does.
double wrapped(double azimuth, double first) {
  double w = azimuth - first;
  w -= 360 * std::floor(w / 360);
  return w > 360 - k_edge ? first : first + w;
}

// Over the azimuth of the profile's own sphere.
double mean_degrees(const IesProfile& profile, double polar) {
  if (!is_measured(profile.polar_degrees, polar)) return 0;
  const Place p = place_of(profile.polar_degrees, polar);
  const std::vector<double>& angles = profile.azimuth_degrees;
  if (angles.size() < 2) return at_row(profile, 0, p);
  double sum = 0;
  for (std::size_t a = 0; a + 1 < angles.size(); ++a)
    sum += 0.5 * (at_row(profile, a, p) + at_row(profile, a + 1, p)) * (angles[a + 1] - angles[a]);
  return sum / 360;
}

double flux_of(const IesProfile& profile) {
  const std::vector<double>& angles = profile.polar_degrees;
  double sum = 0;
  for (std::size_t p = 0; p + 1 < angles.size(); ++p) {
    const double t0 = angles[p] * std::numbers::pi / 180,
                 t1 = angles[p + 1] * std::numbers::pi / 180;
    const double a = mean_degrees(profile, angles[p]), b = mean_degrees(profile, angles[p + 1]);
    sum +=
        a * std::cos(t0) - b * std::cos(t1) + (b - a) / (t1 - t0) * (std::sin(t1) - std::sin(t0));
  }
  return 2 * std::numbers::pi * std::max(sum, 0.0);
}

// The least number of equal intervals of `span`, `least` or more, whose ends meet all angles.
int intervals_for(const std::vector<double>& angles, double span, int least) {
  const int most = int(span) * k_steps_per_degree;
  for (int n = 1; n <= most; ++n) {
    const bool meets = std::all_of(angles.begin(), angles.end(), [&](double angle) {
      const double node = angle * n / span;
      return std::abs(node - std::round(node)) < 1e-3;
    });
    if (meets) return n * ((least + n - 1) / n);
  }
  return k_intervals_otherwise;
}

void make_grid(IesProfile& profile) {
  const std::vector<double>& polar = profile.polar_degrees;
  const std::vector<double>& azimuth = profile.azimuth_degrees;
  const bool round = azimuth.size() == 1;
  const bool is_whole = polar.front() <= 0 && polar.back() >= 180;
  const bool is_circle = round || azimuth.back() - azimuth.front() >= 360 - k_edge;
  const int rows = intervals_for(polar, 180, is_whole ? 1 : 180);
  const int columns = round ? 0 : intervals_for(azimuth, 360, is_circle ? 1 : 360);
  profile.grid_rows = rows + 1;
  profile.grid_columns = columns + 1;
  profile.grid.reserve(std::size_t(profile.grid_rows) * std::size_t(profile.grid_columns));
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      // The last column is the first again, to the last digit.
      const double around = round || i == columns ? 0 : 360.0 * i / columns;
      const double candela = eval_own(profile, 180.0 * j / rows, around);
      profile.grid.push_back(float(std::clamp(candela / profile.max_candela, 0.0, 1.0)));
    }
}

Status check_order(const std::vector<double>& angles, const std::string& name) {
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (!(angles[i] > angles[i - 1]))
      return Error{fmt::format("{}: angles are too close to each other", name)};
  return Success{};
}

} // namespace

double eval_own(const IesProfile& profile, double polar, double azimuth) {
  if (!is_measured(profile.polar_degrees, polar)) return 0;
  const Place p = place_of(profile.polar_degrees, polar);
  const std::vector<double>& angles = profile.azimuth_degrees;
  if (angles.size() < 2) return at_row(profile, 0, p);
  const double within = wrapped(azimuth, angles.front());
  if (!is_measured(angles, within)) return 0;
  const Place a = place_of(angles, within);
  const double low = at_row(profile, a.index, p);
  return low + (at_row(profile, a.index + 1, p) - low) * a.fraction;
}

std::string_view trimmed(std::string_view s) {
  const auto is_empty = [](char c) {
    return c == ' ' || c == '\t' || c == ',' || c == '\f' || c == '\v' || c == '\0';
  };
  while (!s.empty() && is_empty(s.front()))
    s.remove_prefix(1);
  while (!s.empty() && is_empty(s.back()))
    s.remove_suffix(1);
  return s;
}

std::string printable(std::string_view s, std::size_t length) {
  std::string out(s.substr(0, length));
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return out;
}

void AngleRows::unfold() {
  const double twice = 2 * degrees.back();
  for (std::size_t i = degrees.size() - 1; i-- > 0;)
    add(twice - degrees[i], row[i]);
}

void take_rows(const std::vector<double>& polar, const AngleRows& azimuth,
               const std::vector<double>& rows, IesProfile& profile) {
  profile.polar_degrees = polar;
  const std::size_t count = polar.size();
  const auto append = [&](double degrees, std::size_t row) {
    const auto from = rows.begin() + std::ptrdiff_t(row * count);
    profile.azimuth_degrees.push_back(degrees);
    profile.candela.insert(profile.candela.end(), from, from + std::ptrdiff_t(count));
  };
  if (azimuth.degrees.back() <= 360) {
    for (std::size_t i = 0; i < azimuth.degrees.size(); ++i)
      append(azimuth.degrees[i], azimuth.row[i]);
    return;
  }
  const auto split =
      std::size_t(std::lower_bound(azimuth.degrees.begin(), azimuth.degrees.end(), 360 - k_edge) -
                  azimuth.degrees.begin());
  std::vector<double> seam(count);
  const double below = azimuth.degrees[split - 1], above = azimuth.degrees[split];
  const double fraction = std::clamp((360 - below) / (above - below), 0.0, 1.0);
  for (std::size_t p = 0; p < count; ++p) {
    const double a = rows[azimuth.row[split - 1] * count + p];
    seam[p] = a + (rows[azimuth.row[split] * count + p] - a) * fraction;
  }
  const auto append_seam = [&](double degrees) {
    profile.azimuth_degrees.push_back(degrees);
    profile.candela.insert(profile.candela.end(), seam.begin(), seam.end());
  };
  append_seam(0);
  for (std::size_t i = split; i < azimuth.degrees.size(); ++i)
    if (azimuth.degrees[i] - 360 > k_edge) append(azimuth.degrees[i] - 360, azimuth.row[i]);
  // The last angle is the first again.
  for (std::size_t i = 1; i < split; ++i)
    append(azimuth.degrees[i], azimuth.row[i]);
  append_seam(360);
}

Status finish_profile(IesProfile& profile, const std::string& name) {
  if (Status ok = check_order(profile.polar_degrees, name); !ok) return ok;
  if (Status ok = check_order(profile.azimuth_degrees, name); !ok) return ok;
  profile.max_candela = *std::max_element(profile.candela.begin(), profile.candela.end());
  // Below this a share of the maximum has no digits left.
  if (!(profile.max_candela > 1e-100))
    return Error{fmt::format("{}: all intensities are zero", name)};
  profile.flux_lumens = flux_of(profile);
  make_grid(profile);
  return Success{};
}

std::size_t clamp_noise(std::vector<double>& values, const std::string& name,
                        std::vector<std::string>& warnings) {
  if (values.empty()) return 0;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (*least >= 0) return values.size();
  if (-*least > k_noise * *most) return std::size_t(least - values.begin());
  const double worst = *least, largest = *most;
  std::size_t count = 0;
  for (double& value : values)
    if (value < 0) {
      value = 0;
      ++count;
    }
  warnings.push_back(fmt::format(
      "{}: {} of {} intensities {} below 0, down to {:.4g} where the largest is {:.4g}; "
      "counted as 0, as noise of the measurement",
      name, count, values.size(), count == 1 ? "is" : "are", worst, largest));
  return values.size();
}

double eval_candela(const IesProfile& profile, Vec3d d) {
  const PhotometricAngles angles = angles_of(profile.type, d);
  switch (profile.type) {
  case PhotometricType::a:
    return eval_own(profile, 90 - angles.vertical, angles.horizontal);
  case PhotometricType::b:
    return eval_own(profile, 90 + angles.horizontal, angles.vertical);
  default:
    return eval_own(profile, angles.vertical, angles.horizontal);
  }
}

double eval_candela(const IesProfile& profile, double vertical_rad, double horizontal_rad) {
  if (profile.type == PhotometricType::c)
    return eval_own(profile, vertical_rad * 180 / std::numbers::pi,
                    horizontal_rad * 180 / std::numbers::pi);
  return eval_candela(profile,
                      direction_of(PhotometricType::c, {vertical_rad * 180 / std::numbers::pi,
                                                        horizontal_rad * 180 / std::numbers::pi}));
}

double mean_candela(const IesProfile& profile, double vertical_rad) {
  if (profile.type == PhotometricType::c)
    return mean_degrees(profile, vertical_rad * 180 / std::numbers::pi);
  constexpr int sectors = 360;
  double sum = 0;
  for (int i = 0; i < sectors; ++i)
    sum += eval_candela(profile, vertical_rad, 2 * std::numbers::pi * (i + 0.5) / sectors);
  return sum / sectors;
}

} // namespace openltc::light
