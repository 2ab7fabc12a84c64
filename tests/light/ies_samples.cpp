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
  // Types B and A: a whole half sphere by its right side, and a window.
  file.version = "IESNA:LM-63-2002 type B";
  file.kind = "2 2 0.2 0.3 0";
  file.vertical = angles(-90, 90, 15);
  file.horizontal = angles(0, 90, 15);
  samples.push_back(file.text(lobe));
  file.version = "IESNA:LM-63-2002 type A";
  file.kind = "3 2 0.2 0.3 0";
  file.vertical = angles(-20, 15, 2.5);
  file.horizontal = angles(-40, 50, 5);
  samples.push_back(file.text(lobe));
  return samples;
}

std::string LdtFile::text(const std::function<double(double, double)>& intensity) const {
  std::vector<std::string> lines = {"Nobody",
                                    "3",
                                    std::to_string(symmetry),
                                    std::to_string(planes),
                                    number(360.0 / planes),
                                    std::to_string(gamma.size()),
                                    "0",
                                    "report 1",
                                    "a lamp by a formula",
                                    "L-1",
                                    "lamp.ldt",
                                    "today"};
  for (const char* size : {"1200", "300", "80", "1100", "200", "10", "20", "30", "40"})
    lines.push_back(size);
  for (const std::string& value : {std::string("100"), std::string("85"), number(conversion),
                                   std::string("0"), std::to_string(lamps.size())})
    lines.push_back(value);
  const auto item = [&](std::size_t index, std::size_t set) -> std::string {
    switch (index) {
    case 0:
      return std::to_string(lamps[set].first);
    case 2:
      return number(lamps[set].second);
    case 5:
      return "12.5";
    default:
      return index == 1 ? "LED" : index == 3 ? "3000K" : "1B";
    }
  };
  for (std::size_t i = 0; i < 6 * lamps.size(); ++i)
    lines.push_back(set_by_set ? item(i % 6, i / 6) : item(i / lamps.size(), i % lamps.size()));
  for (int i = 0; i < 10; ++i)
    lines.push_back("0.5");
  for (int c = 0; c < planes; ++c)
    lines.push_back(number(360.0 * c / planes));
  for (const double g : gamma)
    lines.push_back(number(g));
  // The specification counts planes from 1.
  const int first = symmetry == 3 ? 3 * planes / 4 + 1 : 1;
  const int last = symmetry == 0   ? planes
                   : symmetry == 1 ? 1
                   : symmetry == 2 ? planes / 2 + 1
                   : symmetry == 3 ? first + planes / 2
                                   : planes / 4 + 1;
  for (int plane = first; plane <= last; ++plane)
    for (const double g : gamma)
      lines.push_back(number(intensity(g, 360.0 * ((plane - 1) % planes) / planes)));
  std::string out;
  for (const std::string& line : lines)
    out += line + line_end;
  return out;
}

std::vector<std::string> ldt_samples() {
  std::vector<std::string> samples;
  for (int symmetry = 0; symmetry <= 4; ++symmetry) {
    LdtFile file;
    file.symmetry = symmetry;
    file.planes = symmetry == 1 ? 1 : 8;
    file.gamma = angles(0, symmetry == 2 ? 180 : 90, 15);
    if (symmetry == 3) file.lamps = {{1, 1000}, {2, 1800}};
    file.set_by_set = symmetry < 3;
    if (symmetry == 4) file.line_end = "\r\n";
    samples.push_back(file.text([](double g, double c) { return 50 + g + c / 10; }));
  }
  return samples;
}

} // namespace openltc::testing
