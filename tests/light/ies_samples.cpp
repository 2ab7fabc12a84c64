// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "ies_samples.h"

#include <cmath>
#include <cstdio>

namespace openltc::testing {

namespace {

std::string number(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.6f", value);
  return digits;
}

} // namespace

std::vector<double> angles(double from, double to, double step) {
  std::vector<double> result;
  for (int i = 0; from + i * step <= to + 1e-9; ++i)
    result.push_back(from + i * step);
  return result;
}

std::string IesFile::text(const std::function<double(double, double)>& candela) const {
  std::string out = version.empty() ? "" : version + "\n";
  out += keywords + tilt + lamps + " " + std::to_string(vertical.size()) + " " +
         std::to_string(horizontal.size()) + " " + kind + "\n" + ballast + "\n";
  for (const std::vector<double>* list : {&vertical, &horizontal}) {
    for (const double angle : *list)
      out += number(angle) + " ";
    out += "\n";
  }
  for (const double h : horizontal) {
    for (const double v : vertical)
      out += number(candela(v, h)) + " ";
    out += "\n";
  }
  return out;
}

std::vector<std::string> ies_samples() {
  const auto lobe = [](double v, double h) {
    return 10 +
           90 * std::abs(std::cos(v * 0.017453)) * (1 + 0.3 * std::cos(h * 3.14159265358979 / 180));
  };
  std::vector<std::string> samples;
  IesFile file;
  file.vertical = angles(0, 90, 10);
  file.horizontal = {0};
  samples.push_back(file.text(lobe));
  file.version = "";
  file.keywords = "A luminaire of 1986\nwith two lines of label\n";
  file.horizontal = angles(0, 90, 22.5);
  file.lamps = "2,1250,0.5";
  samples.push_back(file.text(lobe));
  file.version = "IESNA91";
  file.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.95 0.9\n";
  file.vertical = angles(90, 180, 15);
  file.horizontal = angles(0, 180, 45);
  file.kind = "1 1 -0.5 -0.5 0";
  samples.push_back(file.text(lobe));
  file.version = "IESNA:LM-63-1995";
  file.tilt = "TILT=NONE\n";
  file.horizontal = angles(90, 270, 30);
  file.vertical = angles(0, 180, 12);
  file.ballast = "0.95 1.05 20";
  samples.push_back(file.text(lobe));
  file.version = "IES:LM-63-2019";
  file.ballast = "1 1.00001 20";
  file.vertical = {0, 3.7, 11.1, 40, 79.3, 90};
  file.horizontal = angles(0, 360, 60);
  samples.push_back(file.text(lobe));
  return samples;
}

} // namespace openltc::testing
