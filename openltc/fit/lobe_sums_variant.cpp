// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One variant of lobe_sums, compiled once per instruction set: OPENLTC_ISA is its name,
// OPENLTC_LANES how many floats its registers hold, which is twice as many doubles.
//
// With o = (m0 x + m1 z, y, m2 x + m3 z), q = 1/|o|^2 and d = det s / pi (lobe_fit.cpp):
//   D = o.z d q^2,
//   dD/dm0 = D g0 - 4 D o.x q x      dD/dm2 = D g2 + (d q^2 - 4 D o.z q) x
//   dD/dm1 = D g1 - 4 D o.x q z      dD/dm3 = D g3 + (d q^2 - 4 D o.z q) z
// with g the slopes of log(det s). All zero where o.z <= 0.

#include "openltc/fit/lobe_sums.h"

#include <cstring>

#define OPENLTC_PASTE_(a, b) a##b
#define OPENLTC_PASTE(a, b) OPENLTC_PASTE_(a, b)

namespace openltc::fit {

namespace {

// Lanes of this variant's registers, a divisor of the eight lanes that every sum is kept in.
constexpr int k_width = OPENLTC_LANES / 2;
constexpr int k_lanes = 8;
typedef double Block __attribute__((vector_size(k_width * sizeof(double))));

inline void load(Block& to, const double* from) { std::memcpy(&to, from, sizeof(Block)); }

// A sum's eight lanes, added in one order.
struct Lanes {
  double lane[k_lanes];

  void set(int offset, const Block& block) { std::memcpy(lane + offset, &block, sizeof(Block)); }
  double sum() const {
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) +
           ((lane[1] + lane[5]) + (lane[3] + lane[7]));
  }
};

// The lobe at as many points as a register holds.
struct Points {
  Block x, z, w, p; // as in the input
  Block ox, oz, q, inside, d;

  Points(const LobeSumsInput& in, std::size_t i) {
    Block y;
    load(x, in.x + i);
    load(y, in.y + i);
    load(z, in.z + i);
    load(w, in.weight + i);
    load(p, in.density + i);
    const Block none = {};
    ox = in.m[0] * x + in.m[1] * z;
    oz = in.m[2] * x + in.m[3] * z;
    q = 1.0 / (ox * ox + y * y + oz * oz);
    inside = oz > none ? in.det * q * q : none;
    d = oz * inside;
  }
};

void distances(const LobeSumsInput& in, LobeDistances& out) {
  const Block zero = {};
  Lanes missing_lanes, squares_lanes, cubes_lanes;
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block missing = zero, squares = zero, cubes = zero;
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      const Points at(in, i);
      const Block r = at.d - at.p;
      const Block a = r < zero ? -r : r;
      const Block square = at.w * r * r;
      missing += square / (a + (in.rounding * at.p + in.floor)) - at.w * r;
      squares += square;
      cubes += square * a;
    }
    missing_lanes.set(offset, missing);
    squares_lanes.set(offset, squares);
    cubes_lanes.set(offset, cubes);
  }
  out.missing = 0.5 * missing_lanes.sum();
  out.squares = squares_lanes.sum();
  out.cubes = cubes_lanes.sum();
}

void derivatives(const LobeSumsInput& in, LobeDerivatives& out) {
  const Block zero = {};
  Lanes g_lanes[4], h_lanes[10];
  const double half_tv = 0.5 * in.tv;
  // One register's lanes at a time: twenty-eight sums of half the lanes would not fit the
  // registers.
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block g[4] = {zero, zero, zero, zero};
    Block h[10] = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      const Points at(in, i);
      const Block r = at.d - at.p;
      const Block a = r < zero ? -r : r;
      const Block e = in.rounding * at.p + in.floor;
      const Block inverse = 1.0 / (a + e);
      const Block omega = at.w * (half_tv * (a + 2.0 * e) * inverse * inverse + 2.0 * in.squares +
                                  3.0 * in.cubes * a);
      const Block four_dq = 4.0 * at.d * at.q;
      const Block by_x = -four_dq * at.ox, by_z = at.inside - four_dq * at.oz;
      const Block d0 = at.d * in.log_slope[0] + by_x * at.x;
      const Block d1 = at.d * in.log_slope[1] + by_x * at.z;
      const Block d2 = at.d * in.log_slope[2] + by_z * at.x;
      const Block d3 = at.d * in.log_slope[3] + by_z * at.z;
      const Block pull = omega * r - half_tv * at.w; // the gradient by D
      g[0] += pull * d0;
      g[1] += pull * d1;
      g[2] += pull * d2;
      g[3] += pull * d3;
      const Block w0 = omega * d0, w1 = omega * d1, w2 = omega * d2, w3 = omega * d3;
      h[0] += w0 * d0;
      h[1] += w0 * d1;
      h[2] += w0 * d2;
      h[3] += w0 * d3;
      h[4] += w1 * d1;
      h[5] += w1 * d2;
      h[6] += w1 * d3;
      h[7] += w2 * d2;
      h[8] += w2 * d3;
      h[9] += w3 * d3;
    }
    for (int k = 0; k < 4; ++k)
      g_lanes[k].set(offset, g[k]);
    for (int k = 0; k < 10; ++k)
      h_lanes[k].set(offset, h[k]);
  }
  for (int k = 0; k < 4; ++k)
    out.gradient[k] = g_lanes[k].sum();
  for (int k = 0; k < 10; ++k)
    out.hessian[k] = h_lanes[k].sum();
}

