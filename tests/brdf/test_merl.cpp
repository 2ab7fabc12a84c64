// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// MERL files: a material written from a known BRDF reads as that BRDF; what is wrong is refused.

#include "directions.h"
#include "merl_file.h"
#include "openltc/brdf/choose.h"
#include "openltc/brdf/merl.h"
#include "openltc/fit/quadrature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <unistd.h>

using namespace openltc;
using Counts = std::array<std::int32_t, 3>;

namespace {

// A folder that goes with the test.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("openltc_merl_" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code ec;
    std::filesystem::remove_all(path, ec);
  }
  std::string write(const char* name, const std::vector<std::uint8_t>& bytes) const {
    const std::string file = (path / name).string();
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    REQUIRE(out.good());
    return file;
  }
};

const Counts k_small = {4, 3, 6};

std::vector<double> constant_samples(double value) {
  return std::vector<double>(std::size_t(3 * 4 * 3 * 6), value);
}

brdf::Brdf read(const Counts& counts, const std::vector<double>& samples) {
  Result<brdf::Brdf> material = brdf::parse_merl(test::merl_bytes(counts, samples), "m.binary");
  REQUIRE_MESSAGE(material.ok(), (material.ok() ? "" : material.error().message));
  return *material;
}

// The message with which a file is refused, which must begin with its path.
std::string refusal(const Folder& folder, const std::vector<std::uint8_t>& bytes) {
  const std::string file = folder.write("bad.binary", bytes);
  const Result<brdf::Brdf> material = brdf::read_merl(file);
  if (material.ok()) return "accepted";
  const std::string& message = material.error().message;
  CHECK(message.rfind(file + ": ", 0) == 0);
  CHECK(message.find('\n') == std::string::npos);
  return message.substr(file.size() + 2);
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a material written from a known BRDF reads as that BRDF") {
  const Folder folder;
  const Counts counts = {90, 90, 180}; // those of the database
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const double roughness = 0.5;
  const std::string file = folder.write(
      "copy-of-ggx.binary", test::merl_bytes(counts, test::merl_samples(counts, ggx, roughness)));
  const Result<brdf::Brdf> material = brdf::choose_brdf(file);
  REQUIRE(material.ok());
  CHECK(material->name == "copy-of-ggx");
  CHECK_FALSE(material->has_parameter());
  CHECK(material->width == brdf::LobeWidth::one);
  CHECK_FALSE(material->variant.empty());
  CHECK_FALSE(material->source.empty());

  std::mt19937 bits(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d wo = test::direction(1.45 * uniform(bits), 0);
    const Vec3d wi = test::direction(1.45 * uniform(bits), 6.28 * uniform(bits));
    const double exact = ggx.eval(wo, wi, roughness).scale;
    worst = std::max(worst, std::abs(material->eval(wo, wi, 0).scale - exact) / exact);
    CHECK(material->eval(wo, wi, 0).bias == 0);
  }
  MESSAGE("largest relative error between the bins ", worst);
  CHECK(worst < 0.02);

  for (const double degrees : {0.0, 45.0, 75.0, 85.0}) {
    const double c = std::cos(test::radians(degrees));
    CHECK(fit::make_quadrature(*material, 0, c, {60, 60})->n1 ==
          doctest::Approx(fit::make_quadrature(ggx, roughness, c, {60, 60})->n1).epsilon(5e-3));
  }
}

