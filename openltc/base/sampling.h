// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Low-discrepancy samples: the first two Sobol dimensions, shuffled and scrambled by hashing.
//
// Source: Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4), sections 3 and 4;
// the hash is the one of Laine and Karras 2011 as improved by Vegdahl 2021.
//
// Every pair of dimensions is an independently shuffled and scrambled copy of the same (0,2)
// sequence: N consecutive samples from 0 are well distributed in each pair for any N.
//
// The functions are static: this header is compiled for several instruction sets, and the linker
// must not merge their copies.

#pragma once

#include <cstdint>

namespace openltc {

/// A well mixed 32-bit hash of two values, e.g. pixel and purpose.
static inline std::uint32_t hash_combine(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a ^ (b * 0x9e3779b9u + 0x7f4a7c15u + (a << 6) + (a >> 2));
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  h ^= h >> 16;
  return h;
}

static inline std::uint32_t reverse_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// Hash in which each bit depends on lower bits only: an Owen scramble of reversed digits.
static inline std::uint32_t laine_karras_permutation(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Owen scramble of a binary fraction.
static inline std::uint32_t nested_uniform_scramble(std::uint32_t x, std::uint32_t seed) {
  return reverse_bits(laine_karras_permutation(reverse_bits(x), seed));
}

/// Second Sobol dimension of a sample index, as a binary fraction. Its generator matrix is Pascal's
/// triangle modulo 2, which factors into five shift-and-xor steps on the reversed index.
static inline std::uint32_t sobol_dimension_1(std::uint32_t index) {
  std::uint32_t x = reverse_bits(index);
  x ^= (x & 0x55555555u) << 1;
  x ^= (x & 0x33333333u) << 2;
  x ^= (x & 0x0f0f0f0fu) << 4;
  x ^= (x & 0x00ff00ffu) << 8;
  x ^= (x & 0x0000ffffu) << 16;
  return x;
}

/// A binary fraction as a float in [0, 1).
static inline float fraction(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

struct Sample2 {
  float u, v;
};

/// Sample `index` of the pair of dimensions that `seed` names, in [0, 1)^2. Pairs are independent
/// if their seeds are well mixed, as hash_combine gives them; seeds of few bits are not enough.
static inline Sample2 owen_sobol(std::uint32_t index, std::uint32_t seed) {
  const std::uint32_t shuffled = nested_uniform_scramble(index, seed);
  return {fraction(nested_uniform_scramble(reverse_bits(shuffled), hash_combine(seed, 1))),
          fraction(nested_uniform_scramble(sobol_dimension_1(shuffled), hash_combine(seed, 2)))};
}

/// Bits of the numbers below n, n at least 1.
static inline int bits_below(std::uint32_t n) { return n > 1 ? 32 - __builtin_clz(n - 1) : 0; }

/// Pixels of a block share one sequence, see z_order.
inline constexpr int k_block_bits = 7; // 128 pixels on a side

/// Place of a pixel within its block along a curve that fills each square of 2, 4, 8 ... pixels on
/// a side before it goes on to the next. When the pixels of a block take consecutive samples of one
/// sequence in this order, not only each pixel's samples are well distributed but those of each
/// such square together, so that neighbours err in opposite directions: the error is blue noise
/// over the screen, which the eye averages. Source: Ahmed, Wonka 2020, "Screen-Space Blue-Noise
/// Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels". The random order
/// of a square's quarters comes with the shuffle of owen_sobol, which is a nested scramble of the
/// index.
static inline std::uint32_t z_order(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  for (int bit = 0; bit < k_block_bits; ++bit)
    place |= ((x >> bit) & 1u) << (2 * bit) | ((y >> bit) & 1u) << (2 * bit + 1);
  return place;
}

} // namespace openltc
