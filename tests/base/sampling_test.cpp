// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The sample sequence keeps what low discrepancy promises, whatever the seed.

#include "openltc/base/sampling.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace openltc;

namespace {

constexpr std::uint32_t k_seeds[] = {0, 1, 2, 77, 0x12345678u, 0xdeadbeefu, 0xffffffffu};

// The generator matrix of the second Sobol dimension, column by column: v1 = 1/2 and each next
// direction number is the last one, xor itself shifted right. Sobol 1967; Bratley and Fox 1988.
std::uint32_t sobol_by_direction_numbers(std::uint32_t index) {
  std::uint32_t direction = 0x80000000u, result = 0;
  for (; index != 0; index >>= 1, direction ^= direction >> 1)
    if (index & 1) result ^= direction;
  return result;
}

// Mean product of two coordinates about their mean, relative to their variance of 1/12.
double covariance(float a, float b, int count) {
  return (double(a) - 0.5) * (double(b) - 0.5) * 12 / count;
}

} // namespace

TEST_CASE("reverse_bits_is_its_own_inverse_and_moves_each_bit") {
  for (int bit = 0; bit < 32; ++bit)
    CHECK(reverse_bits(1u << bit) == 1u << (31 - bit));
  std::uint32_t x = 1;
  for (int i = 0; i < 1000; ++i, x = x * 1664525u + 1013904223u)
    REQUIRE(reverse_bits(reverse_bits(x)) == x);
}

TEST_CASE("the_second_sobol_dimension_is_that_of_the_direction_numbers") {
  for (std::uint32_t i = 0; i < 65536; ++i)
    REQUIRE(sobol_dimension_1(i) == sobol_by_direction_numbers(i));
  std::uint32_t x = 1;
  for (int i = 0; i < 100000; ++i, x = x * 1664525u + 1013904223u)
    REQUIRE(sobol_dimension_1(x) == sobol_by_direction_numbers(x));
}

TEST_CASE("a_scramble_maps_intervals_to_intervals") {
  // Owen's condition: two values that share their first k binary digits still share k digits, and
  // no more if they did not.
  for (const std::uint32_t seed : k_seeds) {
    std::uint32_t x = 12345;
    for (int i = 0; i < 1000; ++i, x = x * 1664525u + 1013904223u) {
      const std::uint32_t a = nested_uniform_scramble(x, seed);
      for (int digit = 0; digit < 32; ++digit) {
        const std::uint32_t bit = 0x80000000u >> digit;
        const std::uint32_t difference = a ^ nested_uniform_scramble(x ^ bit, seed);
        REQUIRE(difference >= bit);
        REQUIRE((difference >> 1) < bit);
      }
    }
  }
}

TEST_CASE("every_prefix_of_a_power_of_two_is_a_net") {
  // (0, 2)-net: among 2^k samples each box of 2^-a by 2^-(k-a) holds exactly one.
  for (const std::uint32_t seed : k_seeds)
    for (int k = 0; k <= 12; ++k) {
      const std::uint32_t count = 1u << k;
      for (int a = 0; a <= k; ++a) {
        std::vector<char> taken(count, 0);
        for (std::uint32_t i = 0; i < count; ++i) {
          const Sample2 s = owen_sobol(i, seed);
          const std::uint32_t column = std::uint32_t(std::ldexp(s.u, a));
          const std::uint32_t row = std::uint32_t(std::ldexp(s.v, k - a));
          char& box = taken[(column << (k - a)) | row];
          REQUIRE(box == 0);
          box = 1;
        }
      }
    }
}

TEST_CASE("samples_lie_in_the_unit_square_and_are_uniform") {
  for (const std::uint32_t seed : k_seeds) {
    double mean_u = 0, mean_uv = 0, mean_v2 = 0;
    const int count = 5000; // no power of two
    for (int i = 0; i < count; ++i) {
      const Sample2 s = owen_sobol(std::uint32_t(i), seed);
      REQUIRE(s.u >= 0);
      REQUIRE(s.u < 1);
      REQUIRE(s.v >= 0);
      REQUIRE(s.v < 1);
      mean_u += double(s.u) / count;
      mean_uv += double(s.u * s.v) / count;
      mean_v2 += double(s.v * s.v) / count;
    }
    // Plain random numbers would be off by .004, .003 and .004.
    CHECK(std::abs(mean_u - 0.5) < 1e-3);
    CHECK(std::abs(mean_uv - 0.25) < 1e-3);
    CHECK(std::abs(mean_v2 - 1.0 / 3) < 1e-3);
  }
}

TEST_CASE("the_first_sample_is_uniform_over_seeds") {
  // One sample per pixel: its mean over the picture must be right, in every box.
  const int count = 1 << 16, boxes = 16;
  std::vector<int> histogram(boxes * boxes, 0);
  for (int seed = 0; seed < count; ++seed) {
    const Sample2 s =
        owen_sobol(0, hash_combine(std::uint32_t(seed % 256), std::uint32_t(seed / 256)));
    ++histogram[std::size_t(int(s.u * boxes) * boxes + int(s.v * boxes))];
  }
  const double expected = double(count) / (boxes * boxes);
  double chi2 = 0;
  for (const int n : histogram)
    chi2 += (n - expected) * (n - expected) / expected;
  // 255 degrees of freedom: mean 255, standard deviation 22.6.
  CHECK(chi2 < 255 + 5 * 22.6);
}