TEST_CASE("in the middle of a bin the value is the sample") {
  // Different along each axis and symmetric under phi_d -> pi - phi_d.
  std::vector<double> samples;
  for (int channel = 0; channel < 3; ++channel)
    for (int h = 0; h < 4; ++h)
      for (int d = 0; d < 3; ++d)
        for (int p = 0; p < 6; ++p)
          samples.push_back(1500 * (1 + 100 * h + 10 * d + std::min(p, 5 - p)) /
                            (channel == 0   ? 1
                             : channel == 1 ? 1.15
                                            : 1.66));
  const brdf::Brdf material = read(k_small, samples);
  int compared = 0;
  for (int h = 0; h < 4; ++h)
    for (int d = 0; d < 3; ++d)
      for (int p = 0; p < 6; ++p) {
        const double share = (h + 0.5) / 4, theta_h = 0.5 * f64::k_pi * share * share;
        const Vec3d diff =
            test::direction(0.5 * f64::k_pi * (d + 0.5) / 3, f64::k_pi * (p + 0.5) / 6);
        const double c = std::cos(theta_h), s = std::sin(theta_h);
        const Vec3d wi(c * diff.x + s * diff.z, diff.y, -s * diff.x + c * diff.z);
        const Vec3d wo(-c * diff.x + s * diff.z, -diff.y, s * diff.x + c * diff.z);
        if (!(wi.z > 0 && wo.z > 0)) continue;
        const double expected = 1 + 100 * h + 10 * d + std::min(p, 5 - p);
        CHECK(material.eval(wo, wi, 0).scale / wi.z == doctest::Approx(expected).epsilon(1e-9));
        CHECK(material.eval(wi, wo, 0).scale / wo.z == doctest::Approx(expected).epsilon(1e-9));
        ++compared;
      }
  CHECK(compared > 40);
}

TEST_CASE("the value is the luminance of the channels") {
  const double factor[3] = {0.2126 / 1500, 0.7152 * 1.15 / 1500, 0.0722 * 1.66 / 1500};
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> samples = constant_samples(0);
    std::fill_n(samples.begin() + channel * 72, 72, 1000.0);
    const Vec3d n(0, 0, 1);
    CHECK(read(k_small, samples).eval(n, n, 0).scale == doctest::Approx(1000 * factor[channel]));
  }
}

TEST_CASE("a measured material is symmetric, reciprocal and smooth even if the file is noise") {
  std::mt19937 bits(9);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> samples = constant_samples(0);
  for (double& sample : samples)
    sample = 1500 * uniform(bits);
  const brdf::Brdf material = read(k_small, samples);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d wo = test::direction(1.5 * uniform(bits), 0);
    const Vec3d wi = test::direction(1.5 * uniform(bits), 6.28 * uniform(bits));
    const double f = material.eval(wo, wi, 0).scale / wi.z;
    CHECK(material.eval(wo, Vec3d(wi.x, -wi.y, wi.z), 0).scale / wi.z ==
          doctest::Approx(f).epsilon(1e-9));
    CHECK(material.eval(wi, wo, 0).scale / wo.z == doctest::Approx(f).epsilon(1e-9));
    // No steps: away from the poles of the parametrisation a small turn is a small change.
    if (length(wi - wo) < 0.1 || length(wi - test::mirrored(wo)) < 0.1) continue;
    const Vec3d near = normalize(wi + Vec3d(0, 1e-7, 0));
    CHECK(std::abs(material.eval(wo, near, 0).scale / near.z - f) < 1e-4);
  }
}

TEST_CASE("missing samples take the value of their neighbours") {
  std::vector<double> samples = constant_samples(1500);
  for (std::size_t i = 0; i < 72; ++i)
    if (i % 5 == 1 || i / 18 == 2 || i % 18 / 6 == 2) // scattered, a slab of theta_h, of theta_d
      for (std::size_t channel = 0; channel < 3; ++channel)
        samples[channel * 72 + i] = -1;
  const brdf::Brdf holes = read(k_small, samples);
  const brdf::Brdf whole = read(k_small, constant_samples(1500));
  for (const double a : test::view_angles())
    for (const double b : test::view_angles())
      for (const double phi : {0.0, 1.0, 2.0, 3.0}) {
        const Vec3d wo = test::direction(test::radians(a), 0);
        const Vec3d wi = test::direction(test::radians(b), phi);
        CHECK(holes.eval(wo, wi, 0).scale ==
              doctest::Approx(whole.eval(wo, wi, 0).scale).epsilon(1e-12));
      }
}

