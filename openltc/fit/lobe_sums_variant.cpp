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

// As many points as a register holds.
struct Points {
  Block x, y, z, w, p; // as in the input

  Points(const LobeSumsInput& in, std::size_t i) {
    load(x, in.x + i);
    load(y, in.y + i);
    load(z, in.z + i);
    load(w, in.weight + i);
    load(p, in.density + i);
  }
};

// A lobe at points: o and what follows from it.
struct LobeAt {
  Block ox, oz, q, inside, d;

  LobeAt(const double* m, double det, const Points& at) {
    const Block none = {};
    ox = m[0] * at.x + m[1] * at.z;
    oz = m[2] * at.x + m[3] * at.z;
    q = 1.0 / (ox * ox + at.y * at.y + oz * oz);
    inside = oz > none ? det * q * q : none;
    d = oz * inside;
  }

  // The derivatives of d by m.
  void slopes(const double* log_slope, const Points& at, Block* slope) const {
    const Block four_dq = 4.0 * d * q;
    const Block by_x = -four_dq * ox, by_z = inside - four_dq * oz;
    slope[0] = d * log_slope[0] + by_x * at.x;
    slope[1] = d * log_slope[1] + by_x * at.z;
    slope[2] = d * log_slope[2] + by_z * at.x;
    slope[3] = d * log_slope[3] + by_z * at.z;
  }
};

// One lobe as a density of four unknowns.
struct OneLobe {
  static constexpr int k_unknowns = 4;
  const LobeSumsInput& in;

  const LobeSumsInput& points() const { return in; }
  Block density(const Points& at) const { return LobeAt(in.m, in.det, at).d; }
  Block density(const Points& at, Block* slope) const {
    const LobeAt lobe(in.m, in.det, at);
    lobe.slopes(in.log_slope, at, slope);
    return lobe.d;
  }
};

// Two lobes as one, of which the weight is the last unknown.
struct TwoLobesAsOne {
  static constexpr int k_unknowns = k_two_lobe_unknowns;
  const TwoLobeSumsInput& in;

  const LobeSumsInput& points() const { return in.points; }
  LobeAt part(int k, const Points& at) const { return LobeAt(in.parts[k].m, in.parts[k].det, at); }
  Block density(const Points& at) const {
    return in.parts[0].weight * part(0, at).d + in.parts[1].weight * part(1, at).d;
  }
  Block density(const Points& at, Block* slope) const {
    const LobeAt first = part(0, at), second = part(1, at);
    first.slopes(in.parts[0].log_slope, at, slope);
    second.slopes(in.parts[1].log_slope, at, slope + 4);
    for (int k = 0; k < 8; ++k)
      slope[k] = in.parts[k / 4].weight * slope[k];
    slope[8] = second.d - first.d;
    return in.parts[0].weight * first.d + in.parts[1].weight * second.d;
  }
};

template <class Lobes> void sum_distances(const Lobes& lobes, LobeDistances& out) {
  const LobeSumsInput& in = lobes.points();
  const Block zero = {};
  Lanes missing_lanes, squares_lanes, cubes_lanes;
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block missing = zero, squares = zero, cubes = zero;
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      const Points at(in, i);
      const Block r = lobes.density(at) - at.p;
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

// Upper triangle by rows.
template <class Lobes> void sum_derivatives(const Lobes& lobes, double* gradient, double* hessian) {
  constexpr int k_unknowns = Lobes::k_unknowns, k_entries = k_unknowns * (k_unknowns + 1) / 2;
  const LobeSumsInput& in = lobes.points();
  const Block zero = {};
  Lanes g_lanes[k_unknowns], h_lanes[k_entries];
  const double half_tv = 0.5 * in.tv;
  // One register's lanes at a time: twenty-eight sums of half the lanes would not fit the
  // registers.
  for (int offset = 0; offset < k_lanes; offset += k_width) {
    Block g[k_unknowns], h[k_entries];
    for (Block& sum : g)
      sum = zero;
    for (Block& sum : h)
      sum = zero;
    for (std::size_t i = std::size_t(offset); i < in.count; i += k_lanes) {
      const Points at(in, i);
      Block slope[k_unknowns];
      const Block r = lobes.density(at, slope) - at.p;
      const Block a = r < zero ? -r : r;
      const Block e = in.rounding * at.p + in.floor;
      const Block inverse = 1.0 / (a + e);
      const Block omega = at.w * (half_tv * (a + 2.0 * e) * inverse * inverse + 2.0 * in.squares +
                                  3.0 * in.cubes * a);
      const Block pull = omega * r - half_tv * at.w; // the gradient by the density
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
    gradient[k] = g_lanes[k].sum();
  for (int k = 0; k < k_entries; ++k)
    hessian[k] = h_lanes[k].sum();
}

void distances(const LobeSumsInput& in, LobeDistances& out) { sum_distances(OneLobe{in}, out); }
void derivatives(const LobeSumsInput& in, LobeDerivatives& out) {
  sum_derivatives(OneLobe{in}, out.gradient, out.hessian);
}
void two_distances(const TwoLobeSumsInput& in, LobeDistances& out) {
  sum_distances(TwoLobesAsOne{in}, out);
}
void two_derivatives(const TwoLobeSumsInput& in, TwoLobeDerivatives& out) {
  sum_derivatives(TwoLobesAsOne{in}, out.gradient, out.hessian);
}

} // namespace

LobeSums OPENLTC_PASTE(lobe_sums_, OPENLTC_ISA)() {
  return {distances, derivatives, two_distances, two_derivatives};
}

} // namespace openltc::fit
