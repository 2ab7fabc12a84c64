// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// EULUMDAT files: every symmetry against the formula that wrote it, lamps, and what is refused.

#include "ies_samples.h"
#include "openltc/light/photometry/ldt.h"
#include "openltc/light/photometry/photometry.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace {

using namespace openltc;
using namespace openltc::light;
using openltc::testing::angles;
using openltc::testing::ldt_samples;
using openltc::testing::LdtFile;

constexpr double k_degree = std::numbers::pi / 180;

IesProfile parsed(const std::string& text) {
  Result<IesProfile> profile = parse_ldt(text, "lamp.ldt");
  INFO((profile.ok() ? std::string() : profile.error().message));
  REQUIRE(profile.ok());
  return *profile;
}

TEST_CASE("every_symmetry_is_the_whole_circle_folded") {
  // Functions of the C angle with just that symmetry: of its sine and cosine, one, or their
  // squares.
  const std::function<double(double, double)> around[] = {
      [](double c, double s) { return 2 + c + 0.5 * s; },
      [](double, double) { return 2.0; },
      [](double c, double) { return 2 + c; },
      [](double, double s) { return 2 + s; },
      [](double c, double) { return 1 + c * c; },
  };
  for (int symmetry = 0; symmetry <= 4; ++symmetry)
    for (const int planes : {4, 24}) {
      CAPTURE(symmetry);
      CAPTURE(planes);
      const auto intensity = [&](double gamma, double c) {
        return (10 + gamma) * around[symmetry](std::cos(c * k_degree), std::sin(c * k_degree));
      };
      LdtFile file;
      file.symmetry = symmetry;
      file.planes = symmetry == 1 && planes == 4 ? 1 : planes;
      file.gamma = angles(0, 120, 10);
      file.lamps = {{2, 3000}};
      file.conversion = 0.5;
      const IesProfile profile = parsed(file.text(intensity));
      for (int plane = 0; plane < 24; ++plane)
        for (const double gamma : {0.0, 30.0, 120.0}) {
          // cd per 1000 lm, by 3000 lm and the factor; at the planes of the file.
          if (plane % (24 / planes) != 0) continue;
          CHECK(eval_candela(profile, gamma * k_degree, 15 * plane * k_degree) ==
                doctest::Approx(1.5 * intensity(gamma, 15 * plane)).epsilon(1e-6));
        }
      CHECK(eval_candela(profile, 121 * k_degree, 0) == 0);
      CHECK(profile.type == PhotometricType::c);
      CHECK(profile.lamp_lumens == 3000);
      CHECK(profile.lamp_count == 2);
    }
}

TEST_CASE("a_lamp_as_eulumdat_is_the_lamp_as_lm_63") {
  LdtFile file;
  file.symmetry = 1;
  file.planes = 1;
  file.gamma = angles(0, 90, 22.5);
  const double values[] = {1000, 800, 500, 200, 0};
  const auto table = [&](double gamma, double) { return values[std::size_t(gamma / 22.5 + 0.5)]; };
  const IesProfile ldt = parsed(file.text(table));
  const auto ies = parse_ies("TILT=NONE\n1 1000 1 5 1 1 2 0 0 0\n1 1 10\n0 22.5 45 67.5 90\n0\n"
                             "1000 800 500 200 0\n",
                             "lamp.ies");
  REQUIRE(ies.ok());
  CHECK(ldt.candela == ies->candela);
  CHECK(ldt.flux_lumens == ies->flux_lumens);
  CHECK(ldt.name == "a lamp by a formula");
  CHECK(ldt.downward_share == doctest::Approx(1));
  CHECK(ldt.output_ratio == doctest::Approx(0.85));
  CHECK(ldt.input_watts == doctest::Approx(12.5));
  // The luminaire's length lies along C90, where LM-63 has the width; heights: the highest side.
  CHECK(ldt.size_metres[0] == doctest::Approx(1.1));
  CHECK(ldt.size_metres[1] == doctest::Approx(0.2));
  CHECK(ldt.size_metres[2] == doctest::Approx(0.04));
  // The name decides the format.
  CHECK(parse_photometry(file.text(table), "lamp.LDT").ok());
  CHECK(!parse_photometry(file.text(table), "lamp.ies").ok());
}

TEST_CASE("the_first_set_of_lamps_counts_however_sets_are_written") {
  LdtFile file;
  file.symmetry = 1;
  file.planes = 1;
  file.gamma = {0, 90};
  const auto even = [](double, double) { return 100; };
  file.lamps = {{1, 2000}, {2, 5000}, {1, 900}};
  for (const bool set_by_set : {true, false}) {
    file.set_by_set = set_by_set;
    const IesProfile profile = parsed(file.text(even));
    CHECK(profile.max_candela == doctest::Approx(200));
    REQUIRE(profile.warnings.size() == 1);
    CHECK(profile.warnings[0].find("lamp.ldt: of its 3 sets of lamps the first") == 0);
  }
  file.lamps = {{1, 2000}, {1, 2000}};
  CHECK(parsed(file.text(even)).warnings.empty());
  // A negative count: absolute photometry of the whole luminaire.
  file.lamps = {{-1, 4000}};
  const IesProfile absolute = parsed(file.text(even));
  CHECK(absolute.max_candela == doctest::Approx(400));
  CHECK(absolute.lamp_lumens == 0);
}