TEST_CASE("one negative channel is noise, not a hole") {
  std::vector<double> samples = constant_samples(1500);
  std::fill_n(samples.begin(), 72, -0.5); // red
  const Vec3d n(0, 0, 1);
  CHECK(read(k_small, samples).eval(n, n, 0).scale ==
        doctest::Approx(0.7152 * 1.15 + 0.0722 * 1.66));
}

TEST_CASE("measured materials are finite at every angle") {
  for (const Counts& counts : {Counts{1, 1, 1}, Counts{2, 1, 3}, k_small}) {
    const std::size_t n = std::size_t(counts[0]) * std::size_t(counts[1]) * std::size_t(counts[2]);
    const brdf::Brdf material = read(counts, std::vector<double>(3 * n, 1.0));
    for (const double a : test::view_angles()) {
      const Vec3d wo = test::direction(test::radians(a), 0);
      for (const Vec3d wi : {wo, test::mirrored(wo), Vec3d(0, 0, 1), test::direction(1.57, 2)}) {
        const double value = material.eval(wo, wi, 0).scale;
        CHECK((std::isfinite(value) && value >= 0));
      }
    }
  }
}

TEST_CASE("files that cannot be read are refused") {
  const Folder folder;
  for (const std::string& path : {(folder.path / "absent.binary").string(), folder.path.string()}) {
    const Result<brdf::Brdf> material = brdf::read_merl(path);
    REQUIRE_FALSE(material.ok());
    CHECK(material.error().message.rfind(path + ": ", 0) == 0);
  }
}

TEST_CASE("wrong sizes are refused") {
  const Folder folder;
  const std::vector<std::uint8_t> good = test::merl_bytes(k_small, constant_samples(1));
  CHECK(refusal(folder, good) == "accepted");
  const auto cut = [&](std::size_t n) {
    return std::vector<std::uint8_t>(good.begin(), good.begin() + std::ptrdiff_t(n));
  };
  CHECK(has(refusal(folder, {}), "cut off"));
  CHECK(has(refusal(folder, cut(11)), "cut off"));
  CHECK(has(refusal(folder, cut(12)), "cut off"));
  CHECK(has(refusal(folder, cut(good.size() - 1)), "cut off"));
  std::vector<std::uint8_t> longer = good;
  longer.push_back(0);
  CHECK(has(refusal(folder, longer), "not MERL's"));
}

TEST_CASE("impossible dimensions are refused") {
  const Folder folder;
  const auto with = [&](const Counts& counts) {
    return refusal(folder, test::merl_bytes(counts, constant_samples(1)));
  };
  CHECK(has(with({0, 3, 6}), "theta_h is 0"));
  CHECK(has(with({4, -3, 6}), "theta_d is -3"));
  CHECK(has(with({4, 3, 5000}), "phi_d is 5000"));
  CHECK(has(with({4096, 4096, 4096}), "more than"));
  CHECK(has(with({std::numeric_limits<std::int32_t>::max(), 3, 6}), "theta_h"));
  CHECK(has(with({std::numeric_limits<std::int32_t>::min(), 3, 6}), "theta_h"));
}

TEST_CASE("samples that are no BRDF are refused") {
  const Folder folder;
  const auto with = [&](std::size_t at, double value) {
    std::vector<double> samples = constant_samples(1);
    samples[at] = value;
    return refusal(folder, test::merl_bytes(k_small, samples));
  };
  CHECK(has(with(5, std::nan("")), "sample 5 (red)"));
  CHECK(has(with(72 + 5, std::numeric_limits<double>::infinity()), "sample 77 (green)"));
  CHECK(has(with(215, -std::numeric_limits<double>::infinity()), "sample 215 (blue)"));
  CHECK(has(with(0, 1e300), "sample 0 (red)"));
  for (const double value : {0.0, -1.0})
    CHECK(
        has(refusal(folder, test::merl_bytes(k_small, constant_samples(value))), "nothing to fit"));
}
