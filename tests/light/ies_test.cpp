// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// LM-63 files: what they mean, that flux is the integral of the intensities, and what is refused.

#include "ies_samples.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/photometry/photometry.h"
#include "openltc/light/units/units.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace {

using namespace openltc;
using namespace openltc::light;
using openltc::testing::angles;
using openltc::testing::ies_samples;
using openltc::testing::IesFile;

constexpr double k_pi = std::numbers::pi;

IesProfile parsed(const std::string& text) {
  Result<IesProfile> profile = parse_ies(text, "lamp.ies");
  INFO((profile.ok() ? std::string() : profile.error().message));
  REQUIRE(profile.ok());
  return *profile;
}

double at(const IesProfile& profile, double vertical_degrees, double horizontal_degrees) {
  return eval_candela(profile, vertical_degrees * k_pi / 180, horizontal_degrees * k_pi / 180);
}

// Over rings of equal solid angle, without the closed form.
double summed_flux(const IesProfile& profile) {
  constexpr int rings = 4000, sectors = 360;
  double sum = 0;
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < sectors; ++i)
      sum += eval_candela(profile, std::acos(1 - 2 * (j + 0.5) / rings),
                          2 * k_pi * (i + 0.5) / sectors);
  return sum * 4 * k_pi / (rings * sectors);
}

TEST_CASE("the_file_written_by_hand_reads_as_it_stands") {
  const auto profile = read_photometry(OPENLTC_SOURCE_DIR "/tests/light/files/wall_washer.ies");
  REQUIRE(profile.ok());
  CHECK(profile->version == "IESNA:LM-63-2002");
  CHECK(profile->name == "Wall washer, one side brighter than the other");
  CHECK(profile->keywords.size() == 7);
  CHECK(profile->lamp_lumens == 0); // absolute
  CHECK(profile->input_watts == doctest::Approx(24.5));
  CHECK(profile->size_metres[1] == doctest::Approx(0.3));
  // Multiplier 2, ballast factor 0.9.
  CHECK(profile->max_candela == doctest::Approx(610 * 1.8));
  CHECK(at(*profile, 30, 0) == doctest::Approx(610 * 1.8));
  CHECK(at(*profile, 35, 0) == doctest::Approx(575 * 1.8));
  CHECK(at(*profile, 30, 22.5) == doctest::Approx(582.5 * 1.8));
  // Both halves alike, any number of turns, dark above.
  CHECK(at(*profile, 47, 300) == doctest::Approx(at(*profile, 47, 60)));
  CHECK(at(*profile, 47, -60) == doctest::Approx(at(*profile, 47, 60 + 720)));
  CHECK(at(*profile, 91, 0) == 0);
  CHECK(profile->flux_lumens == doctest::Approx(summed_flux(*profile)).epsilon(1e-4));
}

TEST_CASE("known_intensities_have_their_known_flux") {
  IesFile file;
  file.vertical = angles(0, 180, 10);
  file.horizontal = {0};
  const auto even = parsed(file.text([](double, double) { return 100; }));
  CHECK(even.flux_lumens == doctest::Approx(400 * k_pi));
  CHECK(even.grid_columns == 1);
  file.vertical = angles(0, 90, 0.5);
  file.horizontal = angles(0, 360, 15);
  const auto lambert =
      parsed(file.text([](double v, double) { return 100 * std::cos(v * k_pi / 180); }));
  CHECK(lambert.flux_lumens == doctest::Approx(100 * k_pi).epsilon(1e-4));
  // The mean of 1 + cos(h) over the circle is 1.
  const auto lopsided = parsed(file.text([](double v, double h) {
    return 100 * std::cos(v * k_pi / 180) * (1 + std::cos(h * k_pi / 180));
  }));
  CHECK(lopsided.flux_lumens == doctest::Approx(100 * k_pi).epsilon(1e-4));
}

TEST_CASE("flux_is_the_integral_of_the_intensities_for_every_kind_of_file") {
  for (const std::string& text : ies_samples()) {
    const IesProfile profile = parsed(text);
    CAPTURE(profile.version);
    CHECK(profile.flux_lumens == doctest::Approx(summed_flux(profile)).epsilon(1e-3));
    CHECK(*std::max_element(profile.candela.begin(), profile.candela.end()) == profile.max_candela);
    PunctualLight light;
    light.profile = std::make_shared<IesProfile>(profile);
    light.intensity = Vec3f(float(profile.max_candela));
    CHECK(double(flux_from_intensity(light, light.intensity)->x) ==
          doctest::Approx(profile.flux_lumens).epsilon(1e-5));
    // A cone as wide as everything takes nothing away.
    light.type = PunctualType::spot;
    light.cos_inner = -1;
    light.cos_outer = -1.001f;
    CHECK(double(flux_from_intensity(light, light.intensity)->x) ==
          doctest::Approx(profile.flux_lumens).epsilon(1e-3));
  }
}

