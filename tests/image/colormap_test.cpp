// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What colour scales promise to every reader, in CIE 1976 L*a*b* (D65): equal steps look alike, and
// lightness tells the order, also to those who lack a kind of cones. Their sight is simulated after
// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A Physiologically-based Model for Simulation
// of Color Vision Deficiency", IEEE TVCG 15(6), 2009: its matrices of severity 1, on linear RGB.

#include "openltc/image/colormap.h"
#include "openltc/image/file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::image;

namespace {

using Scale = std::function<Vec3f(float)>;

struct Sight {
  const char* name;
  std::array<std::array<double, 3>, 3> rgb; ///< linear, from what is shown to what is seen
};

constexpr std::array<Sight, 3> k_sights = {{{"all cones", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                                            {"protanopia",
                                             {{{0.152286, 1.052583, -0.204868},
                                               {0.114503, 0.786281, 0.099216},
                                               {-0.003882, -0.048116, 1.051998}}}},
                                            {"deuteranopia",
                                             {{{0.367322, 0.860646, -0.227968},
                                               {0.280085, 0.672501, 0.047413},
                                               {-0.011820, 0.042940, 0.968881}}}}}};

struct Lab {
  double l, a, b;
};

double distance(Lab p, Lab q) { return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b); }

Lab lab_of(Vec3f display, const Sight& sight) {
  const std::array<double, 3> shown = {double(linear_from_srgb(display.x)),
                                       double(linear_from_srgb(display.y)),
                                       double(linear_from_srgb(display.z))};
  std::array<double, 3> seen{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      seen[i] += sight.rgb[i][k] * shown[k];
    seen[i] = std::clamp(seen[i], 0.0, 1.0);
  }
  const auto [r, g, b] = seen;
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  // Primaries of sRGB (IEC 61966-2-1) over the white of D65.
  const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Scale scale_of(Colormap map) {
  return [map](float t) { return map_color(map, t); };
}

std::vector<Lab> walk(const Scale& scale, const Sight& sight, int steps) {
  std::vector<Lab> colors;
  for (int i = 0; i <= steps; ++i)
    colors.push_back(lab_of(scale(float(i) / float(steps)), sight));
  return colors;
}

// Whether every step is lighter than the one before.
bool lightens(const Scale& scale, const Sight& sight, float from, float to) {
  const std::vector<Lab> colors =
      walk([&](float t) { return scale(from + t * (to - from)); }, sight, 128);
  return std::is_sorted(colors.begin(), colors.end(),
                        [](const Lab& p, const Lab& q) { return p.l <= q.l; });
}

struct Steps {
  double least, most; ///< over the mean
};

template <class Size> Steps steps_of(const std::vector<Lab>& colors, Size size) {
  double least = 1e9, most = 0, sum = 0;
  for (std::size_t i = 1; i < colors.size(); ++i) {
    const double step = size(colors[i - 1], colors[i]);
    least = std::min(least, step);
    most = std::max(most, step);
    sum += step;
  }
  const double mean = sum / double(colors.size() - 1);
  return {least / mean, most / mean};
}

// The least distance of colours on the two sides of a diverging scale, over their distance on it.
double sides_apart(const Scale& scale, const Sight& sight) {
  double least = 1e9;
  for (int i = 1; i <= 64; ++i) {
    const float k = float(i) / 64.0f;
    const double apart =
        distance(lab_of(scale(0.5f - k / 2), sight), lab_of(scale(0.5f + k / 2), sight));
    least = std::min(least, apart / double(k));
  }
  return least;
}

} // namespace

TEST_CASE("simulated sight leaves white, grey and black as they are") {
  for (const Sight& sight : k_sights)
    for (const float grey : {0.0f, 0.2f, 0.7f, 1.0f}) {
      const Lab seen = lab_of(Vec3f(grey), sight), shown = lab_of(Vec3f(grey), k_sights[0]);
      CHECK(distance(seen, shown) < 0.01);
    }
}

TEST_CASE("magma and viridis lighten in even steps, to colour-blind readers as well") {
  for (const Colormap map : {Colormap::magma, Colormap::viridis})
    for (const Sight& sight : k_sights) {
      CAPTURE(int(map));
      CAPTURE(sight.name);
      CHECK(lightens(scale_of(map), sight, 0, 1));
      const std::vector<Lab> colors = walk(scale_of(map), sight, 16);
      // The first step of magma, out of black, is the smallest: half the mean in lightness.
      const Steps lightness = steps_of(colors, [](Lab p, Lab q) { return q.l - p.l; });
      CHECK(lightness.least > 0.45);
      CHECK(lightness.most < 1.5);
      const Steps color = steps_of(colors, distance);
      CHECK(color.least > 0.4);
      CHECK(color.most < 1.8);
    }
}

TEST_CASE("blue_red is as light on both sides, which nobody takes for each other") {
  const Scale scale = scale_of(Colormap::blue_red);
  for (const Sight& sight : k_sights) {
    CAPTURE(sight.name);
    CHECK(lightens(scale, sight, 0, 0.5f));
    CHECK(lightens(scale, sight, 1, 0.5f));
    // Red is dark without the cones for long waves: up to 14 of 100 between the ends there.
    const double bound = sight.name == std::string("protanopia") ? 14 : 4;
    for (int i = 0; i <= 64; ++i) {
      const float t = float(i) / 128.0f;
      const Lab blue = lab_of(scale(t), sight), red = lab_of(scale(1 - t), sight);
      CHECK(std::abs(blue.l - red.l) < bound);
      if (i == 64) continue; // the middle
      CHECK(blue.b < 0.5);
      CHECK(red.b > -0.5);
    }
    CHECK(sides_apart(scale, sight) > 70);
    const Steps color = steps_of(walk(scale, sight, 16), distance);
    CHECK(color.least > 0.8);
    CHECK(color.most < 1.3);
  }
}

TEST_CASE("these tests tell rainbows, uneven and red-green scales from good ones") {
  const Scale rainbow = [](float t) {
    const auto ramp = [&](float center) {
      return std::clamp(1.5f - std::fabs(4 * t - center), 0.0f, 1.0f);
    };
    return Vec3f(ramp(3), ramp(2), ramp(1));
  };
  const Scale green_red = [](float t) {
    return t < 0.5f ? Vec3f(2 * t, 0.6f + 0.8f * t, 2 * t) : Vec3f(1, 2 - 2 * t, 2 - 2 * t);
  };
  CHECK_FALSE(lightens(rainbow, k_sights[0], 0, 1));
  const Scale uneven = [](float t) { return map_color(Colormap::viridis, t * t); };
  CHECK(steps_of(walk(uneven, k_sights[0], 16), distance).least < 0.4);
  CHECK(sides_apart(green_red, k_sights[0]) > 70);
  CHECK(sides_apart(green_red, k_sights[2]) < 70);
}