TEST_CASE("mixed_seeds_give_uncorrelated_samples") {
  // Over many pairs of seeds, correlations are those of independent samples. Samples come in
  // stratified groups, so these scatter somewhat more than 1/sqrt(count).
  const int count = 1024, seeds = 40;
  double square_sum[3] = {0, 0, 0}, largest = 0;
  int pairs = 0;
  for (int p = 0; p < seeds; ++p)
    for (int q = 0; q < p; ++q, ++pairs) {
      // As a renderer makes them: neighbouring pixels, or two purposes in one pixel.
      const std::uint32_t a = hash_combine(hash_combine(std::uint32_t(p), 7), 1);
      const std::uint32_t b = hash_combine(hash_combine(std::uint32_t(q), 7), 1);
      double c[3] = {0, 0, 0};
      for (std::uint32_t i = 0; i < std::uint32_t(count); ++i) {
        const Sample2 s = owen_sobol(i, a), t = owen_sobol(i, b);
        c[0] += covariance(s.u, t.u, count);
        c[1] += covariance(s.v, t.v, count);
        c[2] += covariance(s.u, t.v, count);
      }
      for (int k = 0; k < 3; ++k) {
        square_sum[k] += c[k] * c[k];
        largest = std::max(largest, std::abs(c[k]));
      }
    }
  for (const double sum : square_sum)
    CHECK(std::sqrt(sum / pairs * count) < 1.5);
  CHECK(largest < 0.25);
}

TEST_CASE("two_purposes_of_one_pixel_are_uncorrelated") {
  const int count = 1024, pixels = 200;
  double square_sum = 0;
  for (std::uint32_t pixel = 0; pixel < std::uint32_t(pixels); ++pixel) {
    double c = 0;
    for (std::uint32_t i = 0; i < std::uint32_t(count); ++i)
      c += covariance(owen_sobol(i, hash_combine(pixel, 0)).u,
                      owen_sobol(i, hash_combine(pixel, 1)).u, count);
    square_sum += c * c;
  }
  CHECK(std::sqrt(square_sum / pixels * count) < 1.5);
}

TEST_CASE("hashes_of_neighbours_differ") {
  std::set<std::uint32_t> hashes;
  for (std::uint32_t y = 0; y < 128; ++y)
    for (std::uint32_t x = 0; x < 128; ++x)
      hashes.insert(hash_combine(x, y));
  // Among 2^14 random values of 2^32, 0.03 pairs meet.
  CHECK(hashes.size() >= 128 * 128 - 2);
}

TEST_CASE("fraction_stays_below_one") {
  CHECK(fraction(0xffffffffu) < 1.0f);
  CHECK(fraction(0) == 0.0f);
  CHECK(fraction(0x80000000u) == 0.5f);
}

TEST_CASE("squares_of_pixels_share_well_distributed_samples") {
  // Consecutive samples in the order of the curve: those of any aligned square of 2, 4 or 8 pixels
  // on a side are a (0, m, 2)-net, one in every elementary rectangle of their number, for one
  // sample a pixel and for four (Niederreiter 1992, definition 4.1).
  for (const int samples_log2 : {0, 2})
    for (const int side_log2 : {1, 2, 3}) {
      const int side = 1 << side_log2, samples = 1 << samples_log2;
      const int count_log2 = 2 * side_log2 + samples_log2;
      for (const auto& [left, top] : {std::pair{0, 0}, std::pair{3 * side, side}}) {
        std::vector<Sample2> points;
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x)
            for (int s = 0; s < samples; ++s)
              points.push_back(owen_sobol(
                  (z_order(std::uint32_t(left + x), std::uint32_t(top + y)) << samples_log2) +
                      std::uint32_t(s),
                  hash_combine(7, 1)));
        for (int across = 0; across <= count_log2; ++across) {
          std::set<std::pair<int, int>> cells;
          for (const Sample2& p : points)
            cells.insert(
                {int(p.u * float(1 << across)), int(p.v * float(1 << (count_log2 - across)))});
          CHECK(cells.size() == points.size());
        }
      }
    }
}

TEST_CASE("z_order_numbers_each_pixel_of_a_block_once") {
  std::set<std::uint32_t> places;
  const std::uint32_t side = 1u << k_block_bits;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      places.insert(z_order(x, y));
  CHECK(places.size() == side * side);
  CHECK(*places.rbegin() == side * side - 1);
  CHECK(bits_below(1) == 0);
  CHECK(bits_below(2) == 1);
  CHECK(bits_below(5) == 3);
  CHECK(bits_below(8) == 3);
}