TEST_CASE("symmetric_files_are_the_whole_circle_folded") {
  // Symmetric about both planes, so that all ways to write it agree.
  const auto candela = [](double v, double h) {
    const double c = std::cos(h * k_pi / 180);
    return (200 + v) * (1 + c * c);
  };
  IesFile file;
  file.vertical = angles(0, 180, 10);
  file.horizontal = angles(0, 360, 15);
  const IesProfile whole = parsed(file.text(candela));
  for (const auto& range : {std::pair{0.0, 90.0}, {0.0, 180.0}, {90.0, 270.0}, {0.0, 345.0}}) {
    CAPTURE(range.second);
    file.horizontal = angles(range.first, range.second, 15);
    const IesProfile folded = parsed(file.text(candela));
    CHECK(folded.flux_lumens == doctest::Approx(whole.flux_lumens));
    for (double h = 0; h < 360; h += 7)
      for (double v = 0; v <= 180; v += 13)
        CHECK(at(folded, v, h) == doctest::Approx(at(whole, v, h)).epsilon(1e-6));
  }
  // Halves that differ left and right: 90 to 270 degrees mirrors h to 180 - h.
  file.horizontal = {90, 120, 200, 270}; // without an angle of 180, so the seam is made
  const auto half = parsed(file.text([](double v, double h) { return 100 + v + h; }));
  for (double h = 90; h <= 270; h += 4)
    CHECK(at(half, 40, h) == doctest::Approx(at(half, 40, 180 - h)));
  CHECK(at(half, 40, 0) == doctest::Approx(100 + 40 + 180));
  CHECK(half.flux_lumens == doctest::Approx(summed_flux(half)).epsilon(1e-3));
}

TEST_CASE("versions_differ_in_the_factor_after_the_ballast_factor") {
  IesFile file;
  file.vertical = angles(0, 90, 45);
  file.horizontal = {0};
  file.lamps = "3 1000 2";
  file.ballast = "0.5 0.8 60";
  const auto maximum = [&](const char* version) {
    file.version = version;
    return parsed(file.text([](double, double) { return 100; })).max_candela;
  };
  for (const char* version : {"", "IESNA91", "IESNA:LM-63-1995"})
    CHECK(maximum(version) == doctest::Approx(80));
  for (const char* version : {"IESNA:LM-63-2002", "IES:LM-63-2019"})
    CHECK(maximum(version) == doctest::Approx(100));
  CHECK(parsed(file.text([](double, double) { return 1; })).lamp_lumens == 3000);
}

TEST_CASE("numbers_may_be_parted_by_commas_blanks_and_any_line_end") {
  IesFile file;
  file.vertical = angles(0, 90, 15);
  file.horizontal = angles(0, 90, 45);
  const std::string plain = file.text([](double v, double h) { return 10 + v + h; });
  const IesProfile wanted = parsed(plain);
  std::string commas = plain, dos, old_mac = plain;
  for (std::size_t i = plain.find("TILT") + 10; i < plain.size(); ++i)
    if (plain[i] == ' ') commas[i] = ',';
  for (const char c : plain) {
    if (c == '\n') dos += '\r';
    dos += c;
  }
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  for (const std::string& text : {commas, dos, old_mac, "\xef\xbb\xbf" + plain, plain + "\x1a\n"})
    CHECK(parsed(text).candela == wanted.candela);
}

// What shading interpolates on its grid against the file's own interpolation.
template <class Eval> double largest_difference(const IesProfile& profile, const Eval& eval) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d d = normalize(Vec3d(normal(random), normal(random), normal(random)));
    // Where the measurement ends, the grid has a ramp of one step; see below.
    const ProfileAxes axes = profile_axes(profile.type, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const Vec3d own(dot(to_double(axes.x), d), dot(to_double(axes.y), d),
                    dot(to_double(axes.z), d));
    const double vertical = std::atan2(std::hypot(own.x, own.y), own.z);
    const double azimuth = std::atan2(own.y, own.x) * 180 / k_pi;
    const double sides[] = {profile.azimuth_degrees.front(), profile.azimuth_degrees.back()};
    const bool is_circle = sides[1] - sides[0] == 0 || sides[1] - sides[0] >= 360;
    if (!is_circle && std::any_of(sides, sides + 2, [&](double side) {
          return std::abs(std::remainder(azimuth - side, 360)) < 1.001;
        }))
      continue;
    const double edges[] = {profile.polar_degrees.front(), profile.polar_degrees.back()};
    if (std::any_of(edges, edges + 2, [&](double edge) {
          return edge > 0 && edge < 180 && std::abs(vertical * 180 / k_pi - edge) < 1.001;
        }))
      continue;
    const double exact =
        eval_candela(profile, std::atan2(std::hypot(d.x, d.y), d.z), std::atan2(d.y, d.x));
    largest = std::max(largest, std::abs(eval(own) - exact / profile.max_candela));
  }
  return largest;
}

