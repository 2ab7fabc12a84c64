// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: Matusik, Pfister, Brand, McMillan 2003, "A Data-Driven Reflectance Model", and the
// database's description of its files; Rusinkiewicz 1998, "A New Change of Variables for Efficient
// BRDF Representation", for the angles.
//
// A file is three little-endian int32, the counts along theta_h, theta_d and phi_d (90, 90, 180 in
// the database), then three planes of doubles, red, green, blue, to be multiplied by 1/1500,
// 1.15/1500 and 1.66/1500; phi_d runs fastest. theta_h is the half vector's angle to the normal,
// (theta_d, phi_d) is wi in the frame of the half vector. Bin i of n stands for the angles
//   theta_h = pi/2 ((i + 1/2)/n)^2,  theta_d = pi/2 (i + 1/2)/n,  phi_d = pi (i + 1/2)/n:
// the database's own look-up takes the bin an angle falls into, so a sample belongs to the middle.
//
// Between the bins the value is trilinear in those indices: the bins' steps would be noise to a
// quadrature of a few hundred points. phi_d is periodic by pi, which is reciprocity. An isotropic
// surface without handedness is symmetric under phi_d -> pi - phi_d, and the fitter relies on it;
// measurements are so only nearly, and the mean of the two is taken.
//
// Missing samples. The database marks them by negative numbers. A sample is missing when all three
// channels are negative, or when it is for a direction below the horizon and has no light; a single
// negative channel is measuring noise and counts as 0. Missing samples take the value of the
// nearest present one along theta_d, else along phi_d, else along theta_h.

#include "openltc/brdf/merl.h"

#include "openltc/base/regular_file.h"
#include "openltc/target/shade_f64.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

namespace openltc::brdf {

namespace {

constexpr std::size_t k_header_bytes = 12;
constexpr std::int64_t k_max_dimension = 4096, k_max_directions = 1 << 24;
constexpr double k_max_value = 1e9; // 1/steradian, far above any measured highlight
constexpr double k_missing = -1;

// A channel's scale and its share in luminance.
struct Channel {
  const char* name;
  double scale, share;
};
constexpr Channel k_channels[3] = {
    {"red", 1.0 / 1500, 0.2126}, {"green", 1.15 / 1500, 0.7152}, {"blue", 1.66 / 1500, 0.0722}};

// Axes: 0 theta_h, 1 theta_d, 2 phi_d, the last fastest.
struct Material {
  std::array<int, 3> count{};
  std::vector<double> value;