TEST_CASE("ways_of_writing_eulumdat") {
  LdtFile file;
  file.symmetry = 4;
  file.planes = 8;
  file.gamma = angles(0, 90, 22.5);
  const auto candela = [](double gamma, double) { return 100 + gamma; };
  const std::string plain = file.text(candela);
  const IesProfile wanted = parsed(plain);
  file.line_end = " \r\n";
  std::string commas = plain;
  for (char& c : commas)
    if (c == '.') c = ',';
  for (const std::string& text : {file.text(candela), commas, plain + "\n\n\x1a",
                                  "\xef\xbb\xbf" + plain, plain.substr(0, plain.size() - 1)})
    CHECK(parsed(text).candela == wanted.candela);
  const IesProfile more = parsed(plain + "remarks: none\n");
  CHECK(more.candela == wanted.candela);
  REQUIRE(more.warnings.size() == 1);
  CHECK(more.warnings[0].find("\"remarks: none\"") != std::string::npos);
  CHECK(parsed(file.text([](double gamma, double) {
          return gamma < 80 ? 100 : -0.5;
        })).warnings.size() == 1);
}

TEST_CASE("broken_eulumdat_is_refused_by_name_line_and_reason") {
  LdtFile file;
  file.symmetry = 0;
  file.planes = 4;
  file.gamma = angles(0, 90, 45);
  const auto refused = [](const std::string& text, const std::string& words) {
    const auto profile = parse_ldt(text, "lamp.ldt");
    REQUIRE(!profile.ok());
    const std::string& message = profile.error().message;
    CAPTURE(message);
    CHECK(message.rfind("lamp.ldt:", 0) == 0);
    CHECK(message.find(words) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  };
  const auto even = [](double, double) { return 10; };
  const std::string good = file.text(even);
  const auto with_line = [&](int line, const std::string& content) {
    std::size_t at = 0;
    for (int i = 1; i < line; ++i)
      at = good.find('\n', at) + 1;
    return good.substr(0, at) + content + good.substr(good.find('\n', at));
  };
  REQUIRE(parse_ldt(good, "lamp.ldt").ok());
  refused("", "company");
  refused("\x89PNG\r\n\x1a\n", "cut off or no EULUMDAT");
  refused(with_line(3, "5"), "lamp.ldt:3: the symmetry Isym 5");
  refused(with_line(3, "x"), "\"x\" is not a number");
  refused(with_line(4, "0"), "count of C-planes 0");
  refused(with_line(4, "4000"), "too short");
  refused(with_line(6, "1"), "count of gamma angles 1");
  refused(with_line(24, "-1"), "lamp.ldt:24: the conversion factor -1");
  refused(with_line(26, "0"), "sets of lamps 0");
  refused(with_line(26, "99"), "sets of lamps");
  refused(with_line(29, "0"), "0 lumens");
  refused(with_line(45, "80"), "lamp.ldt:45: the C angle 80 follows 90");
  refused(good + "5\n", "left over");
  refused(file.text([](double g, double) { return g > 0 ? 10 : -5; }), "too far below 0");
  refused(file.text([](double, double) { return 0; }), "zero");
  file.symmetry = 3;
  file.planes = 6;
  refused(file.text(even), "Isym = 3");
  // Every truncation, but for that of the last number.
  for (const std::string& text : ldt_samples())
    for (std::size_t size = 0; size + 12 < text.size(); ++size)
      CHECK(!parse_ldt(text.substr(0, size), "lamp.ldt").ok());
}

TEST_CASE("damaged_eulumdat_never_crashes_and_only_usable_light_leaves") {
  std::mt19937 random(20260315);
  const std::vector<std::string> samples = ldt_samples();
  const std::string interesting = "0123456789.-+eE, \n\r\x1a";
  int read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = samples[random() % samples.size()];
    for (int k = 0; k < 1 + int(random() % 3); ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 8);
      else
        text[at] = interesting[random() % interesting.size()];
      if (text.empty()) text.assign(1, 'x');
    }
    const auto profile = parse_ldt(text, "lamp.ldt");
    if (!profile.ok()) {
      CHECK(profile.error().message.rfind("lamp.ldt:", 0) == 0);
      continue;
    }
    ++read;
    bool usable = std::isfinite(profile->flux_lumens) && profile->flux_lumens >= 0;
    for (const double value : profile->candela)
      usable = usable && value >= 0 && value <= profile->max_candela;
    CHECK(usable);
  }
  CHECK(read > 300);
}

} // namespace