TEST_CASE("shading_interpolates_as_the_file_does") {
  for (const std::string& text : ies_samples()) {
    const IesProfile profile = parsed(text);
    CAPTURE(profile.version);
    const double exact =
        largest_difference(profile, [&](Vec3d d) { return f64::eval_profile(profile.view(), d); });
    const double single = largest_difference(profile, [&](Vec3d d) {
      return double(f32::eval_profile(profile.view(), to_float(d) * 3.0f));
    });
    MESSAGE(profile.version << ": grid " << profile.grid_columns << " x " << profile.grid_rows
                            << ", error of the maximum: double " << exact << ", float " << single);
    // The angles of the last sample fit no grid, so half a degree has to do.
    const bool irregular = profile.version == "IES:LM-63-2019";
    CHECK(exact < (irregular ? 1e-3 : 2e-6));
    CHECK(single < (irregular ? 1e-3 : 2e-6));
  }
}

TEST_CASE("shading_loses_no_precision_in_a_narrow_beam") {
  // A beam of one degree: the cosine of its angles has lost its digits in single precision.
  IesFile file;
  file.vertical = angles(0, 1, 0.25);
  file.vertical.push_back(90);
  file.horizontal = {0};
  const IesProfile profile =
      parsed(file.text([](double v, double) { return v < 1 ? 1e5 * (1 - v) : 0; }));
  for (double v = 0; v < 1; v += 0.003) {
    const float t = float(v * k_pi / 180);
    const float shaded = f32::eval_profile(profile.view(), Vec3f(0, -std::sin(t), std::cos(t)));
    CHECK(double(shaded) == doctest::Approx(1 - v).epsilon(1e-4));
  }
}

TEST_CASE("values_of_the_grid_are_shares_of_the_maximum") {
  for (const std::string& text : ies_samples()) {
    const IesProfile profile = parsed(text);
    REQUIRE(profile.grid.size() == std::size_t(profile.grid_columns * profile.grid_rows));
    for (const float value : profile.grid)
      CHECK((value >= 0.0f && value <= 1.0f));
    CHECK(*std::max_element(profile.grid.begin(), profile.grid.end()) > 0.99f);
    for (int j = 0; j < profile.grid_rows; ++j) {
      const float* row = profile.grid.data() + j * profile.grid_columns;
      CHECK(row[0] == row[profile.grid_columns - 1]);
    }
  }
}

