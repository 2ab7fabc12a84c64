// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Photometric types A, B and C are the same light in other angles; what is put right in a file;
// what is written is read again. The directions of the angles are made here by turning the aim
// about the axes that LM-63-2002, section 3, and CIE 121 name.

#include "ies_samples.h"
#include "openltc/light/photometry/photometry.h"
#include "openltc/light/units/units.h"
#include "openltc/target/shade_f32.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <random>
#include <sys/stat.h>
#include <tuple>

namespace {

using namespace openltc;
using namespace openltc::light;
using openltc::testing::angles;
using openltc::testing::ies_samples;
using openltc::testing::IesFile;
using openltc::testing::ldt_samples;

constexpr double k_degree = std::numbers::pi / 180;

// About an axis of the light's frame, x y z: the aim is z, and the frame is left-handed, as seen
// from above a luminaire.
Vec3d turned(Vec3d d, int from, int to, double degrees) {
  double v[3] = {d.x, d.y, d.z};
  const double c = std::cos(degrees * k_degree), s = std::sin(degrees * k_degree);
  const double a = v[from], b = v[to];
  v[from] = c * a - s * b;
  v[to] = s * a + c * b;
  return {v[0], v[1], v[2]};
}

// C: away from the nadir towards x, then around the nadir from x to y.
Vec3d towards_c(double v, double h) { return turned(turned({0, 0, 1}, 2, 0, v), 0, 1, h); }
// B: sideways, clockwise, from the aim towards -y, then up about the horizontal axis y.
Vec3d towards_b(double v, double h) { return turned(turned({0, 0, 1}, 2, 1, -h), 2, 0, v); }
// A: up towards x, then sideways, clockwise, about the upright axis x.
Vec3d towards_a(double v, double h) { return turned(turned({0, 0, 1}, 2, 0, v), 2, 1, -h); }

std::vector<Vec3d> directions(int count) {
  std::mt19937 random(63);
  std::normal_distribution<double> normal;
  std::vector<Vec3d> list;
  for (int i = 0; i < count; ++i)
    list.push_back(normalize(Vec3d(normal(random), normal(random), normal(random))));
  return list;
}

IesProfile parsed(const std::string& text, const std::string& name = "lamp.ies") {
  Result<IesProfile> profile = parse_photometry(text, name);
  INFO((profile.ok() ? std::string() : profile.error().message));
  REQUIRE(profile.ok());
  return *profile;
}

// A lobe of 800 cd about an axis that lies in no plane of symmetry; none behind.
double lobe(Vec3d d) {
  const double c = dot(d, normalize(Vec3d(0.35, -0.2, 0.8)));
  return c > 0 && d.z > 0 ? 800 * c * c * c * c * d.z * d.z : 0;
}

struct System {
  const char* kind;
  Vec3d (*towards)(double v, double h);
  std::vector<double> vertical, horizontal;
};

std::vector<System> systems(double step) {
  return {{"1 2 0 0 0", towards_c, angles(0, 90, step), angles(0, 360, step)},
          {"2 2 0 0 0", towards_b, angles(-90, 90, step), angles(-90, 90, step)},
          {"3 2 0 0 0", towards_a, angles(-90, 90, step), angles(-90, 90, step)}};
}

TEST_CASE("a_lobe_has_the_same_candela_in_every_direction_whatever_its_photometric_type") {
  for (const System& system : systems(2.5)) {
    CAPTURE(system.kind);
    IesFile file;
    file.kind = system.kind;
    file.vertical = system.vertical;
    file.horizontal = system.horizontal;
    const IesProfile profile =
        parsed(file.text([&](double v, double h) { return lobe(system.towards(v, h)); }));
    // As it was written, up to the file's digits, where it was measured.
    for (std::size_t i = 0; i < file.vertical.size(); i += 3)
      for (std::size_t j = 0; j < file.horizontal.size(); j += 3) {
        const Vec3d d = system.towards(file.vertical[i], file.horizontal[j]);
        if (d.z > 1e-9) CHECK(std::abs(eval_candela(profile, d) - lobe(d)) < 2e-6);
      }
    // Between, as linear interpolation errs: step^2 / 8 times the curvature, some 5 per radian^2.
    const ProfileAxes axes = profile_axes(profile.type, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    double worst = 0, worst_shaded = 0;
    for (const Vec3d d : directions(20000)) {
      const double candela = eval_candela(profile, d);
      worst = std::max(worst, std::abs(candela - lobe(d)));
      // Within a step of the grid the measurement's end is a ramp.
      if (std::abs(d.z) < std::sin(1.1 * k_degree)) continue;
      const Vec3f f = to_float(d);
      const Vec3f own(dot(axes.x, f), dot(axes.y, f), dot(axes.z, f));
      const double shaded = double(f32::eval_profile(profile.view(), own)) * profile.max_candela;
      worst_shaded = std::max(worst_shaded, std::abs(shaded - candela));
    }
    CHECK(worst < 800 * 2 * 5 * 2.5 * 2.5 * k_degree * k_degree / 8);
    CHECK(worst_shaded < 800 * 3e-6);
    // Its flux, by quadrature over the half sphere that has light.
    double flux = 0;
    const int n = 400;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double z = (i + 0.5) / n, a = 2 * std::numbers::pi * (j + 0.5) / n;
        flux += lobe({std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z});
      }
    CHECK(profile.flux_lumens ==
          doctest::Approx(flux * 2 * std::numbers::pi / n / n).epsilon(2e-3));
  }
}

TEST_CASE("angles_and_directions_are_each_other's_inverse") {
  for (const System& system : systems(7.5)) {
    const PhotometricType type = PhotometricType(system.kind[0] - '0');
    for (const double v : system.vertical)
      for (const double h : system.horizontal) {
        const Vec3d d = direction_of(type, {v, h});
        CHECK(length(d - system.towards(v, h)) < 1e-12);
        const PhotometricAngles back = angles_of(type, d * 2.0);
        CHECK(length(direction_of(type, back) - d) < 1e-12);
      }
  }
}

TEST_CASE("types_a_and_b_that_begin_at_0_are_mirrored_and_dark_beyond_their_angles") {
  // 100 cd over a window: of type A 60 degrees wide and 40 high, an area of
  // H (sin V2 - sin V1); of type B the other way around.
  IesFile file;
  file.kind = "3 2 0 0 0";
  file.vertical = angles(-20, 20, 10);
  file.horizontal = angles(0, 30, 10);
  const auto even = [](double, double) { return 100; };
  const IesProfile a = parsed(file.text(even));
  CHECK(a.flux_lumens ==
        doctest::Approx(100 * (60 * k_degree) * 2 * std::sin(20 * k_degree)).epsilon(1e-9));
  file.kind = "2 2 0 0 0";
  const IesProfile b = parsed(file.text(even));
  CHECK(b.flux_lumens ==
        doctest::Approx(100 * (40 * k_degree) * 2 * std::sin(30 * k_degree)).epsilon(1e-9));
  for (const double h : {-29.0, -11.0, 0.0, 29.0})
    for (const double v : {-19.0, 3.0, 19.0}) {
      CHECK(eval_candela(a, towards_a(v, h)) == doctest::Approx(100));
      CHECK(eval_candela(b, towards_b(v, h)) == doctest::Approx(100));
    }
  for (const auto& [v, h] : {std::pair{21.0, 0.0}, {-21.0, 0.0}, {0.0, 31.0}, {0.0, -31.0}}) {
    CHECK(eval_candela(a, towards_a(v, h)) == 0);
    CHECK(eval_candela(b, towards_b(v, h)) == 0);
  }
  for (const IesProfile* profile : {&a, &b})
    CHECK(eval_candela(*profile, Vec3d(0, 0, -1)) == 0);
  // A whole turn about the axis of A, and about that of B.
  file.kind = "3 2 0 0 0";
  file.vertical = angles(-90, 90, 30);
  file.horizontal = angles(-180, 180, 30);
  CHECK(parsed(file.text(even)).flux_lumens == doctest::Approx(400 * std::numbers::pi));
  file.kind = "2 2 0 0 0";
  std::swap(file.vertical, file.horizontal);
  CHECK(parsed(file.text(even)).flux_lumens == doctest::Approx(400 * std::numbers::pi));
}

TEST_CASE("a_cone_around_a_floodlight_takes_what_lies_within") {
  IesFile file;
  file.kind = "2 2 0 0 0";
  file.vertical = file.horizontal = angles(-90, 90, 10);
  PunctualLight light;
  light.profile = std::make_shared<IesProfile>(parsed(file.text([](double, double) { return 1; })));
  light.type = PunctualType::spot;
  light.cos_inner = 0.5001f;
  light.cos_outer = 0.5f;
  CHECK(flux_per_intensity(light) == doctest::Approx(std::numbers::pi).epsilon(1e-3));
}

// 1000 cd straight down, 2216.7 lm; the file of a user.
std::string lamp_with(const std::string& last, const std::string& behind) {
  return "IESNA:LM-63-2002\n[TEST] made\n[MANUFAC] nobody\nTILT=NONE\n"
         "1 1000 1 5 1 1 2 0 0 0\n1 1 10\n0 22.5 45 67.5 90\n0\n1000 800 500 200 " +
         last + "\n" + behind;
}

TEST_CASE("noise_below_zero_and_text_behind_the_data_are_warnings") {
  const IesProfile good = parsed(lamp_with("0", ""));
  CHECK(good.warnings.empty());
  for (const auto& [last, behind, words] :
       {std::tuple{"-0.05", "", "below 0"},
        {"0", "[OTHER] added by tool\n", "lamp.ies:10: the text after"},
        {"0", "END OF FILE\n", "END OF FILE"}}) {
    const IesProfile same = parsed(lamp_with(last, behind));
    CHECK(same.candela == good.candela);
    CHECK(same.flux_lumens == good.flux_lumens);
    REQUIRE(same.warnings.size() == 1);
    CHECK(same.warnings[0].rfind("lamp.ies:", 0) == 0);
    CHECK(same.warnings[0].find(words) != std::string::npos);
    CHECK(same.warnings[0].find('\n') == std::string::npos);
  }
  // A hundredth of the maximum is the end of noise; numbers left over are wrong counts.
  CHECK(parse_ies(lamp_with("-10", ""), "lamp.ies").ok());
  CHECK(!parse_ies(lamp_with("-11", ""), "lamp.ies").ok());
  CHECK(!parse_ies(lamp_with("0", "7 END\n"), "lamp.ies").ok());
}

TEST_CASE("what_is_written_as_lm_63_is_read_as_the_same_light") {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& text : ies_samples())
    files.push_back({text, "lamp.ies"});
  for (const std::string& text : ldt_samples())
    files.push_back({text, "lamp.ldt"});
  for (const System& system : systems(15)) {
    IesFile file;
    file.kind = system.kind;
    file.vertical = system.vertical;
    file.horizontal = system.horizontal;
    files.push_back(
        {file.text([&](double v, double h) { return lobe(system.towards(v, h)); }), "lamp.ies"});
  }
  for (const auto& [text, name] : files) {
    const IesProfile before = parsed(text, name);
    CAPTURE(before.version);
    const std::string written = to_lm63(before);
    const IesProfile after = parsed(written);
    CHECK(after.type == before.type);
    CHECK(after.warnings.empty());
    CHECK(after.name == before.name);
    CHECK(after.lamp_lumens == doctest::Approx(before.lamp_lumens));
    CHECK(after.input_watts == doctest::Approx(before.input_watts));
    for (int i = 0; i < 3; ++i)
      CHECK(after.size_metres[i] == doctest::Approx(before.size_metres[i]));
    CHECK(after.flux_lumens == doctest::Approx(before.flux_lumens).epsilon(1e-9));
    for (const Vec3d d : directions(500))
      CHECK(eval_candela(after, d) ==
            doctest::Approx(eval_candela(before, d)).epsilon(1e-8).scale(1e-6));
    for (std::size_t at = 0, end; (end = written.find("\r\n", at)) != std::string::npos;
         at = end + 2)
      CHECK(end - at <= 254);
  }
  // As much as the symmetry needs: one half plane, a quarter, a half.
  const auto horizontal_count = [](const IesFile& file, double (*candela)(double, double)) {
    const std::string written = to_lm63(parsed(file.text(candela)));
    const Result<IesProfile> again = parse_ies(written, "lamp.ies");
    int lamps, lumens, multiplier, vertical, horizontal;
    REQUIRE(std::sscanf(written.c_str() + written.find("TILT=NONE") + 10, "%d %d %d %d %d", &lamps,
                        &lumens, &multiplier, &vertical, &horizontal) == 5);
    return horizontal;
  };
  IesFile file;
  file.vertical = angles(0, 90, 30);
  file.horizontal = angles(0, 360, 30);
  CHECK(horizontal_count(file, [](double v, double) { return 100 - v; }) == 1);
  CHECK(horizontal_count(file, [](double v, double h) {
          return 300 - v + 50 * std::cos(2 * h * k_degree);
        }) == 4);
  CHECK(horizontal_count(file, [](double v, double h) {
          return 300 - v + 50 * std::cos(h * k_degree) * v / 90;
        }) == 7);
  CHECK(horizontal_count(file,
                         [](double v, double h) { return h < 360 ? 100 + v + h : 100 + v; }) == 13);
}

TEST_CASE("only_regular_files_are_read") {
  std::string folder = (std::filesystem::temp_directory_path() / "openltc_XXXXXX").string();
  REQUIRE(mkdtemp(folder.data()) != nullptr);
  const std::string pipe = folder + "/lamp.ies";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::string& path : {pipe, std::string("/dev/zero"), folder, folder + "/none.ldt"}) {
    const auto profile = read_photometry(path);
    REQUIRE(!profile.ok());
    CHECK(profile.error().message.rfind(path + ": ", 0) == 0);
  }
  std::filesystem::remove_all(folder);
}

} // namespace