  std::size_t index(int h, int d, int p) const {
    return (std::size_t(h) * std::size_t(count[1]) + std::size_t(d)) * std::size_t(count[2]) +
           std::size_t(p);
  }
};

std::uint64_t little_endian(const std::uint8_t* bytes, int n) {
  std::uint64_t value = 0;
  for (int i = n - 1; i >= 0; --i)
    value = value << 8 | bytes[i];
  return value;
}

// Whether wi or wo of a bin lies below the horizon; the half vector's frame is turned by theta_h.
bool below_horizon(const Material& m, int h, int d, int p) {
  const double share = (h + 0.5) / m.count[0];
  const double theta_h = 0.5 * f64::k_pi * share * share;
  const double theta_d = 0.5 * f64::k_pi * (d + 0.5) / m.count[1];
  const double phi_d = f64::k_pi * (p + 0.5) / m.count[2];
  return std::cos(theta_h) * std::cos(theta_d) <=
         std::abs(std::sin(theta_h) * std::sin(theta_d) * std::cos(phi_d));
}

// Gives the missing samples of every line along one axis the value of the line's nearest present.
void fill_along(Material& m, int axis) {
  const int n = m.count[std::size_t(axis)];
  std::size_t stride = 1;
  for (int k = axis + 1; k < 3; ++k)
    stride *= std::size_t(m.count[std::size_t(k)]);
  std::vector<int> present;
  for (std::size_t start = 0; start < m.value.size(); ++start) {
    if (start / stride % std::size_t(n) != 0) continue;
    const auto at = [&](int i) -> double& { return m.value[start + std::size_t(i) * stride]; };
    present.clear();
    for (int i = 0; i < n; ++i)
      if (at(i) >= 0) present.push_back(i);
    if (present.empty() || int(present.size()) == n) continue;
    std::size_t next = 0; // of the present ones, the first that is not before i
    for (int i = 0; i < n; ++i) {
      while (next < present.size() && present[next] < i)
        ++next;
      if (next < present.size() && present[next] == i) continue;
      const bool after =
          next == 0 || (next < present.size() && present[next] - i < i - present[next - 1]);
      at(i) = at(present[after ? next : next - 1]);
    }
  }
}

void make_symmetric(Material& m) {
  const std::size_t n = std::size_t(m.count[2]);
  for (std::size_t line = 0; line < m.value.size(); line += n)
    for (std::size_t p = 0; p < n / 2; ++p) {
      double &a = m.value[line + p], &b = m.value[line + n - 1 - p];
      a = b = 0.5 * (a + b);
    }
}

// The two bins around an index and the weight of the second.
struct Between {
  int first, second;
  double weight;
};

Between between(double share, int count) {
  const double at = std::clamp(share * count - 0.5, 0.0, double(count - 1));
  const int first = std::min(int(at), count - 1);
  return {first, std::min(first + 1, count - 1), at - first};
}

Between between_periodic(double share, int count) {
  const double at = share * count - 0.5, below = std::floor(at);
  const int first = (int(below) % count + count) % count;
  return {first, (first + 1) % count, at - below};
}

double look_up(const Material& m, Vec3d wo, Vec3d wi) {
  const Vec3d sum = wo + wi, apart = wi - wo;
  const Vec3d h = normalize(sum);
  const double theta_h = std::atan2(std::hypot(h.x, h.y), h.z);
  const double theta_d = std::atan2(length(apart), length(sum));
  const double phi_h = std::atan2(h.y, h.x);
  const double cos_phi = std::cos(phi_h), sin_phi = std::sin(phi_h);
  const Vec3d x_half(h.z * cos_phi, h.z * sin_phi, -std::hypot(h.x, h.y));
  const double phi_d = std::atan2(cos_phi * wi.y - sin_phi * wi.x, dot(wi, x_half));

  const Between axes[3] = {
      between(std::sqrt(2 * theta_h * f64::k_inv_pi), m.count[0]),
      between(2 * theta_d * f64::k_inv_pi, m.count[1]),
      between_periodic(phi_d * f64::k_inv_pi, m.count[2]),
  };
  double value = 0;
  for (int corner = 0; corner < 8; ++corner) {
    int at[3];
    double weight = 1;
    for (int k = 0; k < 3; ++k) {
      const bool second = corner >> k & 1;
      at[k] = second ? axes[k].second : axes[k].first;
      weight *= second ? axes[k].weight : 1 - axes[k].weight;
    }
    value += weight * m.value[m.index(at[0], at[1], at[2])];
  }
  return value;
}

Error failure(const std::string& name, const std::string& what) {
  return Error{name + ": " + what};
}

// The counts of the header, when the file is as long as they say.
Result<std::array<int, 3>> read_header(std::span<const std::uint8_t> bytes,
                                       const std::string& name) {
  if (bytes.size() < k_header_bytes)
    return failure(name, fmt::format("{} bytes are too few for the header of a MERL file, three "
                                     "int32; was it cut off?",
                                     bytes.size()));
  std::array<int, 3> counts{};
  std::int64_t directions = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = std::int32_t(std::uint32_t(little_endian(bytes.data() + 4 * k, 4)));
    static const char* const k_axis[3] = {"theta_h", "theta_d", "phi_d"};
    if (n < 1 || n > k_max_dimension)
      return failure(name, fmt::format("its count along {} is {}, not one of 1..{}; is it a MERL "
                                       "file?",
                                       k_axis[k], n, k_max_dimension));
    counts[k] = n;
    directions *= n;
  }
  if (directions > k_max_directions)
    return failure(name, fmt::format("{} x {} x {} samples are more than the {} that are read",
                                     counts[0], counts[1], counts[2], k_max_directions));
  const std::size_t count = std::size_t(directions);
  const std::size_t expected = k_header_bytes + 24 * count;
  if (bytes.size() != expected)
    return failure(
        name,
        fmt::format("has {} bytes, but its header of {} x {} x {} samples asks for "
                    "{}; {}",
                    bytes.size(), counts[0], counts[1], counts[2], expected,
                    bytes.size() < expected ? "was it cut off?" : "what follows is not MERL's"));
  return counts;
}

// Luminances from the bytes of a file with the header m.count, k_missing where there is none.
Status read_samples(std::span<const std::uint8_t> bytes, const std::string& name, Material& m) {
  const std::uint8_t* data = bytes.data() + k_header_bytes;
  double largest = 0;
  const std::size_t count = (bytes.size() - k_header_bytes) / 24;
  m.value.resize(count);
  for (int h = 0; h < m.count[0]; ++h)
    for (int d = 0; d < m.count[1]; ++d)
      for (int p = 0; p < m.count[2]; ++p) {
        const std::size_t i = m.index(h, d, p);
        double luminance = 0;
        int negative = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t at = k * count + i;
          const double sample = std::bit_cast<double>(little_endian(data + 8 * at, 8));
          const double value = sample * k_channels[k].scale;
          if (!(value <= k_max_value && std::isfinite(value)))
            return failure(name, fmt::format("sample {} ({}) is {}; a BRDF is finite and below {}",
                                             at, k_channels[k].name, sample, k_max_value));
          negative += value < 0;
          luminance += k_channels[k].share * std::max(0.0, value);
        }
        const bool missing = negative == 3 || (luminance <= 0 && below_horizon(m, h, d, p));
        m.value[i] = missing ? k_missing : luminance;
        largest = std::max(largest, luminance);
      }
  if (!(largest > 0)) return failure(name, "no sample has any light; there is nothing to fit");
  return Success{};
}

} // namespace

Result<Brdf> parse_merl(std::span<const std::uint8_t> bytes, const std::string& name) {
  const Result<std::array<int, 3>> counts = read_header(bytes, name);
  if (!counts) return counts.error();
  auto material = std::make_shared<Material>();
  Material& m = *material;
  m.count = *counts;
  if (Status status = read_samples(bytes, name, m); !status) return status.error();
  for (const int axis : {1, 2, 0})
    fill_along(m, axis);
  make_symmetric(m);

  Brdf brdf;
  brdf.name = std::filesystem::path(name).stem().string();
  brdf.variant = "measured, Rec.709 luminance of the three channels, trilinear between samples";
  brdf.source = "MERL BRDF database: Matusik, Pfister, Brand, McMillan 2003, A Data-Driven "
                "Reflectance Model";
  brdf.width = LobeWidth::one;
  brdf.eval = [material = std::shared_ptr<const Material>(std::move(material))](Vec3d wo, Vec3d wi,
                                                                                double) {
    return BrdfValue{look_up(*material, wo, wi) * wi.z, 0};
  };
  return brdf;
}

Result<Brdf> read_merl(const std::string& path) {
  const Result<std::vector<std::uint8_t>> bytes =
      read_regular_file(path, k_header_bytes + 24 * std::uint64_t(k_max_directions));
  if (!bytes) return bytes.error();
  return parse_merl(*bytes, path);
}

} // namespace openltc::brdf