void refused(const std::string& text, const std::string& words, const std::string& line = "") {
  const auto profile = parse_ies(text, "lamp.ies");
  CAPTURE(text);
  REQUIRE(!profile.ok());
  const std::string& message = profile.error().message;
  CAPTURE(message);
  CHECK(message.rfind("lamp.ies:" + line, 0) == 0);
  CHECK(message.find(words) != std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
}

TEST_CASE("broken_files_are_refused_by_name_line_and_reason") {
  const std::string head = "IESNA:LM-63-2002\n[TEST] x\n", none = head + "TILT=NONE\n";
  const std::string a_window = none + "1 -1 1 2 2 3 2 0 0 0\n1 1 10\n-9 9\n-9 9\n";
  REQUIRE(parse_ies(a_window + "5 6 5 6", "lamp.ies").ok());
  const std::string good = none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 6\n";
  REQUIRE(parse_ies(good, "lamp.ies").ok());
  refused("", "TILT");
  refused(head, "TILT");
  refused("\x89PNG\r\n\x1a\n", "TILT");
  refused(head + "TILT=lamp.tlt\n1", "TILT=LAMP.TLT", "3: ");
  refused(none, "file ends", "4: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 ten\n", "\"ten\"", "8: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 nan\n", "\"nan\"", "8: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 1e999\n", "not a number", "8: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 -6\n", "candela value -6", "8: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n90 0\n0\n5 6\n", "ascend", "6: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 190\n0\n5 6\n", "vertical angle 190", "6: ");
  refused(none + "1 -1 1 2 2 1 2 0 0 0\n1 1 10\n0 90\n0 0\n5 6\n5 6\n", "ascend", "7: ");
  refused(none + "1 -1 1 2 2 1 2 0 0 0\n1 1 10\n0 90\n0 45\n5 6\n5 6\n", "0 to 45");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n15\n5 6\n", "horizontal angles");
  refused(none + "1 -1 1 1 1 1 2 0 0 0\n1 1 10\n0\n0\n5\n", "too few");
  refused(good + "7", "left over", "9: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5", "file ends");
  refused(none + "1 -1 1 4000 4000 1 2 0 0 0\n1 1 10\n", "directions", "4: ");
  refused(none + "1 -1 1 1000 1000 1 2 0 0 0\n1 1 10\n0 90", "too short", "5: ");
  refused(none + "1 -1 1 5000 1 1 2 0 0 0\n", "count of vertical angles 5000", "4: ");
  refused(none + "1 -1 1 2.5 1 1 2 0 0 0\n", "not whole", "4: ");
  refused(none + "1 -1 1 2 1 4 2 0 0 0\n", "photometric type 4", "4: ");
  refused(none + "1 -1 1 2 1 2 2 0 0 0\n1 1 10\n0 90\n0\n5 6\n", "type B");
  refused(none + "1 -1 1 2 2 3 2 0 0 0\n1 1 10\n0 100\n0 90\n5 6 5 6\n", "angle 100", "6: ");
  refused(none + "1 -1 1 2 2 2 2 0 0 0\n1 1 10\n0 90\n0 100\n5 6 5 6\n", "angle 100", "7: ");
  refused(none + "1 -1 1 2 1 1 3 0 0 0\n", "units", "4: ");
  refused(none + "1 -7 1 2 1 1 2 0 0 0\n", "lumens", "4: ");
  refused(none + "1 -1 -1 2 1 1 2 0 0 0\n", "multiplier", "4: ");
  refused(none + "1 -1 1e9 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n5 1e6\n", "all factors", "8: ");
  refused(none + "1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n0 0\n", "zero");
  refused(head + "TILT=INCLUDE\n4\n", "geometry", "4: ");
  refused(head + "TILT=INCLUDE\n1\n99999\n", "tilt angles", "5: ");
  CHECK(!read_photometry("/nonexistent/lamp.ies").ok());
  CHECK(!read_photometry(OPENLTC_SOURCE_DIR "/tests").ok());
}

TEST_CASE("every_truncation_of_a_file_is_refused") {
  for (const std::string& text : ies_samples())
    for (std::size_t size = 0; size + 13 < text.size(); ++size) {
      // A shortened last number would still be a number; anything shorter misses one.
      const auto profile = parse_ies(text.substr(0, size), "lamp.ies");
      CHECK(!profile.ok());
    }
}

TEST_CASE("damaged_files_never_crash_and_only_usable_light_leaves") {
  std::mt19937 random(20260314);
  const std::vector<std::string> samples = ies_samples();
  const std::string interesting = "0123456789.-+eE, \n\r[]=\x1a\x00TILT";
  int read = 0;
  for (int i = 0; i < 6000; ++i) {
    std::string text = samples[random() % samples.size()];
    const int edits = 1 + int(random() % 4);
    for (int k = 0; k < edits; ++k) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
      case 0:
        text[at] = char(random() % 256);
        break;
      case 1:
        text[at] = interesting[random() % interesting.size()];
        break;
      case 2:
        text.erase(at, 1 + random() % 20);
        break;
      default:
        text.insert(at, text.substr(random() % text.size(), random() % 20));
        break;
      }
      if (text.empty()) text.assign(1, 'x');
    }
    const auto profile = parse_ies(text, "lamp.ies");
    if (!profile.ok()) {
      CHECK(profile.error().message.rfind("lamp.ies:", 0) == 0);
      continue;
    }
    ++read;
    bool usable = std::isfinite(profile->flux_lumens) && profile->flux_lumens >= 0 &&
                  std::isfinite(profile->max_candela) && profile->max_candela > 0;
    for (const double value : profile->candela)
      usable = usable && value >= 0 && value <= profile->max_candela;
    for (const float value : profile->grid)
      usable = usable && value >= 0.0f && value <= 1.0f;
    CHECK(usable);
  }
  CHECK(read > 500); // not all are refused at the door
}

} // namespace