// One of two lobes at as many points as a register holds: o and what follows from it.
struct PartAt {
  Block ox, oz, q, inside, d;

  PartAt(const TwoLobeSumsInput::Part& part, const Block& x, const Block& y, const Block& z) {
    const Block none = {};
    ox = part.m[0] * x + part.m[1] * z;
    oz = part.m[2] * x + part.m[3] * z;
    q = 1.0 / (ox * ox + y * y + oz * oz);
    inside = oz > none ? part.det * q * q : none;
    d = oz * inside;
  }

  // weight times the derivatives of d by m.
  void slopes(const TwoLobeSumsInput::Part& part, const Block& x, const Block& z,
              Block* slope) const {
    const Block four_dq = 4.0 * d * q;
    const Block by_x = -four_dq * ox, by_z = inside - four_dq * oz;
    slope[0] = part.weight * (d * part.log_slope[0] + by_x * x);
    slope[1] = part.weight * (d * part.log_slope[1] + by_x * z);
    slope[2] = part.weight * (d * part.log_slope[2] + by_z * x);
    slope[3] = part.weight * (d * part.log_slope[3] + by_z * z);
  }
};

void two_distances(const TwoLobeSumsInput& input, LobeDistances& out) {
  const LobeSumsInput& in = input.points;
  const Block zero = {};
  Lanes missing_lanes, squares_lanes, cubes_lanes;
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block missing = zero, squares = zero, cubes = zero;
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      Block x, y, z, w, p;
      load(x, in.x + i);
      load(y, in.y + i);
      load(z, in.z + i);
      load(w, in.weight + i);
      load(p, in.density + i);
      const PartAt first(input.parts[0], x, y, z), second(input.parts[1], x, y, z);
      const Block r = input.parts[0].weight * first.d + input.parts[1].weight * second.d - p;
      const Block a = r < zero ? -r : r;
      const Block square = w * r * r;
      missing += square / (a + (in.rounding * p + in.floor)) - w * r;
      squares += square;
      cubes += square * a;
    }
    missing_lanes.set(offset, missing);
    squares_lanes.set(offset, squares);
    cubes_lanes.set(offset, cubes);
  }
  out.missing = 0.5 * missing_lanes.sum();
  out.squares = squares_lanes.sum();
  out.cubes = cubes_lanes.sum();
}

void two_derivatives(const TwoLobeSumsInput& input, TwoLobeDerivatives& out) {
  constexpr int k_unknowns = k_two_lobe_unknowns, k_entries = k_unknowns * (k_unknowns + 1) / 2;
  const LobeSumsInput& in = input.points;
  const Block zero = {};
  Lanes g_lanes[k_unknowns], h_lanes[k_entries];
  const double half_tv = 0.5 * in.tv;
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block g[k_unknowns], h[k_entries];
    for (Block& sum : g)
      sum = zero;
    for (Block& sum : h)
      sum = zero;
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      Block x, y, z, w, p;
      load(x, in.x + i);
      load(y, in.y + i);
      load(z, in.z + i);
      load(w, in.weight + i);
      load(p, in.density + i);
      const PartAt first(input.parts[0], x, y, z), second(input.parts[1], x, y, z);
      const Block r = input.parts[0].weight * first.d + input.parts[1].weight * second.d - p;
      const Block a = r < zero ? -r : r;
      const Block e = in.rounding * p + in.floor;
      const Block inverse = 1.0 / (a + e);
      const Block omega =
          w * (half_tv * (a + 2.0 * e) * inverse * inverse + 2.0 * in.squares + 3.0 * in.cubes * a);
      const Block pull = omega * r - half_tv * w; // the gradient by the density
      Block slope[k_unknowns];
      first.slopes(input.parts[0], x, z, slope);
      second.slopes(input.parts[1], x, z, slope + 4);
      slope[8] = second.d - first.d;
      int entry = 0;
#pragma GCC unroll 9
      for (int k = 0; k < k_unknowns; ++k) {
        g[k] += pull * slope[k];
        const Block weighted = omega * slope[k];
#pragma GCC unroll 9
        for (int l = k; l < k_unknowns; ++l, ++entry)
          h[entry] += weighted * slope[l];
      }
    }
    for (int k = 0; k < k_unknowns; ++k)
      g_lanes[k].set(offset, g[k]);
    for (int k = 0; k < k_entries; ++k)
      h_lanes[k].set(offset, h[k]);
  }
  for (int k = 0; k < k_unknowns; ++k)
    out.gradient[k] = g_lanes[k].sum();
  for (int k = 0; k < k_entries; ++k)
    out.hessian[k] = h_lanes[k].sum();
}

} // namespace

LobeSums OPENLTC_PASTE(lobe_sums_, OPENLTC_ISA)() {
  return {distances, derivatives, two_distances, two_derivatives};
}

} // namespace openltc::fit
